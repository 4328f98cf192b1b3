//! Moves nodes of the mesh so that the quadrilaterals around irregular places become more rectangular. As in
//! `crate::mesh`, each quadrilateral pulls its corners towards the rectangle that fits it best.
//!
//! Nodes stay in the tangent planes of their centres during the work, and walk to their final places at the end.

use super::nodes::SurfaceNodes;
use crate::mesh::quads::{height, score};
use crate::mesh::{Face, Metric, Nodes};
use crate::trimesh::TriMesh;
use glam::{DVec2, DVec3};

/// Passes over the nodes.
const ROUNDS: u32 = 8;
/// A node that would move less than this (in diagonals) stays.
const LEAST_MOVE: f64 = 0.01;
/// A triangle whose height is less than this share of its longest side gains nothing from moves.
const FLAT: f64 = 0.4;
/// Nodes to try in a slice.
const TRIED: usize = 600;

/// Nodes that are being moved.
pub(super) struct Smoothing {
    /// The elements around each node.
    start: Vec<u32>,
    uses: Vec<u32>,
    /// Marks nodes that may move: the inner ones.
    free: Vec<bool>,
    /// Marks nodes beside one that has moved, in the last round and in this one.
    awake: Vec<bool>,
    next: Vec<bool>,
    round: u32,
    at: usize,
}

impl Smoothing {
    /// Starts with these elements; `free` marks the nodes that may move.
    pub fn new(faces: &[Face], free: Vec<bool>) -> Self {
        let count = free.len();
        let mut start = vec![0u32; count + 1];
        for &k in faces.iter().flat_map(Face::nodes) {
            start[k as usize + 1] += 1;
        }
        for k in 1..start.len() {
            start[k] += start[k - 1];
        }
        let mut uses = vec![0u32; start[count] as usize];
        let mut at = start.clone();
        for (f, face) in faces.iter().enumerate() {
            for &k in face.nodes() {
                uses[at[k as usize] as usize] = f as u32;
                at[k as usize] += 1;
            }
        }
        Self {
            start,
            uses,
            awake: free.clone(),
            next: vec![false; count],
            free,
            round: 0,
            at: 0,
        }
    }

    /// Does one more slice; true when done.
    pub fn advance(&mut self, nodes: &mut SurfaceNodes, faces: &[Face]) -> bool {
        let mut left = TRIED;
        while self.round < ROUNDS {
            while self.at < self.free.len() {
                if left == 0 {
                    return false;
                }
                let k = self.at;
                self.at += 1;
                if !self.awake[k] || !self.free[k] {
                    continue;
                }
                left -= 1;
                let around = &self.uses[self.start[k] as usize..self.start[k + 1] as usize];
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

/// Moves a node if that improves its elements; true if it has moved.
fn move_one(nodes: &mut SurfaceNodes, faces: &[Face], around: &[u32], k: u32) -> bool {
    let (mut sum, mut count, mut longest) = (DVec3::ZERO, 0.0, 0.0_f64);
    for &f in around {
        let [a, b, c, d] = *faces[f as usize].nodes() else {
            continue;
        };
        let corners = [a, b, c, d];
        let place = corners.iter().position(|&c| c == k).unwrap_or(0);
        let corners = [0, 1, 2, 3].map(|j| corners[(place + j) % 4]);
        let Some((frame, [p, q, r, s])) = nodes.plane(corners) else {
            continue;
        };
        let metric = Metric::mean([p.metric, q.metric, r.metric, s.metric]);
        let (own, other) = (p.at - r.at, q.at - s.at);
        let (length, other) = (metric.length(own), metric.length(other));
        let middle: DVec2 = (p.at + q.at + r.at + s.at) / 4.0;
        let asked = middle + own * (0.25 * (length + other) / length) - p.at;
        sum += frame.out(asked);
        longest = longest.max(length);
        count += 1.0;
    }
    let normal = nodes.points[k as usize].normal;
    let by = sum / f64::max(count, 1.0);
    let by = by - normal * normal.dot(by);
    if count == 0.0 || by.length() < LEAST_MOVE * longest {
        return false;
    }
    let old = nodes.points[k as usize].at;
    let before = worth(nodes, faces, around);
    for pace in [1.0, 0.4] {
        nodes.points[k as usize].at = old + pace * by;
        if worth(nodes, faces, around) > before {
            return true;
        }
    }
    nodes.points[k as usize].at = old;
    false
}

/// The sum of the elements' quality; bad ones count more.
fn worth<N: Nodes>(nodes: &N, faces: &[Face], around: &[u32]) -> f64 {
    let each = around.iter().map(|&f| match *faces[f as usize].nodes() {
        [a, b, c, d] => {
            let lack = 1.0 - score(nodes, [a, b, c, d]);
            -lack - lack * lack
        }
        [a, b, c] => -4.0 * (FLAT - height(nodes, [a, b, c])).max(0.0),
        _ => 0.0,
    });
    each.sum()
}

/// Walks nodes from the cells' centres to their new places.
pub(super) fn settle(
    mesh: &TriMesh,
    nodes: &mut SurfaceNodes,
    from: usize,
    to: usize,
    home: impl Fn(usize) -> crate::trimesh::SurfacePoint,
) {
    for k in from..to {
        let start = home(k);
        let by = nodes.points[k].at - start.at;
        if by != DVec3::ZERO {
            nodes.points[k] = mesh.walk(&start, start.frame().within(by)).to;
        }
    }
}
