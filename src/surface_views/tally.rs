//! Singular points, counted.

use crate::surface_field::{SurfaceFields, SurfaceSingularity};

/// What the theorem of Poincaré and Hopf speaks of: the sum of the indices is the Euler characteristic, together with
/// the turns of the borders where there are any.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// Singular points of positive and of negative index.
    pub points: [usize; 2],
    /// The sum of their indices.
    pub index_sum: f64,
    /// What borders add to it; 0 where there are none. See [`SurfaceFields::border_index`].
    pub border_index: f64,
    /// The Euler characteristic of the surface.
    pub euler: i64,
}

impl Tally {
    /// All at once.
    pub fn new(fields: &SurfaceFields) -> Self {
        Self::of(fields, &fields.singular_points())
    }

    pub(super) fn of(fields: &SurfaceFields, points: &[SurfaceSingularity]) -> Self {
        let positive = points.iter().filter(|p| p.turns > 0).count();
        let turns: i32 = points.iter().map(|p| p.turns).sum();
        Self {
            points: [positive, points.len() - positive],
            index_sum: f64::from(turns) / f64::from(fields.symmetry()),
            border_index: fields.border_index(),
            euler: fields.mesh().euler(),
        }
    }

    /// Does the sum agree with the Euler characteristic?
    pub fn agrees(&self) -> bool {
        self.index_sum + self.border_index == self.euler as f64
    }
}
