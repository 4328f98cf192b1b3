//! The outline to be paved: islands and their holes, and the questions the later stages ask of it
//! (inside? how far is the boundary, and in which direction?).
//!
//! A ring inside an even number of other rings is an outer one, the rim of an island; inside an odd
//! number it is a hole. An island may lie in a hole of another. Nothing joins cells of two islands.
//!
//! All coordinates are picture units (pixels), x to the right, y down. An outer ring has a positive
//! shoelace area sum(x0 y1 - x1 y0) / 2 on these numbers (it runs clockwise on screen), holes a
//! negative one, so the paved side is always to the same hand of a segment: at its inward normal
//! (-dy, dx).

mod candidates;
mod check;
mod crossing;
mod distance;
mod facing;
mod islands;
mod lines;
mod nesting;
mod parts;
mod ring;
pub mod shape;
mod squares;

pub(crate) use candidates::closest_on_segment;
pub use check::{MAX_LINE_POINTS, MAX_POINTS, Ring, check_lines};
pub use distance::{Domain, Nearest};
pub use facing::{Facing, Foot};
pub(crate) use lines::crosses;
pub(crate) use parts::divided;
pub(crate) use ring::ring_contains;

pub use crate::planar::Space;
use glam::DVec2;

/// Rings as they were given, unchecked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// The rings, outer ones and holes, not closed (the last point differs from the first).
    pub rings: Vec<Vec<DVec2>>,
    /// Constraint lines, which cells line up along: runs of points, closed where the last point is
    /// the first again. They may touch and cross the rings and each other; what lies outside does
    /// not count.
    pub lines: Vec<Vec<DVec2>>,
}

/// Twice the signed area of the triangle a, b, c: positive where c lies at the inward hand of a to b.
pub fn cross(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// The shoelace area of a ring, positive where it runs clockwise on screen.
pub fn signed_area(ring: &[DVec2]) -> f64 {
    // Around the first point, so that rings far from the origin lose no digits.
    let Some(&origin) = ring.first() else {
        return 0.0;
    };
    let twice: f64 = ring
        .windows(2)
        .map(|w| (w[0] - origin).perp_dot(w[1] - origin))
        .sum();
    twice / 2.0
}
