//! Cuts surfaces along their creases.

use super::super::{MeshBuilding, MeshFault, NONE, TriMesh};
use super::slice;
use super::split::Splitter;
use glam::DVec3;

/// A surface with borders along its creases.
#[derive(Clone, Debug, PartialEq)]
pub struct CreaseCut {
    /// The surface, with a vertex for each side of a crease.
    pub mesh: TriMesh,
    /// For each vertex, the one that it was before the cut. Vertices with the same origin stay at the same place.
    pub origin: Vec<u32>,
    /// How many edges were cut.
    pub count: usize,
}

/// Cuts all edges where the surface turns by more than an angle. Best after refining: then the faces between creases
/// come apart even where two creases do not meet at a vertex of the file.
pub struct CreaseCutting {
    at: usize,
    cos: f64,
    normals: Vec<DVec3>,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    across: Vec<[u32; 3]>,
    count: usize,
    splitter: Option<Splitter>,
    building: Option<MeshBuilding>,
}

impl CreaseCutting {
    /// Cuts along creases sharper than `angle`, in radians from 0 to pi.
    pub fn new(mesh: TriMesh, angle: f64) -> Self {
        Self {
            at: 0,
            cos: libm::cos(angle),
            normals: mesh.faces,
            positions: mesh.positions,
            triangles: mesh.triangles,
            across: mesh.across,
            count: 0,
            splitter: None,
            building: None,
        }
    }

    /// Does one more slice. Returns the surface when it is done, or the fault of the cut mesh.
    pub fn advance(&mut self) -> Option<Result<CreaseCut, MeshFault>> {
        if let Some(building) = &mut self.building {
            let mesh = building.advance()?;
            return Some(mesh.map(|mesh| self.cut_mesh(mesh)));
        }
        let count = self.triangles.len();
        if let Some(splitter) = &mut self.splitter {
            if splitter.advance(&mut self.positions, &mut self.triangles, &self.across) {
                let positions = std::mem::take(&mut self.positions);
                let triangles = std::mem::take(&mut self.triangles);
                self.across = Vec::new();
                self.building = Some(MeshBuilding::new(positions, triangles));
            }
            return None;
        }
        for t in slice(&mut self.at, count) {
            for k in 0..3 {
                self.cut(t, k);
            }
        }
        if self.at == count {
            self.splitter = Some(Splitter::new(self.positions.len(), count));
        }
        None
    }

    fn cut(&mut self, t: usize, k: usize) {
        let edge = self.across[t][k];
        if edge == NONE {
            return;
        }
        let other = edge as usize / 3;
        if self.normals[t].dot(self.normals[other]) < self.cos {
            self.across[t][k] = NONE;
            self.across[other][edge as usize % 3] = NONE;
            self.count += 1;
        }
    }

    fn cut_mesh(&mut self, mesh: TriMesh) -> CreaseCut {
        let all = 0..(mesh.positions.len() as u32);
        let added = self
            .splitter
            .take()
            .map_or(Vec::new(), |split| split.origin);
        let old = all.end as usize - added.len();
        CreaseCut {
            mesh,
            origin: all.take(old).chain(added).collect(),
            count: self.count,
        }
    }

    /// Does all the work at once.
    ///
    /// # Errors
    /// If the cut mesh has a fault.
    pub fn finish(mut self) -> Result<CreaseCut, MeshFault> {
        loop {
            if let Some(cut) = self.advance() {
                return cut;
            }
        }
    }
}
