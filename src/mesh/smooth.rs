//! Smoothing: moves nodes so that the quadrilaterals around irregular places become more rectangular.
//!
//! Where rows end the packed centres are in equilibrium, but the elements between them lean. Each
//! quadrilateral proposes for its corners the rectangle that fits it best: around its centre, with diagonals
//! made equally long. A node moves to the mean of the proposals if its elements gain by that, so nothing is
//! ever turned inside out.

use super::quads::{height, score};
use super::{Face, Metric, Node, Nodes};
use crate::csr::Csr;
use glam::DVec3;

/// Passes over the nodes.
const ROUNDS: u32 = 8;
/// A node stays if its proposed move is shorter than this share of the longest diagonal at the node.
const LEAST_MOVE: f64 = 0.01;
/// Cost of a side at 45 degrees to its cell's axis.
const TURNED: f64 = 0.3;
/// A triangle lower than this share of its longest side counts as bad.
const FLAT: f64 = 0.4;

/// Nodes that can be moved: in the plane, with z = 0, or in the tangent planes of a surface.
pub(crate) trait Movable: Nodes {
    /// The place of a node.
    fn place(&self, node: u32) -> DVec3;

    /// Moves a node to a place.
    fn put(&mut self, node: u32, place: DVec3);

    /// The proposal of a quadrilateral for its first corner, and the length of the diagonal through that corner. `None`
    /// if it proposes nothing.
    fn proposal(&self, corners: [u32; 4]) -> Option<(DVec3, f64)>;

    /// The move of a node to the mean of its proposals.
    fn way(&self, node: u32, mean: DVec3) -> DVec3;

    /// Cost of the direction of a side from one node to another.
    fn turned(&self, _from: u32, _to: u32) -> f64 {
        0.0
    }
}

impl Movable for [Node] {
    fn place(&self, node: u32) -> DVec3 {
        self[node as usize].at.extend(0.0)
    }

    fn put(&mut self, node: u32, place: DVec3) {
        self[node as usize].at = place.truncate();
    }

    fn proposal(&self, corners: [u32; 4]) -> Option<(DVec3, f64)> {
        let nodes = self.laid(corners);
        let (by, length) = from_middle(&nodes);
        let [p, q, r, s] = nodes;
        Some((((p.at + q.at + r.at + s.at) / 4.0 + by).extend(0.0), length))
    }

    fn way(&self, node: u32, mean: DVec3) -> DVec3 {
        mean - self.place(node)
    }

    fn turned(&self, from: u32, to: u32) -> f64 {
        let [p, q] = [from, to].map(|k| &self[k as usize]);
        let (side, e) = (q.at - p.at, p.axis);
        let turned = 2.0 * side.dot(e) * side.perp_dot(e) / side.length_squared();
        TURNED * turned * turned
    }
}

/// The vector from the centre of a quadrilateral to the corner of its rectangle at the first node, and the length of
/// the diagonal through that node.
pub(crate) fn from_middle(nodes: &[Node; 4]) -> (glam::DVec2, f64) {
    let [p, q, r, s] = nodes;
    let metric = Metric::mean([p.metric, q.metric, r.metric, s.metric]);
    let (own, other) = (p.at - r.at, q.at - s.at);
    let (length, other) = (metric.length(own), metric.length(other));
    (own * (0.25 * (length + other) / length), length)
}

/// A smoothing in progress.
pub(crate) struct Smoothing {
    /// The elements around each node.
    around: Csr<u32>,
    /// Whether each node may move.
    free: Vec<bool>,
    /// Whether each node is beside one that moved in the last pass; `next` is the same for this pass.
    awake: Vec<bool>,
    next: Vec<bool>,
    round: u32,
    at: usize,
}

impl Smoothing {
    /// Begins with the nodes of these elements. Nodes marked in `free` may move; nodes on the border should not be
    /// marked.
    pub fn new(faces: &[Face], free: Vec<bool>) -> Self {
        let uses = faces.iter().zip(0..);
        let uses = uses.flat_map(|(face, f)| face.nodes().iter().map(move |&k| (k as usize, f)));
        Self {
            around: Csr::from_pairs(free.len(), uses),
            awake: free.clone(),
            next: vec![false; free.len()],
            free,
            round: 0,
            at: 0,
        }
    }

    /// Tries at most this many nodes; true when finished.
    pub fn advance<N: Movable + ?Sized>(
        &mut self,
        nodes: &mut N,
        faces: &[Face],
        mut most: usize,
    ) -> bool {
        while self.round < ROUNDS {
            while self.at < self.free.len() {
                if most == 0 {
                    return false;
                }
                let k = self.at;
                self.at += 1;
                if !self.awake[k] || !self.free[k] {
                    continue;
                }
                most -= 1;
                let around = self.around.row(k);
                if move_one(nodes, faces, around, k as u32) {
                    for &near in around.iter().flat_map(|&f| faces[f as usize].nodes()) {
                        self.next[near as usize] = true;
                    }
                }
            }
            (self.round, self.at) = (self.round + 1, 0);
            std::mem::swap(&mut self.awake, &mut self.next);
            self.next.fill(false);
        }
        true
    }
}

/// Moves a node if that improves its elements.
fn move_one<N: Movable + ?Sized>(nodes: &mut N, faces: &[Face], around: &[u32], k: u32) -> bool {
    let (mut sum, mut count, mut longest) = (DVec3::ZERO, 0u32, 0.0_f64);
    for &f in around {
        let [a, b, c, d] = *faces[f as usize].nodes() else {
            continue;
        };
        let corners = [a, b, c, d];
        let place = corners.iter().position(|&c| c == k).unwrap_or(0);
        let corners = [0, 1, 2, 3].map(|j| corners[(place + j) % 4]);
        if let Some((proposal, length)) = nodes.proposal(corners) {
            sum += proposal;
            longest = longest.max(length);
            count += 1;
        }
    }
    if count == 0 {
        return false;
    }
    let by = nodes.way(k, sum / f64::from(count));
    if by.length() < LEAST_MOVE * longest {
        return false;
    }
    let old = nodes.place(k);
    let before = worth(nodes, faces, around);
    for pace in [1.0, 0.4] {
        nodes.put(k, old + pace * by);
        if worth(nodes, faces, around) > before {
            return true;
        }
    }
    nodes.put(k, old);
    false
}

/// The sum of the elements' quality; bad elements weigh more.
fn worth<N: Movable + ?Sized>(nodes: &N, faces: &[Face], around: &[u32]) -> f64 {
    let mut sum = 0.0;
    for &f in around {
        match *faces[f as usize].nodes() {
            [a, b, c, d] => {
                let lack = 1.0 - score(nodes, [a, b, c, d]);
                sum -= lack + lack * lack;
                for (from, to) in [(a, b), (b, c), (c, d), (d, a)] {
                    sum -= nodes.turned(from, to);
                }
            }
            [a, b, c] => {
                sum -= 4.0 * (FLAT - height(nodes, [a, b, c])).max(0.0);
            }
            _ => {}
        }
    }
    sum
}
