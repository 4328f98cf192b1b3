//! Collapses edges one by one, in the order of their costs.
//!
//! Garland, Heckbert (1997), Surface Simplification Using Quadric Error Metrics: each vertex keeps the planes of the
//! triangles that it stands for. The next edge is the one whose new vertex is least far from all these planes. The
//! caller decides the place of that vertex, its cost, and which edges may collapse. Edges of equal cost collapse in
//! the order of their numbers.

use super::quadric::Quadric;
use crate::order::rank;
use glam::DVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Weight of an edge's squared length in its cost, times the weights around it: on flat parts short edges collapse
/// first, so triangles keep good shapes.
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
    /// Triangles whose vertices have no planes yet, without candidates.
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

    /// Takes the candidate with the least cost. Candidates whose ends have changed since are dropped.
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

    /// How many triangles a vertex lists, with some removed ones.
    #[cfg(house)]
    pub fn around(&self, v: u32) -> usize {
        self.around[v as usize].len()
    }

    /// The triangles around a vertex.
    pub fn living(&self, v: u32) -> impl Iterator<Item = (usize, [u32; 3])> {
        let around = self.around[v as usize].iter();
        let all = around.map(|&t| (t as usize, self.triangles[t as usize]));
        all.filter(move |(_, triangle)| triangle.contains(&v))
    }

    /// Replaces the vertex `gone` by `kept`. Triangles with both become `removed`. Returns the number of these.
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
