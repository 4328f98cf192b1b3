//! A cell on a surface.

use crate::field::CellKind;
use crate::trimesh::SurfacePoint;
use glam::{DVec2, DVec3};

/// A packed cell with its polygon, in the mesh's units.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceCell {
    /// The particle it belongs to.
    pub id: u32,
    /// Its shape.
    pub kind: CellKind,
    /// Its particle's centre.
    pub centre: SurfacePoint,
    /// Unit vector along a side, in the frame of the centre; zero where the direction field vanishes.
    pub axis: DVec2,
    /// The side it should have; a stretched one has the area of a square of this side.
    pub size: f64,
    /// Length along `axis` over width.
    pub aspect: f64,
    /// Its corners, counter-clockwise seen from outside.
    pub ring: Vec<DVec3>,
    /// The unit normals of the surface at the corners.
    pub normals: Vec<DVec3>,
    /// Whether its ring runs along a border of the surface.
    pub on_border: bool,
}
