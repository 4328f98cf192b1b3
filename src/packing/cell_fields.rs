//! The fields that the cells of a packing follow, on any domain.

use crate::field::CellKind;
use glam::DVec2;
use std::fmt::Debug;

/// The fields of the cells: size, kind, direction and aspect ratio at a place.
pub(crate) trait CellFields: Copy {
    /// A location of a cell.
    type Place: Copy + Debug;

    fn kind(self, p: Self::Place) -> CellKind;
    fn size(self, p: Self::Place) -> f64;
    fn aspect(self, p: Self::Place) -> f64;
    /// Unit vector along a side, in the frame of the place; zero where the field vanishes.
    fn direction(self, p: Self::Place) -> DVec2;
    /// The mean size.
    fn mean_size(self) -> f64;
}
