//! A cell in motion.

use super::Particle;
use super::cell_fields::CellFields;
use glam::DVec2;

/// A particle with its velocity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MovingParticle<P> {
    pub particle: Particle<P>,
    /// Velocity, in the tangent frame of the particle's centre.
    pub velocity: DVec2,
    /// The cell's size over the size field's value at its centre; 1 unless sizes vary.
    pub factor: f64,
    /// Whether the cell moved in the last step. Also true for new cells, and for all cells after a
    /// removal.
    pub has_moved: bool,
}

impl<P: Copy> MovingParticle<P> {
    /// Sets the centre, and takes direction, size and aspect ratio from the fields there.
    pub fn place<A: CellFields<Place = P>>(&mut self, centre: P, asked: A) {
        self.particle.centre = centre;
        self.particle.axis = asked.direction(centre);
        self.particle.size = self.factor * asked.size(centre);
        self.particle.aspect = asked.aspect(centre);
    }
}
