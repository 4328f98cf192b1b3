//! The weights of one Loop step, row by row.
//!
//! Loop, C. (1987), Smooth subdivision surfaces based on triangles: an inner edge's new point takes 3/8 of each end and
//! 1/8 of each opposite corner. A vertex of valence n keeps 1 - n beta(n) and takes beta(n) of each neighbour. Along a
//! boundary only the boundary counts: new points take 1/2, 1/2 of the ends, old ones 3/4 of themselves and 1/8, 1/8 of
//! their neighbours.

use super::edges::Edge;
use crate::csr::Csr;

/// The share of each neighbour in the new place of an inner vertex of valence `n`.
pub fn beta(n: usize) -> f64 {
    let n = n.max(1) as f64;
    let c = 0.375 + 0.25 * libm::cos(std::f64::consts::TAU / n);
    (0.625 - c * c) / n
}

/// The matrix of one step, row by row: the old vertices first, then one for each edge in the order of their ends.
#[derive(Debug)]
pub(super) struct SubdivisionMatrix {
    /// For each vertex its neighbours in rising order, each with whether it is on the boundary.
    spokes: Csr<(u32, bool)>,
    vertices: usize,
    edges: Vec<Edge>,
    share: fn(usize, usize) -> f64,
}

impl SubdivisionMatrix {
    /// Loop's step, which halves all edges.
    pub fn halving(vertices: usize, edges: Vec<Edge>) -> Self {
        Self {
            spokes: spokes(vertices, &edges),
            vertices,
            edges,
            share: step_share,
        }
    }

    /// The step to the limit, which makes no vertex.
    pub fn to_limit(vertices: usize, edges: &[Edge]) -> Self {
        Self {
            spokes: spokes(vertices, edges),
            vertices,
            edges: Vec::new(),
            share: limit_share,
        }
    }

    pub fn len(&self) -> usize {
        self.vertices + self.edges.len()
    }

    /// Puts row `i` into an empty list.
    pub fn row(&self, i: usize, to: &mut Vec<(u32, f64)>) {
        if i < self.vertices {
            let own = self.spokes.row(i);
            let rim = own.iter().filter(|s| s.1).count();
            let share = (self.share)(own.len(), rim);
            let neighbours = own.iter().filter(|s| rim == 0 || s.1);
            to.extend(neighbours.map(|s| (s.0, share)));
            to.push((i as u32, 1.0 - share * to.len() as f64));
            return;
        }
        let Edge { ends, opposite } = &self.edges[i - self.vertices];
        let [a, b] = *ends;
        match *opposite {
            Some([c, d]) => to.extend([(a, 0.375), (b, 0.375), (c, 0.125), (d, 0.125)]),
            None => to.extend([(a, 0.5), (b, 0.5)]),
        }
    }
}

fn spokes(vertices: usize, edges: &[Edge]) -> Csr<(u32, bool)> {
    let both = |edge: &Edge| {
        let ([a, b], on_boundary) = (edge.ends, edge.opposite.is_none());
        [
            (a as usize, (b, on_boundary)),
            (b as usize, (a, on_boundary)),
        ]
    };
    Csr::from_pairs(vertices, edges.iter().flat_map(both))
}

/// The weight in a step of each of `n` neighbours of a vertex; if `rim` of them are on the boundary, only
/// those count.
fn step_share(n: usize, rim: usize) -> f64 {
    if rim == 0 { beta(n) } else { 0.25 / rim as f64 }
}

/// The weight of each neighbour of a vertex in its limit position, after infinitely many steps.
fn limit_share(n: usize, rim: usize) -> f64 {
    if rim == 0 {
        1.0 / (n as f64 + 0.375 / beta(n))
    } else {
        1.0 / (3.0 * rim as f64)
    }
}
