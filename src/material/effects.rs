//! Effects of the weather on a point of a surface: wear, dirt, moss and wet, in this order.
//!
//! Heights and thicknesses are shares of the joints' depth, noises have a standard deviation of about 1, and
//! every cover is a share, 0..1. The numbers are chosen by eye.

use super::phong::{DIRT, FINISHES, MOSS, ROWS, WATER};
use crate::field::smoothstep_f32 as smoothstep;
use crate::order::{greater, lesser};

/// Strength of each effect, 0..1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WeatherParams {
    /// Trodden tops are lowered, rounded and polished, mostly along the middle of the way.
    pub wear: f64,
    /// Moss, in the joints first.
    pub moss: f64,
    /// Dust and mud in hollows.
    pub dirt: f64,
    /// Water: with growing strength surfaces are damp, then wet, then under puddles.
    pub wet: f64,
}

/// Hollowness of level ground, midway between tops (0) and joints (1).
pub(crate) const LEVEL: f32 = 0.5;

/// The surroundings of a point.
pub(crate) struct Place {
    pub is_stone: bool,
    /// [`LEVEL`] on level ground, towards 1 in joints and towards 0 on tops.
    pub hollow: f32,
    /// The mean height close around the point, in picture units.
    pub near: f32,
    /// How much the place is walked on, 0..1.
    pub trodden: f32,
    /// The distance to the boundary in cell sizes, negative outside.
    pub inside: f32,
    /// Broad and fine noise.
    pub broad: f32,
    pub grains: f32,
    /// Another broad noise.
    pub patches: f32,
}

/// The surface at a point, which the weather changes.
pub(crate) struct Sample {
    pub height: f32,
    /// Red, green, blue, 0..255.
    pub colour: [f32; 3],
    /// Index into the table of materials.
    pub material: u8,
    /// Whether the surface absorbs water: ground, dirt and moss do, stone does not.
    pub soaks: bool,
}

/// The strengths of the weather, and the joints that it works on.
pub(crate) struct Effects {
    wear: f32,
    moss: f32,
    dirt: f32,
    wet: f32,
    /// Height of the joints' ground, and their depth, in picture units.
    level: f32,
    depth: f32,
    /// The colour of the dirt in hollows, 0..255.
    silt: [f32; 3],
}

mod wear {
    /// Amplitude of the noise in the wear.
    pub const NOISE: f32 = 0.35;
    /// Roughness up to this depth is rubbed off.
    pub const RUB: f32 = 0.06;
    /// Feet reach surfaces above a third of the joints' depth: slope and start of the ramp.
    pub const REACHED: [f32; 2] = [3.0, 1.0];
    /// The greatest loss of height.
    pub const LOSS: f32 = 0.44;
    /// Height below and above the cut over which its edge is rounded.
    pub const EDGE: f32 = 0.22;
    /// The cut is complete from a wear of 1 / `SOON` on.
    pub const SOON: f32 = 4.0;
    /// Wear at which a place gets the next finish, and the one after that.
    pub const POLISHED: [f32; 2] = [0.3, 0.6];
    /// Gain in lightness of worn stone, which has lost dust and crust.
    pub const LIGHTER: f32 = 0.05;
}

mod dirt {
    /// Amplitudes of the broad and fine noise in the distribution of dirt.
    pub const NOISE: [f32; 2] = [0.10, 0.04];
    /// Dirt lies where the sum of hollowness, noise and strength exceeds this.
    pub const FROM: f32 = 0.96;
    /// How fast the cover grows with the sum beyond `FROM`.
    pub const SLOPE: f32 = 1.9;
    /// The dirt's share in the colour at low strength, and the gain at full strength.
    pub const COVER: [f32; 2] = [0.35, 0.6];
    /// Amplitudes of the fine and broad noise in the colour of dirt.
    pub const TONE: [f32; 2] = [0.06, 0.05];
    /// The thickness of dirt.
    pub const SILT: f32 = 0.06;
    /// Dirt is thick in hollows only: slope and start of the ramp.
    pub const GATHERS: [f32; 2] = [2.0, 0.6];
    /// Cover from which the surface material is dirt.
    pub const SOLID: f32 = 0.45;
}

mod moss {
    /// Growth: weight of hollows, amplitudes of broad and fine noise, and the weight of treading, which
    /// prevents it.
    pub const HOLLOW: f32 = 0.72;
    pub const NOISE: [f32; 2] = [0.15, 0.06];
    pub const TRODDEN: f32 = 0.14;
    /// Moss grows where the sum of these exceeds `FROM` - `STRENGTH` x the strength of moss.
    pub const FROM: f32 = 0.86;
    pub const STRENGTH: f32 = 0.98;
    /// How fast the cover grows with the sum beyond that limit.
    pub const SLOPE: f32 = 7.0;
    /// The colours of moss, in the shade and in the light.
    pub const GREENS: [[f32; 3]; 2] = [[54.0, 66.0, 30.0], [102.0, 108.0, 53.0]];
    /// The share of the lighter colour: on level ground, its gain towards tops, and the amplitudes of fine and broad
    /// noise.
    pub const EVEN: f32 = 0.5;
    pub const LIGHT: f32 = 0.55;
    pub const TONE: [f32; 2] = [0.2, 0.25];
    /// Amplitude of the fine noise in the colour of moss.
    pub const GRAIN: f32 = 0.16;
    /// The thickness of moss, and as shares of it the constant part and the amplitude of fine noise.
    pub const PAD: f32 = 0.13;
    pub const THICKNESS: [f32; 2] = [0.75, 0.22];
    /// Cover from which the surface material is moss.
    pub const SOLID: f32 = 0.5;
}

mod wet {
    /// The dampness of a place grows with the strength from a threshold on, and is greater in hollows. These are the
    /// weight of the strength, its threshold, the weight of hollows, and the amplitude of the noise.
    pub const STRENGTH: f32 = 1.5;
    pub const FROM: f32 = 0.2;
    pub const HOLLOW: f32 = 0.5;
    pub const NOISE: f32 = 0.2;
    /// From a strength of 1 / `SOON` on, any place can be soaked.
    pub const SOON: f32 = 4.0;
    /// Darkening of wet surfaces: absorbing ones, and others.
    pub const DARKER: [f32; 2] = [0.46, 0.36];
    /// Gain in saturation of wet colours.
    pub const VIVID: f32 = 0.3;
    /// Dampness from which the damp materials, and the wet ones, are used.
    pub const FINISHES: [f32; 2] = [0.33, 0.7];
    /// Height of the water over the ground: rise with the strength, start below the ground, and the drop
    /// beyond the boundary.
    pub const RISE: f32 = 0.85;
    pub const BELOW: f32 = 0.5;
    pub const RUNS_OFF: f32 = 0.6;
    /// Ramp from inside to beyond the boundary: start, and slope by the distance in cell sizes.
    pub const AWAY: [f32; 2] = [0.5, 2.0];
    /// Greatest loss of light in deep water, and the depth at which half of it is reached, in picture units.
    pub const MURK: f32 = 0.35;
    pub const HALF: f32 = 2.0;
    /// The sky's reflection in still water: its colour, and its share.
    pub const SKY: [f32; 3] = [126.0, 138.0, 148.0];
    pub const MIRROR: f32 = 0.42;
    /// Depth from which the surface material is water, in picture units.
    pub const SOLID: f32 = 0.5;
}

impl Effects {
    /// Effects on joints with the ground at `level` and this `depth`, in picture units, and with dirt of the
    /// colour `silt` (0..255).
    pub fn new(params: WeatherParams, [level, depth]: [f32; 2], silt: [f32; 3]) -> Self {
        Self {
            wear: params.wear as f32,
            moss: params.moss as f32,
            dirt: params.dirt as f32,
            wet: params.wet as f32,
            level,
            depth,
            silt,
        }
    }

    /// Whether there are no effects.
    pub fn is_none(&self) -> bool {
        [self.wear, self.moss, self.dirt, self.wet] == [0.0; 4]
    }

    /// Applies wear, dirt, moss and wet in this order: later ones cover earlier ones.
    pub fn apply(&self, place: &Place, sample: &mut Sample) {
        if self.wear > 0.0 && place.is_stone {
            self.wear(place, sample);
        }
        if self.dirt > 0.0 {
            self.dirt(place, sample);
        }
        if self.moss > 0.0 {
            self.moss(place, sample);
        }
        if self.wet > 0.0 {
            self.soak(place, sample);
            self.flood(place, sample);
        }
    }

    /// Trodden tops are lowered, rounded and polished.
    fn wear(&self, place: &Place, sample: &mut Sample) {
        let worn = lesser(
            self.wear * place.trodden * (1.0 + wear::NOISE * place.broad),
            1.0,
        );
        let stand = self.stand(sample);
        let rub = wear::RUB * self.depth;
        let flat = lesser(
            greater(place.near, sample.height - rub),
            sample.height + rub,
        );
        let [slope, start] = wear::REACHED;
        sample.height += (flat - sample.height) * worn * smoothstep(slope * stand - start);
        // Tops are cut off; a parabola joins the slope and the cut smoothly.
        let stand = self.stand(sample);
        let ceiling = Self::ceiling(worn);
        let over = greater(wear::EDGE - (stand - ceiling).abs(), 0.0);
        let cut = lesser(stand, ceiling) - over * over / (4.0 * wear::EDGE);
        sample.height += (cut - stand) * self.depth * lesser(wear::SOON * worn, 1.0);
        let [once, twice] = wear::POLISHED;
        if worn > once {
            sample.material = (sample.material + 1 + u8::from(worn > twice)).min(FINISHES as u8);
        }
        sample.colour = sample.colour.map(|v| v * (1.0 + wear::LIGHTER * worn));
    }

    /// Greatest height above the joints' ground, relative to their depth, at this wear.
    pub fn ceiling(worn: f32) -> f32 {
        1.0 + wear::EDGE - (wear::LOSS + wear::EDGE) * worn
    }

    /// The height above the joints' ground, relative to the joints' depth.
    fn stand(&self, sample: &Sample) -> f32 {
        (sample.height - self.level) / self.depth
    }

    /// Dust and mud in hollows.
    fn dirt(&self, place: &Place, sample: &mut Sample) {
        let Place { broad, grains, .. } = *place;
        let noise = dirt::NOISE;
        let lies = place.hollow + noise[0] * broad + noise[1] * grains - dirt::FROM + self.dirt;
        let [least, more] = dirt::COVER;
        let cover = (least + more * self.dirt) * smoothstep(dirt::SLOPE * lies);
        let tone = 1.0 + dirt::TONE[0] * grains + dirt::TONE[1] * broad;
        mix(&mut sample.colour, self.silt.map(|v| v * tone), cover);
        let [slope, start] = dirt::GATHERS;
        sample.height += dirt::SILT * self.depth * cover * smoothstep(slope * place.hollow - start);
        if cover > dirt::SOLID {
            sample.material = DIRT;
            sample.soaks = true;
        }
    }

    /// Moss, in the joints first.
    fn moss(&self, place: &Place, sample: &mut Sample) {
        let Place {
            hollow,
            broad,
            grains,
            ..
        } = *place;
        let noise = moss::NOISE;
        let shade = moss::HOLLOW * hollow + noise[0] * broad + noise[1] * grains
            - moss::TRODDEN * place.trodden;
        let cover = smoothstep((shade - moss::FROM + moss::STRENGTH * self.moss) * moss::SLOPE);
        let [fine, patches] = moss::TONE;
        let light =
            moss::EVEN - moss::LIGHT * (hollow - LEVEL) + fine * grains + patches * place.patches;
        let [mut green, lit] = moss::GREENS;
        mix(&mut green, lit, light.clamp(0.0, 1.0));
        let tone = 1.0 + moss::GRAIN * grains;
        mix(&mut sample.colour, green.map(|v| v * tone), cover);
        let [pad, tufts] = moss::THICKNESS;
        sample.height += self.depth * moss::PAD * cover * (pad + tufts * grains);
        if cover > moss::SOLID {
            sample.material = MOSS;
            sample.soaks = true;
        }
    }

    /// Damp, then wet.
    fn soak(&self, place: &Place, sample: &mut Sample) {
        let lies = wet::STRENGTH * self.wet - wet::FROM
            + wet::HOLLOW * (place.hollow - LEVEL)
            + wet::NOISE * place.broad;
        let soaked = smoothstep(lies) * smoothstep(wet::SOON * self.wet);
        let [r, g, b] = sample.colour;
        let grey = (r + g + b) / 3.0;
        let [deep, slight] = wet::DARKER;
        let dark = 1.0 - soaked * if sample.soaks { deep } else { slight };
        let vivid = 1.0 + wet::VIVID * soaked;
        sample.colour = sample.colour.map(|v| (grey + (v - grey) * vivid) * dark);
        let [damp, soaking] = wet::FINISHES;
        sample.material += ROWS * (u8::from(soaked > damp) + u8::from(soaked > soaking));
    }

    /// Puddles.
    fn flood(&self, place: &Place, sample: &mut Sample) {
        let [start, slope] = wet::AWAY;
        let away = smoothstep(start - slope * place.inside);
        let stand = wet::RISE * self.wet - wet::BELOW - wet::RUNS_OFF * away;
        let surface = self.level + self.depth * stand;
        let deep = surface - sample.height;
        if deep <= 0.0 {
            return;
        }
        let clear = lesser(deep, 1.0);
        let murk = wet::MURK * deep / (deep + wet::HALF);
        sample.colour = sample.colour.map(|v| v * (1.0 - murk));
        mix(&mut sample.colour, wet::SKY, wet::MIRROR * clear);
        sample.height = surface;
        if clear > wet::SOLID {
            sample.material = WATER;
        }
    }
}

fn mix(colour: &mut [f32; 3], other: [f32; 3], share: f32) {
    for (own, other) in colour.iter_mut().zip(other) {
        *own += (other - *own) * share;
    }
}
