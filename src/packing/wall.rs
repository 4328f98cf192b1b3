//! The soft wall: the boundary keeps the cells' edges on it.

use super::force::bubble_force;
use super::shape::{CUT, Shape};
use super::{Body, Surroundings};
use crate::domain::{Projection, Walls};
use glam::DVec2;

/// Strength of a wall over that of a neighbour.
const STIFFNESS: f64 = 2.0;

/// A centre is never left nearer to the boundary than this share of its cell's extent.
pub(super) const CLOSEST: f64 = 0.2;

/// How far from the boundary a cell of this length can feel it: a square's half diagonal times the
/// cut.
pub(super) fn reach(length: f64) -> f64 {
    0.5 * std::f64::consts::SQRT_2 * length * CUT
}

/// The force of all walls on a cell, and how far away they are at least; `near` is room for them.
pub(super) fn wall_force(body: &Body, walls: &Walls, near: &mut Vec<Projection>) -> (DVec2, f64) {
    let centre = body.particle.centre;
    let shape = Shape::of(&body.particle);
    let reach = reach(shape.length()).min(walls.reach());
    if !walls.is_near(centre) {
        return (DVec2::ZERO, reach);
    }
    walls.project(centre, reach, near);
    let mut force = DVec2::ZERO;
    for wall in near.iter() {
        let half = shape.half_extent(wall.inward);
        force += wall.inward * (STIFFNESS * 2.0 * half * bubble_force(wall.distance / half));
    }
    // None where it stands on the boundary.
    (force, near.first().map_or(0.0, |wall| wall.distance))
}

/// Does a cell of this length stay clear of walls at least this far away when it moves by `by`?
pub(super) fn stays_clear(distance: f64, by: f64, length: f64) -> bool {
    distance - by > CLOSEST * length
}

/// Puts a centre that has moved too near to the boundary or a constraint line, or beyond it, back to
/// its own side; on a torus, back into the picture.
pub(super) fn keep_inside(from: DVec2, to: DVec2, shape: Shape, around: Surroundings) -> DVec2 {
    let domain = around.domain;
    // After a move shorter than the reach of the walls, a cell beyond them is near them.
    let is_short = from.distance(to) < around.walls.reach();
    if is_short && domain.is_in_box(to) && !around.walls.is_near(to) {
        return to;
    }
    let near = domain.nearest(to);
    let mut centre = to;
    let least = CLOSEST * shape.extent(near.inward);
    if near.distance < least {
        // Where the outline is narrower than that, in its middle.
        let depth = domain.medial_depth(near.point, near.inward, least);
        centre = if depth > 0.0 {
            near.point + near.inward * depth
        } else {
            from
        };
    }
    if domain.is_parted(from, centre) {
        centre = from;
    }
    if let Some(line) = domain.nearest_line(centre) {
        let least = CLOSEST * shape.extent(line.inward);
        let away = line.point + line.inward * least;
        if line.distance < least
            && domain.nearest(away).distance > 0.0
            && !domain.is_parted(centre, away)
        {
            centre = away;
        }
    }
    domain.space().wrap(centre)
}
