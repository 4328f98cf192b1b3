//! Polygons and lines: circles, rounded corners, thick lines, images on a tile. Picture units, y down.

use crate::planar::unit_vector;
use glam::DVec2;

/// Offsets of a ring's images that reach into a tile of this side, without the ring itself.
pub fn copies(ring: &[DVec2], side: f64) -> Vec<DVec2> {
    let lo = ring.iter().fold(DVec2::INFINITY, |lo, &p| lo.min(p));
    let hi = ring.iter().fold(DVec2::NEG_INFINITY, |hi, &p| hi.max(p));
    let steps = |lo: f64, hi: f64| {
        let ways = [(0.0, true), (side, lo < 0.0), (-side, hi > side)];
        ways.into_iter().filter(|way| way.1).map(|way| way.0)
    };
    let shifts = steps(lo.y, hi.y).flat_map(|y| steps(lo.x, hi.x).map(move |x| DVec2::new(x, y)));
    shifts.filter(|&shift| shift != DVec2::ZERO).collect()
}

/// A ring as a line that ends at its start.
pub(super) fn closed(ring: &[DVec2]) -> Vec<DVec2> {
    let mut line = ring.to_vec();
    line.extend(ring.first());
    line
}

/// A polygon that approximates a circle.
pub(super) fn round(centre: DVec2, radius: f64) -> Vec<DVec2> {
    let count = if radius < 12.0 { 12 } else { 64 };
    let point = |k: i32| {
        let turn = std::f64::consts::TAU * f64::from(k) / f64::from(count);
        centre + radius * unit_vector(turn)
    };
    (0..count).map(point).collect()
}

/// Corners that turn by less than the angle with this cosine are not rounded.
const FLAT: f64 = 0.9;

/// The ring with rounded corners, each cut by up to `round` picture units.
pub(super) fn rounded(ring: &[DVec2], round: f64) -> Vec<DVec2> {
    let n = ring.len();
    let mut points = Vec::with_capacity(3 * n);
    for (k, &corner) in ring.iter().enumerate() {
        let (to, from) = (ring[(k + 1) % n] - corner, ring[(k + n - 1) % n] - corner);
        let reach = round.min(0.4 * to.length().min(from.length()));
        let is_flat = -to.dot(from) > FLAT * to.length() * from.length();
        if reach < 0.2 || is_flat {
            points.push(corner);
            continue;
        }
        let start = corner + from.normalize_or_zero() * reach;
        let end = corner + to.normalize_or_zero() * reach;
        // The midpoint of the parabola that touches both sides.
        points.extend([start, 0.5 * corner + 0.25 * (start + end), end]);
    }
    points
}

/// Limit of mitres, relative to the offset of the sides.
pub(super) const MITRE: f64 = 2.0;

/// The ring moved outwards by `by` picture units, or inwards if negative; for clockwise rings (on screen).
pub(super) fn beside(ring: &[DVec2], by: f64) -> Vec<DVec2> {
    let n = ring.len();
    let out = |k: usize| -(ring[(k + 1) % n] - ring[k % n]).normalize_or_zero().perp();
    let moved = |k: usize| {
        let (before, after) = (out(k + n - 1), out(k));
        let mitre = (before + after) / (1.0 + before.dot(after)).max(1e-9);
        ring[k] + by * mitre.clamp_length_max(MITRE)
    };
    (0..n).map(moved).collect()
}

/// The corners of a line with a width; it extends half the width beyond its ends, so that joints close.
pub(super) fn bar([from, to]: [DVec2; 2], width: f64) -> [DVec2; 4] {
    let along = (to - from).normalize_or_zero() * (width / 2.0);
    let across = along.perp();
    [
        from - along - across,
        to + along - across,
        to + along + across,
        from - along + across,
    ]
}
