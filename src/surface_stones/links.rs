//! The graph of neighbouring cells on a surface: those that share a corner of their rings.

use crate::order;
use crate::surface_cells::SurfaceCell;
use glam::DVec3;

/// Corners closer to each other than this part of the mean size are the same.
const SAME: f64 = 1e-5;

/// The neighbours of each cell, as rising indices. If a is a neighbour of b, then b is one of a.
pub fn links(cells: &[SurfaceCell]) -> Vec<Vec<u32>> {
    let side = SAME * super::mean_size(cells);
    // Rounding may put a corner into any of the cubes that touch its own.
    let cube = |p: DVec3| [p.x, p.y, p.z].map(|v| (v / (4.0 * side)).floor() as i64);
    let mut corners: Vec<([i64; 3], u32, DVec3)> = Vec::new();
    for (k, cell) in cells.iter().enumerate() {
        corners.extend(cell.ring.iter().map(|&p| (cube(p), k as u32, p)));
    }
    corners.sort_unstable_by_key(|&(cube, k, _)| (cube, k));
    let mut links = vec![Vec::new(); cells.len()];
    for (k, cell) in cells.iter().enumerate() {
        let own: &mut Vec<u32> = &mut links[k];
        for &p in &cell.ring {
            for near in 0..8 {
                // Along an axis where the corner is near a side of its cube, also take the next cube.
                let reach = DVec3::from([0, 1, 2].map(|axis| f64::from(near >> axis & 1)));
                let [low, high] = [p - side, p + side].map(cube);
                let at = [0, 1, 2].map(|axis| {
                    if reach[axis] > 0.0 {
                        high[axis]
                    } else {
                        low[axis]
                    }
                });
                let is_there = [0, 1, 2].map(|axis| reach[axis] == 0.0 || high[axis] != low[axis]);
                if is_there.contains(&false) {
                    continue;
                }
                let first = corners.partition_point(|c| c.0 < at);
                for &(_, other, q) in corners[first..].iter().take_while(|c| c.0 == at) {
                    if other != k as u32 && (p - q).length() <= side {
                        own.push(other);
                    }
                }
            }
        }
        own.sort_unstable();
        own.dedup();
    }
    links
}

/// The neighbours beyond the sides of a cell: those of its links that share two corners or more with it.
pub fn neighbours(cells: &[SurfaceCell], links: &[Vec<u32>], k: usize) -> Vec<u32> {
    let side = SAME * super::mean_size(cells);
    let ring = &cells[k].ring;
    let is_shared = |p: &&DVec3| ring.iter().any(|q| (**p - *q).length() <= side);
    let shared = |&other: &u32| cells[other as usize].ring.iter().filter(is_shared).count();
    let linked = links.get(k).into_iter().flatten().copied();
    linked.filter(|other| shared(other) > 1).collect()
}

/// Spreads directions from known cells to the others, over the graph. `offer` rates how well the direction of the
/// first cell suits the second; `take` copies it. The best pairs come first.
pub(super) fn spread(
    links: &[Vec<u32>],
    mut is_known: Vec<bool>,
    mut offer: impl FnMut(usize, usize) -> f64,
    mut take: impl FnMut(usize, usize),
) {
    use std::cmp::Reverse;
    let mut due = std::collections::BinaryHeap::new();
    let mut open = |due: &mut std::collections::BinaryHeap<_>, is_known: &[bool], from: usize| {
        for &to in links[from].iter().filter(|&&to| !is_known[to as usize]) {
            let agreement = offer(from, to as usize);
            due.push(Reverse((order::rank(-agreement), to, from as u32)));
        }
    };
    for from in (0..links.len()).filter(|&k| is_known[k]) {
        open(&mut due, &is_known, from);
    }
    while let Some(Reverse((_, to, from))) = due.pop() {
        let (to, from) = (to as usize, from as usize);
        if !is_known[to] {
            take(from, to);
            is_known[to] = true;
            open(&mut due, &is_known, to);
        }
    }
}
