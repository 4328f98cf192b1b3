//! The forces of one body on the bodies that it touches.

use super::Particle;
use super::body::MovingParticle;
use super::force::force_between;
use super::physics::CornerBubbles;
use super::square_pairs::TwoSquarePairs;
use super::transport::ParallelTransport;
use crate::field::CellKind;
use glam::DVec2;

/// The data of a body that the forces of most pairs need, close together in memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct PairData<P> {
    pub centre: P,
    axis: DVec2,
    size: f64,
    /// Two cells do not touch if they are farther apart than the sum of their reaches; infinite for stretched cells.
    pub reach: f64,
    is_square: bool,
}

impl<P: Copy> PairData<P> {
    /// `square_reach` is in stable distances.
    pub fn of(particle: &Particle<P>, square_reach: f64) -> Self {
        let stretched = particle.kind.is_stretched();
        Self {
            centre: particle.centre,
            axis: particle.axis,
            size: particle.size,
            reach: if stretched {
                f64::INFINITY
            } else {
                square_reach * 0.5 * particle.size
            },
            is_square: particle.kind == CellKind::Square,
        }
    }

    /// Whether it is a square of this size with an axis.
    fn is_plain(&self, size: f64) -> bool {
        self.is_square && self.size == size && self.axis != DVec2::ZERO
    }
}

/// The number of a body within reach of another one, the offset to it, and the parallel transport from there.
pub(super) type Touching<T> = (usize, DVec2, T);

/// The forces of body `i` on one or two bodies that it touches. `data` has the inputs of all bodies.
#[inline(always)]
pub(super) fn forces_on<P: Copy, T: ParallelTransport>(
    (i, bodies): (usize, &[MovingParticle<P>]),
    pairs: &[Touching<T>],
    data: &[PairData<P>],
    bubbles: CornerBubbles,
) -> [DVec2; 2] {
    let (a, two) = (&data[i], [pairs[0], pairs[pairs.len() - 1]]);
    let others = two.map(|(j, ..)| &data[j]);
    let size = a.size;
    if a.is_plain(size) && others.into_iter().all(|b| b.is_plain(size)) {
        let axes = [0, 1].map(|k| two[k].2.apply(others[k].axis));
        let offsets = two.map(|(_, r, _)| r);
        return TwoSquarePairs { size, bubbles }.forces(a.axis, axes, offsets);
    }
    let mut forces = [DVec2::ZERO; 2];
    for (force, &(j, r, turn)) in forces.iter_mut().zip(pairs) {
        *force = force_between(&bodies[i].particle, &bodies[j].particle, (r, turn), bubbles);
    }
    forces
}
