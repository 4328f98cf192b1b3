//! The light that surfaces send to the eye, for four pixels at once and without tables.

use super::Lamp;
use super::four_lanes::{FourVectors, all, power, share};
use super::tile::{Vectors, get};
use crate::light::{GAP, LAMP, SKY, STEEP, ShadeParams};
use crate::material::Material;
use crate::order::greater;
use wide::f32x4;

/// The light that the floor reflects, linear, on a face that looks straight down.
const BOUNCE: [f32; 3] = [0.47, 0.43, 0.37];
/// Shares of it that come from other bodies beside, and that the lamp's strength has no effect on.
const BESIDE: f32 = 0.3;
const STEADY: f32 = 0.3;
/// A weak light from behind: its part of the sky's light, on a face seen from its edge.
const RIM: f32 = 0.7;

/// The visible shares, 0..1, of the lights at a point.
#[derive(Clone, Copy)]
pub(super) struct Reaching {
    /// The lamp's share.
    pub lamp: f32,
    /// The sky's share beside bodies near the point.
    pub sky: f32,
    /// The sky's share over the floor below the point.
    pub floor: f32,
}

impl Reaching {
    /// Nothing is hidden.
    pub const ALL: Self = Self {
        lamp: 1.0,
        sky: 1.0,
        floor: 1.0,
    };

    /// The shares at a pixel of a tile, from its lists of all three.
    #[inline(always)]
    pub fn at(lists: &Vectors, k: usize) -> Self {
        let [lamp, sky, floor] = get(lists, k).to_array();
        Self { lamp, sky, floor }
    }
}

/// A material with the factors of the recipe: ambient, diffuse and specular share, and exponent.
pub(super) type SurfaceFinish = [f32; 4];

/// The finish of a material.
pub(super) fn finish_of(material: &Material, params: &ShadeParams) -> SurfaceFinish {
    let exponent = greater(material.shininess * params.shininess as f32, 0.1);
    [
        material.ambient * params.ambient as f32,
        material.diffuse * params.diffuse as f32,
        material.specular * params.specular as f32,
        exponent,
    ]
}

/// Points of surfaces at four pixels, ready to be lit.
pub(super) struct LitPoints {
    pub positions: FourVectors,
    pub normals: FourVectors,
    /// Unit vectors to the eye.
    pub to_eye: FourVectors,
    /// Visible shares of the lamp, of the sky, and of the sky over the floor; see [`Reaching`].
    pub reaching: FourVectors,
    /// Red, green, blue, 0..255 (sRGB).
    pub colours: FourVectors,
    pub finish: [f32x4; 4],
}

/// The share of the sky with the recipe's strength of occlusion.
#[inline(always)]
pub(super) fn open_to(params: &ShadeParams, open: f32) -> f32 {
    1.0 - params.occlusion as f32 * (1.0 - open)
}

/// The share of the lamp with the recipe's strength of shadows.
#[inline(always)]
pub(super) fn seen_of(params: &ShadeParams, seen: f32, open: f32) -> f32 {
    (1.0 - params.shadow as f32 * (1.0 - seen)) * (1.0 - GAP * (1.0 - open))
}

impl LitPoints {
    /// The light to the eye, linear.
    #[inline(always)]
    pub fn light(&self, lamp: &Lamp, params: &ShadeParams) -> FourVectors {
        let [ambient, diffuse, specular, exponent] = self.finish;
        let (to, strength) = lamp.from_four(self.positions);
        let one = f32x4::ONE;
        let facing = self.normals.dot(to).fast_max(f32x4::ZERO);
        let open = one - all(params.occlusion as f32) * (one - self.reaching.y);
        // A surface that faces away from the lamp has no light of it in any case.
        let seen = one - all(params.shadow as f32) * (one - self.reaching.x);
        let arrives = seen * (one - all(GAP) * (one - open)) * strength;
        let ahead = self.normals.dot(self.to_eye);
        let mirrored = share((facing + facing) * ahead - to.dot(self.to_eye));
        // With the lamp behind the surface there is no mirrored light.
        let shine = specular * power(mirrored, exponent) * arrives;
        let shine = facing.simd_gt(f32x4::ZERO) & shine;
        let fill = self.fill(open, one - share(ahead), strength) * ambient;
        let lamp = FourVectors::all(LAMP);
        let scattered = fill + lamp * (diffuse * facing * arrives);
        linear(self.colours).times(scattered) + lamp * shine
    }

    /// The light that arrives from all but the lamp: from the sky, from the floor, and from behind. `edge` is 1 for a
    /// surface seen from its edge.
    #[inline(always)]
    fn fill(&self, open: f32x4, edge: f32x4, strength: f32x4) -> FourVectors {
        let (one, half, up) = (f32x4::ONE, all(0.5), self.normals.y);
        // The first is less for surfaces that face up, the second for those that face down.
        let above = all(STEEP) + all(1.0 - STEEP) * up;
        let below = all(STEEP) + all(STEEP) * up;
        let sky = above.fast_min(below) + all(RIM) * edge * edge * edge * (half + half * up);
        let floor = all(BESIDE) + all(1.0 - BESIDE) * self.reaching.z;
        let floor = floor * (all(STEADY) + all(1.0 - STEADY) * strength.fast_min(one));
        let bounce = (half - half * up) * floor;
        FourVectors::all(SKY) * (open * sky) + FourVectors::all(BOUNCE) * (open * bounce)
    }
}

/// Linear light of colours on the screen, 0..255, to 0.001 of white.
#[inline(always)]
fn linear(colours: FourVectors) -> FourVectors {
    let v = colours * all(1.0 / 255.0);
    let high = FourVectors::all([0.682_171_1; 3]) + v * all(0.305_306);
    v.times(FourVectors::all([0.012_522_9; 3]) + v.times(high))
}
