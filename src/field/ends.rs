//! Which pieces of the boundary are ends, across the way that cells are to follow.
//!
//! Two-fold directions along two walls at right angles cancel on the line between them. At the end
//! of a road that line is a fault through the rows; without the end's weight they run straight up
//! to it.

use crate::domain::Domain;
use glam::DVec2;

/// The boundary turns at a corner by more than this (cosine of 40 degrees).
const CORNER: f64 = 0.766;
/// A piece this many times as long as the shorter of its neighbours is an end, or none at all.
const END: (f64, f64) = (0.5, 1.0);

/// The weight of each segment of [`Domain::segments`]: `ends` for the pieces between two convex
/// corners that are at most half as long as the pieces beside them, 1 for those as long as the
/// shorter one, in between for those in between.
pub(super) fn strengths(domain: &Domain, ends: f64) -> Vec<f64> {
    let mut strengths = Vec::with_capacity(domain.segments().len());
    for ring in domain.rings() {
        let first = strengths.len();
        strengths.resize(first + ring.len(), 1.0);
        mark(ring, ends, &mut strengths[first..]);
    }
    strengths
}

fn mark(ring: &[DVec2], ends: f64, strengths: &mut [f64]) {
    let n = ring.len();
    let along = |k: usize| (ring[(k + 1) % n] - ring[k % n]).normalize_or_zero();
    let turns = |k: usize| along(k + n - 1).dot(along(k)) < CORNER;
    let corners: Vec<usize> = (0..n).filter(|&k| turns(k)).collect();
    let count = corners.len();
    if count < 3 {
        return;
    }
    // A piece goes from a corner to the next one.
    let segments = |piece: usize| {
        let (from, to) = (corners[piece % count], corners[(piece + 1) % count]);
        (0..(to + n - from - 1) % n + 1).map(move |k| (from + k) % n)
    };
    let length = |piece: usize| -> f64 {
        segments(piece)
            .map(|k| ring[k].distance(ring[(k + 1) % n]))
            .sum()
    };
    let convex = |corner: usize| {
        let k = corners[corner % count];
        along(k + n - 1).perp_dot(along(k)) > 0.0
    };
    for piece in 0..count {
        if convex(piece) && convex(piece + 1) {
            let beside = length(piece + count - 1).min(length(piece + 1));
            let t = ((length(piece) / beside - END.0) / (END.1 - END.0)).clamp(0.0, 1.0);
            let full = t * t * (3.0 - 2.0 * t);
            for k in segments(piece) {
                strengths[k] = ends + (1.0 - ends) * full;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Outline;

    fn of(outer: &[[f64; 2]]) -> Vec<f64> {
        let outline = Outline {
            outer: outer.iter().map(|&p| p.into()).collect(),
            ..Outline::default()
        };
        strengths(&Domain::from_checked(&outline), 0.0)
    }

    #[test]
    fn the_short_sides_of_a_road_are_its_ends() {
        let road = of(&[[0., 0.], [150., 0.], [300., 0.], [300., 90.], [0., 90.]]);
        assert_eq!(road, [1.0, 1.0, 0.0, 1.0, 0.0]);
    }

    #[test]
    fn a_square_and_an_l_have_no_ends() {
        assert_eq!(of(&[[0., 0.], [9., 0.], [9., 9.], [0., 9.]]), [1.0; 4]);
        let l = of(&[[0., 0.], [9., 0.], [9., 5.], [5., 5.], [5., 9.], [0., 9.]]);
        assert!(l.iter().all(|&s| s > 0.5), "{l:?}");
    }
}
