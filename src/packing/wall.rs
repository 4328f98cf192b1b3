//! The soft wall: the boundary keeps the cells' edges on it.

use super::Body;
use super::force::{CUT, bubble_force};
use super::integrate::Surroundings;
use super::shape::Shape;
use crate::domain::{Facing, Foot};
use glam::DVec2;

/// Strength of a wall over that of a neighbour.
const STIFFNESS: f64 = 2.0;

/// A centre is never left nearer to the boundary than this share of its cell's extent.
const CLOSEST: f64 = 0.2;

/// How far from the boundary a cell of this length can feel it: a square's half diagonal times the
/// cut.
pub(super) fn reach(length: f64) -> f64 {
    0.5 * std::f64::consts::SQRT_2 * length * CUT
}

/// The force of all walls on a cell.
pub(super) fn wall_force(body: &Body, facing: &Facing, feet: &mut Vec<Foot>) -> DVec2 {
    let centre = body.particle.centre;
    if body.particle.fixed || !facing.is_near(centre) {
        return DVec2::ZERO;
    }
    let shape = Shape::of(&body.particle);
    facing.feet(centre, reach(shape.length()), feet);
    let mut force = DVec2::ZERO;
    for foot in feet.iter() {
        let half = shape.half_extent(foot.inward);
        force += foot.inward * (STIFFNESS * 2.0 * half * bubble_force(foot.distance / half));
    }
    force
}

/// Puts a centre that got too near to the boundary, or beyond it, back inside.
pub(super) fn keep_inside(centre: DVec2, shape: Shape, around: Surroundings) -> DVec2 {
    let (lo, hi) = around.domain.bounds();
    let in_box = centre.cmpgt(lo).all() && centre.cmplt(hi).all();
    // A single move is shorter than the reach of the walls: whoever is beyond them is near them.
    if in_box && !around.facing.is_near(centre) {
        return centre;
    }
    let near = around.domain.nearest(centre);
    let least = CLOSEST * shape.extent(near.inward);
    if near.distance >= least {
        return centre;
    }
    near.point + near.inward * least
}
