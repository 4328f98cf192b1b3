//! Divides polygons into quadrilaterals at the least cost.
//!
//! Dynamic programming over the polygon's chords, as for its cheapest triangulation (Klincsek 1980, Minimal
//! triangulations of polygonal domains): the best division on one side of a chord does not depend on the
//! other side.

use super::Nodes;
use super::quads::{height, score};

/// The most corners of a polygon.
pub(super) const MOST: usize = 14;
/// Cost of a triangle; a quadrilateral costs 1 minus its score.
pub(super) const TRIANGLE: f64 = 1.5;
/// A new triangle is higher than this share of its longest side.
const FLAT: f64 = 0.4;

/// The cheapest divisions of one polygon with at most [`MOST`] corners.
pub(super) struct Division {
    /// For each pair of corners i < j, the least cost of the part between them.
    cost: [[f64; MOST]; MOST],
    /// The other two corners of the quadrilateral beside the chord from i to j; for a triangle the corner
    /// twice.
    apex: [[[u8; 2]; MOST]; MOST],
}

/// The best division of a part of the polygon found so far: an entry of both tables of [`Division`].
struct Best {
    cost: f64,
    apex: [u8; 2],
}

impl Best {
    const NONE: Self = Self {
        cost: f64::INFINITY,
        apex: [0, 0],
    };
    /// A side of the polygon has no part beside it.
    const SIDE: Self = Self {
        cost: 0.0,
        ..Self::NONE
    };
}

impl Division {
    /// Starts empty.
    pub fn new() -> Self {
        Self {
            cost: [[0.0; MOST]; MOST],
            apex: [[[0; 2]; MOST]; MOST],
        }
    }

    /// Finds the cheapest division into quadrilaterals that score at least `worst`, with at most one
    /// triangle; gives its cost.
    pub fn of<N: Nodes + ?Sized>(&mut self, nodes: &N, corners: &[u32], worst: f64) -> f64 {
        let n = corners.len();
        for span in 1..n {
            for i in 0..n - span {
                let j = i + span;
                let best = match span {
                    1 => Best::SIDE,
                    _ => self.cheapest((nodes, corners), worst, [i, j]),
                };
                (self.cost[i][j], self.apex[i][j]) = (best.cost, best.apex);
            }
        }
        self.cost[0][n - 1]
    }

    /// The cheapest division of the part between corners i and j, from those of shorter parts.
    fn cheapest<N: Nodes + ?Sized>(
        &self,
        on: (&N, &[u32]),
        worst: f64,
        [i, j]: [usize; 2],
    ) -> Best {
        let mut best = Best::NONE;
        for a in i + 1..j {
            if self.cost[i][a] < best.cost {
                self.try_quads(on, worst, [i, a, j], &mut best);
                self.try_triangle(on, [i, a, j], &mut best);
            }
        }
        best
    }

    /// Tries the quadrilaterals with corners i, a and j.
    fn try_quads<N: Nodes + ?Sized>(
        &self,
        (nodes, corners): (&N, &[u32]),
        worst: f64,
        [i, a, j]: [usize; 3],
        best: &mut Best,
    ) {
        for b in a + 1..j {
            let inner = self.cost[i][a] + self.cost[a][b] + self.cost[b][j];
            if inner >= best.cost {
                continue;
            }
            let score = score(nodes, [i, a, b, j].map(|k| corners[k]));
            if score >= worst && inner + 1.0 - score < best.cost {
                best.cost = inner + 1.0 - score;
                best.apex = [a as u8, b as u8];
            }
        }
    }

    /// Tries the triangle of corners i, a and j.
    fn try_triangle<N: Nodes + ?Sized>(
        &self,
        (nodes, corners): (&N, &[u32]),
        [i, a, j]: [usize; 3],
        best: &mut Best,
    ) {
        // A polygon with an even number of corners needs no triangle.
        let is_odd = corners.len() % 2 == 1;
        let cost = self.cost[i][a] + self.cost[a][j] + TRIANGLE;
        let is_high = || height(nodes, [i, a, j].map(|k| corners[k])) > FLAT;
        if is_odd && cost < best.cost && is_high() {
            (best.cost, best.apex) = (cost, [a as u8; 2]);
        }
    }

    /// The elements of the division found for `n` corners, as positions in the polygon.
    pub fn pieces(&self, n: usize, mut each: impl FnMut(&[u8])) {
        let mut open = vec![(0u8, n as u8 - 1)];
        while let Some((i, j)) = open.pop() {
            if j - i < 2 {
                continue;
            }
            let [a, b] = self.apex[usize::from(i)][usize::from(j)];
            if a == b {
                each(&[i, a, j]);
                open.extend([(i, a), (a, j)]);
            } else {
                each(&[i, a, b, j]);
                open.extend([(i, a), (a, b), (b, j)]);
            }
        }
    }
}
