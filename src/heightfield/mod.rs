//! Solids as a height field: they are scan-converted into data planes (Miyata, Itoh, Shimada 2000, section
//! 3.2) on the ground, weathered, and lit.
//!
//! ```
//! use bubblestone::cells::Cell;
//! use bubblestone::domain::{Domain, Outline};
//! use bubblestone::field::CellKind;
//! use bubblestone::heightfield::{GROUND, Painter, Shader, TextureParams, Weathering};
//! use bubblestone::light::ShadeParams;
//! use bubblestone::material::{Gloss, WeatherParams, material_table};
//! use bubblestone::solid::Solids;
//! use glam::DVec2;
//!
//! # let corners = [(8.0, 8.0), (56.0, 8.0), (56.0, 56.0), (8.0, 56.0)];
//! # let ring = corners.map(DVec2::from).to_vec();
//! # let cell = Cell {
//! #     id: 1,
//! #     centre: DVec2::splat(32.0),
//! #     kind: CellKind::Square,
//! #     size: 48.0,
//! #     aspect: 1.0,
//! #     axis: DVec2::X,
//! #     ring,
//! # };
//! # let rings = vec![cell.ring.clone()];
//! # let domain = Domain::from_checked(&Outline { rings, ..Outline::default() });
//! // The planes: one stone, on a `cell` that fills `domain`, in a picture of 64 by 64 pixels.
//! let texture = TextureParams {
//!     side: 64,
//!     size: cell.size,
//!     ..TextureParams::default()
//! };
//! let mut painter = Painter::new(texture);
//! painter.paint(&mut Solids::new(), &cell, 0);
//! let painted = painter.finish();
//! assert_eq!((painted.planes.id[0], painted.planes.id[32 * 64 + 32]), (GROUND, 1));
//!
//! // The weather, rows at a time.
//! let weather = WeatherParams { moss: 0.5, ..WeatherParams::default() };
//! let mut weathering = Weathering::new(weather, painted);
//! while !weathering.advance(&domain, 16) {}
//! let planes = weathering.finish();
//!
//! // The light, rows at a time, too.
//! let materials = material_table(texture.palette, texture.ground, Gloss::Own);
//! let shade = ShadeParams::default();
//! let mut shader = Shader::new(&shade, planes.side, planes.pixel_scale);
//! while !shader.advance(&planes, &materials, 16) {}
//! assert_eq!(shader.rgba().len(), 4 * 64 * 64);
//! ```

#[cfg(house)]
mod block;
mod box_filter;
#[cfg(house)]
mod bump_map;
#[cfg(house)]
mod cutout;
mod ground;
mod lit;
mod making;
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

#[cfg(house)]
pub use bump_map::BumpMap;
#[cfg(house)]
pub use cutout::HeightFieldScene;
#[cfg(house)]
pub(crate) use ground::Bed;
pub use lit::Shader;
pub use painter::Painter;
pub use params::TextureParams;
pub use planes::{GROUND, Planes};
pub use sheet::{ground, means};
pub(crate) use slopes::{beside, row_slopes, smooth_row_slopes};
pub use surface::Surfaces;
#[cfg(house)]
pub(crate) use surface::between;
pub use weather::{Painted, Weathering};
