//! Loop's subdivision of triangle meshes, and its weights as a sparse matrix.
//!
//! Loop, C. (1987), Smooth subdivision surfaces based on triangles: see [`super::loop_step`]. Every triangle becomes
//! four.
//!
//! A step is linear in the positions, and its weights follow from the connectivity alone. So one level is a
//! sparse matrix, several levels are a product of matrices, and meshes with the same connectivity share it:
//! see [`Stencil`].

use super::edges::{Edges, split};
use super::loop_step::SubdivisionMatrix;
use super::sparse::{Matrix, Product};
use glam::Vec3;
use std::rc::Rc;

/// The triangles of a solid, or of its control mesh: a stone or a cell of skin from the base up, open below.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solid {
    /// x, y and height above the base level, in picture units.
    pub vertices: Vec<Vec3>,
    /// Triangles, clockwise on screen seen from above; shared by all solids with the same connectivity.
    pub triangles: Rc<[[u32; 3]]>,
}

/// The refined vertices of every mesh with one connectivity as weighted sums of its vertices (a matrix in
/// compressed rows), and the refined triangles.
#[derive(Clone, Debug)]
pub struct Stencil {
    sources: usize,
    /// Row i holds the entries `starts[i] .. starts[i + 1]`.
    starts: Vec<u32>,
    columns: Vec<u16>,
    weights: Vec<f32>,
    /// For each level, the ends of the edges whose midpoints became vertices.
    parents: Vec<[u32; 2]>,
    /// The end of each level in `parents`.
    ends: Vec<usize>,
    /// The refined triangles, shared by all solids made with this stencil.
    pub triangles: Rc<[[u32; 3]]>,
}

impl Stencil {
    /// The weights of `levels` Loop steps on a mesh with `vertices` vertices, at most 65,536.
    pub fn new(vertices: usize, triangles: &[[u32; 3]], levels: u32) -> Self {
        Self::made(vertices, triangles.to_vec(), levels, false)
    }

    /// Like [`Stencil::new`], with every refined vertex moved to its limit under further steps. So the refined mesh
    /// lies on the limit surface, and finer meshes hardly differ.
    pub fn to_limit(vertices: usize, triangles: &[[u32; 3]], levels: u32) -> Self {
        Self::made(vertices, triangles.to_vec(), levels, true)
    }

    fn made(vertices: usize, triangles: Vec<[u32; 3]>, levels: u32, limit: bool) -> Self {
        let mut builder = StencilBuilder::new(vertices, triangles, levels, limit);
        while !builder.advance(usize::MAX) {}
        builder.finish()
    }

    /// The number of vertices of the unrefined mesh.
    pub fn sources(&self) -> usize {
        self.sources
    }

    /// The number of vertices of the refined mesh.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// The bytes that it takes.
    #[cfg(test)]
    pub fn bytes(&self) -> usize {
        let (rows, entries) = (self.starts.capacity(), self.columns.capacity());
        4 * rows + 6 * entries + 8 * self.parents.capacity() + 12 * self.triangles.len()
    }

    /// Whether the refined mesh has no vertex.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// For each level, its new vertices as the ends of the edges that they divide. They follow the unrefined
    /// mesh's vertices in this order.
    pub fn levels(&self) -> impl Iterator<Item = &[[u32; 2]]> + '_ {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        starts
            .zip(&self.ends)
            .map(|(start, &end)| &self.parents[start..end])
    }

    /// The columns and weights of refined vertex `i`; the weights sum to 1.
    pub fn row(&self, i: usize) -> impl Iterator<Item = (u32, f32)> + '_ {
        let span = self.starts[i] as usize..self.starts[i + 1] as usize;
        let columns = self.columns[span.clone()].iter().copied();
        columns
            .map(u32::from)
            .zip(self.weights[span].iter().copied())
    }

    /// The refined vertices of the mesh with the vertices `points`.
    ///
    /// # Panics
    /// If their number is not [`Stencil::sources`].
    pub fn apply(&self, points: &[Vec3]) -> Vec<Vec3> {
        let mut refined = Vec::new();
        self.apply_to(points, &mut refined);
        refined
    }

    /// As [`Stencil::apply`], into a list that is cleared first.
    pub fn apply_to(&self, points: &[Vec3], refined: &mut Vec<Vec3>) {
        assert_eq!(points.len(), self.sources, "a stencil fits one mesh");
        refined.clear();
        refined.reserve(self.len());
        let mut start = self.starts[0] as usize;
        for &end in &self.starts[1..] {
            let span = start..end as usize;
            let mut sum = Vec3::ZERO;
            for (&column, &weight) in self.columns[span.clone()].iter().zip(&self.weights[span]) {
                sum += points[column as usize] * weight;
            }
            refined.push(sum);
            start = end as usize;
        }
    }
}

/// A stencil in progress.
#[derive(Debug)]
pub(super) struct StencilBuilder {
    sources: usize,
    rows: Matrix,
    triangles: Vec<[u32; 3]>,
    parents: Vec<[u32; 2]>,
    ends: Vec<usize>,
    /// Steps not yet begun, and whether the step to the limit is still to do.
    levels: u32,
    limit: bool,
    /// The edges of the current step.
    edges: Option<Edges>,
    product: Option<(SubdivisionMatrix, Product)>,
}

impl StencilBuilder {
    /// See [`Stencil::new`] and [`Stencil::to_limit`].
    pub fn new(vertices: usize, triangles: Vec<[u32; 3]>, levels: u32, limit: bool) -> Self {
        Self {
            sources: vertices,
            rows: Matrix::identity(vertices),
            triangles,
            parents: Vec::new(),
            ends: Vec::new(),
            levels,
            limit,
            edges: None,
            product: None,
        }
    }

    /// Computes about `most` rows; true when finished.
    pub fn advance(&mut self, mut most: usize) -> bool {
        while most > 0 {
            if let Some((step, mut product)) = self.product.take() {
                let row = |i: usize, to: &mut Vec<_>| step.row(i, to);
                match product.advance(row, &self.rows, &mut most) {
                    true => self.rows = product.done,
                    false => self.product = Some((step, product)),
                }
            } else if let Some(edges) = self.edges.take() {
                most = most.saturating_sub(edges.list.len());
                let step = self.step(edges);
                let product = Product::new(step.len(), self.sources);
                self.product = Some((step, product));
            } else if self.levels > 0 || self.limit {
                let edges = Edges::new(self.rows.len(), &self.triangles);
                most = most.saturating_sub(edges.list.len());
                self.edges = Some(edges);
            } else {
                return true;
            }
        }
        false
    }

    /// The next step, on the mesh with these edges.
    fn step(&mut self, edges: Edges) -> SubdivisionMatrix {
        let count = self.rows.len();
        if self.levels == 0 {
            self.limit = false;
            return SubdivisionMatrix::to_limit(count, &edges.list);
        }
        self.parents.extend(edges.list.iter().map(|edge| edge.ends));
        self.ends.push(self.parents.len());
        self.triangles = split(count, &self.triangles, &edges);
        self.levels -= 1;
        SubdivisionMatrix::halving(count, edges.list)
    }

    /// The finished stencil.
    pub fn finish(self) -> Stencil {
        let mut rows = self.rows;
        rows.columns.shrink_to_fit();
        Stencil {
            sources: self.sources,
            weights: rows.weights.iter().map(|&w| w as f32).collect(),
            starts: rows.starts,
            columns: rows.columns,
            parents: self.parents,
            ends: self.ends,
            triangles: self.triangles.into(),
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::solid::beta;

    /// One Loop step of a mesh with at most 65,536 vertices.
    pub(crate) fn loop_subdivide(mesh: &Solid) -> Solid {
        let stencil = Stencil::new(mesh.vertices.len(), &mesh.triangles, 1);
        Solid {
            vertices: stencil.apply(&mesh.vertices),
            triangles: stencil.triangles,
        }
    }

    /// A vertex of valence n (index 0) in a closed double pyramid.
    fn pyramid(n: u32) -> Solid {
        let mut vertices = vec![Vec3::new(0.1, -0.2, 2.0), Vec3::new(0.3, 0.1, -1.0)];
        let mut triangles = Vec::new();
        for i in 0..n {
            let angle = f64::from(i) / f64::from(n) * std::f64::consts::TAU;
            vertices.push(Vec3::new(
                libm::cos(angle) as f32,
                libm::sin(angle) as f32,
                0.3 * (i % 2) as f32,
            ));
            let (a, b) = (2 + i, 2 + (i + 1) % n);
            triangles.extend([[0, a, b], [1, b, a]]);
        }
        Solid {
            vertices,
            triangles: triangles.into(),
        }
    }

    fn repeated(mut mesh: Solid, levels: u32) -> Solid {
        for _ in 0..levels {
            mesh = loop_subdivide(&mesh);
        }
        mesh
    }

    #[test]
    fn vertices_go_to_their_known_limit() {
        // Limit of a vertex: (1 - n g) v + g sum of neighbours, g = 1 / (n + 3 / (8 beta)).
        for n in 3..=9 {
            let mesh = pyramid(n);
            let g = 1.0 / (f64::from(n) + 0.375 / beta(n as usize));
            let ring: Vec3 = mesh.vertices[2..].iter().sum();
            let limit = mesh.vertices[0] * (1.0 - f64::from(n) * g) as f32 + ring * g as f32;
            let reached = repeated(mesh.clone(), 6).vertices[0];
            assert!((limit - reached).length() < 2e-3, "{n}: {limit} {reached}");
            let stencil = Stencil::to_limit(mesh.vertices.len(), &mesh.triangles, 2);
            let at_once = stencil.apply(&mesh.vertices)[0];
            assert!((limit - at_once).length() < 1e-5, "{n}: {limit} {at_once}");
        }
    }

    #[test]
    fn known_weights() {
        assert!((beta(3) - 3.0 / 16.0).abs() < 1e-12);
        assert!((beta(6) - 1.0 / 16.0).abs() < 1e-12);
    }

    #[test]
    fn weights_are_a_partition_of_unity_and_not_negative() {
        let mesh = pyramid(5);
        let stencil = Stencil::new(mesh.vertices.len(), &mesh.triangles, 3);
        for i in 0..stencil.len() {
            let sum: f32 = stencil.row(i).map(|(_, w)| w).sum();
            assert!((sum - 1.0).abs() < 1e-5, "row {i} sums to {sum}");
            assert!(stencil.row(i).all(|(_, w)| w > 0.0));
        }
    }

    #[test]
    fn stencil_equals_repeated_steps_and_follows_affine_maps() {
        let mesh = pyramid(4);
        let stencil = Stencil::new(mesh.vertices.len(), &mesh.triangles, 3);
        let by_steps = repeated(mesh.clone(), 3);
        assert_eq!(stencil.triangles[..], by_steps.triangles[..]);
        let map = |p: Vec3| Vec3::new(2.0 * p.x - p.z + 5.0, p.y + 0.5 * p.x, 3.0 * p.z - 1.0);
        let moved: Vec<Vec3> = mesh.vertices.iter().map(|&p| map(p)).collect();
        let refined = stencil.apply(&mesh.vertices);
        for ((a, b), c) in refined
            .iter()
            .zip(&by_steps.vertices)
            .zip(stencil.apply(&moved))
        {
            assert!((*a - *b).length() < 1e-5);
            assert!((map(*a) - c).length() < 1e-4);
        }
    }

    #[test]
    fn closed_meshes_stay_closed() {
        let mesh = repeated(pyramid(5), 2);
        let edges = Edges::new(mesh.vertices.len(), &mesh.triangles);
        assert!(edges.list.iter().all(|e| e.opposite.is_some()));
        let (v, t) = (mesh.vertices.len(), mesh.triangles.len());
        assert_eq!(v + t - 3 * t / 2, 2, "Euler");
    }

    #[test]
    fn boundary_is_the_spline_of_the_boundary_alone() {
        let vertices = vec![
            Vec3::new(0.0, 0.0, 0.0),
            Vec3::new(8.0, 0.0, 0.0),
            Vec3::new(8.0, 8.0, 0.0),
            Vec3::new(0.0, 8.0, 0.0),
            Vec3::new(4.0, 4.0, 99.0),
        ];
        let mesh = Solid {
            vertices,
            triangles: [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]].into(),
        };
        let fine = loop_subdivide(&mesh);
        assert_eq!(fine.vertices[0], Vec3::new(1.0, 1.0, 0.0));
        assert!(fine.vertices.contains(&Vec3::new(4.0, 0.0, 0.0)));
    }

    #[test]
    fn nothing_stays_nothing() {
        assert_eq!(loop_subdivide(&Solid::default()), Solid::default());
    }
}
