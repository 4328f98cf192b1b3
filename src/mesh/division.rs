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
                let (mut least, mut apex) = (f64::INFINITY, [0, 0]);
                if span == 1 {
                    least = 0.0;
                }
                for a in i + 1..j {
                    let first = self.cost[i][a];
                    if first >= least {
                        continue;
                    }
                    for b in a + 1..j {
                        let inner = first + self.cost[a][b] + self.cost[b][j];
                        if inner < least {
                            let quad = [i, a, b, j].map(|k| corners[k]);
                            let score = score(nodes, quad);
                            if score >= worst && inner + 1.0 - score < least {
                                (least, apex) = (inner + 1.0 - score, [a as u8, b as u8]);
                            }
                        }
                    }
                    // A triangle is tried only if the polygon has an odd number of corners: an even number needs none.
                    let inner = first + self.cost[a][j] + TRIANGLE;
                    if inner < least
                        && n % 2 == 1
                        && height(nodes, [i, a, j].map(|k| corners[k])) > FLAT
                    {
                        (least, apex) = (inner, [a as u8, a as u8]);
                    }
                }
                self.cost[i][j] = least;
                self.apex[i][j] = apex;
            }
        }
        self.cost[0][n - 1]
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
