//! Bounding box and point test of a single ring.

use crate::planar::orientation;
use glam::DVec2;

/// The corners of the bounding box of points, the smallest and the largest.
pub(super) fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    points
        .iter()
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(lo, hi), &p| {
            (lo.min(p), hi.max(p))
        })
}

/// Whether the point is inside the ring, for either orientation. Exact; counts crossings of a ray to +x.
pub(crate) fn ring_contains(ring: &[DVec2], p: DVec2) -> bool {
    let mut inside = false;
    let mut a = ring.last().copied().unwrap_or(p);
    for &b in ring {
        if (a.y > p.y) != (b.y > p.y) {
            // The side is taken from its upper end, so that a point on a side that two rings share is in
            // exactly one of them.
            let (upper, lower) = if a.y < b.y { (a, b) } else { (b, a) };
            inside ^= orientation(upper, lower, p) > 0.0;
        }
        a = b;
    }
    inside
}
