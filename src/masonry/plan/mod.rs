//! The plan of a building's masonry: what several features must agree on before the first cell is laid.
//!
//! Generators only read it. Legakis, Dorsey, Gortler (2001) find grid lines for each face (section 5.1) and flip the
//! bricks of edges by hand (section 5.2). Here course lines belong to all walls that hang together, and phases are
//! solved for.

mod depths;
mod face_grid;
mod fault;
mod grid_lines;
mod lines;
mod making;
mod parity;

pub use depths::{ThicknessWork, thicknesses};
pub use face_grid::{FaceGrid, region};
pub use fault::{PlanFault, PlanWarning};
pub use grid_lines::{GridLine, grid_lines};
pub use lines::{CourseMark, CourseWarning, Courses, divided, merged, pieces};
pub use making::{Plan, is_wall};
pub use parity::{Change, Columns, PhaseEdge, PhasePlan, repair, solve};
