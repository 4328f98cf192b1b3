//! How thick a wall is behind a place on its face.

use super::ids::FaceId;
use super::whole::Building;
use crate::trimesh::{MeshFault, Search, TriMesh};
use std::sync::Arc;

/// A surface counts as opposite if the cosine between the ray and its outward normal is greater: within 60 degrees.
const OPPOSITE: f64 = 0.5;
/// A ray begins this far behind its face (metres).
const BELOW: f64 = 1e-4;

/// Finds the thickness of walls by rays through the child mesh, with a tree of boxes.
#[derive(Clone, Debug)]
pub struct WallThickness {
    building: Arc<Building>,
    mesh: TriMesh,
    search: Search,
}

impl WallThickness {
    /// Prepares a building.
    ///
    /// # Errors
    /// If its polygons are not a valid mesh. After the tests of [`Building::new`], only degenerate polygons can cause
    /// that.
    pub fn new(building: Arc<Building>) -> Result<Self, MeshFault> {
        let positions = building.vertices().iter().map(|v| v.position).collect();
        let triangles = building.polygons().iter();
        let corners = |k: usize| move |polygon: &super::child::Polygon| polygon.vertices[k].0;
        let triangle = |p| [corners(0)(p), corners(1)(p), corners(2)(p)];
        let mesh = TriMesh::new(positions, triangles.map(triangle).collect())?;
        let search = Search::new(&mesh);
        Ok(Self {
            building,
            mesh,
            search,
        })
    }

    /// The thickness of the wall behind s and t on a face (metres): the way along the inward normal to the first
    /// surface that looks away from the face. If there is none, the thickness that the face has from the draft. `None`
    /// if the building is open there, or if the wall is thicker than `most`.
    pub fn behind(&self, face: FaceId, s: f64, t: f64, most: f64) -> Option<f64> {
        let own = self.building.face(face);
        let frame = own.surface.frame(s, t);
        let way = -frame.normal;
        let from = frame.origin + way * BELOW;
        let is_opposite = |triangle: u32| self.mesh.face_normal(triangle).dot(way) > OPPOSITE;
        let search = &self.search;
        let reach = own.thickness.map_or(most, |_| f64::INFINITY);
        let hit = search.ray_within(&self.mesh, (from, way), reach, is_opposite);
        hit.map(|hit| hit.along + BELOW).or(own.thickness)
    }
}
