//! Which ring lies inside which.

use super::ring::{bounds, ring_contains};
use glam::DVec2;

/// For each ring the numbers of the rings around it, in rising order. An even number of them makes it
/// an outer ring, an odd one a hole. The rings should not meet; an empty one is inside none.
pub(super) fn around(rings: &[Vec<DVec2>]) -> Vec<Vec<u32>> {
    let boxes: Vec<(DVec2, DVec2)> = rings.iter().map(|ring| bounds(ring)).collect();
    let rings_around = |ring: &Vec<DVec2>| {
        let Some(&p) = ring.first() else {
            return Vec::new();
        };
        // Of itself a ring holds its first point or not, by chance.
        let holds = |k: usize| {
            let (lo, hi) = boxes[k];
            let near = p.cmpge(lo).all() && p.cmple(hi).all();
            near && !std::ptr::eq(&rings[k], ring) && ring_contains(&rings[k], p)
        };
        (0..rings.len())
            .filter(|&k| holds(k))
            .map(|k| k as u32)
            .collect()
    };
    rings.iter().map(rings_around).collect()
}

/// For each ring the ring that its paved side belongs to: an outer ring itself, for a hole the
/// innermost outer ring around it. The rings must not meet.
pub(super) fn owners(rings: &[Vec<DVec2>]) -> Vec<usize> {
    let around = around(rings);
    let owner = |(ring, outside): (usize, &Vec<u32>)| {
        if outside.len().is_multiple_of(2) {
            return ring;
        }
        let innermost = outside.iter().map(|&k| k as usize);
        innermost.max_by_key(|&k| around[k].len()).unwrap_or(ring)
    };
    around.iter().enumerate().map(owner).collect()
}
