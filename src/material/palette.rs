//! What stones, hides and ground look like: colours, patterns, materials.
//!
//! Miyata, Itoh, Shimada (2000), section 5.4: a table given in advance, from which each stone draws at
//! random. Colours are sRGB as in a photograph taken in even light; amounts are parts of the colour's own
//! lightness.

use super::phong::{FINISHES, Material};

/// A kind of stone or of hide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// The word of the link.
    pub name: &'static str,
    /// Colours drawn per stone, all equally likely: name one twice to see it twice as often.
    pub bases: &'static [[u8; 3]],
    /// Colour of veins, lichen or moss.
    pub second: [u8; 3],
    /// Colour of cells that a rule marks.
    pub mark: [u8; 3],
    /// Colour of the belly's side.
    pub belly: [u8; 3],
    /// Colour of the bare skin between cells.
    pub flesh: [u8; 3],
    /// Deviation of lightness between stones.
    pub tone: f32,
    /// Deviation of warmth between stones.
    pub tint: f32,
    /// Blotches within a stone.
    pub mottle: f32,
    /// Mineral grains within a stone.
    pub speckle: f32,
    /// Bands along the stone, as in sandstone and slate.
    pub bands: f32,
    /// Veins of the second colour, 0..1.
    pub veins: f32,
    /// Patches of the second colour, 0..1: moss, lichen, rust.
    pub patches: f32,
    /// Scale of the relief the recipe asks for: sawn stone is smoother than hewn.
    pub relief: f32,
    /// From rough to smooth.
    pub finishes: [Material; FINISHES],
}

/// What lies between the stones and around the pavement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// The word of the link.
    pub name: &'static str,
    /// Its two colours, mixed in patches.
    pub colours: [[u8; 3]; 2],
    /// Lightness of single grains.
    pub speckle: f32,
    /// Height of single grains, in pixels.
    pub grain: f32,
    /// Height of unevenness, part of the joints' depth.
    pub swell: f32,
    /// Share of the places for a pebble that have one.
    pub pebbles: f32,
    /// Colour of pebbles.
    pub pebble: [u8; 3],
    /// Colour of the dirt that comes from it.
    pub dirt: [u8; 3],
    /// How the ground gives back light.
    pub material: Material,
}
