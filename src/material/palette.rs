//! The appearance of stones, hides and ground: colours, patterns, materials.
//!
//! Miyata, Itoh, Shimada (2000), section 5.4: a table given in advance, from which each stone draws at
//! random. Colours are sRGB as in a photograph taken in even light; amounts are relative to the colour's own
//! lightness.

use super::phong::{FINISHES, Material};

/// A kind of stone or of hide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// The palette's word in links.
    pub name: &'static str,
    /// Base colours, drawn for each stone with equal probability. A colour listed twice occurs twice as
    /// often.
    pub bases: &'static [[u8; 3]],
    /// Colour of veins, lichen or moss.
    pub second: [u8; 3],
    /// Colour of marked cells.
    pub mark: [u8; 3],
    /// Colour of the belly's side.
    pub belly: [u8; 3],
    /// Colour of the bare skin between cells.
    pub flesh: [u8; 3],
    /// Standard deviation of lightness between stones.
    pub tone: f32,
    /// Standard deviation of warmth between stones.
    pub tint: f32,
    /// Strength of blotches within a stone.
    pub mottle: f32,
    /// Strength of mineral grains within a stone.
    pub speckle: f32,
    /// Strength of bands along the stone, as in sandstone and slate.
    pub bands: f32,
    /// Strength of veins in the second colour, 0..1.
    pub veins: f32,
    /// Strength of patches in the second colour, 0..1: moss, lichen, rust.
    pub patches: f32,
    /// Factor of the recipe's relief: sawn stone is smoother than hewn.
    pub relief: f32,
    /// The materials, from rough to smooth.
    pub finishes: [Material; FINISHES],
}

/// The ground between the stones and around the pavement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// The ground's word in links.
    pub name: &'static str,
    /// Its two colours, mixed in patches.
    pub colours: [[u8; 3]; 2],
    /// Variation of lightness between single grains.
    pub speckle: f32,
    /// Height of single grains, in picture units.
    pub grain: f32,
    /// Height of unevenness, relative to the joints' depth.
    pub swell: f32,
    /// Share of the possible places that have a pebble.
    pub pebbles: f32,
    /// Colour of pebbles.
    pub pebble: [u8; 3],
    /// Colour of dirt from this ground.
    pub dirt: [u8; 3],
    /// How the ground reflects light.
    pub material: Material,
}
