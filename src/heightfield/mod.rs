//! Solids as a height field: they are put into data planes (Miyata, Itoh, Shimada 2000, section 3.2) on the
//! ground, the weather goes over these, and they are lit.

mod box_filter;
mod ground;
mod light;
mod occlusion;
mod painter;
mod params;
mod pixel_scale;
mod planes;
mod samples;
mod scan;
mod sheet;
mod slopes;
mod surface;
mod weather;

pub(crate) use light::decoded;
pub use light::{Light, ShadeParams, Shader};
pub use painter::Painter;
pub use params::TextureParams;
pub use planes::{GROUND, Planes};
pub use sheet::{ground, means};
pub(crate) use slopes::{beside, row_slopes};
pub use surface::{Surface, Surfaces};
pub use weather::{Painted, Weathering};
