//! What the planes are made by, and what follows from it for all stones and for one.

use super::ground::Bed;
use super::pixel_scale::PixelScale;
use crate::cells::Cell;
use crate::material::{Coat, ColourParams, Face, ground, palette};
use crate::solid::{StoneKind, StoneParams, joint_depth, lean, top};

/// What the planes are made by; the papers' symbols in brackets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureParams {
    /// Picture units along a side of the picture.
    pub side: usize,
    /// Pixels for each picture unit, along a side: 1 to 8.
    pub pixel_scale: usize,
    /// Seed of colours, relief and ground.
    pub seed: u64,
    /// The size cells were asked to have on average, in picture units (Cs).
    pub size: f64,
    /// The stones.
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
    /// Colours by rule.
    pub colour: ColourParams,
    /// The planes repeat without a seam: what reaches over an edge comes in at the other.
    pub tile: bool,
}

/// Deviation of the relief at the scale of a stone, of its amplitude.
const RELIEF: f64 = 0.3;
/// The same at most, of the joints' depth: else the ground would swallow low stones.
const MOST_RELIEF: f64 = 0.2;
/// The ground stays below the stones' tops by at least this part of the joint.
const FILL: f64 = 0.9;
/// Joints deeper than this part of the size of cells do not make the ground more uneven: tall stones do not
/// stand on hills.
const MOST_SWELL: f64 = 0.33;
/// Stones lie as unevenly as they may where joints are so deep, of their size, and less where they are
/// not.
const UNEVEN: f64 = 0.2;

impl TextureParams {
    /// Deviation of the relief that is added to stones, in picture units; skin brings its noise along.
    pub(crate) fn relief(&self) -> f32 {
        match self.stone.kind {
            StoneKind::Skin => 0.0,
            _ => {
                let wanted = self.amplitude * RELIEF * f64::from(palette(self.palette).relief);
                wanted.min(MOST_RELIEF * joint_depth(&self.stone, self.size)) as f32
            }
        }
    }

    /// How deep the ground lies below the stones' tops, in picture units.
    pub(crate) fn depth(&self) -> f64 {
        joint_depth(&self.stone, self.size) * FILL
    }

    /// Height of the ground above the base level, in picture units.
    pub(crate) fn level(&self) -> f64 {
        top(&self.stone, self.size) - self.depth()
    }

    /// The ground between and around the stones, still to be made.
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

    /// How unevenly a stone of a cell of that size is laid, 0..1: low stones lie even.
    fn unevenness(&self, size: f64) -> f64 {
        let laid_deep = match self.stone.kind {
            StoneKind::Skin => 1.0,
            _ => (joint_depth(&self.stone, size) / (UNEVEN * size)).min(1.0),
        };
        (self.stone.distortion / 0.3).min(1.0) * laid_deep
    }

    /// The face of a cell's stone.
    pub(crate) fn face(&self, cell: &Cell, coat: Coat) -> Face {
        Face::new(
            palette(self.palette),
            cell,
            self.seed,
            (self.vary as f32, self.unevenness(cell.size) as f32),
            coat,
            (self.colour.rim as f32, lean(cell, &self.stone)),
        )
    }
}
