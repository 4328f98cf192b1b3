//! Counts of singular points.

use crate::surface_field::{SurfaceFields, SurfaceSingularity};

/// The terms of the Poincaré-Hopf theorem: the sum of the indices, plus the turns of the borders, is the Euler
/// characteristic.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// How many singular points have positive and negative index.
    pub points: [usize; 2],
    /// The sum of their indices.
    pub index_sum: f64,
    /// The turns of the borders; 0 without borders. See [`SurfaceFields::border_index`].
    pub border_index: f64,
    /// The Euler characteristic of the surface.
    pub euler: i64,
}

impl Tally {
    /// Counts all singular points of the fields.
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

    /// Whether the sum agrees with the Euler characteristic.
    pub fn agrees(&self) -> bool {
        self.index_sum + self.border_index == self.euler as f64
    }
}
