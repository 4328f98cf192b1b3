//! Writers of results: text with numbers as the shortest decimals that read back as the same bits, maps of the
//! planes, and files of the cells' surfaces.

mod bytes;
#[cfg(house)]
mod chart;
mod exr;
mod fixed;
mod frame;
#[cfg(house)]
mod frame_maps;
mod glb;
#[cfg(house)]
mod ground;
mod json;
pub mod maps;
mod metrics;
#[cfg(house)]
mod model;
#[cfg(house)]
mod model_obj;
mod obj;
mod order;
#[cfg(house)]
mod part_file;
mod programs;
mod report;
#[cfg(house)]
mod scene_file;
#[cfg(house)]
mod shades;
mod slab;
mod surface;
mod svg;

pub use exr::exr;
#[cfg(house)]
pub use frame_maps::{FramePlane, frame_map};
pub use json::{cells_json, mesh_json, text};
#[cfg(house)]
pub use json::{surface_cells_json, surface_mesh_json};
pub use maps::{Map, MapKind};
pub use metrics::metrics_json;
#[cfg(house)]
pub use model::ModelFile;
#[cfg(house)]
pub use model_obj::model_obj;
pub use order::{DETAILS, MeshFormat, MeshOrder, MeshSize};
#[cfg(house)]
pub use part_file::PartFile;
pub use programs::maps_for;
pub use report::{Report, StageTime};
#[cfg(house)]
pub use scene_file::{SceneFile, SceneTerms};
pub use slab::{Slab, SlabFile};
pub use surface::MeshFile;
pub use svg::svg;
