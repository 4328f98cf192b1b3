//! Finds where three cells meet, and makes the triangles between them.

use super::divided::Divided;
use crate::mesh::triangles::Triangles;
use crate::trimesh::NONE;

/// Triangles of the domain to look at in a slice.
const TRIANGLES: usize = 60_000;
/// Sides to follow in a slice.
const SIDES: usize = 6000;

/// The triangles between cells, while they are made.
#[derive(Default)]
pub(super) struct Junctions {
    /// Triangles of the domain whose corners belong to three different cells, in rising order.
    pub places: Vec<u32>,
    looked: usize,
    made: Triangles,
}

impl Junctions {
    /// Does one more slice; returns the triangles when all are made.
    pub fn advance(&mut self, divided: &Divided, label: &[u32]) -> Option<Triangles> {
        let labels = |t: u32| divided.triangles[t as usize].map(|v| label[v as usize]);
        let count = divided.triangles.len();
        if self.looked < count {
            let end = count.min(self.looked + TRIANGLES);
            for t in self.looked as u32..end as u32 {
                let [a, b, c] = labels(t);
                if a != b && b != c && c != a && a != NONE && b != NONE && c != NONE {
                    self.places.push(t);
                    self.made.nodes.push([a, b, c]);
                }
            }
            self.looked = end;
            return None;
        }
        let from = self.made.adjacent.len();
        let to = self.places.len().min(from + SIDES);
        for &place in &self.places[from..to] {
            let side = |k| self.follow(divided, &labels, place, k);
            // Sides are stored by the corner opposite them.
            self.made.adjacent.push([side(1), side(2), side(0)]);
        }
        (to == self.places.len()).then(|| std::mem::take(&mut self.made))
    }

    /// Follows the line between two cells from an edge of a triangle to the next triangle of three cells. [`NONE`] if
    /// the line ends at the border.
    fn follow(
        &self,
        divided: &Divided,
        labels: &impl Fn(u32) -> [u32; 3],
        mut t: u32,
        mut k: usize,
    ) -> u32 {
        loop {
            let next = divided.across[t as usize][k];
            if next == NONE {
                return NONE;
            }
            let corners = divided.triangles[t as usize];
            let j = divided.edge(next, corners[(k + 1) % 3], corners[k]);
            let here = labels(next);
            let (a, b, c) = (here[j], here[(j + 1) % 3], here[(j + 2) % 3]);
            if c == a {
                k = (j + 1) % 3;
            } else if c == b {
                k = (j + 2) % 3;
            } else {
                return self.places.binary_search(&next).map_or(NONE, |k| k as u32);
            }
            t = next;
        }
    }
}
