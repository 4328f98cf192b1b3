//! The plan of a building's masonry: what several features must agree on before the first cell is laid.
//!
//! Generators only read the plan. Legakis, Dorsey, Gortler (2001) find grid lines for each face (section 5.1) and flip
//! the bricks of edges by hand (section 5.2). Here course lines belong to all connected walls together, and phases are
//! solved for.

mod depths;
mod face_grid;
mod fault;
mod grid_lines;
mod groups;
mod lines;
mod making;
mod parity;
mod repair;
mod whole;

pub use depths::{ThicknessWork, thicknesses};
pub use face_grid::{FaceGrid, is_wall, region};
pub use fault::{PlanFault, PlanWarning};
pub use grid_lines::{GridLine, grid_lines};
pub use lines::{CourseMark, CourseWarning, Courses, divided, merged, pieces};
pub use making::PlanMaking;
pub use parity::{Columns, PhaseEdge, PhasePlan, solve};
pub use repair::{Change, RepairWork};
pub use whole::Plan;
