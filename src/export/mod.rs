//! Writers of what the stages found, as text. Numbers are the shortest decimals that read back as
//! the same bits.

mod figures;
mod json;
mod report;

pub use figures::metrics_json;
pub use json::{cells_json, mesh_json, text};
pub use report::{Report, StageTime};
