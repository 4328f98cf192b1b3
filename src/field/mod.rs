//! Size, direction, aspect ratio and kind of the cells as functions of the point.
//!
//! Values without a simple formula are sampled on a background grid. Directions have the symmetry of the
//! cells: four-fold for squares, two-fold for the other kinds; `symmetry.rs` describes how they are stored.
//!
//! On a torus everything repeats: sources act through their nearest images, gradients become waves, spots
//! wrap, and rays about a point are those of (sin x, sin y). A constant direction is replaced by the nearest
//! size, angle and aspect ratio that fit the side (`lattice`), so the packing sees only values that fit.
//!
//! ```
//! # use bubblestone::domain::{Domain, Outline};
//! use bubblestone::field::{FieldBuilder, FieldParams};
//! use glam::DVec2;
//!
//! # let corners = [(14.0, 14.0), (114.0, 14.0), (114.0, 114.0), (14.0, 114.0)];
//! # let rings = vec![corners.map(glam::DVec2::from).to_vec()];
//! # let domain = Domain::from_checked(&Outline { rings, ..Outline::default() });
//! // `domain` is a square from (14, 14) to (114, 114).
//! let params = FieldParams {
//!     size: 12.0,
//!     ..FieldParams::default()
//! };
//! let fields = FieldBuilder::build(&domain, params);
//! let place = DVec2::new(24.0, 64.0);
//! assert_eq!(fields.size(place), 12.0);
//! // Rows along a wall, or across it: for squares that is the same.
//! let along = fields.direction(place);
//! assert!(along.x.abs().max(along.y.abs()) > 0.99);
//! ```

mod at_point;
mod builder;
mod ends;
mod follow;
mod formulas;
mod grid;
mod kind;
mod lattice;
mod params;
mod scalar;
mod singular;
mod smoothstep;
mod sources;
pub(crate) mod symmetry;

pub use at_point::{DirectionSum, SegmentTerm, WalkPlace, printed_sum};
pub use builder::FieldBuilder;
pub use kind::CellKind;
pub use params::{Direction, FieldParams};
pub use scalar::{Grading, SoftSpot};
pub use singular::Singularity;
pub(crate) use smoothstep::{smoothstep, smoothstep_f32};

use crate::domain::Domain;
use glam::DVec2;
use grid::SampleGrid;
use scalar::Gradient;

/// The sampled fields, defined at every point.
#[derive(Clone, Debug)]
pub struct Fields {
    params: FieldParams,
    /// The constant direction; for [`Direction::Spiral`], the direction relative to the rays.
    along: DVec2,
    grid: SampleGrid,
    /// Sampled directions: none if the direction is constant, two if parts have kinds with different
    /// symmetry.
    layers: Vec<Layer>,
    /// The part of the size that is evaluated, not sampled.
    gradient: Option<Gradient>,
    /// Sampled factors of the size; empty if all are 1.
    size_factors: Vec<f64>,
    /// Sampled aspect ratios of stretched cells; empty if constant.
    aspects: Vec<f64>,
    /// For parts with their own kinds: a domain that finds the part of a point, and the kinds by part.
    parts: Option<(Domain, Vec<CellKind>)>,
}

/// Representation vectors of directions with one symmetry at the nodes.
#[derive(Clone, Debug)]
struct Layer {
    symmetry: u32,
    nodes: Vec<DVec2>,
}

/// Bounds of the size field as multiples of the mean size.
pub(crate) const SIZE_RANGE: (f64, f64) = (0.2, 3.0);
/// Divisor of the picture's side that gives the smallest cell: 100,000 such cells would fill the picture.
const FINEST: f64 = 320.0;
/// Bounds of the aspect ratio.
pub(crate) const ASPECT_RANGE: (f64, f64) = (1.0, 5.0);

impl Fields {
    /// The parameters of the fields. On a torus with a constant direction, size, angle and aspect ratio are
    /// adjusted to repeat with the side.
    pub fn params(&self) -> &FieldParams {
        &self.params
    }

    /// The size of a cell at this point: its side, or for a stretched cell the side of the square with its
    /// area.
    pub fn size(&self, p: DVec2) -> f64 {
        let FieldParams { size, side, .. } = self.params;
        if self.gradient.is_none() && self.size_factors.is_empty() {
            return size;
        }
        let mut factor = 1.0;
        if let Some(gradient) = &self.gradient {
            factor = gradient.at(p).clamp(SIZE_RANGE.0, SIZE_RANGE.1);
        }
        if !self.size_factors.is_empty() {
            factor *= self.grid.interpolated(&self.size_factors, p);
        }
        let wanted = size * factor.clamp(SIZE_RANGE.0, SIZE_RANGE.1);
        wanted.max((side / FINEST).min(size))
    }

    /// Unit vector along one side of a cell at this point, or zero where the field vanishes. It is defined up
    /// to turns that leave the cell's kind unchanged ([`CellKind::symmetry`]).
    pub fn direction(&self, p: DVec2) -> DVec2 {
        let layer = match self.layers.as_slice() {
            [] => return self.along,
            [only] => only,
            [first, second, ..] => {
                if first.symmetry == self.kind(p).symmetry() {
                    first
                } else {
                    second
                }
            }
        };
        let r = self.grid.interpolated(&layer.nodes, p).normalize_or_zero();
        symmetry::direction_of(r, layer.symmetry)
    }

    /// The kind of a cell at this point.
    pub fn kind(&self, p: DVec2) -> CellKind {
        let own = self.parts.as_ref();
        let own = own.and_then(|(domain, kinds)| kinds.get(domain.part(p)));
        *own.unwrap_or(&self.params.kind)
    }

    /// Length over width of a cell at this point: 1 for squares and circles, else 1..5.
    pub fn aspect(&self, p: DVec2) -> f64 {
        if !self.kind(p).is_stretched() {
            1.0
        } else if self.aspects.is_empty() {
            self.params.aspect
        } else {
            self.grid.interpolated(&self.aspects, p)
        }
    }
}
