//! The nine samples of each pixel: a depth buffer, in which the highest surface wins.
//!
//! So the order in which stones are painted hardly matters. Scales of nearly equal height share a sample's
//! colour: otherwise rounding would decide.

use super::scan::ACROSS;
use crate::order::lesser;

/// Samples of a pixel.
pub(super) const PER_PIXEL: usize = ACROSS * ACROSS;

/// Two stones whose heights differ by less, in picture units, share a sample's colour: otherwise rounding
/// would decide.
pub(super) const BLEND: f32 = 0.5;

/// The samples of all pixels of a few rows.
pub(super) struct Samples {
    /// A bit for each sample that a stone covers; the others belong to the ground.
    taken: Vec<u16>,
    /// The height of each covered sample.
    heights: Vec<[f32; PER_PIXEL]>,
    /// The number of samples of the stone that owns the pixel.
    owned: Vec<u8>,
    /// The share of a sample's colour that a stone has for each picture unit above the ground, at most 1 in all.
    share_per_height: f32,
}

impl Samples {
    /// All samples belong to the ground.
    pub fn new(pixels: usize, share_per_height: f32) -> Self {
        Self {
            taken: vec![0; pixels],
            heights: vec![[0.0; PER_PIXEL]; pixels],
            owned: vec![0; pixels],
            share_per_height,
        }
    }

    /// Gives all samples back to the ground; `pixels` may not grow.
    pub fn clear(&mut self, pixels: usize) {
        self.taken.clear();
        self.taken.resize(pixels, 0);
        self.owned.clear();
        self.owned.resize(pixels, 0);
        self.heights.truncate(pixels);
        if pixels == 0 {
            self.heights = Vec::new();
        }
    }

    /// Adds a stone to the samples of pixel `i`: with these `heights`, plus `raise` from its relief, above a ground of
    /// height `soil`.
    pub fn cover(
        &mut self,
        i: usize,
        heights: [f32; PER_PIXEL],
        raise: f32,
        soil: f32,
    ) -> Coverage {
        let mut cover = Coverage::default();
        let highest = &mut self.heights[i];
        for (k, &height) in heights.iter().enumerate() {
            let height = height + raise;
            if height <= soil {
                continue;
            }
            if self.taken[i] & (1 << k) == 0 {
                self.taken[i] |= 1 << k;
                highest[k] = height;
                cover.new += 1;
                cover.new_heights += height;
                let share = lesser((height - soil) * self.share_per_height, 1.0);
                cover.new_share += share;
                cover.add(height, share);
                continue;
            }
            let above = height - highest[k];
            if above > -0.5 * BLEND {
                let share = lesser(above * (1.0 / BLEND) + 0.5, 1.0);
                cover.shared += share;
                cover.add(height, share);
            }
            if above > 0.0 {
                highest[k] = height;
                cover.won += 1;
                cover.gained += above;
            }
        }
        cover
    }

    /// Whether pixel `i` belongs to the stone with this coverage from now on. The stone with most samples
    /// owns it, the first of equals; the ground owns it only if no stone has half the samples.
    pub fn is_owner(&mut self, i: usize, cover: &Coverage) -> bool {
        let count = cover.new + cover.won;
        let owned = self.owned[i].saturating_sub(cover.won);
        let is_owner = count > owned && usize::from(count) * 2 >= PER_PIXEL;
        self.owned[i] = if is_owner { count } else { owned };
        is_owner
    }
}

/// A stone's coverage of the samples of a pixel.
#[derive(Clone, Copy, Default)]
pub(super) struct Coverage {
    /// Samples taken from the ground, the sum of the heights there, and their share in the colour.
    pub new: u8,
    pub new_heights: f32,
    pub new_share: f32,
    /// Samples where the stone is higher than earlier stones, and the sum of the differences.
    won: u8,
    pub gained: f32,
    /// The stone's share in the colour of samples that other stones cover, too.
    pub shared: f32,
    /// The sum of the stone's visible heights, weighted by its shares, and the sum of the weights.
    pub heights: f32,
    pub weight: f32,
}

impl Coverage {
    fn add(&mut self, height: f32, share: f32) {
        self.heights += height * share;
        self.weight += share;
    }
}
