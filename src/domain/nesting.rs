//! Nesting of rings.

use super::ring::{bounds, ring_contains};
use glam::DVec2;

/// For each ring, the numbers of the rings around it, in rising order. A ring with an even number of them is
/// an outer ring, with an odd number a hole. The rings should not meet; an empty ring is inside none.
pub(super) fn around(rings: &[Vec<DVec2>]) -> Vec<Vec<u32>> {
    let boxes: Vec<(DVec2, DVec2)> = rings.iter().map(|ring| bounds(ring)).collect();
    let rings_around = |ring: &Vec<DVec2>| {
        let Some(&p) = ring.first() else {
            return Vec::new();
        };
        // A ring is not tested against itself: its first point would be in or out by chance.
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

/// For each ring, the outer ring of the island whose rim it is: itself, or for a hole the innermost outer
/// ring around it. The rings must not meet.
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
