//! Neighbours of the vertices of a mesh, with weights and parallel transport.

use super::{TangentFrame, TriMesh};
use glam::{DVec2, DVec3};
use std::ops::Range;

/// Carries a tangent vector from one unit normal to another by the smallest rotation between them.
#[inline(always)]
pub(crate) fn carried(v: DVec3, from: DVec3, to: DVec3) -> DVec3 {
    let share = v.dot(to) / (1.0 + from.dot(to)).max(1e-9);
    v - (from + to) * share
}

/// Bounds of an edge's weight: slivers then neither tear their corners apart nor tie them together.
const WEIGHTS: (f64, f64) = (0.05, 4.0);

/// The neighbours of each vertex, counter-clockwise, with the weights of the edges to them and the turns that carry
/// vectors from a neighbour's frame into the vertex' frame.
#[derive(Clone, Debug, Default)]
pub(crate) struct Adjacency {
    start: Vec<u32>,
    pub to: Vec<u32>,
    /// Half the sum of the cotangents of the angles opposite an edge, clamped to [`WEIGHTS`].
    pub weight: Vec<f64>,
    pub turn: Vec<DVec2>,
    /// A third of the area of the triangles around each vertex.
    pub mass: Vec<f64>,
    pub frames: Vec<TangentFrame>,
    /// The sum of the squared edge lengths of all triangles.
    squares: f64,
}

impl Adjacency {
    /// The range of a vertex' entries in `to`, `weight` and `turn`.
    #[inline(always)]
    pub fn of(&self, vertex: usize) -> Range<usize> {
        self.start[vertex] as usize..self.start[vertex + 1] as usize
    }

    /// The number of vertices.
    pub fn len(&self) -> usize {
        self.mass.len()
    }

    /// The mean of the squared lengths of the triangles' edges.
    pub fn mean_square(&self, mesh: &TriMesh) -> f64 {
        self.squares / (3 * mesh.triangles().len()) as f64
    }

    /// Does all the work at once.
    #[cfg(test)]
    pub fn build(mesh: &TriMesh) -> Self {
        let mut builder = AdjacencyBuilder::new(mesh);
        while !builder.advance(mesh, usize::MAX) {}
        builder.links
    }
}

/// Makes [`Adjacency`] in slices: first by triangles, then by vertices.
#[derive(Clone, Debug)]
pub(crate) struct AdjacencyBuilder {
    pub links: Adjacency,
    /// Cotangents of the angles at each triangle's corners.
    cots: Vec<[f64; 3]>,
    /// How many edges lie on the border.
    borders: usize,
    at: usize,
}

impl AdjacencyBuilder {
    pub fn new(mesh: &TriMesh) -> Self {
        let count = mesh.positions().len();
        let mut links = Adjacency {
            mass: vec![0.0; count],
            ..Adjacency::default()
        };
        links.start.reserve(count + 1);
        links.start.push(0);
        Self {
            links,
            cots: Vec::with_capacity(mesh.triangles().len()),
            borders: 0,
            at: 0,
        }
    }

    /// Works on at most `amount` triangles or vertices; true when all are done.
    pub fn advance(&mut self, mesh: &TriMesh, amount: usize) -> bool {
        let triangles = mesh.triangles().len();
        let vertices = mesh.positions().len();
        let end = self.at.saturating_add(amount.max(1));
        if self.cots.len() < triangles {
            let end = end.min(triangles);
            for t in self.at..end {
                self.triangle(mesh, t as u32);
            }
            self.at = if end == triangles { 0 } else { end };
            return false;
        }
        if self.links.frames.len() < vertices {
            let end = end.min(vertices);
            let normals = &mesh.normals()[self.at..end];
            let frames = &mut self.links.frames;
            frames.extend(normals.iter().map(|&n| TangentFrame::of(n)));
            self.at = if end == vertices { 0 } else { end };
            return false;
        }
        if self.at == 0 {
            // Reserve first: growing step by step would copy the lists again and again.
            let count = 3 * triangles + self.borders;
            self.links.to.reserve_exact(count);
            self.links.weight.reserve_exact(count);
            self.links.turn.reserve_exact(count);
        }
        let end = end.min(vertices);
        for v in self.at..end {
            self.vertex(mesh, v as u32);
        }
        self.at = end;
        if end == vertices {
            self.cots = Vec::new();
        }
        end == vertices
    }

    fn triangle(&mut self, mesh: &TriMesh, t: u32) {
        let p = mesh.corners(t);
        let double = (p[1] - p[0]).cross(p[2] - p[0]).length();
        let mut cots = [0.0; 3];
        for k in 0..3 {
            let (e, f) = (p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
            let dot = e.dot(f);
            // Slivers have huge cotangents of both signs; bounds keep their sums finite.
            cots[k] = (dot / double.max(1e-6 * e.length() * f.length())).clamp(-1e6, 1e6);
            if !cots[k].is_finite() {
                cots[k] = 0.0;
            }
        }
        for k in 0..3 {
            self.borders += usize::from(mesh.across(t, k).is_none());
            self.links.squares += p[k].distance_squared(p[(k + 1) % 3]);
        }
        for v in mesh.triangles()[t as usize] {
            self.links.mass[v as usize] += double / 6.0;
        }
        self.cots.push(cots);
    }

    fn vertex(&mut self, mesh: &TriMesh, v: u32) {
        let first = self.links.to.len();
        // The edge between a corner and the next one of the fan: its other end, and the cotangent opposite it.
        let mut before: Option<(u32, f64)> = None;
        for (t, k) in mesh.fan(v) {
            let corners = mesh.triangles()[t as usize];
            let cots = self.cots[t as usize];
            let behind = before.map_or(0.0, |(_, cot)| cot);
            self.push(v, corners[(k + 1) % 3], cots[(k + 2) % 3] + behind);
            before = Some((corners[(k + 2) % 3], cots[(k + 1) % 3]));
        }
        if let Some((last, cot)) = before {
            if self.links.to[first] == last {
                self.links.weight[first] += 0.5 * cot;
            } else {
                self.push(v, last, cot);
            }
        }
        for w in &mut self.links.weight[first..] {
            *w = w.clamp(WEIGHTS.0, WEIGHTS.1);
        }
        self.links.start.push(self.links.to.len() as u32);
    }

    fn push(&mut self, v: u32, other: u32, cots: f64) {
        let links = &mut self.links;
        let (own, from) = (&links.frames[v as usize], &links.frames[other as usize]);
        let turn = own.within(carried(from.x, from.normal, own.normal));
        links.turn.push(turn.normalize_or(DVec2::X));
        links.to.push(other);
        links.weight.push(0.5 * cots);
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples;
    use super::*;

    #[test]
    fn links_are_the_same_from_both_ends() {
        for mesh in [samples::torus(24, 10), samples::hill(12)] {
            let links = Adjacency::build(&mesh);
            for i in 0..links.len() {
                for e in links.of(i) {
                    let j = links.to[e] as usize;
                    let back = links.of(j).find(|&b| links.to[b] as usize == i);
                    let back = back.expect("the way back");
                    assert!((links.weight[e] - links.weight[back]).abs() < 1e-12);
                    let turn = links.turn[e].rotate(links.turn[back]);
                    assert!((turn - DVec2::X).length() < 1e-12);
                }
            }
            let mass: f64 = links.mass.iter().sum();
            assert!((mass / mesh.area() - 1.0).abs() < 1e-12);
        }
    }
}
