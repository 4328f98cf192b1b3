//! A cell in motion.

use super::Particle;
use super::cell_fields::CellFields;
use glam::DVec2;

/// A particle with its velocity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MovingParticle<P> {
    pub particle: Particle<P>,
    /// Velocity, in the frame of its place.
    pub velocity: DVec2,
    /// Factor of this cell's size over the size field.
    pub factor: f64,
    /// Whether it moved in the last step, or is new.
    pub has_moved: bool,
}

impl<P: Copy> MovingParticle<P> {
    /// Moves it; its direction and size follow the fields.
    pub fn place<A: CellFields<Place = P>>(&mut self, centre: P, asked: A) {
        self.particle.centre = centre;
        self.particle.axis = asked.direction(centre);
        self.particle.size = self.factor * asked.size(centre);
        self.particle.aspect = asked.aspect(centre);
    }
}
