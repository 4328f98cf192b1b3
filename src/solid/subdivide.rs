//! Loop's subdivision of triangle meshes, and its weights as a sparse matrix.
//!
//! Loop, C. (1987), Smooth subdivision surfaces based on triangles: an inner edge's new point takes
//! 3/8 of its ends and 1/8 of the two opposite corners; a vertex of valence n keeps 1 - n beta(n) and
//! takes beta(n) of each neighbour; along a boundary only the boundary counts, 1/2, 1/2 and
//! 1/8, 3/4, 1/8. Every triangle becomes four.
//!
//! A step is linear in the positions, and its weights follow from the connectivity alone. So one
//! level is a sparse matrix, several levels are the product of theirs, and meshes of one connectivity
//! share it: see [`Stencil`].

use crate::order;
use glam::Vec3;
use std::rc::Rc;

/// A triangle mesh; triangles index `vertices` and go round alike seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// x and y in picture units, z the height.
    pub vertices: Vec<Vec3>,
    /// Three vertex indices each.
    pub triangles: Vec<[u32; 3]>,
}

/// The share of each neighbour in the new place of an inner vertex of valence `n`.
pub fn beta(n: usize) -> f64 {
    let n = n.max(1) as f64;
    let c = 0.375 + 0.25 * libm::cos(std::f64::consts::TAU / n);
    (0.625 - c * c) / n
}

/// One Loop step.
pub fn loop_subdivide(mesh: &TriangleMesh) -> TriangleMesh {
    let stencil = Stencil::new(mesh.vertices.len(), &mesh.triangles, 1);
    TriangleMesh {
        vertices: stencil.apply(&mesh.vertices),
        triangles: stencil.triangles.to_vec(),
    }
}

/// The refined vertices of every mesh of one connectivity as weighted sums of its vertices
/// (a matrix in compressed rows), and the refined triangles.
#[derive(Clone, Debug)]
pub struct Stencil {
    sources: usize,
    /// Row i holds the entries `starts[i] .. starts[i + 1]`.
    starts: Vec<u32>,
    columns: Vec<u32>,
    weights: Vec<f32>,
    /// Level after level, the ends of the edges whose middles became vertices.
    parents: Vec<[u32; 2]>,
    /// Up to where in `parents` each level goes.
    ends: Vec<usize>,
    /// The refined triangles, to be shared by all solids made with this stencil.
    pub triangles: Rc<[[u32; 3]]>,
}

impl Stencil {
    /// The weights of `levels` Loop steps on a mesh of `vertices` vertices.
    pub fn new(vertices: usize, triangles: &[[u32; 3]], levels: u32) -> Self {
        Self::made(vertices, triangles, levels, false)
    }

    /// The same with every refined vertex moved to where further steps would lead it, so that the
    /// refined mesh lies on the limit surface and finer ones hardly differ.
    pub fn to_limit(vertices: usize, triangles: &[[u32; 3]], levels: u32) -> Self {
        Self::made(vertices, triangles, levels, true)
    }

    fn made(vertices: usize, triangles: &[[u32; 3]], levels: u32, limit: bool) -> Self {
        let mut rows = Rows::identity(vertices);
        let mut triangles = triangles.to_vec();
        let (mut parents, mut ends) = (Vec::new(), Vec::new());
        for _ in 0..levels {
            let edges = edges(&triangles);
            parents.extend(edges.iter().map(|edge| edge.ends));
            ends.push(parents.len());
            let step = step(rows.len(), &edges);
            triangles = split(rows.len(), &triangles, &edges);
            rows = step.times(&rows, vertices);
        }
        if limit {
            let mut step = Rows::empty();
            push_vertices(rows.len(), &edges(&triangles), limit_share, &mut step);
            rows = step.times(&rows, vertices);
        }
        Self {
            sources: vertices,
            weights: rows.weights.iter().map(|&w| w as f32).collect(),
            starts: rows.starts,
            columns: rows.columns,
            parents,
            ends,
            triangles: triangles.into(),
        }
    }

    /// How many vertices the unrefined mesh has.
    pub fn sources(&self) -> usize {
        self.sources
    }

    /// How many vertices the refined mesh has.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether the refined mesh has no vertex.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Level after level, the new vertices by the ends of the edges that they divide. They follow the
    /// unrefined mesh's vertices in this order.
    pub fn levels(&self) -> impl Iterator<Item = &[[u32; 2]]> + '_ {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        starts
            .zip(&self.ends)
            .map(|(start, &end)| &self.parents[start..end])
    }

    /// The columns and weights that make refined vertex `i`; the weights sum to 1.
    pub fn row(&self, i: usize) -> impl Iterator<Item = (u32, f32)> + '_ {
        let span = self.starts[i] as usize..self.starts[i + 1] as usize;
        let columns = self.columns[span.clone()].iter().copied();
        columns.zip(self.weights[span].iter().copied())
    }

    /// The refined vertices of the mesh whose vertices are `points`; panics where their number is
    /// not [`Stencil::sources`].
    pub fn apply(&self, points: &[Vec3]) -> Vec<Vec3> {
        let mut refined = Vec::new();
        self.apply_to(points, &mut refined);
        refined
    }

    /// As [`Stencil::apply`], into a list that is emptied first.
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

/// A sparse matrix in compressed rows: row i holds the entries `starts[i] .. starts[i + 1]`.
struct Rows {
    starts: Vec<u32>,
    columns: Vec<u32>,
    weights: Vec<f64>,
}

impl Rows {
    fn empty() -> Self {
        Self {
            starts: vec![0],
            columns: Vec::new(),
            weights: Vec::new(),
        }
    }

    fn identity(n: usize) -> Self {
        let mut rows = Self::empty();
        (0..n as u32).for_each(|i| rows.push([(i, 1.0)]));
        rows
    }

    fn len(&self) -> usize {
        self.starts.len() - 1
    }

    fn push(&mut self, row: impl IntoIterator<Item = (u32, f64)>) {
        for (column, weight) in row {
            self.columns.push(column);
            self.weights.push(weight);
        }
        self.starts.push(self.columns.len() as u32);
    }

    fn row(&self, i: usize) -> impl Iterator<Item = (u32, f64)> + '_ {
        let span = self.starts[i] as usize..self.starts[i + 1] as usize;
        let columns = self.columns[span.clone()].iter().copied();
        columns.zip(self.weights[span].iter().copied())
    }

    /// The product with a matrix of `columns` columns. Sums go into a dense row that is emptied after
    /// use, so no map is needed.
    fn times(&self, other: &Rows, columns: usize) -> Rows {
        let mut dense = vec![0.0f64; columns];
        let mut touched: Vec<u32> = Vec::new();
        let mut product = Rows::empty();
        for i in 0..self.len() {
            for (source, weight) in self.row(i) {
                for (column, inner) in other.row(source as usize) {
                    if dense[column as usize] == 0.0 {
                        touched.push(column);
                    }
                    dense[column as usize] += weight * inner;
                }
            }
            order::sort(&mut touched, |&c| (c.into(), 0));
            let sums = touched.iter().map(|&c| (c, dense[c as usize]));
            product.push(sums);
            for column in touched.drain(..) {
                dense[column as usize] = 0.0;
            }
        }
        product
    }
}

/// An edge, its ends in rising order, with the corners opposite to it: two, or else it is a boundary.
struct Edge {
    ends: [u32; 2],
    opposite: Option<[u32; 2]>,
}

fn ordered(a: u32, b: u32) -> [u32; 2] {
    if a < b { [a, b] } else { [b, a] }
}

fn edges(triangles: &[[u32; 3]]) -> Vec<Edge> {
    let mut sides: Vec<([u32; 2], u32)> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [(ordered(a, b), c), (ordered(b, c), a), (ordered(c, a), b)])
        .collect();
    order::sort(&mut sides, |&([a, b], c)| (order::pair(a, b), c.into()));
    sides
        .chunk_by(|x, y| x.0 == y.0)
        .map(|same| Edge {
            ends: same[0].0,
            opposite: match same {
                [c, d] => Some([c.1, d.1]),
                _ => None,
            },
        })
        .collect()
}

/// The matrix of one step: the old vertices first, then one per edge in the order of their ends.
fn step(vertices: usize, edges: &[Edge]) -> Rows {
    let mut rows = Rows::empty();
    push_vertices(vertices, edges, step_share, &mut rows);
    for Edge { ends, opposite } in edges {
        let [a, b] = *ends;
        match *opposite {
            Some([c, d]) => rows.push([(a, 0.375), (b, 0.375), (c, 0.125), (d, 0.125)]),
            None => rows.push([(a, 0.5), (b, 0.5)]),
        }
    }
    rows
}

/// What a step takes of each of `n` neighbours of a vertex, of which those on the boundary alone count
/// where `rim` are.
fn step_share(n: usize, rim: usize) -> f64 {
    if rim == 0 { beta(n) } else { 0.25 / rim as f64 }
}

/// What all steps together take of them, in the end.
fn limit_share(n: usize, rim: usize) -> f64 {
    if rim == 0 {
        1.0 / (n as f64 + 0.375 / beta(n))
    } else {
        1.0 / (3.0 * rim as f64)
    }
}

fn push_vertices(vertices: usize, edges: &[Edge], share: fn(usize, usize) -> f64, rows: &mut Rows) {
    // (vertex, neighbour, whether on the boundary), vertex after vertex.
    let mut spokes: Vec<(u32, u32, bool)> = edges
        .iter()
        .flat_map(|edge| {
            let ([a, b], rim) = (edge.ends, edge.opposite.is_none());
            [(a, b, rim), (b, a, rim)]
        })
        .collect();
    order::sort(&mut spokes, |&(a, b, rim)| (order::pair(a, b), rim.into()));
    let mut at = 0;
    for vertex in 0..vertices as u32 {
        let count = spokes[at..].iter().take_while(|s| s.0 == vertex).count();
        let own = &spokes[at..at + count];
        let rim = own.iter().filter(|s| s.2).count();
        let share = share(count, rim);
        let neighbours = own.iter().filter(|s| rim == 0 || s.2);
        let kept = 1.0 - share * neighbours.clone().count() as f64;
        rows.push(neighbours.map(|s| (s.1, share)).chain([(vertex, kept)]));
        at += count;
    }
}

fn split(vertices: usize, triangles: &[[u32; 3]], edges: &[Edge]) -> Vec<[u32; 3]> {
    let middle = |a: u32, b: u32| {
        let ends = ordered(a, b);
        let at = edges.partition_point(|edge| edge.ends < ends);
        (vertices + at) as u32
    };
    triangles
        .iter()
        .flat_map(|&[a, b, c]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A vertex of valence n (index 0) in a closed double pyramid.
    fn pyramid(n: u32) -> TriangleMesh {
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
        TriangleMesh {
            vertices,
            triangles,
        }
    }

    fn repeated(mut mesh: TriangleMesh, levels: u32) -> TriangleMesh {
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
            let reached = repeated(mesh.clone(), 7).vertices[0];
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
        assert!(edges(&mesh.triangles).iter().all(|e| e.opposite.is_some()));
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
        let mesh = TriangleMesh {
            vertices,
            triangles: vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
        };
        let fine = loop_subdivide(&mesh);
        assert_eq!(fine.vertices[0], Vec3::new(1.0, 1.0, 0.0));
        assert!(fine.vertices.contains(&Vec3::new(4.0, 0.0, 0.0)));
    }

    #[test]
    fn nothing_stays_nothing() {
        assert_eq!(
            loop_subdivide(&TriangleMesh::default()),
            TriangleMesh::default()
        );
    }
}
