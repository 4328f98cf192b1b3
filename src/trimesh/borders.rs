//! Finds the borders and the connected parts of a mesh, in slices.

use super::{NONE, TriMesh};

/// Triangles, vertices or corners in a slice.
const SLICE: usize = 1 << 15;

/// The borders of a mesh as closed rings of vertices, one after the other. Seen from outside, the surface lies on
/// their left.
#[derive(Default)]
pub(super) struct BorderWalk {
    /// For each vertex the next one along its border, or [`NONE`] if the vertex has been passed or lies on no border.
    next: Vec<u32>,
    /// How many triangles have put their edges into `next`.
    linked: usize,
    /// The vertex at which the current ring starts, and the one that is reached.
    start: usize,
    reached: usize,
    /// The vertices of all rings.
    pub corners: Vec<u32>,
    /// Where each ring ends in the list of vertices.
    pub ends: Vec<usize>,
}

impl BorderWalk {
    /// Does one more slice; true when all rings are known.
    pub fn advance(&mut self, mesh: &TriMesh) -> bool {
        let count = mesh.triangles().len();
        self.next.resize(mesh.positions().len(), NONE);
        if self.linked < count {
            let end = count.min(self.linked + SLICE);
            (self.linked..end).for_each(|t| self.link(mesh, t));
            self.linked = end;
            return false;
        }
        for _ in 0..SLICE {
            if self.start == self.next.len() {
                return true;
            }
            let next = std::mem::replace(&mut self.next[self.reached], NONE);
            if next != NONE {
                self.corners.push(self.reached as u32);
                self.reached = next as usize;
                continue;
            }
            if self.corners.len() > self.ends.last().copied().unwrap_or(0) {
                self.ends.push(self.corners.len());
            }
            self.start += 1;
            self.reached = self.start;
        }
        false
    }

    fn link(&mut self, mesh: &TriMesh, t: usize) {
        let corners = mesh.triangles()[t];
        for k in (0..3).filter(|&k| mesh.across[t][k] == NONE) {
            self.next[corners[k] as usize] = corners[(k + 1) % 3];
        }
    }
}

/// The connected components of a mesh over edges.
#[derive(Default)]
pub(super) struct PartSearch {
    /// Triangles of the current part whose neighbours are still to be seen.
    open: Vec<u32>,
    /// All triangles before this one have a part.
    at: usize,
    /// The number of each triangle's part.
    pub part: Vec<u32>,
    /// How many parts there are.
    pub count: usize,
}

impl PartSearch {
    /// Does one more slice; true when all parts are known.
    pub fn advance(&mut self, mesh: &TriMesh) -> bool {
        self.part.resize(mesh.triangles().len(), NONE);
        for _ in 0..SLICE {
            if let Some(t) = self.open.pop() {
                self.spread(mesh, t);
            } else if self.at == self.part.len() {
                return true;
            } else {
                if self.part[self.at] == NONE {
                    self.part[self.at] = self.count as u32;
                    self.count += 1;
                    self.open.push(self.at as u32);
                }
                self.at += 1;
            }
        }
        false
    }

    /// Adds the neighbours of a triangle to its part.
    fn spread(&mut self, mesh: &TriMesh, t: u32) {
        for &edge in mesh.across[t as usize].iter().filter(|&&edge| edge != NONE) {
            let other = edge / 3;
            if self.part[other as usize] == NONE {
                self.part[other as usize] = self.part[t as usize];
                self.open.push(other);
            }
        }
    }
}

impl TriMesh {
    /// The borders as closed rings of vertices. Seen from outside, the surface lies on their left.
    pub fn borders(&self) -> Vec<Vec<u32>> {
        let mut walk = BorderWalk::default();
        while !walk.advance(self) {}
        let starts = std::iter::once(0).chain(walk.ends.iter().copied());
        let rings = starts.zip(&walk.ends);
        rings
            .map(|(start, &end)| walk.corners[start..end].to_vec())
            .collect()
    }

    /// Connected components over edges: the number of each triangle's component, and how many there are.
    pub fn parts(&self) -> (Vec<u32>, usize) {
        let mut search = PartSearch::default();
        while !search.advance(self) {}
        (search.part, search.count)
    }
}
