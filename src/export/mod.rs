//! Writers of what the stages found: text with numbers as the shortest decimals that read back as the
//! same bits, maps of the planes, and files of the cells' surfaces.

mod fixed;
mod frame;
mod glb;
mod json;
pub mod maps;
mod metrics;
mod obj;
mod report;
mod surface;
mod svg;

pub use json::{cells_json, mesh_json, text};
pub use maps::{Map, MapKind};
pub use metrics::metrics_json;
pub use report::{Report, StageTime};
pub use surface::{MeshFile, MeshFormat};
pub use svg::svg;
