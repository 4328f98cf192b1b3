//! Collapses edges one by one, in the order of their costs.
//!
//! Garland, Heckbert (1997), Surface Simplification Using Quadric Error Metrics: each vertex keeps the planes of the
//! triangles that it stands for. The next edge is the one whose new vertex is least far from all these planes. The
//! caller decides the place of that vertex, its cost, and which edges may collapse. Edges of equal cost collapse in
//! the order of their numbers.

use super::quadric::Quadric;
use crate::csr::NONE;
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
    /// Linked lists of the corners at each vertex, removed ones included: the first and the last corner of each vertex,
    /// and the corner after each corner. Corner 3 t + k is corner k of triangle t.
    lists: Vec<[u32; 2]>,
    next: Vec<u32>,
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
            next: vec![NONE; 3 * triangles.len()],
            triangles,
            quadrics: vec![Quadric::default(); count],
            lists: vec![[NONE; 2]; count],
            changes: vec![0; count],
            edges: BinaryHeap::new(),
        }
    }

    /// An empty mesh with room for this many vertices and triangles.
    #[cfg(house)]
    pub fn with_room(vertices: usize, triangles: usize) -> Self {
        Self {
            places: Vec::with_capacity(vertices),
            next: Vec::with_capacity(3 * triangles),
            triangles: Vec::with_capacity(triangles),
            quadrics: Vec::with_capacity(vertices),
            lists: Vec::with_capacity(vertices),
            changes: Vec::with_capacity(vertices),
            edges: BinaryHeap::new(),
        }
    }

    /// Adds vertices and triangles.
    #[cfg(house)]
    pub fn extend(&mut self, places: impl Iterator<Item = DVec3>, triangles: &[[u32; 3]]) {
        self.places.extend(places);
        let count = self.places.len();
        self.quadrics.resize(count, Quadric::default());
        self.lists.resize(count, [NONE; 2]);
        self.changes.resize(count, 0);
        self.triangles.extend_from_slice(triangles);
        self.next.resize(3 * self.triangles.len(), NONE);
    }

    /// Adds the plane of a triangle to its corners.
    pub fn weigh(&mut self, t: usize, plane: &Quadric) {
        for (k, v) in self.triangles[t].into_iter().enumerate() {
            self.quadrics[v as usize].add(plane);
            self.push(v, 3 * t + k);
        }
    }

    /// Adds a corner at the end of the list of a vertex.
    fn push(&mut self, v: u32, corner: usize) {
        self.next[corner] = NONE;
        let [first, last] = &mut self.lists[v as usize];
        match *last {
            NONE => *first = corner as u32,
            last => self.next[last as usize] = corner as u32,
        }
        *last = corner as u32;
    }

    /// The corners in the list of a vertex.
    fn corners(&self, v: u32) -> impl Iterator<Item = usize> {
        let mut at = self.lists[v as usize][0];
        std::iter::from_fn(move || {
            let corner = (at != NONE).then_some(at as usize)?;
            at = self.next[corner];
            Some(corner)
        })
    }

    /// Adds a candidate.
    pub fn offer(&mut self, ends: [u32; 2], cost: f64) {
        let edge = (rank(cost), ends, self.changed(ends));
        self.edges.push(Reverse(edge));
    }

    /// Takes the candidate with the least cost. Candidates whose ends have changed since are dropped.
    pub fn pop(&mut self) -> Option<[u32; 2]> {
        loop {
            let (ends, is_current) = self.take()?;
            if is_current {
                return Some(ends);
            }
        }
    }

    /// Takes the candidate with the least cost, and tells whether its ends are as they were.
    pub fn take(&mut self) -> Option<([u32; 2], bool)> {
        let Reverse((_, ends, changes)) = self.edges.pop()?;
        Some((ends, self.changed(ends) == changes))
    }

    /// How often two vertices have changed.
    pub fn changed(&self, [a, b]: [u32; 2]) -> u32 {
        self.changes[a as usize] + self.changes[b as usize]
    }

    /// Drops the removed corners from the list of a vertex.
    pub fn tidy(&mut self, v: u32) {
        let mut at = std::mem::replace(&mut self.lists[v as usize], [NONE; 2])[0];
        while at != NONE {
            let corner = at as usize;
            at = self.next[corner];
            if self.triangles[corner / 3].contains(&v) {
                self.push(v, corner);
            }
        }
    }

    /// The number of corners in the list of a vertex, removed ones included.
    #[cfg(test)]
    pub fn listed(&self, v: u32) -> usize {
        self.corners(v).count()
    }

    /// The triangles around a vertex.
    pub fn living(&self, v: u32) -> impl Iterator<Item = (usize, [u32; 3])> {
        let all = self.corners(v).map(|corner| corner / 3);
        let all = all.map(|t| (t, self.triangles[t]));
        all.filter(move |(_, triangle)| triangle.contains(&v))
    }

    /// Replaces the vertex `gone` by `kept`. Triangles with both become `removed`. Returns the number of these.
    pub fn merge(&mut self, gone: u32, kept: u32, removed: [u32; 3]) -> usize {
        let mut count = 0;
        let mut at = std::mem::replace(&mut self.lists[gone as usize], [NONE; 2])[0];
        while at != NONE {
            let corner = at as usize;
            at = self.next[corner];
            let triangle = &mut self.triangles[corner / 3];
            let Some(place) = triangle.iter().position(|&v| v == gone) else {
                continue;
            };
            if triangle.contains(&kept) {
                *triangle = removed;
                count += 1;
            } else {
                triangle[place] = kept;
                self.push(kept, corner);
            }
        }
        self.tidy(kept);
        let quadric = self.quadrics[gone as usize];
        self.quadrics[kept as usize].add(&quadric);
        self.changes[gone as usize] += 1;
        self.changes[kept as usize] += 1;
        count
    }
}
