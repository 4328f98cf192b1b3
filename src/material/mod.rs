//! Materials of surfaces: colours, noise, Phong's attributes, coats, and the weather at a point. The module uses cells,
//! but neither solids nor pixels.

mod coat;
mod effects;
mod face;
mod grounds;
mod hides;
mod marking;
#[cfg(house)]
mod near_grain;
mod noise;
mod palette;
mod palettes;
mod pattern;
mod phong;
mod reaction;
mod stones;

pub use coat::Coats;
pub use effects::WeatherParams;
pub(crate) use effects::{Effects, LEVEL, Place, Sample};
pub use face::stone_colour;
pub(crate) use face::{StoneTexture, TextureNoise};
pub use grounds::GROUNDS;
#[cfg(house)]
pub(crate) use marking::{CLOUDS, CLOUDS_AT, Marking, WAVELENGTH, belly_at, near, turned};
#[cfg(house)]
pub(crate) use near_grain::{GrainStrength, NearGrain};
pub use noise::NoiseTile;
#[cfg(house)]
pub(crate) use noise::from_three_sides;
pub(crate) use noise::{floor, white};
pub use palette::{Ground, Palette};
pub use palettes::{PALETTES, ground, material_table, palette};
pub use pattern::{Coat, ColourParams, Pattern};
pub(crate) use phong::GROUND_ROW;
#[cfg(house)]
pub(crate) use phong::MOSS;
pub use phong::{FINISHES, Gloss, Material};
#[cfg(house)]
pub(crate) use reaction::Reaction;
