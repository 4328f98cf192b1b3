//! What stones, hides and ground are made of: colours, patterns, optical attributes.
//!
//! Miyata, Itoh, Shimada (2000), section 5.4: a table given in advance, from which a random number
//! draws for each stone. Colours are sRGB as one would pick them from a photograph taken in even
//! light; amounts are parts of the colour's own lightness.

use super::grounds::GROUNDS;
use super::hides::HIDES;
use super::optics::{FINISHES, Optics};
use super::stones::STONES;

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
    pub optics: [Optics; FINISHES],
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
    /// Colour of what the wind and feet carry from it into hollows.
    pub dirt: [u8; 3],
    /// How the ground gives back light.
    pub optics: Optics,
}

/// All palettes, stones first; the first is the default.
pub const PALETTES: &[Palette] = &{
    let mut all = [STONES[0]; STONES.len() + HIDES.len()];
    let mut k = 0;
    while k < all.len() {
        all[k] = if k < STONES.len() {
            STONES[k]
        } else {
            HIDES[k - STONES.len()]
        };
        k += 1;
    }
    all
};

/// The palette of that name, the default where there is none.
pub fn palette(name: &str) -> &'static Palette {
    let found = PALETTES.iter().find(|p| p.name == name);
    found.unwrap_or(&PALETTES[0])
}

/// The ground of that name, the default where there is none. Hide is the palette's flesh.
pub fn ground(name: &str, palette: &Palette) -> Ground {
    let found = GROUNDS.iter().find(|g| g.name == name);
    let mut ground = *found.unwrap_or(&GROUNDS[0]);
    if ground.name == HIDE {
        let light = |factor: f32| palette.flesh.map(|v| (f32::from(v) * factor) as u8);
        ground.colours = [light(1.07), light(0.9)];
    }
    ground
}

/// The word of the ground that is bare skin.
const HIDE: &str = "hide";
