//! The plan of a building.

use super::face_grid::FaceGrid;
use super::fault::PlanWarning;
use super::repair::Change;
use crate::building::{Building, EdgeId, FaceId, Module, labels};

/// The plan of a building: what several features must agree on before the first cell is laid.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The module.
    pub module: Module,
    /// The grid of each face.
    pub grids: Vec<FaceGrid>,
    /// For each face the first wall of its phase set: the walls that can be shifted by a column
    /// only together.
    pub phase_sets: Vec<FaceId>,
    /// The edges at which bricks do not alternate.
    pub conflicts: Vec<EdgeId>,
    /// The changes of columns that have removed conflicts; walls are numbered as faces.
    pub changes: Vec<Change>,
    /// Warnings about what may look wrong.
    pub warnings: Vec<PlanWarning>,
}

/// Whether an edge belongs to a window, a door or an arch.
pub(super) fn is_of_opening(building: &Building, edge: EdgeId) -> bool {
    const OPENINGS: [&str; 4] = [labels::WINDOW, labels::DOOR, labels::ARCH, labels::SILL];
    let labels = &building.edge(edge).labels;
    labels
        .iter()
        .any(|label| OPENINGS.contains(&label.as_str()))
}

impl Plan {
    /// The grid of a face.
    pub fn grid(&self, face: FaceId) -> &FaceGrid {
        &self.grids[face.index()]
    }
}
