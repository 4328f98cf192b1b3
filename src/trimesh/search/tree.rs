//! The search tree: boxes over the triangles in the order of a Morton curve.

use super::super::TriMesh;
use super::super::sorting::Sorting;
use crate::order::{greater, lesser};
use glam::DVec3;

/// Triangles in a leaf.
const LEAF: usize = 8;
/// The curve has 2^BITS steps along each axis. The bits of the three axes together take three rounds of the sort.
const BITS: u32 = 10;
/// Rounding may make the distance to a box too large by less than this factor.
pub(super) const SLACK: f64 = 1.0 + 1e-12;

/// Room for the open nodes of a search: one on each level, in the largest tree.
const DEEP: usize = 24;

/// The search tree of one mesh.
#[derive(Clone, Debug)]
pub struct Search {
    pub(super) triangles: Vec<u32>,
    /// The tree as a heap: the box of node k holds those of nodes 2k and 2k + 1. The last half are the leaves.
    boxes: Vec<(DVec3, DVec3)>,
    stage: TreeStage,
    at: usize,
}

/// A search tree in progress.
#[derive(Clone, Debug)]
enum TreeStage {
    /// The codes of the triangles along the curve, with their indices.
    Codes(Vec<(u64, u32)>),
    Sort(Sorting),
    Leaves,
    /// The boxes of the tree are made, from the leaves up.
    Up,
    Done,
}

/// Nodes that are still to be searched, each with a lower bound of its distance (squared for the nearest place).
pub(super) struct OpenNodes(Vec<(f64, usize)>);

impl OpenNodes {
    /// The root.
    pub fn new() -> Self {
        let mut nodes = Vec::with_capacity(DEEP);
        nodes.push((0.0, 1));
        Self(nodes)
    }

    /// Takes the node to be searched next.
    pub fn pop(&mut self) -> Option<(f64, usize)> {
        self.0.pop()
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Opens the children of a node, the nearer one to be searched first. Children at infinity are left out.
    pub fn split(&mut self, node: usize, far: impl Fn(usize) -> f64) {
        let (a, b) = (2 * node, 2 * node + 1);
        let (to_a, to_b) = (far(a), far(b));
        let (farther, nearer) = if to_a < to_b {
            ((to_b, b), (to_a, a))
        } else {
            ((to_a, a), (to_b, b))
        };
        for child in [farther, nearer] {
            if child.0 < f64::INFINITY {
                self.0.push(child);
            }
        }
    }
}

const NOTHING: (DVec3, DVec3) = (DVec3::INFINITY, DVec3::NEG_INFINITY);

impl Search {
    /// Makes the whole tree; [`Search::begin`] and [`Search::advance`] make it in slices.
    pub fn new(mesh: &TriMesh) -> Self {
        let mut search = Self::begin(mesh);
        while !search.advance(mesh, usize::MAX) {}
        search
    }

    /// Starts an empty tree.
    pub fn begin(mesh: &TriMesh) -> Self {
        let count = mesh.triangles().len();
        let leaves = count.div_ceil(LEAF).next_power_of_two();
        Self {
            triangles: Vec::with_capacity(count),
            boxes: vec![NOTHING; 2 * leaves],
            stage: TreeStage::Codes(Vec::with_capacity(count)),
            at: 0,
        }
    }

    /// Works on at most `amount` triangles; true when the tree is complete.
    pub fn advance(&mut self, mesh: &TriMesh, amount: usize) -> bool {
        let leaves = self.leaf_count();
        // How many triangles, leaves or boxes the stage works on. The sort makes its own slices.
        let all = match self.stage {
            TreeStage::Codes(_) => mesh.triangles().len(),
            TreeStage::Leaves => leaves,
            TreeStage::Up => leaves - 1,
            TreeStage::Sort(_) | TreeStage::Done => 0,
        };
        let end = all.min(self.at.saturating_add(amount.max(1)));
        self.stage = match std::mem::replace(&mut self.stage, TreeStage::Done) {
            TreeStage::Codes(mut codes) => {
                push_codes(mesh, end, &mut codes);
                match end == all {
                    true => TreeStage::Sort(Sorting::new(codes)),
                    false => TreeStage::Codes(codes),
                }
            }
            TreeStage::Sort(mut sorting) => match sorting.advance() {
                Some(sorted) => {
                    self.triangles.extend(sorted.iter().map(|&(_, t)| t));
                    TreeStage::Leaves
                }
                None => TreeStage::Sort(sorting),
            },
            TreeStage::Leaves => {
                self.leaves(mesh, end);
                if end == all {
                    TreeStage::Up
                } else {
                    TreeStage::Leaves
                }
            }
            TreeStage::Up => {
                self.up(end);
                if end == all {
                    TreeStage::Done
                } else {
                    TreeStage::Up
                }
            }
            TreeStage::Done => TreeStage::Done,
        };
        self.at = if end == all { 0 } else { end };
        matches!(self.stage, TreeStage::Done)
    }

    fn leaves(&mut self, mesh: &TriMesh, end: usize) {
        let leaves = self.leaf_count();
        for leaf in self.at..end {
            let mut all = NOTHING;
            for &t in self.leaf(leaf) {
                for p in mesh.corners(t) {
                    all = (all.0.min(p), all.1.max(p));
                }
            }
            self.boxes[leaves + leaf] = all;
        }
    }

    fn up(&mut self, end: usize) {
        let leaves = self.leaf_count();
        for node in self.at..end {
            let node = leaves - 1 - node;
            let [a, b] = [self.boxes[2 * node], self.boxes[2 * node + 1]];
            self.boxes[node] = (a.0.min(b.0), a.1.max(b.1));
        }
    }

    /// The number of leaves. Nodes from this number on are leaves.
    pub(super) fn leaf_count(&self) -> usize {
        self.boxes.len() / 2
    }

    /// The triangles of a leaf.
    pub(super) fn leaf(&self, leaf: usize) -> &[u32] {
        let count = self.triangles.len();
        &self.triangles[(leaf * LEAF).min(count)..((leaf + 1) * LEAF).min(count)]
    }

    /// Whether `test` is true for a triangle near `p`. It is called for all triangles that are at most `radius` away,
    /// and for some others, until it returns true.
    pub fn any_within(&self, p: DVec3, radius: f64, mut test: impl FnMut(u32) -> bool) -> bool {
        let mut open = vec![1];
        let leaves = self.leaf_count();
        while let Some(node) = open.pop() {
            if self.square(node, p) > radius * radius * SLACK {
                continue;
            }
            if node < leaves {
                open.extend([2 * node, 2 * node + 1]);
            } else if self.leaf(node - leaves).iter().any(|&t| test(t)) {
                return true;
            }
        }
        false
    }

    /// The square of the distance from a point to a box; infinity for an empty box.
    pub(super) fn square(&self, node: usize, p: DVec3) -> f64 {
        let (lo, hi) = self.boxes[node];
        if lo.x > hi.x {
            return f64::INFINITY;
        }
        p.distance_squared(p.max(lo).min(hi))
    }

    /// Where a ray enters a box; infinity if it misses it.
    pub(super) fn entry(&self, node: usize, from: DVec3, inverse: DVec3) -> f64 {
        let (lo, hi) = self.boxes[node];
        let (mut first, mut last) = (0.0_f64, f64::INFINITY);
        for k in 0..3 {
            if inverse[k].is_finite() {
                let (a, b) = (
                    (lo[k] - from[k]) * inverse[k],
                    (hi[k] - from[k]) * inverse[k],
                );
                first = greater(first, lesser(a, b) / SLACK);
                last = lesser(last, greater(a, b) * SLACK);
            } else if from[k] < lo[k] || from[k] > hi[k] {
                return f64::INFINITY;
            }
        }
        if first <= last { first } else { f64::INFINITY }
    }
}

/// Adds the codes of triangles along the curve, up to the triangle `end`.
fn push_codes(mesh: &TriMesh, end: usize, codes: &mut Vec<(u64, u32)>) {
    let (lo, hi) = mesh.bounds();
    let side = (hi - lo).max_element().max(f64::MIN_POSITIVE);
    let most = ((1 << BITS) - 1) as f64;
    for t in codes.len() as u32..end as u32 {
        let [a, b, c] = mesh.corners(t);
        let place = ((a + b + c) / 3.0 - lo) / side * most;
        let [x, y, z] = place.to_array().map(|x| spread(x as u32));
        codes.push((u64::from(x | y << 1 | z << 2), t));
    }
}

/// Puts two zero bits between neighbouring bits.
fn spread(x: u32) -> u32 {
    let mut spread = 0;
    for bit in 0..BITS {
        spread |= (x >> bit & 1) << (3 * bit);
    }
    spread
}
