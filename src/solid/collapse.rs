//! Collapses of edges, one by one, by their costs.
//!
//! Garland, Heckbert (1997), Surface Simplification Using Quadric Error Metrics: each vertex has the planes of the
//! triangles that it stands for, and the edge goes first whose one new vertex is least off all these planes. Where that
//! vertex lies, what it costs, and which edges may go, is for the caller to say. Equal costs go by number.

use super::quadric::Quadric;
use crate::order::rank;
use glam::DVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Cost of an edge's length, as a factor of its square and the weights around: on flat parts short edges go first, which
/// keeps triangles well-shaped.
pub(crate) const LENGTH: f64 = 1e-5;

/// A candidate edge: the rank of its cost, its ends, and how often both had changed when the cost was computed.
type EdgeCandidate = Reverse<(u64, [u32; 2], u32)>;

/// Triangles whose edges collapse.
pub(crate) struct Collapse {
    pub places: Vec<DVec3>,
    pub triangles: Vec<[u32; 3]>,
    pub quadrics: Vec<Quadric>,
    /// The triangles around each vertex, including some removed ones.
    around: Vec<Vec<u32>>,
    /// The number of changes of each vertex.
    changes: Vec<u32>,
    edges: BinaryHeap<EdgeCandidate>,
}

impl Collapse {
    /// Vertices without planes, and no candidates yet.
    pub fn new(places: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Self {
        let count = places.len();
        Self {
            places,
            triangles,
            quadrics: vec![Quadric::default(); count],
            around: vec![Vec::new(); count],
            changes: vec![0; count],
            edges: BinaryHeap::new(),
        }
    }

    /// Adds the plane of a triangle to its corners.
    pub fn weigh(&mut self, t: usize, plane: &Quadric) {
        for v in self.triangles[t].map(|v| v as usize) {
            self.quadrics[v].add(plane);
            self.around[v].push(t as u32);
        }
    }

    /// Adds a candidate.
    pub fn offer(&mut self, ends: [u32; 2], cost: f64) {
        let edge = (rank(cost), ends, self.changed(ends));
        self.edges.push(Reverse(edge));
    }

    /// The candidate of the least cost whose ends have not changed since.
    pub fn pop(&mut self) -> Option<[u32; 2]> {
        loop {
            let Reverse((_, ends, changes)) = self.edges.pop()?;
            if self.changed(ends) == changes {
                return Some(ends);
            }
        }
    }

    fn changed(&self, [a, b]: [u32; 2]) -> u32 {
        self.changes[a as usize] + self.changes[b as usize]
    }

    /// The triangles around a vertex.
    pub fn living(&self, v: u32) -> impl Iterator<Item = (usize, [u32; 3])> {
        let around = self.around[v as usize].iter();
        let all = around.map(|&t| (t as usize, self.triangles[t as usize]));
        all.filter(move |(_, triangle)| triangle.contains(&v))
    }

    /// Puts one vertex in place of two. Triangles between both become `removed`; gives their number.
    pub fn merge(&mut self, gone: u32, kept: u32, removed: [u32; 3]) -> usize {
        let mut count = 0;
        for t in std::mem::take(&mut self.around[gone as usize]) {
            let triangle = &mut self.triangles[t as usize];
            let Some(corner) = triangle.iter().position(|&v| v == gone) else {
                continue;
            };
            if triangle.contains(&kept) {
                *triangle = removed;
                count += 1;
            } else {
                triangle[corner] = kept;
                self.around[kept as usize].push(t);
            }
        }
        let triangles = &self.triangles;
        self.around[kept as usize].retain(|&t| triangles[t as usize].contains(&kept));
        let quadric = self.quadrics[gone as usize];
        self.quadrics[kept as usize].add(&quadric);
        self.changes[gone as usize] += 1;
        self.changes[kept as usize] += 1;
        count
    }
}
