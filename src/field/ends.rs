//! The ends of the boundary: pieces across the direction that cells should follow.
//!
//! Two-fold directions along two walls at right angles cancel on the bisector. At the end of a road the bisector would
//! be a fault through the rows. Without weight on the end, the rows run straight up to it.

use crate::domain::Domain;
use glam::DVec2;

/// The boundary turns at a corner by more than this (cosine of 40 degrees).
const CORNER: f64 = 0.766;
/// Limits of a piece's length, in lengths of its shorter neighbour: up to the first limit a piece is an end, from the
/// second on it is not.
const END: (f64, f64) = (0.5, 1.0);

/// The weight of each segment of [`Domain::segments`]. Pieces between two convex corners that are at most
/// half as long as their neighbours get `ends`, pieces as long as the shorter neighbour get 1, and others a
/// value between.
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
    let mut corners = Vec::new();
    let mut before = (ring[0] - ring[n - 1]).normalize_or_zero();
    for k in 0..n {
        let along = (ring[(k + 1) % n] - ring[k]).normalize_or_zero();
        if before.dot(along) < CORNER {
            corners.push((k, before.perp_dot(along) > 0.0));
        }
        before = along;
    }
    let count = corners.len();
    if count < 3 {
        return;
    }
    // A piece runs from a corner to the next one; the last piece wraps around the ring's start.
    let (mut piece, mut piece_of, mut lengths) = (count - 1, vec![0; n], vec![0.0; count]);
    for k in 0..n {
        let next = (piece + 1) % count;
        if corners[next].0 == k {
            piece = next;
        }
        piece_of[k] = piece;
        lengths[piece] += ring[k].distance(ring[(k + 1) % n]);
    }
    for (strength, &piece) in strengths.iter_mut().zip(&piece_of) {
        let (earlier, later) = ((piece + count - 1) % count, (piece + 1) % count);
        if corners[piece].1 && corners[later].1 {
            let beside = lengths[earlier].min(lengths[later]);
            let t = ((lengths[piece] / beside - END.0) / (END.1 - END.0)).clamp(0.0, 1.0);
            *strength = ends + (1.0 - ends) * t * t * (3.0 - 2.0 * t);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Outline;

    fn of(outer: &[[f64; 2]]) -> Vec<f64> {
        let outline = Outline {
            rings: vec![outer.iter().map(|&p| p.into()).collect()],
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
