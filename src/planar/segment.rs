//! Distances, crossings and divisions of segments.

use super::orientation;
use crate::order;
use glam::DVec2;

/// The point of the segment a to b nearest to p.
pub(crate) fn closest_on_segment(p: DVec2, a: DVec2, b: DVec2) -> DVec2 {
    let ab = b - a;
    let square = ab.length_squared();
    if square == 0.0 {
        return a;
    }
    let t = (p - a).dot(ab) / square;
    if t <= 0.0 {
        a
    } else if t >= 1.0 {
        b
    } else {
        a + ab * t
    }
}

/// Whether a to b crosses the segment c to d. Touching in a or b does not count. Touching in c or d does, so
/// that a path through the common end of two segments crosses one of them.
pub(crate) fn crosses(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> bool {
    if a.min(b).cmpgt(c.max(d)).any() || c.min(d).cmpgt(a.max(b)).any() {
        return false;
    }
    let (sa, sb) = (orientation(c, d, a), orientation(c, d, b));
    let apart = (sa > 0.0 && sb < 0.0) || (sa < 0.0 && sb > 0.0);
    apart && (orientation(a, b, c) >= 0.0) != (orientation(a, b, d) >= 0.0)
}

/// Splits segments at points on them; each point comes with its segment's number.
pub(crate) fn divided(segments: &[[DVec2; 2]], places: &[(usize, DVec2)]) -> Vec<[DVec2; 2]> {
    let mut on: Vec<Vec<DVec2>> = vec![Vec::new(); segments.len()];
    for &(segment, p) in places {
        on[segment].push(p);
    }
    let mut pieces = Vec::new();
    for (&[a, b], mut points) in segments.iter().zip(on) {
        order::sort(&mut points, |p| (order::rank(p.distance_squared(a)), 0));
        let mut from = a;
        for to in points.into_iter().chain([b]) {
            if from != to {
                pieces.push([from, to]);
            }
            from = to;
        }
    }
    pieces
}
