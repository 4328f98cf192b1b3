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
    planes: Planes,
    /// Rise to the right and down, of each pixel, by pixels of its own id.
    slopes: Vec<[f32; 2]>,
}

impl Relief {
    /// Of finished planes.
    pub fn new(planes: &Planes) -> Self {
        let slopes = slopes(planes);
        Self {
            planes: planes.clone(),
            slopes,
        }
    }

    /// The pixel at a column and row, if there is one.
    fn pixel(&self, x: i32, y: i32) -> Option<usize> {
        let side = self.planes.side as i32;
        let (x, y) = match self.planes.tile {
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
        let side = self.planes.side as f32;
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
            if self.planes.id[at] != id {
                continue;
            }
            let across = if right == 1 { tx } else { 1.0 - tx };
            let weight = across * if down == 1 { ty } else { 1.0 - ty };
            sum += weight;
            for (sum, part) in colour.iter_mut().zip(self.planes.colour[at]) {
                *sum += weight * f32::from(part);
            }
            for (sum, part) in slope.iter_mut().zip(self.slopes[at]) {
                *sum += weight * part;
            }
            open += weight * f32::from(self.planes.occlusion[at]);
            if weight > best {
                (best, surfel.material) = (weight, self.planes.material[at]);
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
fn slopes(planes: &Planes) -> Vec<[f32; 2]> {
    let (side, tile) = (planes.side, planes.tile);
    let unit = planes.pixel_scale as f32;
    let rise = |at: usize, [before, after]: [usize; 2]| {
        let own = |there: &usize| planes.id[*there] == planes.id[at];
        let [low, high] = [before, after].map(|there| if own(&there) { there } else { at });
        let apart = f32::from(u8::from(low != at) + u8::from(high != at));
        match apart > 0.0 {
            true => (planes.bump[high] - planes.bump[low]) * unit / apart,
            false => 0.0,
        }
    };
    let pixel = |at: usize| {
        let (x, y) = (at % side, at / side);
        let across = beside(x, side, tile).map(|x| y * side + x);
        let down = beside(y, side, tile).map(|y| y * side + x);
        [rise(at, across), rise(at, down)]
    };
    (0..side * side).map(pixel).collect()
}
