//! The graph of neighbouring cells on a surface: those that share a corner of their rings.

use crate::order;
use crate::surface_cells::SurfaceCell;
use glam::DVec3;

/// Corners closer to each other than this part of the mean size are the same.
const SAME: f64 = 1e-5;

/// The neighbours of each cell, as rising indices. If a is a neighbour of b, then b is one of a.
pub fn links(cells: &[SurfaceCell]) -> Vec<Vec<u32>> {
    let grid = CornerGrid::new(cells);
    let linked = |(k, cell): (usize, &SurfaceCell)| {
        let near = cell.ring.iter().flat_map(|&p| grid.near(p));
        let mut own: Vec<u32> = near.filter(|&other| other as usize != k).collect();
        own.sort_unstable();
        own.dedup();
        own
    };
    cells.iter().enumerate().map(linked).collect()
}

/// The corners of all cells, to find those that are the same.
struct CornerGrid {
    /// Corners at most this far apart are the same.
    side: f64,
    /// Corners with their cubes and cells, sorted by these.
    corners: Vec<([i64; 3], u32, DVec3)>,
}

impl CornerGrid {
    fn new(cells: &[SurfaceCell]) -> Self {
        let mut grid = Self {
            side: SAME * super::mean_size(cells),
            corners: Vec::new(),
        };
        for (k, cell) in (0..).zip(cells) {
            for &p in &cell.ring {
                grid.corners.push((grid.cube(p), k, p));
            }
        }
        grid.corners.sort_unstable_by_key(|&(cube, k, _)| (cube, k));
        grid
    }

    /// The cube of a place. Cubes are so large that places near it lie in at most two along each axis.
    fn cube(&self, p: DVec3) -> [i64; 3] {
        p.to_array().map(|v| (v / (4.0 * self.side)).floor() as i64)
    }

    /// The cells with a corner at a place, once for each such corner.
    fn near(&self, p: DVec3) -> impl Iterator<Item = u32> {
        let [low, high] = [p - self.side, p + self.side].map(|p| self.cube(p));
        cubes(low, high)
            .flat_map(|cube| self.within(cube))
            .filter(move |(_, _, q)| (p - q).length() <= self.side)
            .map(|&(_, cell, _)| cell)
    }

    fn within(&self, cube: [i64; 3]) -> impl Iterator<Item = &([i64; 3], u32, DVec3)> {
        let first = self.corners.partition_point(|c| c.0 < cube);
        let rest = self.corners[first..].iter();
        rest.take_while(move |c| c.0 == cube)
    }
}

/// All cubes from one to another.
fn cubes(low: [i64; 3], high: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    let [x, y, z] = [0, 1, 2].map(|axis| low[axis]..=high[axis]);
    let flat = x.flat_map(move |x| y.clone().map(move |y| [x, y]));
    flat.flat_map(move |[x, y]| z.clone().map(move |z| [x, y, z]))
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
