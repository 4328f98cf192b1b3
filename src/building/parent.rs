//! The parent mesh: corners, edges and faces, the features that masonry is laid on (Legakis, Dorsey, Gortler 2001,
//! section 3.1, figure 2).

use super::class::{Bend, CornerClass};
use super::ids::{CornerId, EdgeId, FaceId, PolygonEdgeId, PolygonId, VertexId};
use super::path::Path;
use super::surface::FaceSurface;
use super::wings::Wings;
use glam::DVec2;

/// A walk along an edge: a part of a face's loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeUse {
    /// The edge.
    pub edge: EdgeId,
    /// True if it is walked from start to end: then the face is the edge's first one.
    pub forward: bool,
}

/// An end of an edge at a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeEnd {
    /// The edge.
    pub edge: EdgeId,
    /// 0 if the edge starts at the corner, 1 if it ends there.
    pub end: usize,
}

/// A corner: where edges meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Corner {
    /// Its vertex in the child mesh.
    pub vertex: VertexId,
    /// The ends of the edges that meet here, counter-clockwise seen from outside. At a border, the first and the last
    /// edge lie on it.
    pub edges: Vec<EdgeEnd>,
    /// The faces between the edges: `faces[k]` is between `edges[k]` and the next edge; `None` outside of a border.
    pub faces: Vec<Option<FaceId>>,
    /// Its labels: its own ones if it has any, else those of its faces (see [`super::labels`]).
    pub labels: Vec<String>,
    /// Whether the draft gives it labels of its own.
    pub has_own_labels: bool,
    /// Its valence, its numbers of convex and concave edges, and the direction of such an edge if it is the only one.
    pub class: CornerClass,
    /// The stored bit: whether its pattern is flipped by hand (section 5.2).
    pub flip: bool,
}

/// An edge: where two faces meet, or the border of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// The face that walks it from start to end and lies to its left, seen from outside, and the one that walks it back.
    /// The first one always exists.
    pub faces: [Option<FaceId>; 2],
    /// The corners at its start and its end; `None` if it is closed, as the rim of a cylinder.
    pub corners: [Option<CornerId>; 2],
    /// Its shape, by arc length from its start (metres).
    pub path: Path,
    /// Its polygon edges from start to end; true if a polygon edge runs in the direction of the edge.
    pub chain: Vec<(PolygonEdgeId, bool)>,
    /// Its neighbours in the loops of both faces.
    pub wings: Wings<EdgeId>,
    /// Whether it is convex, concave, smooth or open.
    pub bend: Bend,
    /// The angle that the solid fills at the middle of the edge (radians): below pi if convex, above if concave, pi if
    /// open.
    pub dihedral: f64,
    /// Its labels: its own ones if it has any, else those of its faces (see [`super::labels`]).
    pub labels: Vec<String>,
    /// Whether the draft gives it labels of its own.
    pub has_own_labels: bool,
    /// The stored bit: whether its pattern is flipped by hand (section 5.2).
    pub flip: bool,
}

impl Edge {
    /// Its length (metres).
    pub fn length(&self) -> f64 {
        self.path.length()
    }

    /// Whether it has no ends.
    pub fn is_closed(&self) -> bool {
        self.corners[0].is_none()
    }

    /// 0 for the face that walks it from start to end, 1 for the other one; `None` if it is not an edge of the face.
    pub fn side(&self, face: FaceId) -> Option<usize> {
        self.faces.iter().position(|&own| own == Some(face))
    }

    /// The face on the other side, seen from `face`; `None` at a border.
    pub fn across(&self, face: FaceId) -> Option<FaceId> {
        let side = self.side(face)?;
        self.faces[1 - side]
    }

    /// Whether it is vertical: the largest component of the way from its start to its end is along y (section 5.3,
    /// Orientation). A closed edge is not.
    pub fn is_vertical(&self) -> bool {
        let way = self.path.point(self.path.length()) - self.path.point(0.0);
        !self.is_closed() && way.y.abs() > way.x.abs().max(way.z.abs())
    }
}

/// How rows of masonry run on a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stance {
    /// A wall: t grows upwards, rows are of equal t.
    Upright,
    /// A reveal with an arch, or a vault: t grows inwards, rows run along s.
    Through,
    /// Ground, roofs and sills: a disk, or a flat face whose normal is steeper than about 45 degrees.
    Level,
}

/// A face, with holes or without.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Its labels, the most important one first.
    pub labels: Vec<String>,
    /// Its surface in closed form.
    pub surface: FaceSurface,
    /// Its loops of edges: outer ones counter-clockwise seen from outside, holes clockwise. A seam, where the face
    /// meets itself, is not in them.
    pub loops: Vec<Vec<EdgeUse>>,
    /// Its region in s and t (metres): rings of straight sides no longer than those of the child mesh, outer ones
    /// counter-clockwise. That of a whole cylinder or disk is cut open at a seam, so it spans one period in s.
    pub rings: Vec<Vec<DVec2>>,
    /// The bounding box of the rings.
    pub(super) bounds: [DVec2; 2],
    /// Its polygons in the child mesh.
    pub polygons: Vec<PolygonId>,
    /// The thickness of the wall behind the face (metres), if the wall is this single face without a back.
    pub thickness: Option<f64>,
}

impl Face {
    /// Whether it has a label.
    pub fn has_label(&self, wanted: &str) -> bool {
        self.labels.iter().any(|label| label == wanted)
    }

    /// How rows run on it.
    pub fn stance(&self) -> Stance {
        let FaceSurface::Sweep(sweep) = &self.surface else {
            return Stance::Level;
        };
        let rise = sweep.direction().y;
        let is_flat = self.surface.is_flat();
        if is_flat && self.surface.frame(0.0, 0.0).normal.y.abs() > STEEP {
            Stance::Level
        } else if rise > UPRIGHT || (is_flat && rise > STEEP) {
            Stance::Upright
        } else {
            Stance::Through
        }
    }

    /// Its bounding box in s and t (metres): the least and the greatest values.
    pub fn bounds(&self) -> [DVec2; 2] {
        self.bounds
    }
}

/// A face is upright if the direction of t has a greater y: it is within 2.6 degrees of upwards.
const UPRIGHT: f64 = 0.999;
/// Flat faces whose normals have a greater |y| are level; other flat faces on which t rises more than this are upright.
const STEEP: f64 = 0.7;
