//! What the fields of a surface are made from.

use super::{Bone, Stroke};
use crate::field::Kind;
use crate::trimesh::SurfacePoint;
use glam::DVec3;

/// What the fields of a surface are made from. Lengths and places are in the mesh's units, angles in radians.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceFieldParams {
    /// Kind of the cells.
    pub kind: Kind,
    /// Their size.
    pub size: SizeParams,
    /// The aspect ratio of stretched ones.
    pub aspect: AspectParams,
    /// Where their direction comes from.
    pub direction: DirectionParams,
    /// Where their one sense comes from; nothing where they need none.
    pub flow: Option<FlowParams>,
    /// Lines inside the body, from head to tail.
    pub bones: Vec<Bone>,
}

/// How large cells are in the mean, before anything changes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// Their side: a stretched one has the area of a square of this side.
    Size(f64),
    /// About so many cells.
    Count(f64),
}

/// The way that a value changes along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Along {
    /// From the lowest place in this direction to the highest; by height, that is (0, 1, 0).
    Axis(DVec3),
    /// From the head of the bones to their tail.
    Bones,
}

/// A factor that changes evenly (its logarithm does) along the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taper {
    /// Along what.
    pub along: Along,
    /// The factor where it begins ...
    pub first: f64,
    /// ... and where it ends.
    pub last: f64,
}

/// Smaller cells where the surface bends more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByCurvature {
    /// The angle that a cell spans (radians; .1 to .35).
    pub angle: f64,
    /// The smallest and the largest factor of the size.
    pub factors: (f64, f64),
}

/// A soft spot: its value in the middle, falling off smoothly to nothing at the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceSpot {
    /// Its middle. It does not show on the other side of a thin sheet.
    pub at: SurfacePoint,
    /// Where it ends.
    pub radius: f64,
    /// A factor of the size, or an aspect ratio.
    pub value: f64,
}

/// Where sizes come from: all of it multiplied.
#[derive(Clone, Debug, PartialEq)]
pub struct SizeParams {
    /// The size in the mean.
    pub amount: Amount,
    /// Its change along the body.
    pub taper: Option<Taper>,
    /// Its change with the curvature.
    pub curvature: Option<ByCurvature>,
    /// Spots; where they overlap, factors are multiplied.
    pub spots: Vec<SurfaceSpot>,
    /// The steepest slope of the size that curvature and spots may make.
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
    /// Round where the surface bends alike in all directions, stretched where it bends one way only.
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

/// Where directions come from: how much each of them counts, 0 not at all. Where none counts, the field is as smooth
/// as it can be.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionParams {
    /// One direction in space, projected.
    pub axis: f64,
    /// That direction.
    pub towards: DVec3,
    /// The bones.
    pub bones: f64,
    /// The direction of least curvature.
    pub curvature: f64,
    /// Borders of the surface.
    pub borders: f64,
    /// Creases: edges sharper than `crease_angle`.
    pub creases: f64,
    /// The angle between the normals of its two sides from which on an edge is a crease.
    pub crease_angle: f64,
    /// Painted strokes, later ones over earlier ones, all of them over anything else.
    pub strokes: Vec<Stroke>,
    /// Lines that cells line up along: as strokes, but for their width, which is about a cell's.
    pub lines: Vec<Stroke>,
    /// Everything is turned by this angle in the end, counter-clockwise seen from outside.
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

/// Where the one sense from head to tail comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowParams {
    /// How much the direction in space counts, as it points.
    pub axis: f64,
    /// That direction.
    pub towards: DVec3,
    /// How much the bones count, from head to tail.
    pub bones: f64,
    /// Strokes, as they were drawn.
    pub strokes: Vec<Stroke>,
    /// The other way round.
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
