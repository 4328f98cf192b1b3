//! The soft wall: the boundary keeps the cells' edges on it.

use super::Body;
use super::force::{CUT, bubble_force};
use super::integrate::Surroundings;
use crate::domain::{Facing, Foot};
use glam::DVec2;

/// Strength of a wall over that of a neighbour.
const STIFFNESS: f64 = 2.0;

/// A centre is never left nearer to the boundary than this share of its cell's size.
const CLOSEST: f64 = 0.2;

/// How far from the boundary a cell of this size can feel it: its half diagonal times the cut.
pub(super) fn reach(size: f64) -> f64 {
    0.5 * std::f64::consts::SQRT_2 * size * CUT
}

/// Half the extent of a square cell along a unit vector, at least nearly half its side: a square
/// that stands on its corner may poke its tip into the wall a little.
fn half_extent(body: &Body, inward: DVec2) -> f64 {
    let axis = body.particle.axis;
    let half = 0.5 * body.particle.size;
    if axis == DVec2::ZERO {
        return half;
    }
    let support = axis.dot(inward).abs() + axis.perp_dot(inward).abs();
    half * support.min(1.15)
}

/// The force of all walls on a cell.
pub(super) fn wall_force(body: &Body, facing: &Facing, feet: &mut Vec<Foot>) -> DVec2 {
    let centre = body.particle.centre;
    if body.particle.fixed || !facing.is_near(centre) {
        return DVec2::ZERO;
    }
    facing.feet(centre, reach(body.particle.size), feet);
    let mut force = DVec2::ZERO;
    for foot in feet.iter() {
        let half = half_extent(body, foot.inward);
        force += foot.inward * (STIFFNESS * 2.0 * half * bubble_force(foot.distance / half));
    }
    force
}

/// Puts a centre that has moved too near to the boundary or a constraint line, or beyond it, back to
/// its own side; on a torus, back into the picture.
pub(super) fn keep_inside(from: DVec2, to: DVec2, size: f64, around: Surroundings) -> DVec2 {
    let domain = around.domain;
    let (lo, hi) = domain.bounds();
    let in_box = to.cmpgt(lo).all() && to.cmplt(hi).all();
    // A single move is shorter than the reach of the walls: whoever is beyond them is near them.
    if in_box && !around.facing.is_near(to) {
        return to;
    }
    let near = domain.nearest(to);
    let mut centre = to;
    if near.distance < CLOSEST * size {
        centre = near.point + near.inward * (CLOSEST * size);
    }
    if domain.crosses_line(from, centre) {
        centre = from;
    }
    if let Some(line) = domain.nearest_line(centre)
        && line.distance < CLOSEST * size
    {
        let away = line.point + line.inward * (CLOSEST * size);
        if domain.nearest(away).distance > 0.0 && !domain.crosses_line(centre, away) {
            centre = away;
        }
    }
    domain.wrap(centre)
}
