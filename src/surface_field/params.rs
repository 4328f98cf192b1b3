//! Parameters of the fields of a surface.

use super::{Bone, Stroke};
use crate::field::CellKind;
use crate::trimesh::SurfacePoint;
use glam::DVec3;

/// Parameters of the fields of a surface. Lengths and places are in the mesh's units, angles in radians.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceFieldParams {
    /// Kind of the cells.
    pub kind: CellKind,
    /// Size of the cells.
    pub size: SizeParams,
    /// Aspect ratio of stretched cells.
    pub aspect: AspectParams,
    /// Where the direction of cells comes from.
    pub direction: DirectionParams,
    /// Where the flow from head to tail comes from; `None` without a flow.
    pub flow: Option<FlowParams>,
    /// Skeleton curves inside the body, from head to tail.
    pub bones: Vec<Bone>,
}

/// The mean size of cells, before anything changes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// The side of a cell; a stretched one has the area of a square of this side.
    Size(f64),
    /// About this many cells on the surface.
    Count(f64),
}

/// The direction along which a value changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Along {
    /// From the lowest point of the surface in this direction to the highest; for height, (0, 1, 0).
    Axis(DVec3),
    /// From the head of the bones to their tail.
    Bones,
}

/// A factor whose logarithm changes linearly along the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taper {
    /// The direction of the change.
    pub along: Along,
    /// The factor at the start ...
    pub first: f64,
    /// ... and at the end.
    pub last: f64,
}

/// Makes cells smaller where the surface is more curved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByCurvature {
    /// The angle in radians that a cell spans; useful from 0.1 to 0.35.
    pub angle: f64,
    /// The smallest and the largest factor of the size.
    pub factors: (f64, f64),
}

/// A soft spot: its value holds in the middle and fades smoothly to nothing at the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceSpot {
    /// Its middle. The spot does not reach the other side of a thin sheet.
    pub at: SurfacePoint,
    /// The distance at which it ends.
    pub radius: f64,
    /// A factor of the size, or an aspect ratio.
    pub value: f64,
}

/// Where sizes come from. The factors of all sources are multiplied.
#[derive(Clone, Debug, PartialEq)]
pub struct SizeParams {
    /// The mean size.
    pub amount: Amount,
    /// Change of the size along the body.
    pub taper: Option<Taper>,
    /// Change of the size with the curvature.
    pub curvature: Option<ByCurvature>,
    /// Spots; factors of spots that overlap are multiplied.
    pub spots: Vec<SurfaceSpot>,
    /// The steepest slope of the size, where curvature and spots change it.
    pub slope: f64,
}

impl Default for SizeParams {
    fn default() -> Self {
        Self {
            amount: Amount::Count(1000.0),
            taper: None,
            curvature: None,
            spots: Vec::new(),
            slope: 0.25,
        }
    }
}

/// Where aspect ratios come from.
#[derive(Clone, Debug, PartialEq)]
pub struct AspectParams {
    /// Length along the direction over width, 1..5.
    pub aspect: f64,
    /// A factor that changes along the body.
    pub taper: Option<Taper>,
    /// Whether cells are round where the surface is curved alike in all directions, and stretched where it is curved
    /// one way only.
    pub by_curvature: bool,
    /// Spots with an aspect ratio of their own, later ones over earlier ones.
    pub spots: Vec<SurfaceSpot>,
}

impl Default for AspectParams {
    fn default() -> Self {
        Self {
            aspect: 1.0,
            taper: None,
            by_curvature: false,
            spots: Vec::new(),
        }
    }
}

/// The weights of the constraints of directions; 0 has no influence. If all are 0, the field is as smooth as possible.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionParams {
    /// The weight of one direction in space, projected onto the surface.
    pub axis: f64,
    /// The direction in space.
    pub towards: DVec3,
    /// The weight of the bones.
    pub bones: f64,
    /// The weight of the direction of least curvature.
    pub curvature: f64,
    /// The weight of the borders of the surface.
    pub borders: f64,
    /// The weight of creases: edges sharper than `crease_angle`.
    pub creases: f64,
    /// An edge is a crease if the normals of its two sides form at least this angle.
    pub crease_angle: f64,
    /// Painted strokes: later ones over earlier ones, all of them over anything else.
    pub strokes: Vec<Stroke>,
    /// Lines that cells line up along: like strokes, but about as wide as a cell.
    pub lines: Vec<Stroke>,
    /// The angle by which the whole field is turned in the end, counter-clockwise seen from outside.
    pub turn: f64,
}

impl Default for DirectionParams {
    fn default() -> Self {
        Self {
            axis: 0.0,
            towards: DVec3::Y,
            bones: 0.0,
            curvature: 0.0,
            borders: 0.0,
            creases: 0.0,
            crease_angle: 25.0_f64.to_radians(),
            strokes: Vec::new(),
            lines: Vec::new(),
            turn: 0.0,
        }
    }
}

/// Where the flow from head to tail comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowParams {
    /// The weight of the direction in space, the sense of which counts.
    pub axis: f64,
    /// The direction in space.
    pub towards: DVec3,
    /// The weight of the bones, from head to tail.
    pub bones: f64,
    /// Strokes, in the sense in which they were drawn.
    pub strokes: Vec<Stroke>,
    /// Whether the flow is reversed in the end.
    pub flip: bool,
}

impl Default for FlowParams {
    fn default() -> Self {
        Self {
            axis: 0.0,
            towards: DVec3::Y,
            bones: 1.0,
            strokes: Vec::new(),
            flip: false,
        }
    }
}
