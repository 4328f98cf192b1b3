//! A building as files and rules describe it, not checked yet.

use super::surface::FaceSurface;
use glam::DVec3;

/// A building as it is described: numbered vertices, and faces with their loops. All lengths are metres, y is up.
/// [`super::Building::new`] checks it and makes both meshes of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draft {
    /// The vertices that loops name by number.
    pub vertices: Vec<DVec3>,
    /// The sides of loops that are arcs of circles; all others are straight.
    pub arcs: Vec<DraftArc>,
    /// The faces.
    pub faces: Vec<DraftFace>,
    /// Labels for single edges: the two vertices of a side, and a label for the edge that the side belongs to.
    pub edge_labels: Vec<([u32; 2], String)>,
    /// Labels for single corners: a vertex, and a label for the corner there.
    pub corner_labels: Vec<(u32, String)>,
    /// Edges whose pattern is flipped by hand (section 5.2, the stored bit), each named by the two vertices of a side.
    pub edge_flips: Vec<[u32; 2]>,
    /// Corners whose pattern is flipped by hand, each named by its vertex.
    pub corner_flips: Vec<u32>,
    /// Meshes that carry no masonry: glass, doors, rails.
    pub extras: Vec<ExtraMesh>,
    /// The height of the ground (metres), if there is any.
    pub ground: Option<f64>,
}

/// A side that is an arc: counter-clockwise from `from` to `to`, if the axis points at the viewer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DraftArc {
    /// The vertex at its start.
    pub from: u32,
    /// The vertex at its end.
    pub to: u32,
    /// The centre of the circle (metres).
    pub centre: DVec3,
    /// The axis; its length does not matter.
    pub axis: DVec3,
}

/// A face.
#[derive(Clone, Debug, PartialEq)]
pub struct DraftFace {
    /// Its labels, the most important one first.
    pub labels: Vec<String>,
    /// Its surface; a face without one is an error.
    pub surface: Option<FaceSurface>,
    /// Its loops of vertices, seen from outside: outer ones counter-clockwise, holes clockwise. A whole cylinder has
    /// one loop around its bottom and one around its top.
    pub loops: Vec<Vec<u32>>,
    /// The thickness of the wall behind the face (metres), if the wall is this single face without a back.
    pub thickness: Option<f64>,
}

/// A mesh that carries no masonry.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExtraMesh {
    /// Its kind, such as `pane` or `rail`.
    pub name: String,
    /// A word for its material, such as `glass`, `wood` or `iron`.
    pub material: String,
    /// Its vertices (metres).
    pub positions: Vec<DVec3>,
    /// Its triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}
