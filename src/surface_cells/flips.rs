//! Delaunay flips on a surface.
//!
//! A side is flipped if the other diagonal is better in the plane and the metric of its four nodes. These depend on
//! the four nodes alone, so flips cannot run in circles.

use super::nodes::SurfaceNodes;
use crate::mesh::Nodes;
use crate::mesh::triangles::{MOST_FLIPS, Triangles, wants_flip};
use crate::trimesh::NONE;

/// Sides to look at in a slice.
const SIDES: usize = 8000;
/// The fewest sides that an inner node keeps.
const FEWEST: u32 = 3;

/// Flips that are under way.
pub(super) struct Flips {
    /// Sides still to look at: a triangle, and the corner opposite the side.
    open: Vec<[u32; 2]>,
    left: usize,
    /// The number of sides at each node.
    valence: Vec<u32>,
    is_inner: Vec<bool>,
}

impl Flips {
    /// Starts with these triangles; nothing is flipped yet.
    pub fn new(nodes: &SurfaceNodes, triangles: &Triangles) -> Self {
        let mut flips = Self {
            open: Vec::with_capacity(2 * triangles.nodes.len()),
            left: MOST_FLIPS * triangles.nodes.len(),
            valence: vec![0; nodes.count()],
            is_inner: vec![true; nodes.count()],
        };
        for (t, (corners, adjacent)) in triangles.nodes.iter().zip(&triangles.adjacent).enumerate()
        {
            for k in 0..3 {
                flips.valence[corners[k] as usize] += 1;
                if adjacent[k] == NONE {
                    flips.is_inner[corners[(k + 1) % 3] as usize] = false;
                    flips.is_inner[corners[(k + 2) % 3] as usize] = false;
                } else if t as u32 <= adjacent[k] {
                    flips.open.push([t as u32, k as u32]);
                }
            }
        }
        flips.open.reverse();
        flips
    }

    /// Does one more slice; true when done.
    pub fn advance(&mut self, nodes: &SurfaceNodes, triangles: &mut Triangles) -> bool {
        for _ in 0..SIDES {
            let Some([t, k]) = self.open.pop() else {
                return true;
            };
            self.try_flip(nodes, triangles, t, k as usize);
        }
        false
    }

    fn try_flip(&mut self, nodes: &SurfaceNodes, triangles: &mut Triangles, t: u32, k: usize) {
        let u = triangles.adjacent[t as usize][k];
        if u == NONE || u == t || self.left == 0 {
            return;
        }
        let [c, a, b] = [0, 1, 2].map(|s| triangles.nodes[t as usize][(k + s) % 3]);
        let Some(j) = facing(triangles, u, [b, a]) else {
            return;
        };
        let d = triangles.nodes[u as usize][j];
        // A flip gives a further side to an inner node with fewer than three. It takes none from a node that has only
        // three.
        let is_lens = [c, d].iter().any(|&k| self.is_lens(k));
        let is_spare = |k: u32| !self.is_inner[k as usize] || self.valence[k as usize] > FEWEST;
        if c == d
            || !is_spare(a)
            || !is_spare(b)
            || !(is_lens || wants_flip(&nodes.laid([c, a, d, b])))
            || is_joined(triangles, [t, u], c, d)
        {
            return;
        }
        self.left -= 1;
        flip(triangles, [t, u], [k, j]);
        for n in [a, b] {
            self.valence[n as usize] -= 1;
        }
        for n in [c, d] {
            self.valence[n as usize] += 1;
        }
        self.open.extend([[t, 0], [t, 2], [u, 0], [u, 2]]);
    }

    /// Whether this is an inner node with fewer than three sides.
    pub fn is_lens(&self, node: u32) -> bool {
        self.is_inner[node as usize] && self.valence[node as usize] < FEWEST
    }
}

/// The corner of `u` whose opposite side goes from one node to another.
fn facing(triangles: &Triangles, u: u32, [from, to]: [u32; 2]) -> Option<usize> {
    let corners = &triangles.nodes[u as usize];
    (0..3).find(|&j| corners[(j + 1) % 3] == from && corners[(j + 2) % 3] == to)
}

/// Whether a side joins `c`, a node of one of the two triangles, to `d`.
fn is_joined(triangles: &Triangles, both: [u32; 2], c: u32, d: u32) -> bool {
    // Go around the node one way and, if that ends at a border, the other way.
    for way in [1, 2] {
        let mut at = both[0];
        loop {
            let corners = &triangles.nodes[at as usize];
            if corners.contains(&d) {
                return true;
            }
            let Some(k) = corners.iter().position(|&n| n == c) else {
                return false;
            };
            at = triangles.adjacent[at as usize][(k + way) % 3];
            if at == both[0] {
                return false;
            }
            if at == NONE {
                break;
            }
        }
    }
    false
}

/// Replaces the side between `t` (opposite its corner `k`) and `u` (opposite its corner `j`) by the other diagonal:
/// `t` becomes (c, a, d), `u` (d, b, c). Unlike the flip in the plane, this one allows two triangles that share two
/// nodes more than once.
fn flip(triangles: &mut Triangles, [t, u]: [u32; 2], [k, j]: [usize; 2]) {
    let nodes = |t: u32, k: usize| triangles.nodes[t as usize][k % 3];
    let sides = |t: u32, k: usize| triangles.adjacent[t as usize][k % 3];
    let (c, a, b, d) = (nodes(t, k), nodes(t, k + 1), nodes(t, k + 2), nodes(u, j));
    let (bc, ca) = (sides(t, k + 1), sides(t, k + 2));
    let (ad, db) = (sides(u, j + 1), sides(u, j + 2));
    triangles.nodes[t as usize] = [c, a, d];
    triangles.adjacent[t as usize] = [ad, u, ca];
    triangles.nodes[u as usize] = [d, b, c];
    triangles.adjacent[u as usize] = [bc, t, db];
    for (outer, side, new) in [(bc, [c, b], u), (ad, [d, a], t)] {
        if outer != NONE
            && let Some(place) = facing(triangles, outer, side)
        {
            triangles.adjacent[outer as usize][place] = new;
        }
    }
}
