//! The soft wall, which keeps the cells' edges on the boundary.

use super::body::MovingParticle;
use super::force::{bubble_force, bubble_potential};
use super::packing_domain::{Boundary, ClosestPoint};
use super::shape::{CUT, CellShape};
use crate::order::lesser;
use glam::DVec2;

/// Strength of a wall relative to a neighbour.
const STIFFNESS: f64 = 2.0;

/// A centre stays at least this share of its cell's extent away from the boundary.
pub(crate) const CLOSEST: f64 = 0.2;

/// The distance at which a cell of this length begins to feel the boundary: a square's half diagonal times
/// the cut.
pub(crate) fn reach(length: f64) -> f64 {
    0.5 * std::f64::consts::SQRT_2 * length * CUT
}

/// The force of all walls on a cell, and a lower bound of their distance; `near` is scratch space.
pub(super) fn wall_force<W: Boundary>(
    body: &MovingParticle<W::Place>,
    walls: W,
    near: &mut Vec<W::ClosestPoint>,
) -> (DVec2, f64) {
    let centre = body.particle.centre;
    let shape = CellShape::of(&body.particle);
    let reach = lesser(reach(shape.length()), walls.reach());
    if !walls.is_near(centre) {
        return (DVec2::ZERO, reach);
    }
    walls.closest_points(centre, reach, near);
    let mut force = DVec2::ZERO;
    for wall in near.iter() {
        let half = shape.half_extent(wall.inward());
        force += wall.inward() * (STIFFNESS * 2.0 * half * bubble_force(wall.distance() / half));
    }
    // Without a closest point there is no force, and the bound is 0: the cell may stand on the boundary.
    (force, near.first().map_or(0.0, ClosestPoint::distance))
}

/// The potential of all walls for a cell; [`wall_force`] is minus its gradient.
pub(super) fn wall_potential<W: Boundary>(
    body: &MovingParticle<W::Place>,
    walls: W,
    near: &mut Vec<W::ClosestPoint>,
) -> f64 {
    let centre = body.particle.centre;
    if !walls.is_near(centre) {
        return 0.0;
    }
    let shape = CellShape::of(&body.particle);
    let reach = lesser(reach(shape.length()), walls.reach());
    walls.closest_points(centre, reach, near);
    let potential = |wall: &W::ClosestPoint| {
        let half = shape.half_extent(wall.inward());
        STIFFNESS * 2.0 * half * half * bubble_potential(wall.distance() / half)
    };
    near.iter().map(potential).sum()
}

/// Whether a cell of this length, at least `distance` from all walls, stays clear of them when it moves by
/// `by`.
pub(super) fn stays_clear(distance: f64, by: f64, length: f64) -> bool {
    distance - by > CLOSEST * length
}
