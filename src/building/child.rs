//! The child mesh: vertices, polygon edges and polygons (Legakis, Dorsey, Gortler 2001, section 3.1, figure 2).

use super::ids::{CornerId, EdgeId, FaceId, PolygonEdgeId, PolygonId, VertexId};
use super::wings::Wings;
use glam::DVec3;

/// A vertex of the child mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Vertex {
    /// Its place (metres).
    pub position: DVec3,
    /// A polygon edge that begins or ends here; at a vertex on a border, one that lies on the border.
    pub edge: PolygonEdgeId,
    /// The corner here, if there is one: most vertices have none.
    pub corner: Option<CornerId>,
}

/// A polygon edge of the child mesh: a straight piece of an [`super::Edge`], or a side of two polygons of one face.
#[derive(Clone, Debug, PartialEq)]
pub struct PolygonEdge {
    /// Its start and its end.
    pub vertices: [VertexId; 2],
    /// The polygon that walks it from start to end, and the one that walks it back; `None` where the border is.
    pub polygons: [Option<PolygonId>; 2],
    /// The polygon edges before and after it around both polygons.
    pub wings: Wings<PolygonEdgeId>,
    /// The edge of the parent mesh that it is part of; `None` inside of a face.
    pub edge: Option<EdgeId>,
}

/// A polygon of the child mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// Its vertices, counter-clockwise seen from outside.
    pub vertices: Vec<VertexId>,
    /// Its polygon edges: `edges[k]` joins `vertices[k]` and the next vertex.
    pub edges: Vec<PolygonEdgeId>,
    /// The face that it is part of.
    pub face: FaceId,
}
