//! Faults for which a model is no building, and warnings about a building.

use super::ids::{CornerId, EdgeId, FaceId};
use glam::DVec3;

/// Coordinates and lengths beyond this are refused (metres).
pub const FARTHEST: f64 = 1e4;
/// The most faces of a building.
pub const MOST_FACES: usize = 4000;
/// The most sides of loops, vertices, arcs, or triangles of extra meshes.
pub const MOST_SIDES: usize = 200_000;
/// The greatest distance of a loop from its surface (metres).
pub const OFF_SURFACE: f64 = 1e-3;

/// Why a model is no building.
#[derive(Clone, Debug, PartialEq)]
pub enum BuildingFault {
    /// The text is not JSON.
    NotJson {
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// The parser's words.
        why: String,
    },
    /// The text is an OBJ file with a line that cannot be read, or too large; the notice says which.
    NotObj(crate::notice::Notice),
    /// The version is not 1.
    Version {
        /// The version that is given, as text; empty if there is none.
        found: String,
    },
    /// The unit is not `m`.
    Unit {
        /// The unit that is given, as text; empty if there is none.
        found: String,
    },
    /// A value is missing, or of the wrong kind.
    Field {
        /// Where it is, such as `faces[3].loops[0]`.
        path: String,
        /// The kind that is allowed there.
        allowed: &'static str,
    },
    /// A number is not finite, or greater than [`FARTHEST`].
    Number {
        /// Where the number is, such as `v[3]`.
        path: String,
        /// The number as text.
        found: String,
    },
    /// A vertex of an OBJ file has a coordinate that is not finite, or greater than [`FARTHEST`].
    Far {
        /// The vertex, counted from 1.
        vertex: usize,
        /// The coordinate as text (metres).
        found: String,
        /// The size of the box around all vertices (metres).
        size: [f64; 3],
    },
    /// There are no faces.
    Empty,
    /// There are more than [`MOST_FACES`] faces.
    TooManyFaces {
        /// The number of faces.
        faces: usize,
    },
    /// There are more than [`MOST_SIDES`] sides of loops, vertices, arcs, or triangles of extra meshes; or more than
    /// twice as many vertices after arcs are cut.
    TooManySides {
        /// The number that is too great.
        sides: usize,
    },
    /// A loop, an arc or a triangle names a vertex that does not exist.
    NoVertex {
        /// Where it is named.
        path: String,
        /// The vertex that is named.
        vertex: u32,
    },
    /// A loop has fewer than three vertices that differ by over 0.2 mm.
    ShortLoop {
        /// The face.
        face: FaceId,
        /// The number of the loop in the face.
        ring: usize,
    },
    /// An arc has no axis, its ends do not lie on a circle about it, or another arc joins the same vertices.
    BadArc {
        /// The number of the arc in the draft.
        arc: usize,
        /// The fault.
        why: ArcFault,
    },
    /// A face has no parameterisation.
    NoSurface {
        /// The face.
        face: FaceId,
    },
    /// The parameterisation of a face is invalid.
    BadSurface {
        /// The face.
        face: FaceId,
        /// The fault.
        why: SurfaceFault,
    },
    /// A loop lies off its surface by more than [`OFF_SURFACE`].
    OffSurface {
        /// The face.
        face: FaceId,
        /// The place of the loop that is off (metres).
        at: DVec3,
        /// The distance from the surface (metres).
        by: f64,
    },
    /// Loops of a face cross or touch themselves or each other.
    Crossing {
        /// The face.
        face: FaceId,
        /// A place where they do (metres).
        at: DVec3,
    },
    /// The loops of a face enclose no area, or run the wrong way: outer ones have to be counter-clockwise.
    InsideOut {
        /// The face.
        face: FaceId,
    },
    /// An arc of a loop is not cut where its face bends: its circle is not that of the surface.
    NotOnCircle {
        /// The face.
        face: FaceId,
        /// A place on the arc (metres).
        at: DVec3,
    },
    /// More than two faces meet along a side (section 6 of the paper leaves that to future work).
    NonManifold {
        /// The ends of the side, as vertices of the draft.
        vertices: [u32; 2],
        /// The faces there.
        faces: Vec<FaceId>,
    },
    /// Two faces walk a side in the same direction, so one of them is turned over.
    TurnedOver {
        /// The ends of the side, as vertices of the draft.
        vertices: [u32; 2],
        /// Both faces.
        faces: [FaceId; 2],
    },
    /// Two polygons of an OBJ file run the same way along a side.
    Polygons {
        /// The ends of the side, as numbers of vertices in the file, from 0.
        vertices: [usize; 2],
        /// Both polygons, as numbers of polygons in the file, from 0.
        polygons: [usize; 2],
        /// The fault.
        why: PolygonFault,
    },
}

/// Why two polygons of an OBJ file run the same way along a side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PolygonFault {
    /// No other polygon meets them there, so one of them is turned over.
    Turned,
    /// More than two polygons meet there: this many.
    Many(usize),
    /// Both have the same vertices.
    Twice,
    /// Both are the same polygon.
    Itself,
}

/// The fault of an arc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArcFault {
    /// The axis is the zero vector.
    NoAxis,
    /// The ends' distances from the centre differ by over 1 mm, or the start is within 1 mm of the centre.
    Radius,
    /// An end lies over 1 mm off the plane through the centre that is normal to the axis.
    Plane,
    /// Another arc joins the same two vertices.
    Twice,
}

/// The fault of a parameterisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceFault {
    /// A profile has no piece, a piece has no length, or a radius is not above 0.
    NoLength,
    /// Pieces of a profile do not meet within 1 mm.
    Gap,
    /// A profile has a kink: its pieces have to be tangent within a degree.
    Kink,
    /// A direction is not a unit vector at right angles to the profile, within 1e-6.
    Direction,
    /// An arc runs around its circle more than once.
    Turns,
    /// The loops of a whole cylinder or disk do not bound a region.
    Unbounded,
}

/// An oddity of a building, which is built nevertheless.
#[derive(Clone, Debug, PartialEq)]
pub enum BuildingWarning {
    /// Edges with one face: ground lines, single walls. They carry no cells.
    OpenEdges(Vec<EdgeId>),
    /// A corner joins parts that have no edge in common.
    Pinched(CornerId),
    /// A label or a flip names two vertices that are no side of a loop.
    NoSuchEdge {
        /// The two vertices that are named.
        vertices: [u32; 2],
    },
    /// A label or a flip names a vertex that is no corner.
    NoSuchCorner {
        /// The vertex that is named.
        vertex: u32,
    },
    /// No loop has this arc as a side.
    UnusedArc {
        /// The number of the arc in the draft.
        arc: usize,
    },
}
