//! Why a building cannot be laid with a module, and what may look wrong.

use super::lines::CourseWarning;
use crate::building::{EdgeId, FaceId, Misfit, ThinWall};
use crate::masonry::module::ModuleFault;

/// Why a building cannot be laid with a module.
#[derive(Clone, Debug, PartialEq)]
pub enum PlanFault {
    /// The module cannot be laid on any building.
    Module(ModuleFault),
    /// The building is too small, or a wall too narrow or too thin.
    Misfit(Misfit),
}

/// A warning about what may look wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum PlanWarning {
    /// About the courses that a group of connected walls shares.
    Courses {
        /// The first wall of the group.
        face: FaceId,
        /// The warning itself.
        what: CourseWarning,
    },
    /// Columns are narrower than 0.8 or wider than 1.25 times the module's width.
    Columns {
        /// The wall.
        face: FaceId,
        /// The ends of the interval along s (metres).
        ends: [f64; 2],
        /// The width of the columns over the module's width.
        ratio: f64,
    },
    /// A wall is thinner than half a brick: cells reach to its middle.
    Thin(ThinWall),
    /// Bricks of two walls do not alternate at this edge; its bricks alternate by rows alone.
    Conflict(EdgeId),
}
