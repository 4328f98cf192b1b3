//! The nine samples of each pixel, as a depth buffer: who stands there highest.

use super::scan::SAMPLES;
use crate::order::lesser;

/// Samples of a pixel.
pub(super) const PER_PIXEL: usize = SAMPLES * SAMPLES;

/// Two stones whose heights differ by less, in picture units, share a sample's colour: otherwise a hair would
/// decide.
pub(super) const EVEN: f32 = 0.5;

/// The samples of all pixels of a few rows.
pub(super) struct Samples {
    /// Those that a stone has, bit by bit; the others are the ground's.
    taken: Vec<u16>,
    /// The height of each taken sample.
    heights: Vec<[f32; PER_PIXEL]>,
    /// How many the stone that owns the pixel has.
    owned: Vec<u8>,
    /// Share of a stone in a sample for each picture unit that it stands above the ground.
    firm: f32,
}

impl Samples {
    /// All the ground's.
    pub fn new(pixels: usize, firm: f32) -> Self {
        Self {
            taken: vec![0; pixels],
            heights: vec![[0.0; PER_PIXEL]; pixels],
            owned: vec![0; pixels],
            firm,
        }
    }

    /// All the ground's again, of not more pixels than before.
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

    /// What a stone gets of pixel `i`, where it has these heights, `raise` more by its relief, and the
    /// ground's is `soil`.
    pub fn claim(&mut self, i: usize, heights: [f32; PER_PIXEL], raise: f32, soil: f32) -> Claim {
        let mut claim = Claim::default();
        let highest = &mut self.heights[i];
        for (k, &height) in heights.iter().enumerate() {
            let height = height + raise;
            if height <= soil {
                continue;
            }
            if self.taken[i] & (1 << k) == 0 {
                self.taken[i] |= 1 << k;
                highest[k] = height;
                claim.fresh += 1;
                claim.risen += height;
                let share = lesser((height - soil) * self.firm, 1.0);
                claim.bare += share;
                claim.add(height, share);
                continue;
            }
            let above = height - highest[k];
            if above > -0.5 * EVEN {
                let share = lesser(above * (1.0 / EVEN) + 0.5, 1.0);
                claim.share += share;
                claim.add(height, share);
            }
            if above > 0.0 {
                highest[k] = height;
                claim.won += 1;
                claim.gained += above;
            }
        }
        claim
    }

    /// Whether pixel `i` belongs to the stone that made this claim from now on: to whoever has most of
    /// its samples; to the stone that came first, of equals, and never to the ground where a stone has
    /// half of it.
    pub fn is_won(&mut self, i: usize, claim: &Claim) -> bool {
        let count = claim.fresh + claim.won;
        let owned = self.owned[i].saturating_sub(claim.won);
        let is_won = count > owned && usize::from(count) * 2 >= PER_PIXEL;
        self.owned[i] = if is_won { count } else { owned };
        is_won
    }
}

/// What a stone gets of the samples of a pixel.
#[derive(Clone, Copy, Default)]
pub(super) struct Claim {
    /// Samples that were the ground's, the sum of the heights there, and its share in their colour.
    pub fresh: u8,
    pub risen: f32,
    pub bare: f32,
    /// Samples at which it is higher than stones before it, and by how much together.
    won: u8,
    pub gained: f32,
    /// Its share in the colour of samples that other stones have, too.
    pub share: f32,
    /// The sum of its heights where it is seen, each as much as it is seen, and how much that is.
    pub sum: f32,
    pub weight: f32,
}

impl Claim {
    fn add(&mut self, height: f32, share: f32) {
        self.sum += height * share;
        self.weight += share;
    }
}
