//! Why a building cannot be laid with a module, and what may look wrong.

use super::lines::CourseWarning;
use crate::building::{EdgeId, FaceId};
use crate::masonry::module::ModuleFault;

/// Why a building cannot be laid with a module.
#[derive(Clone, Debug, PartialEq)]
pub enum PlanFault {
    /// The module itself.
    Module(ModuleFault),
    /// All intervals of the walls that hang together are narrower than half a module.
    ModuleTooLarge {
        /// One of the walls.
        face: FaceId,
        /// The widest interval of these walls (metres).
        width: f64,
    },
    /// A wall between two convex edges is narrower than half a module.
    TooNarrow {
        /// The wall.
        face: FaceId,
        /// Its width (metres).
        width: f64,
    },
}

/// A warning about what may look wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum PlanWarning {
    /// About the courses of the walls that hang together with this one.
    Courses {
        /// The first of these walls.
        face: FaceId,
        /// The warning itself.
        what: CourseWarning,
    },
    /// Columns are narrower or wider than 0.8 to 1.25 of the module.
    Columns {
        /// The wall.
        face: FaceId,
        /// The ends of the interval along s (metres).
        ends: [f64; 2],
        /// Their width over the module's.
        ratio: f64,
    },
    /// A wall between two convex edges is narrower than two modules: its bricks are halves.
    Narrow {
        /// The wall.
        face: FaceId,
        /// Its width (metres).
        width: f64,
    },
    /// Bricks of two walls do not alternate at this edge; its bricks alternate by rows alone.
    Conflict(EdgeId),
}
