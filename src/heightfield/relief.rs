//! The planes as the finish of bodies in space: where a stone is seen from above it has the colour, the material, the
//! slopes and the occlusion that its pixels have.
//!
//! Walls, which the planes do not see, keep what the surface has at its vertices.

use super::Planes;
use super::slopes::beside;
use crate::order::{greater, lesser};
use crate::scene::{Detail, Surfel};
use glam::Vec3;

/// From where surfaces slope so much (y of the normal) the planes begin to count, and where they count in full.
const SLOPES: [f32; 2] = [0.25, 0.6];
/// Where a pixel of the screen covers so many pixels of the planes, their slopes begin to fade, and are gone: they
/// would only sparkle.
const FADES: [f32; 2] = [1.5, 5.0];
/// Slopes are no steeper: rims of stones are higher than any relief.
const STEEPEST: f32 = 1.6;

/// The planes of a picture that bodies stand in as [`crate::scene`] has it: the side is 1.
pub struct Relief {
    side: usize,
    tile: bool,
    id: Vec<u32>,
    colour: Vec<[u8; 3]>,
    material: Vec<u8>,
    occlusion: Vec<u8>,
    /// Rise to the right and down, of each pixel, by pixels of its own id.
    slopes: Vec<[f32; 2]>,
}

impl Relief {
    /// Of such planes, once all rows are added.
    pub fn new(planes: &Planes) -> Self {
        let pixels = planes.side * planes.side;
        Self {
            side: planes.side,
            tile: planes.tile,
            id: Vec::with_capacity(pixels),
            colour: Vec::with_capacity(pixels),
            material: Vec::with_capacity(pixels),
            occlusion: Vec::with_capacity(pixels),
            slopes: Vec::with_capacity(pixels),
        }
    }

    /// Adds about so many pixels of these finished planes; true after the last ones.
    pub fn add(&mut self, planes: &Planes, pixels: usize) -> bool {
        let from = self.id.len();
        let span = from..planes.id.len().min(from.saturating_add(pixels));
        self.id.extend_from_slice(&planes.id[span.clone()]);
        self.colour.extend_from_slice(&planes.colour[span.clone()]);
        self.material
            .extend_from_slice(&planes.material[span.clone()]);
        self.occlusion
            .extend_from_slice(&planes.occlusion[span.clone()]);
        self.slopes.extend(span.map(|at| slope(planes, at)));
        self.id.len() == planes.id.len()
    }

    /// The pixel at a column and row, if there is one.
    fn pixel(&self, x: i32, y: i32) -> Option<usize> {
        let side = self.side as i32;
        let (x, y) = match self.tile {
            true => (x.rem_euclid(side), y.rem_euclid(side)),
            false => (x, y),
        };
        let inside = x >= 0 && y >= 0 && x < side && y < side;
        inside.then_some((y * side + x) as usize)
    }
}

impl Detail for Relief {
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32) {
        let upright = (surfel.normal.y - SLOPES[0]) / (SLOPES[1] - SLOPES[0]);
        if upright <= 0.0 {
            return;
        }
        let side = self.side as f32;
        let x = (surfel.position.x + 0.5) * side - 0.5;
        let y = (surfel.position.z + 0.5) * side - 0.5;
        let (fx, fy) = (x.floor(), y.floor());
        let (tx, ty) = (x - fx, y - fy);
        let (mut sum, mut best) = (0.0, 0.0);
        let (mut colour, mut slope, mut open) = ([0.0; 3], [0.0; 2], 0.0);
        for k in 0..4 {
            let (right, down) = (k & 1, k >> 1);
            let Some(at) = self.pixel(fx as i32 + right, fy as i32 + down) else {
                continue;
            };
            if self.id[at] != id {
                continue;
            }
            let across = if right == 1 { tx } else { 1.0 - tx };
            let weight = across * if down == 1 { ty } else { 1.0 - ty };
            sum += weight;
            for (sum, part) in colour.iter_mut().zip(self.colour[at]) {
                *sum += weight * f32::from(part);
            }
            for (sum, part) in slope.iter_mut().zip(self.slopes[at]) {
                *sum += weight * part;
            }
            open += weight * f32::from(self.occlusion[at]);
            if weight > best {
                (best, surfel.material) = (weight, self.material[at]);
            }
        }
        if sum < 0.05 {
            return;
        }
        let part = lesser(upright, 1.0);
        for (own, plane) in surfel.colour.iter_mut().zip(colour) {
            *own += (plane / sum - *own) * part;
        }
        surfel.open = 1.0 + (open / (255.0 * sum) - 1.0) * part;
        let covered = spread * side;
        let near = ((FADES[1] - covered) / (FADES[1] - FADES[0])).clamp(0.0, 1.0);
        let limit = |v: f32| lesser(greater(v / sum, -STEEPEST), STEEPEST);
        let fine = Vec3::new(-limit(slope[0]), 1.0, -limit(slope[1])).normalize();
        let mixed = surfel.normal + (fine - surfel.normal) * (part * near);
        surfel.normal = mixed.normalize_or(surfel.normal);
    }
}

/// By differences between pixels of one id: across its rim a stone has no slope.
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
