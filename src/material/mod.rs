//! What surfaces are made of: colours, noise, optical attributes, coats by rule, and what the weather does
//! to a place. It knows cells, and neither solids nor pixels.

mod coat;
mod effects;
mod grounds;
mod hides;
mod noise;
mod optics;
mod palette;
mod palettes;
mod reaction;
mod skin;
mod stones;

pub use coat::{Coat, Coats, ColourParams, Pattern};
pub use effects::WeatherParams;
pub(crate) use effects::{Effects, Place, Sample, soft};
pub use grounds::GROUNDS;
pub use noise::Tile;
pub(crate) use noise::floor;
pub use optics::{FINISHES, Gloss, Optics};
pub use palette::{Ground, Palette};
pub use palettes::{PALETTES, ground, optics_table, palette};
pub use skin::stone_colour;
pub(crate) use skin::{Patterns, Skin};
