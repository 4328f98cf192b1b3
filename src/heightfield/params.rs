//! Parameters of the planes, and values derived from them for all stones and for one.

use super::ground::Bed;
use super::pixel_scale::PixelScale;
use crate::cells::Cell;
#[cfg(house)]
use crate::material::GrainStrength;
use crate::material::{Coat, ColourParams, StoneTexture, ground, palette};
use crate::random::SEED;
use crate::solid::{StoneKind, StoneParams, joint_depth, lean, top};

/// Parameters of the planes; the papers' symbols in brackets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureParams {
    /// Picture units along a side of the picture.
    pub side: usize,
    /// Pixels for each picture unit, along a side: 1 to 8.
    pub pixel_scale: usize,
    /// Seed of colours, relief and ground.
    pub seed: u64,
    /// The mean size of cells, in picture units (Cs).
    pub size: f64,
    /// Parameters of the stones.
    pub stone: StoneParams,
    /// Fractal dimension of profiles of the relief, 1..2 (Fd).
    pub dimension: f64,
    /// Amplitude of the relief at the scale of a stone, in picture units (Af).
    pub amplitude: f64,
    /// Name of the palette, one of [`crate::material::PALETTES`].
    pub palette: &'static str,
    /// Name of the ground, one of [`crate::material::GROUNDS`].
    pub ground: &'static str,
    /// Variation of tone between stones: 0 none, 1 as the palette has it.
    pub vary: f64,
    /// Colour rules.
    pub colour: ColourParams,
    /// Whether the planes repeat without a seam: a stone across an edge continues at the opposite one.
    pub tile: bool,
}

impl Default for TextureParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// Standard deviation of the relief at the scale of a stone, relative to its amplitude.
const RELIEF: f64 = 0.3;
/// Upper limit of the relief's deviation, relative to the joints' depth: otherwise the ground would cover low stones.
const MOST_RELIEF: f64 = 0.2;
/// Highest level of the ground, as a share of the joint's depth.
const FILL: f64 = 0.9;
/// Joints deeper than this share of the cells' size do not make the ground more uneven, so tall stones do not
/// stand on hills.
const MOST_SWELL: f64 = 0.33;
/// Depth of joints, relative to the size, from which stones are laid with full unevenness; with shallower
/// joints they lie more even.
const UNEVEN: f64 = 0.2;

impl TextureParams {
    /// Granite in sand, for a picture of 512 units.
    pub const DEFAULT: Self = Self {
        side: 512,
        pixel_scale: 1,
        seed: SEED,
        size: 23.0,
        stone: StoneParams::DEFAULT,
        dimension: 1.5,
        amplitude: 2.0,
        palette: "granite",
        ground: "sand",
        vary: 1.0,
        colour: ColourParams::DEFAULT,
        tile: false,
    };

    /// Standard deviation of the relief added to stones, in picture units; skin has its own noise.
    pub(crate) fn relief(&self) -> f32 {
        match self.stone.kind {
            StoneKind::Skin => 0.0,
            _ => {
                let wanted = self.amplitude * RELIEF * f64::from(palette(self.palette).relief);
                wanted.min(MOST_RELIEF * joint_depth(&self.stone, self.size)) as f32
            }
        }
    }

    /// Depth of the ground below the stones' tops, in picture units.
    pub(crate) fn depth(&self) -> f64 {
        joint_depth(&self.stone, self.size) * FILL
    }

    /// Height of the ground above the base level, in picture units.
    pub(crate) fn level(&self) -> f64 {
        top(&self.stone, self.size) - self.depth()
    }

    /// The ground between and around the stones, not yet made.
    pub(crate) fn bed(&self) -> Bed {
        let most = match self.stone.kind {
            StoneKind::Skin => f64::INFINITY,
            _ => MOST_SWELL * self.size,
        };
        Bed::new(
            ground(self.ground, palette(self.palette)),
            [self.level() as f32, self.depth().min(most) as f32],
            self.seed,
            self.tile.then_some(self.side * self.pixel_scale),
            PixelScale::new(self.pixel_scale),
        )
    }

    /// The grain of stones, or of the ground, from close by.
    #[cfg(house)]
    pub(crate) fn near_grain(&self, is_stone: bool) -> GrainStrength {
        let palette = palette(self.palette);
        let ground = ground(self.ground, palette);
        // Heights of a fractal profile fall with a power of the distance.
        let part = libm::pow(1.0 / self.size.max(1.0), 2.0 - self.dimension) as f32;
        match is_stone {
            true => GrainStrength {
                speckle: palette.speckle,
                height: self.relief() * part,
            },
            false => GrainStrength {
                speckle: ground.speckle,
                height: ground.grain,
            },
        }
    }

    /// Unevenness of a stone for a cell of that size, 0..1: low stones lie even.
    fn unevenness(&self, size: f64) -> f64 {
        let laid_deep = match self.stone.kind {
            StoneKind::Skin => 1.0,
            _ => (joint_depth(&self.stone, size) / (UNEVEN * size)).min(1.0),
        };
        (self.stone.distortion / 0.3).min(1.0) * laid_deep
    }

    /// The surface texture of a cell's stone.
    pub(crate) fn face(&self, cell: &Cell, coat: Coat) -> StoneTexture {
        StoneTexture::new(
            palette(self.palette),
            cell,
            self.seed,
            (self.vary as f32, self.unevenness(cell.size) as f32),
            coat,
            (self.colour.rim as f32, lean(cell, &self.stone)),
        )
    }
}
