//! Finds the segments near a box with an R-tree, packed strip by strip (Leutenegger, Edgington, Lopez 1997,
//! STR: a simple and efficient algorithm for R-tree packing).

use crate::order;
use glam::DVec2;
use std::ops::Range;

/// The number of boxes within a box.
const BRANCHES: usize = 4;
/// About the number of leaves in a strip, divided by the number of strips.
const STRIP: f64 = 4.0;

/// The smallest and the largest corner.
type Corners = [DVec2; 2];

/// An R-tree over the bounding boxes of segments. It serves segments far apart as well as close ones: only the order of
/// their places matters, not the distances.
pub(super) struct RTree {
    /// The segments, in the order of the leaves.
    order: Vec<u32>,
    levels: Vec<Vec<Corners>>,
}

impl RTree {
    pub fn new(segments: &[[DVec2; 2]]) -> Self {
        let order = in_strips(segments);
        let around = |&k: &u32| {
            let [a, b] = segments[k as usize];
            [a.min(b), a.max(b)]
        };
        let mut levels: Vec<Vec<Corners>> = vec![order.iter().map(around).collect()];
        while levels[levels.len() - 1].len() > BRANCHES {
            let below = levels[levels.len() - 1].chunks(BRANCHES);
            levels.push(below.map(joined).collect());
        }
        Self { order, levels }
    }

    /// Collects the numbers of the segments whose boxes meet this box.
    pub fn near(&self, lo: DVec2, hi: DVec2, found: &mut Vec<u32>) {
        found.clear();
        let top = self.levels.len() - 1;
        self.search((top, 0..self.levels[top].len()), [lo, hi], found);
    }

    /// Searches these boxes of a level, the last one first.
    fn search(
        &self,
        (level, these): (usize, Range<usize>),
        [lo, hi]: Corners,
        found: &mut Vec<u32>,
    ) {
        for k in these.rev() {
            let [low, high] = self.levels[level][k];
            if low.cmpgt(hi).any() || high.cmplt(lo).any() {
                continue;
            }
            if level == 0 {
                found.push(self.order[k]);
            } else {
                let end = self.levels[level - 1].len().min((k + 1) * BRANCHES);
                self.search((level - 1, k * BRANCHES..end), [lo, hi], found);
            }
        }
    }
}

/// Sorts segments into strips, and each strip from top to bottom, so that neighbours in the list are
/// neighbours in the plane.
fn in_strips(segments: &[[DVec2; 2]]) -> Vec<u32> {
    let middle = |k: u32| segments[k as usize][0].midpoint(segments[k as usize][1]);
    let mut order: Vec<u32> = (0..segments.len() as u32).collect();
    order::sort(&mut order, |&k| (order::rank(middle(k).x), 0));
    let strip = (STRIP * segments.len() as f64).sqrt().ceil().max(1.0);
    for strip in order.chunks_mut(strip as usize) {
        order::sort(strip, |&k| (order::rank(middle(k).y), 0));
    }
    order
}

fn joined(boxes: &[Corners]) -> Corners {
    let first = boxes[0];
    let join = |[lo, hi]: Corners, [l, h]: &Corners| [lo.min(*l), hi.max(*h)];
    boxes.iter().fold(first, join)
}
