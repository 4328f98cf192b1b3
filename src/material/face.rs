//! The texture of one stone: attributes drawn from the palette by its id, and its colour and relief at every
//! place.

use super::noise::NoiseTile;
use super::palette::Palette;
use super::pattern::Coat;
use super::phong::FINISHES;
use crate::cells::Cell;
use crate::field::smoothstep_f32;
use crate::order::{self, greater, lesser};
use crate::random::{Purpose, Random};
use glam::DVec2;

/// Noise shared by all stones of a seed; each stone reads it at an offset of its own.
#[derive(Clone, Debug)]
pub struct TextureNoise {
    /// The relief of the surface, with the requested fractal dimension.
    pub relief: NoiseTile,
    broad: NoiseTile,
    grains: NoiseTile,
    /// There are `2^doublings` values for each picture unit, along a side.
    doublings: u32,
}

impl TextureNoise {
    /// Noise for stones of about `size` picture units, with `2^doublings` values for each unit.
    pub fn new(seed: u64, size: f64, dimension: f64, doublings: u32) -> Self {
        let mut levels = 2;
        while levels < 8 && f64::from(1u32 << levels) * 1.42 < size {
            levels += 1;
        }
        let tile = |item, log_side, levels, dimension| {
            NoiseTile::finer(seed, item, [log_side, levels], dimension, doublings)
        };
        Self {
            relief: tile(1, 9, levels, dimension),
            broad: tile(2, 8, levels, 1.4),
            grains: tile(3, 8, 1, 1.7),
            doublings,
        }
    }
}

/// Dust covers a stone up to this share of the joint's depth.
const DUST_HEIGHT: f32 = 0.75;
/// The dust's greatest share in the colour, at the rim.
const DUST: f32 = 0.55;
/// Darkening at the rim of a stone.
const RIM: f32 = 0.30;
/// Change of lightness for one standard deviation of the relief: hollows are darker.
const CAVITY: f32 = 0.05;
/// Darkening of the darkest rim or centre of a cell.
const SHADED: f32 = 0.66;
/// Offset of a top's centre from that of its base after subdivision, relative to the top's lean.
const LEAN: f32 = 0.6;
/// Frequency of bands along a stone, relative to that across it.
const BAND_STRETCH: f32 = 0.16;

/// The attributes of one stone.
#[derive(Clone, Debug)]
pub struct StoneTexture {
    base: [f32; 3],
    centre: [f32; 2],
    axis: [f32; 2],
    offset: [f32; 2],
    shift: [i32; 2],
    turn: u64,
    tilt: [f32; 2],
    step: f32,
    /// Darkening of the rim; if negative, of the centre.
    rim: f32,
    lean: [f32; 2],
    /// For each side of the cell a scaled normal (see [`sides`]); empty if neither rim nor centre is darkened.
    sides: Vec<[f32; 2]>,
    /// Index into the table of materials.
    pub material: u8,
}

impl StoneTexture {
    /// Draws the attributes of a cell's stone. `vary` scales differences in tone, `uneven` (0..1) those in
    /// height and tilt. `rim` darkens the rim or, if negative, the centre of a top that is offset from the
    /// base by `lean`.
    pub fn new(
        palette: &Palette,
        cell: &Cell,
        seed: u64,
        (vary, uneven): (f32, f32),
        coat: Coat,
        (rim, lean): (f32, DVec2),
    ) -> Self {
        let mut random = attributes(seed, cell.id);
        let base = draw_colour(palette, &mut random, vary, coat);
        let material = 1 + random.below(FINISHES) as u8;
        let mut signed = || random.signed() as f32;
        let tilt = [signed() * uneven * 0.03, signed() * uneven * 0.03];
        let step = signed() * uneven * 0.035 * cell.size as f32;
        let offset = [signed() * 900.0, signed() * 900.0];
        let bits = random.bits();
        let axis = cell.axis.try_normalize().unwrap_or(DVec2::X);
        Self {
            base,
            centre: [cell.centre.x as f32, cell.centre.y as f32],
            axis: [axis.x as f32, axis.y as f32],
            offset,
            shift: [(bits >> 8 & 0xFFFF) as i32, (bits >> 24 & 0xFFFF) as i32],
            turn: bits & 7,
            tilt,
            step,
            rim,
            lean: [LEAN * lean.x as f32, LEAN * lean.y as f32],
            sides: if rim == 0.0 { Vec::new() } else { sides(cell) },
            material,
        }
    }

    /// A large offset that gives each stone its own part of a noise.
    #[cfg(house)]
    pub fn own_offset(&self) -> [f32; 3] {
        let [x, y] = self.offset;
        [x, y, 0.0]
    }

    /// Height of this stone above level at a place of the picture, in picture units.
    pub fn lift(&self, [x, y]: [f32; 2]) -> f32 {
        let (dx, dy) = (x - self.centre[0], y - self.centre[1]);
        self.step + self.tilt[0] * dx + self.tilt[1] * dy
    }

    /// The fractal relief at a place on the noise's grid, with standard deviation about 1. Each stone turns and mirrors
    /// the noise, but never interpolates it, so that the roughness is kept.
    pub fn relief(&self, noise: &TextureNoise, [x, y]: [i32; 2]) -> f32 {
        let (x, y) = if self.turn & 1 == 0 { (x, y) } else { (y, x) };
        let x = if self.turn & 2 == 0 { x } else { -x };
        let y = if self.turn & 4 == 0 { y } else { -y };
        let [across, down] = self.shift.map(|v| v << noise.doublings);
        noise.relief.at(x + across, y + down)
    }

    /// The stone's colour at a place of the picture, 0..255, for a given `relief`. `height` is that of the
    /// surface above the ground, relative to the joint's depth; `dust` is the ground's colour.
    pub fn colour(
        &self,
        palette: &Palette,
        noise: &TextureNoise,
        [x, y]: [f32; 2],
        relief: f32,
        (height, dust): (f32, [f32; 3]),
    ) -> [f32; 3] {
        let (dx, dy) = (x - self.centre[0], y - self.centre[1]);
        let u = dx * self.axis[0] + dy * self.axis[1] + self.offset[0];
        let v = dy * self.axis[0] - dx * self.axis[1] + self.offset[1];
        let blotch = noise.broad.between(u, v);
        let grain = noise.grains.between(1.3 * v, 1.3 * u);
        let mut light = 1.0 + palette.mottle * blotch + palette.speckle * mineral(grain);
        light += CAVITY * relief.clamp(-2.0, 2.0);
        if palette.bands > 0.0 {
            light += palette.bands * noise.broad.between(u * BAND_STRETCH, 1.7 * v + 40.0);
        }
        let rim = (1.0 - height).clamp(0.0, 1.0);
        light *= 1.0 - RIM * rim * rim.sqrt();
        if self.rim != 0.0 {
            light *= 1.0 - SHADED * self.shade([dx, dy]);
        }
        let second = self.second_share(palette, noise, (u, v), rim);
        let dust_share = (1.0 - height / DUST_HEIGHT).clamp(0.0, 1.0);
        let dust_share = DUST * dust_share * dust_share * (1.0 + 0.5 * blotch).clamp(0.3, 1.5);
        std::array::from_fn(|k| {
            let own = self.base[k] * (1.0 - second) + f32::from(palette.second[k]) * second;
            let own = own * light;
            (own + (dust[k] * 0.85 - own) * dust_share).clamp(0.0, 255.0)
        })
    }

    /// Darkening at a place of the cell, by its distance from the centre.
    fn shade(&self, [dx, dy]: [f32; 2]) -> f32 {
        let (dx, dy) = (dx - self.lean[0], dy - self.lean[1]);
        let reach = |s: &[f32; 2]| s[0] * dx + s[1] * dy;
        let out = self.sides.iter().map(reach).fold(0.0, greater);
        let step = |from: f32, to: f32| smoothstep_f32((out - from) / (to - from));
        if self.rim > 0.0 {
            self.rim * step(0.45, 1.0)
        } else {
            -self.rim * (1.0 - step(0.1, 0.85))
        }
    }

    /// Share of the palette's second colour: veins are the zero lines of a noise, patches its peaks.
    fn second_share(
        &self,
        palette: &Palette,
        noise: &TextureNoise,
        at: (f32, f32),
        rim: f32,
    ) -> f32 {
        let (u, v) = at;
        let mut share = 0.0;
        if palette.veins > 0.0 {
            let field = noise.broad.between(0.8 * u + 17.0, 0.5 * v + 91.0);
            let line = greater(1.0 - field.abs() * 5.0, 0.0);
            share += palette.veins * line * line;
        }
        if palette.patches > 0.0 {
            let field = noise.broad.between(v + 61.0, u - 29.0);
            let hill = (field * 0.8 - 0.55 + 1.2 * rim).clamp(0.0, 1.0);
            share += palette.patches * hill;
        }
        lesser(share, 1.0)
    }
}

/// For each side of a cell the normal from its centre, over its squared length: the dot product with a place
/// relative to the centre is 1 on the side.
fn sides(cell: &Cell) -> Vec<[f32; 2]> {
    let next = cell.ring.iter().cycle().skip(1);
    let side = |(&a, &b): (&DVec2, &DVec2)| {
        let out = -(b - a).perp();
        let far = out.dot(a - cell.centre);
        let way = if far > 1e-9 { out / far } else { DVec2::ZERO };
        [way.x as f32, way.y as f32]
    };
    cell.ring.iter().zip(next).map(side).collect()
}

/// The colour of the stone of the cell `id`, without noise: red, green, blue, 0..255 for sensible palettes.
/// `vary` scales differences between stones; `coat` is the cell's pattern.
pub fn stone_colour(palette: &Palette, id: u32, seed: u64, vary: f32, coat: Coat) -> [f32; 3] {
    draw_colour(palette, &mut attributes(seed, id), vary, coat)
}

/// The random stream of a stone's attributes; its colour comes first.
fn attributes(seed: u64, id: u32) -> Random {
    Random::new(seed, Purpose::Attribute, u64::from(id))
}

fn draw_colour(palette: &Palette, random: &mut Random, vary: f32, coat: Coat) -> [f32; 3] {
    let pick = palette.bases[random.below(palette.bases.len())].map(f32::from);
    let chance = spread(random);
    let (pick, tone) = match coat.soft > 0.0 {
        true => {
            let there = shade_at(palette, coat.tone);
            let mixed = |k: usize| pick[k] + (there[k] - pick[k]) * coat.soft;
            let tone = chance + (coat.tone.clamp(-2.0, 2.0) - chance) * coat.soft;
            (std::array::from_fn(mixed), tone)
        }
        false => (pick, chance),
    };
    let tone = 1.0 + palette.tone * vary * tone;
    let tint = palette.tint * vary * spread(random);
    let warm = [1.0 + tint, 1.0, 1.0 - tint];
    let mean = mean_colour(palette);
    std::array::from_fn(|k| {
        let mut own = mean[k] + (pick[k] - mean[k]) * vary.min(1.5);
        own += (f32::from(palette.mark[k]) - own) * coat.mark;
        own += (f32::from(palette.belly[k]) - own) * coat.belly;
        own * tone * warm[k]
    })
}

/// The palette's colour for a tone: its bases from dark to light, blended, over the tones from -2 to 2.
fn shade_at(palette: &Palette, tone: f32) -> [f32; 3] {
    let mut bases = palette.bases.to_vec();
    order::sort(&mut bases, |base| {
        let [r, g, b] = base.map(u64::from);
        (r + g + b, r << 16 | g << 8 | b)
    });
    let last = bases.len() - 1;
    let at = (0.25 * tone + 0.5).clamp(0.0, 1.0) * last as f32;
    let low = (at as usize).min(last);
    let [a, b] = [bases[low], bases[(low + 1).min(last)]].map(|base| base.map(f32::from));
    std::array::from_fn(|k| a[k] + (b[k] - a[k]) * (at - low as f32))
}

/// Roughly normal with standard deviation 1, within -2..2.
fn spread(random: &mut Random) -> f32 {
    ((random.signed() + random.signed() + random.signed()) as f32).clamp(-2.0, 2.0)
}

/// Strengthens large values, for single dark and bright grains instead of a haze.
fn mineral(grain: f32) -> f32 {
    let g = grain.clamp(-2.5, 2.5);
    0.35 * g + 0.3 * g * g.abs()
}

fn mean_colour(palette: &Palette) -> [f32; 3] {
    let n = palette.bases.len() as f32;
    std::array::from_fn(|k| palette.bases.iter().map(|b| f32::from(b[k])).sum::<f32>() / n)
}
