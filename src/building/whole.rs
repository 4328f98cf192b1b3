//! A building: both meshes, with the links between them.

use super::child::{Polygon, PolygonEdge, Vertex};
use super::draft::ExtraMesh;
use super::fault::BuildingWarning;
use super::ids::{CornerId, EdgeId, FaceId, PolygonEdgeId, PolygonId, VertexId};
use super::parent::{Corner, Edge, EdgeEnd, Face};
use glam::DVec3;

/// A checked building. Its lists do not change; ids are places in them.
#[derive(Clone, Debug, PartialEq)]
pub struct Building {
    pub(super) vertices: Vec<Vertex>,
    pub(super) polygon_edges: Vec<PolygonEdge>,
    pub(super) polygons: Vec<Polygon>,
    pub(super) corners: Vec<Corner>,
    pub(super) edges: Vec<Edge>,
    pub(super) faces: Vec<Face>,
    pub(super) extras: Vec<ExtraMesh>,
    pub(super) ground: Option<f64>,
    pub(super) warnings: Vec<BuildingWarning>,
}

/// Directions at a place on an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeFrame {
    /// The place (metres).
    pub origin: DVec3,
    /// The unit tangent, from the edge's start to its end.
    pub tangent: DVec3,
    /// The outward unit normals of both faces.
    pub normals: [Option<DVec3>; 2],
    /// Unit vectors from the edge into both faces, along them: normal x tangent for the first face, tangent x normal for
    /// the second one.
    pub inward: [Option<DVec3>; 2],
}

impl Building {
    /// The vertices of the child mesh.
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// The polygon edges of the child mesh.
    pub fn polygon_edges(&self) -> &[PolygonEdge] {
        &self.polygon_edges
    }

    /// The polygons of the child mesh.
    pub fn polygons(&self) -> &[Polygon] {
        &self.polygons
    }

    /// The corners of the parent mesh.
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// The edges of the parent mesh.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The faces of the parent mesh, in the order of the draft.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// The meshes that carry no masonry.
    pub fn extras(&self) -> &[ExtraMesh] {
        &self.extras
    }

    /// The height of the ground (metres), if there is any.
    pub fn ground(&self) -> Option<f64> {
        self.ground
    }

    /// The oddities of the building.
    pub fn warnings(&self) -> &[BuildingWarning] {
        &self.warnings
    }

    /// A vertex.
    pub fn vertex(&self, id: VertexId) -> &Vertex {
        &self.vertices[id.index()]
    }

    /// A polygon edge.
    pub fn polygon_edge(&self, id: PolygonEdgeId) -> &PolygonEdge {
        &self.polygon_edges[id.index()]
    }

    /// A polygon.
    pub fn polygon(&self, id: PolygonId) -> &Polygon {
        &self.polygons[id.index()]
    }

    /// A corner.
    pub fn corner(&self, id: CornerId) -> &Corner {
        &self.corners[id.index()]
    }

    /// An edge.
    pub fn edge(&self, id: EdgeId) -> &Edge {
        &self.edges[id.index()]
    }

    /// A face.
    pub fn face(&self, id: FaceId) -> &Face {
        &self.faces[id.index()]
    }

    /// The ids of all corners.
    pub fn corner_ids(&self) -> impl Iterator<Item = CornerId> + use<> {
        (0..self.corners.len() as u32).map(CornerId)
    }

    /// The ids of all edges.
    pub fn edge_ids(&self) -> impl Iterator<Item = EdgeId> + use<> {
        (0..self.edges.len() as u32).map(EdgeId)
    }

    /// The ids of all faces.
    pub fn face_ids(&self) -> impl Iterator<Item = FaceId> + use<> {
        (0..self.faces.len() as u32).map(FaceId)
    }

    /// A copy of the building with the flip bits of these corners and edges inverted, once for each time that an id is
    /// listed. Ids that the building does not have are ignored.
    pub fn flipped(&self, corners: &[CornerId], edges: &[EdgeId]) -> Self {
        let mut turned = self.clone();
        for id in corners {
            let found = turned.corners.get_mut(id.index());
            found.into_iter().for_each(|corner| corner.flip ^= true);
        }
        for id in edges {
            let found = turned.edges.get_mut(id.index());
            found.into_iter().for_each(|edge| edge.flip ^= true);
        }
        turned
    }

    /// The place of a corner (metres).
    pub fn place(&self, id: CornerId) -> DVec3 {
        self.vertex(self.corner(id).vertex).position
    }

    /// The frame of an edge at an arc length from its start (metres).
    pub fn edge_frame(&self, id: EdgeId, along: f64) -> EdgeFrame {
        let edge = self.edge(id);
        let (origin, tangent) = (edge.path.point(along), edge.path.tangent(along));
        let normals = edge.faces.map(|face| {
            let surface = &self.face(face?).surface;
            let place = surface.project(origin);
            Some(surface.frame(place.x, place.y).normal)
        });
        let [first, second] = normals;
        EdgeFrame {
            origin,
            tangent,
            normals,
            inward: [
                first.map(|normal| normal.cross(tangent)),
                second.map(|normal| tangent.cross(normal)),
            ],
        }
    }

    /// The unit vector along which an edge leaves a corner.
    pub fn leaving(&self, end: EdgeEnd) -> DVec3 {
        let [start, stop] = self.edge(end.edge).path.end_tangents();
        if end.end == 0 { start } else { -stop }
    }
}
