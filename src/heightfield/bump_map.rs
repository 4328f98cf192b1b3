//! The planes as a bump map of bodies in space: a stone seen from above has the colour, material, slope and
//! occlusion of its pixels.
//!
//! Walls, which the planes do not see, keep the values at the surface's vertices. From close by, grain finer than the
//! planes' pixels is added everywhere.

use super::slopes::beside;
use super::{GROUND, Planes, TextureParams};
use crate::material::{GrainStrength, NearGrain, floor};
use crate::order::{greater, lesser};
use crate::scene::{Detail, Surfel};
use glam::Vec3;

/// Slope of the surface (y of the normal) at which the planes begin to count, and at which they count fully.
const SLOPES: [f32; 2] = [0.25, 0.6];
/// The slopes of the planes fade out where a pixel of the screen covers from the first to the second number of their
/// pixels: finer relief would only sparkle.
const FADES: [f32; 2] = [1.5, 5.0];
/// Slopes are clamped to this: at the rims of stones the planes are steeper than any relief.
const STEEPEST: f32 = 1.6;

/// The square of the difference to the mesh's slope from which a pixel belongs to a wall.
const WALL: f32 = 1.5;
/// Factor on the weight of a body's own pixels: from the weight 1 / `RIM` on, the planes count fully.
const RIM: f32 = 2.0;
/// Less weight of a body's own pixels is ignored.
const LEAST: f32 = 0.05;

/// The planes of a picture, in the coordinates of [`crate::scene`]: the side is 1.
pub struct BumpMap {
    side: i32,
    tile: bool,
    pixels: Vec<Pixel>,
    grain: NearGrain,
    /// Picture units along a side.
    units: f32,
    /// The grain of the ground and of stones.
    strengths: [GrainStrength; 2],
}

/// All values at a pixel, together in memory.
#[derive(Clone, Copy)]
struct Pixel {
    id: u32,
    /// Rise to the right and downwards, between pixels of the same id.
    slope: [f32; 2],
    /// Red, green, blue, and the share of the sky that is seen.
    look: [u8; 4],
    material: u8,
}

impl BumpMap {
    /// Starts empty for these planes, and the parameters that they were made with.
    pub fn new(params: &TextureParams, planes: &Planes) -> Self {
        Self {
            side: planes.side as i32,
            tile: planes.tile,
            pixels: Vec::with_capacity(planes.id.len()),
            grain: NearGrain::new(params.seed),
            units: params.side as f32,
            strengths: [false, true].map(|is_stone| params.near_grain(is_stone)),
        }
    }

    /// Copies at most `most` further pixels of the finished planes; true after the last ones.
    pub fn add(&mut self, planes: &Planes, most: usize) -> bool {
        let (from, all) = (self.pixels.len(), planes.id.len());
        let pixel = |at: usize| {
            let ([r, g, b], open) = (planes.colour[at], planes.occlusion[at]);
            Pixel {
                id: planes.id[at],
                slope: slope(planes, at),
                look: [r, g, b, open],
                material: planes.material[at],
            }
        };
        let next = from..all.min(from.saturating_add(most));
        self.pixels.extend(next.map(pixel));
        self.pixels.len() == all
    }

    /// The pixel at a column and row; outside the picture, one without an owner.
    #[inline(always)]
    fn pixel(&self, x: i32, y: i32) -> &Pixel {
        let side = self.side;
        let is_inside = |x: i32, y: i32| x >= 0 && y >= 0 && x < side && y < side;
        let (x, y) = match self.tile && !is_inside(x, y) {
            true => (x.rem_euclid(side), y.rem_euclid(side)),
            false => (x, y),
        };
        match is_inside(x, y) {
            true => &self.pixels[(y * side + x) as usize],
            false => &NOTHING,
        }
    }
}

/// The pixel outside of the picture. Its id belongs to no body.
const NOTHING: Pixel = Pixel {
    id: u32::MAX,
    slope: [0.0; 2],
    look: [0; 4],
    material: 0,
};

impl Detail for BumpMap {
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32) {
        self.show_planes(surfel, id, spread);
        let place = (surfel.position * self.units, surfel.normal);
        let strength = self.strengths[usize::from(id != GROUND)];
        if let Some(grain) = self.grain.at(place, spread * self.units, strength) {
            grain.add_to(&mut surfel.colour, &mut surfel.normal);
        }
    }
}

impl BumpMap {
    /// Adds the planes where the surface can be seen from above.
    fn show_planes(&self, surfel: &mut Surfel, id: u32, spread: f32) {
        let upright = (surfel.normal.y - SLOPES[0]) / (SLOPES[1] - SLOPES[0]);
        if upright <= 0.0 {
            return;
        }
        // The rim of a block lies beyond the planes.
        let beyond = greater(surfel.position.x.abs(), surfel.position.z.abs());
        if id == GROUND && beyond > 0.5 {
            return;
        }
        let seen = self.own_pixels(surfel, id);
        surfel.material = seen.material;
        if seen.weight < LEAST {
            return;
        }
        let part = lesser(upright, 1.0) * lesser(RIM * (seen.weight - LEAST), 1.0);
        let one = 1.0 / seen.weight;
        let [r, g, b, open] = seen.look.map(|sum| sum * one);
        for (own, plane) in surfel.colour.iter_mut().zip([r, g, b]) {
            *own += (plane - *own) * part;
        }
        surfel.open = 1.0 + (open * (1.0 / 255.0) - 1.0) * part;
        let covered = spread * self.side as f32;
        let near = ((FADES[1] - covered) / (FADES[1] - FADES[0])).clamp(0.0, 1.0);
        let limit = |v: f32| lesser(greater(v * one, -STEEPEST), STEEPEST);
        let [across, down] = seen.slope.map(limit);
        let fine = Vec3::new(-across, 1.0, -down).normalize();
        let mixed = surfel.normal + (fine - surfel.normal) * (part * near);
        surfel.normal = mixed.normalize_or(surfel.normal);
    }

    /// The sums over the four pixels around a surface element, as far as they belong to its body.
    #[inline(always)]
    fn own_pixels(&self, surfel: &Surfel, id: u32) -> OwnPixels {
        let side = self.side as f32;
        let x = (surfel.position.x + 0.5) * side - 0.5;
        let y = (surfel.position.z + 0.5) * side - 0.5;
        let (fx, fy) = (floor(x), floor(y));
        let (tx, ty) = (x - fx as f32, y - fy as f32);
        let mesh = [-surfel.normal.x, -surfel.normal.z].map(|v| v / surfel.normal.y);
        // All four without a branch. Pixels of other bodies get zero weight, and so do pixels on this body's walls,
        // which would make a round rim jagged.
        let own: [(f32, &Pixel); 4] = std::array::from_fn(|k| {
            let (right, down) = (k & 1, k >> 1);
            let pixel = self.pixel(fx + right as i32, fy + down as i32);
            let across = if right == 1 { tx } else { 1.0 - tx };
            let off = [0, 1].map(|k| pixel.slope[k] - mesh[k]);
            let agrees = WALL - off[0] * off[0] - off[1] * off[1];
            let agrees = lesser(greater(agrees, 0.0), 1.0);
            let weight = across * if down == 1 { ty } else { 1.0 - ty } * agrees;
            let is_own = pixel.id == id;
            (if is_own { weight } else { 0.0 }, pixel)
        });
        let mut seen = OwnPixels {
            weight: 0.0,
            look: [0.0; 4],
            slope: [0.0; 2],
            material: surfel.material,
        };
        let mut best = 0.0;
        for (weight, pixel) in own {
            seen.weight += weight;
            let parts = pixel.look.map(f32::from);
            seen.look = std::array::from_fn(|k| seen.look[k] + weight * parts[k]);
            seen.slope = std::array::from_fn(|k| seen.slope[k] + weight * pixel.slope[k]);
            if weight > best {
                (best, seen.material) = (weight, pixel.material);
            }
        }
        seen
    }
}

/// Weighted sums over the pixels of a body around a place.
struct OwnPixels {
    /// The sum of the weights.
    weight: f32,
    look: [f32; 4],
    slope: [f32; 2],
    /// The material of the pixel with the greatest weight.
    material: u8,
}

/// Differences between pixels of one id: a stone has no slope across its rim.
fn slope(planes: &Planes, at: usize) -> [f32; 2] {
    let (side, tile) = (planes.side, planes.tile);
    let unit = planes.pixel_scale as f32;
    let rise = |[before, after]: [usize; 2]| {
        let own = |there: &usize| planes.id[*there] == planes.id[at];
        let [low, high] = [before, after].map(|there| if own(&there) { there } else { at });
        let apart = f32::from(u8::from(low != at) + u8::from(high != at));
        match apart > 0.0 {
            true => (planes.bump[high] - planes.bump[low]) * unit / apart,
            false => 0.0,
        }
    };
    let (x, y) = (at % side, at / side);
    let across = beside(x, side, tile).map(|x| y * side + x);
    let down = beside(y, side, tile).map(|y| y * side + x);
    [rise(across), rise(down)]
}
