//! Builds a [`TriMesh`] from vertices and triangles, in slices.

use super::mesh::{MeshFault, TriMesh};
use crate::csr::NONE;
use crate::order;
use glam::DVec3;

/// Triangles or vertices in a slice.
const SLICE: usize = 1 << 14;
/// Edges of one vertex are compared in pairs up to this count, and sorted by their other end above it.
const MANY: usize = 24;

/// A mesh that is being built.
pub struct MeshBuilding {
    mesh: TriMesh,
    stage: BuildingPhase,
    /// How many triangles or vertices the current stage has done.
    at: usize,
    /// How many triangles each vertex has.
    degrees: Vec<u32>,
    /// Where the edges of each vertex begin in `edges`. An edge belongs to its end with fewer triangles, so that not even
    /// the middle of a large fan has many.
    starts: Vec<u32>,
    edges: Vec<u32>,
}

#[derive(Clone, Copy, PartialEq)]
enum BuildingPhase {
    Check,
    Count,
    Sort,
    Link,
    Faces,
    Normals,
}

impl MeshBuilding {
    /// Starts with the vertices and with triangles that run counter-clockwise seen from outside.
    pub fn new(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Self {
        Self {
            mesh: TriMesh {
                first: vec![NONE; positions.len()],
                normals: vec![DVec3::ZERO; positions.len()],
                faces: Vec::new(),
                across: Vec::new(),
                area: 0.0,
                positions,
                triangles,
            },
            stage: BuildingPhase::Check,
            at: 0,
            degrees: Vec::new(),
            starts: Vec::new(),
            edges: Vec::new(),
        }
    }

    /// Does one more slice. Returns the mesh when it is done, or the fault of the triangles.
    pub fn advance(&mut self) -> Option<Result<TriMesh, MeshFault>> {
        let count = match self.stage {
            BuildingPhase::Link | BuildingPhase::Normals => self.mesh.positions.len(),
            _ => self.mesh.triangles.len(),
        };
        let end = count.min(self.at + SLICE);
        let range = self.at..end;
        self.at = end;
        let worked = match self.stage {
            BuildingPhase::Check => self.check(range),
            BuildingPhase::Count => {
                self.count(range);
                Ok(())
            }
            BuildingPhase::Sort => {
                self.sort(range);
                Ok(())
            }
            BuildingPhase::Link => range.into_iter().try_for_each(|v| {
                let edges = &mut self.edges[span(&self.starts, v)];
                link(&mut self.mesh, v as u32, edges)
            }),
            BuildingPhase::Faces => {
                range.for_each(|t| self.mesh.weigh(t));
                Ok(())
            }
            BuildingPhase::Normals => {
                for normal in &mut self.mesh.normals[range] {
                    *normal = normal.normalize_or(DVec3::Y);
                }
                Ok(())
            }
        };
        if let Err(fault) = worked {
            return Some(Err(fault));
        }
        (end == count && self.is_last()).then(|| {
            let empty = TriMesh::none();
            Ok(std::mem::replace(&mut self.mesh, empty))
        })
    }

    /// Does all the work at once.
    ///
    /// # Errors
    /// A fault of the triangles.
    pub fn finish(mut self) -> Result<TriMesh, MeshFault> {
        loop {
            if let Some(mesh) = self.advance() {
                return mesh;
            }
        }
    }

    /// Goes to the next stage; true after the last one.
    fn is_last(&mut self) -> bool {
        self.at = 0;
        self.stage = match self.stage {
            BuildingPhase::Check => {
                self.starts = vec![0; self.mesh.positions.len() + 2];
                BuildingPhase::Count
            }
            BuildingPhase::Count => {
                for v in 1..self.starts.len() {
                    self.starts[v] += self.starts[v - 1];
                }
                self.edges = vec![0; 3 * self.mesh.triangles.len()];
                BuildingPhase::Sort
            }
            BuildingPhase::Sort => {
                self.degrees = Vec::new();
                self.mesh.across = vec![[NONE; 3]; self.mesh.triangles.len()];
                BuildingPhase::Link
            }
            BuildingPhase::Link => {
                (self.starts, self.edges) = (Vec::new(), Vec::new());
                self.mesh.faces.reserve_exact(self.mesh.triangles.len());
                BuildingPhase::Faces
            }
            BuildingPhase::Faces => BuildingPhase::Normals,
            BuildingPhase::Normals => return true,
        };
        false
    }

    fn check(&mut self, range: std::ops::Range<usize>) -> Result<(), MeshFault> {
        if self.mesh.triangles.is_empty() {
            return Err(MeshFault::Empty);
        }
        if range.start == 0 && !self.mesh.positions.iter().all(|p| p.is_finite()) {
            return Err(MeshFault::NotFinite);
        }
        let count = self.mesh.positions.len() as u32;
        let is_bad = |t: &[u32; 3]| {
            t.iter().any(|&v| v >= count) || t[0] == t[1] || t[1] == t[2] || t[2] == t[0]
        };
        if self.mesh.triangles[range.clone()].iter().any(is_bad) {
            return Err(MeshFault::BadTriangle);
        }
        self.degrees.resize(self.mesh.positions.len(), 0);
        for &v in self.mesh.triangles[range].iter().flatten() {
            self.degrees[v as usize] += 1;
        }
        Ok(())
    }

    /// The vertices that the three edges of a triangle belong to.
    fn owners(&self, t: usize) -> [u32; 3] {
        let [a, b, c] = self.mesh.triangles[t].map(|v| (self.degrees[v as usize], v));
        [a.min(b), b.min(c), c.min(a)].map(|(_, v)| v)
    }

    // Counts stand two places further on: after the prefix sum, entry v + 1 is where vertex v begins, and filling the
    // list moves it to where v ends.
    fn count(&mut self, range: std::ops::Range<usize>) {
        for t in range {
            for v in self.owners(t) {
                self.starts[v as usize + 2] += 1;
            }
        }
    }

    fn sort(&mut self, range: std::ops::Range<usize>) {
        for t in range {
            for (k, v) in self.owners(t).into_iter().enumerate() {
                let place = &mut self.starts[v as usize + 1];
                self.edges[*place as usize] = (3 * t + k) as u32;
                *place += 1;
            }
        }
    }
}

/// The range of a vertex' edges.
fn span(starts: &[u32], v: usize) -> std::ops::Range<usize> {
    starts[v] as usize..starts[v + 1] as usize
}

/// The two ends of a directed edge, in its direction.
fn ends(mesh: &TriMesh, edge: u32) -> [u32; 2] {
    let (t, k) = (edge as usize / 3, edge as usize % 3);
    let corners = &mesh.triangles[t];
    [corners[k], corners[(k + 1) % 3]]
}

/// Joins edges that have the same two ends. All of `edges` belong to `vertex`.
fn link(mesh: &mut TriMesh, vertex: u32, edges: &mut [u32]) -> Result<(), MeshFault> {
    // Exclusive or with the vertex leaves the other end.
    let other_end = |[a, b]: [u32; 2]| a ^ b ^ vertex;
    let sorted = edges.len() > MANY;
    if sorted {
        order::sort(edges, |&edge| {
            (other_end(ends(mesh, edge)).into(), edge.into())
        });
    }
    for (i, &edge) in edges.iter().enumerate() {
        let own = ends(mesh, edge);
        for &other in &edges[i + 1..] {
            let theirs = ends(mesh, other);
            if sorted && other_end(theirs) != other_end(own) {
                break;
            }
            if theirs == own {
                return Err(MeshFault::BadEdge);
            }
            if theirs == [own[1], own[0]] {
                for (from, to) in [(edge, other), (other, edge)] {
                    let place = &mut mesh.across[from as usize / 3][from as usize % 3];
                    if *place != NONE {
                        return Err(MeshFault::BadEdge);
                    }
                    *place = to;
                }
            }
        }
    }
    Ok(())
}

impl TriMesh {
    /// Builds a mesh from vertices and triangles, which run counter-clockwise seen from outside.
    ///
    /// # Errors
    /// A fault of the triangles, see [`MeshFault`].
    pub fn new(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshFault> {
        MeshBuilding::new(positions, triangles).finish()
    }

    /// An empty mesh: the placeholder that a builder keeps when its mesh is taken out.
    pub(super) fn none() -> Self {
        Self {
            positions: Vec::new(),
            triangles: Vec::new(),
            across: Vec::new(),
            normals: Vec::new(),
            faces: Vec::new(),
            first: Vec::new(),
            area: 0.0,
        }
    }

    /// Adds a triangle to the normals of its corners, weighted with the angles there (Thurmer, Wuthrich 1998,
    /// Computing Vertex Normals from Polygonal Facets), to the area, and to the first corners of its vertices.
    fn weigh(&mut self, t: usize) {
        let corners = self.corners(t as u32);
        let cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let double = cross.length();
        let normal = cross.try_normalize().unwrap_or(DVec3::ZERO);
        self.faces.push(normal);
        self.area += 0.5 * double;
        for k in 0..3 {
            let (e, f) = (
                corners[(k + 1) % 3] - corners[k],
                corners[(k + 2) % 3] - corners[k],
            );
            let v = self.triangles[t][k] as usize;
            self.normals[v] += libm::atan2(double, e.dot(f)) * normal;
            // A counter-clockwise fan at the border begins with the corner that has no triangle before it.
            if self.first[v] == NONE || self.across[t][k] == NONE {
                self.first[v] = (3 * t + k) as u32;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing;
    use super::*;

    #[test]
    fn no_vertex_has_many_edges_to_compare() {
        for (positions, triangles) in [testing::disc(3000), testing::ball(3)] {
            let mut building = MeshBuilding::new(positions, triangles);
            while building.stage != BuildingPhase::Link {
                assert!(building.advance().is_none());
            }
            let vertices = 0..building.mesh.positions.len();
            let most = vertices.map(|v| span(&building.starts, v).len()).max();
            assert!(most.is_some_and(|most| most <= MANY), "{most:?}");
        }
    }
}
