//! The triangulation: Delaunay (spade), then flipped to be Delaunay in the local metric.

pub(crate) use crate::csr::NONE;

use super::metric::Metric;
use super::{Node, Nodes};
use crate::planar::{Delaunay, insert};
use glam::DVec2;
use spade::{Point2, Triangulation as _};

/// Most flips for each triangle: where the metric turns within a few cells, flips can cycle.
pub(crate) const MOST_FLIPS: usize = 4;
/// An edge is flipped if its opposite angles add up to more than 180 degrees by this (their sine), so that
/// ties stay.
const TIE: f64 = 1e-9;

/// Triangles with positive shoelace area, and their adjacency.
#[derive(Clone, Debug, Default)]
pub(crate) struct Triangles {
    pub nodes: Vec<[u32; 3]>,
    /// The triangle across the side opposite to each node; [`NONE`] at the border.
    pub adjacent: Vec<[u32; 3]>,
}

/// Points inserted in one slice of the work.
const POINTS: usize = 2000;

/// The Delaunay triangulation of nodes, which are inserted one by one, in slices.
pub(crate) struct IncrementalDelaunay {
    nodes: Vec<Node>,
    mesh: Delaunay,
    /// The node at each vertex.
    node_of: Vec<u32>,
    inserted: usize,
}

impl IncrementalDelaunay {
    /// Starts with no node inserted.
    pub fn new(nodes: Vec<Node>) -> Self {
        Self {
            node_of: Vec::with_capacity(nodes.len()),
            nodes,
            mesh: Delaunay::default(),
            inserted: 0,
        }
    }

    /// Inserts some more nodes; true when all are inserted.
    pub fn advance(&mut self) -> bool {
        let end = self.nodes.len().min(self.inserted + POINTS);
        // In the order given, so that handles tell coinciding points apart.
        for k in self.inserted..end {
            let at = self.nodes[k].at;
            if let Some(handle) = insert(&mut self.mesh, Point2::new(at.x, at.y))
                && handle.index() == self.node_of.len()
            {
                self.node_of.push(k as u32);
            }
        }
        self.inserted = end;
        end == self.nodes.len()
    }

    /// The nodes and their triangles; inserts the remaining nodes at once.
    pub fn finish(mut self) -> (Vec<Node>, Triangles) {
        while !self.advance() {}
        let triangles = Triangles::read(&self.mesh, &self.node_of);
        (self.nodes, triangles)
    }
}

impl Triangles {
    /// Reads Delaunay triangles in an order that depends on the points only. Points that coincide with an
    /// earlier one get no triangle.
    fn read(mesh: &Delaunay, node_of: &[u32]) -> Self {
        let mut made = Self::default();
        // Spade winds anticlockwise with y up, which gives a positive shoelace area in our coordinates. Its
        // face 0 is the outer one.
        for face in mesh.inner_faces() {
            let sides = face.adjacent_edges();
            made.nodes
                .push(sides.map(|e| node_of[e.from().fix().index()]));
            let across = |k: usize| {
                let other = sides[(k + 1) % 3].rev().face();
                other
                    .as_inner()
                    .map_or(NONE, |f| f.fix().index() as u32 - 1)
            };
            made.adjacent.push([across(0), across(1), across(2)]);
        }
        made
    }

    /// Keeps the triangles for which `good` holds.
    pub fn retain(&mut self, good: impl Fn(&[u32; 3]) -> bool) {
        let mut kept = 0;
        let mut new = Vec::with_capacity(self.nodes.len());
        for nodes in &self.nodes {
            let stays = good(nodes);
            new.push(if stays { kept } else { NONE });
            kept += u32::from(stays);
        }
        let mut k = 0;
        self.nodes.retain(|_| {
            k += 1;
            new[k - 1] != NONE
        });
        k = 0;
        self.adjacent.retain(|_| {
            k += 1;
            new[k - 1] != NONE
        });
        for t in self.adjacent.iter_mut().flatten() {
            if *t != NONE {
                *t = new[*t as usize];
            }
        }
    }

    /// The side of `t` that borders on `u`.
    pub fn side_towards(&self, t: u32, u: u32) -> usize {
        let adjacent = &self.adjacent[t as usize];
        (0..3).find(|&k| adjacent[k] == u).unwrap_or(0)
    }

    /// Lawson's flips in the local metric. The triangulation becomes Delaunay in it where possible, and is
    /// valid wherever the flips stop. Sides for which `keep` holds are not flipped.
    pub fn flip_to_metric(&mut self, nodes: &[Node], keep: impl Fn([u32; 2]) -> bool) {
        if nodes.iter().all(|n| n.metric == Metric::EUCLIDEAN) {
            return;
        }
        let mut open: Vec<[u32; 2]> = Vec::new();
        for t in (0..self.nodes.len() as u32).rev() {
            open.extend((0..3).map(|k| [t, k]));
        }
        let mut left = MOST_FLIPS * self.nodes.len();
        while let Some([t, k]) = open.pop() {
            let (t, k) = (t as usize, k as usize);
            let u = self.adjacent[t][k];
            if u == NONE || left == 0 {
                continue;
            }
            let [c, a, b] = [0, 1, 2].map(|s| self.nodes[t][(k + s) % 3]);
            let j = self.side_towards(u, t as u32);
            let d = self.nodes[u as usize][j];
            if keep([a.min(b), a.max(b)]) || !wants_flip(&nodes.laid([c, a, d, b])) {
                continue;
            }
            left -= 1;
            self.flip(t as u32, k, u, j);
            open.extend([[t as u32, 0], [t as u32, 2], [u, 0], [u, 2]]);
        }
    }

    /// Replaces the side between `t` (opposite to its node `k`) and `u` (opposite to its node `j`) by the
    /// other diagonal: `t` becomes (c, a, d), `u` (d, b, c).
    fn flip(&mut self, t: u32, k: usize, u: u32, j: usize) {
        let at = |t: u32, k: usize| (t as usize, k % 3);
        let node = |(t, k): (usize, usize)| self.nodes[t][k];
        let side = |(t, k): (usize, usize)| self.adjacent[t][k];
        let (c, a, b) = (node(at(t, k)), node(at(t, k + 1)), node(at(t, k + 2)));
        let d = node(at(u, j));
        // The neighbours across b-c and c-a of `t`, and across a-d and d-b of `u`.
        let (bc, ca) = (side(at(t, k + 1)), side(at(t, k + 2)));
        let (ad, db) = (side(at(u, j + 1)), side(at(u, j + 2)));
        self.nodes[t as usize] = [c, a, d];
        self.adjacent[t as usize] = [ad, u, ca];
        self.nodes[u as usize] = [d, b, c];
        self.adjacent[u as usize] = [bc, t, db];
        for (outer, old, new) in [(ad, u, t), (bc, t, u)] {
            if outer != NONE {
                let side = self.side_towards(outer, old);
                self.adjacent[outer as usize][side] = new;
            }
        }
    }
}

/// Whether the diagonal from `c` to `d` of the quadrilateral c, a, d, b is better than that from a to b.
pub(crate) fn wants_flip([c, a, d, b]: &[Node; 4]) -> bool {
    let metric = Metric::mean([c.metric, a.metric, d.metric, b.metric]);
    let (u, v) = (a.at - c.at, b.at - c.at);
    let (p, q) = (b.at - d.at, a.at - d.at);
    let (at_c, at_d) = (u.perp_dot(v), p.perp_dot(q));
    let sum = at_c * metric.dot(p, q) + at_d * metric.dot(u, v);
    let scale = metric.length(u) * metric.length(v) * metric.length(p) * metric.length(q);
    sum < -TIE * scale && is_convex(c.at, a.at, d.at) && is_convex(d.at, b.at, c.at)
}

/// Whether the triangle has a positive area, beyond rounding.
fn is_convex(a: DVec2, b: DVec2, c: DVec2) -> bool {
    let (u, v) = (b - a, c - a);
    u.perp_dot(v) > TIE * (u.length_squared() + v.length_squared())
}
