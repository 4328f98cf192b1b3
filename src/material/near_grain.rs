//! Grain finer than a picture unit, for looks from close by.
//!
//! The colours and relief of stones and ground have at most one value for each picture unit. From close by, a pixel
//! shows less than that, and the surface would look blurred. Then octaves of noise are added that are finer and finer,
//! each as soon as the pixels can show it (Perlin 1985, An Image Synthesizer). From farther away they add nothing.

use super::noise::{NoiseTile, floor};
use crate::order::{greater, lesser};
use glam::Vec3;

/// Values along the side of the tile, as a power of two, and its levels.
const TILE: [u32; 2] = [7, 1];
/// The random stream of the tile, and its fractal dimension: each value differs from its neighbours.
const STREAM: (u64, f64) = (13, 1.9);
/// The number of octaves. The first has two values in a unit, along a side; each next one has twice as many.
const OCTAVES: u32 = 4;
/// An octave begins to show, and shows fully, if neighbouring values are this many pixels of the screen apart.
const SHOWS: [f32; 2] = [1.0, 2.5];
/// The height of an octave, relative to that of the one before.
const FALL: f32 = 0.45;
/// The lightness of an octave, relative to that of the one before.
const PALER: f32 = 0.72;
/// A factor for the slopes of all octaves.
const RAISED: f32 = 1.6;
/// Slopes along the surface are clamped to this.
const STEEPEST: f32 = 0.8;
/// Three readings, one along each axis, are blended; readings with less weight are left out.
const LEAST: f32 = 0.02;

/// A periodic noise that is read in octaves.
pub(crate) struct NearGrain {
    tile: NoiseTile,
}

/// How strong the grain of a material is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GrainStrength {
    /// Deviation of lightness, relative to the lightness.
    pub speckle: f32,
    /// Deviation of height at the distance of one picture unit, in picture units.
    pub height: f32,
}

/// The grain at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grain {
    /// A factor for colours.
    factor: f32,
    /// The slope of the grain's height, as a vector in the world.
    slope: Vec3,
}

impl Grain {
    /// Applies the grain to a colour (0..255) and to a unit normal.
    pub fn add_to(self, colour: &mut [f32; 3], normal: &mut Vec3) {
        *colour = colour.map(|v| lesser(v * self.factor, 255.0));
        let along = self.slope - *normal * normal.dot(self.slope);
        let limit = lesser(1.0, STEEPEST / greater(along.length(), 1e-6));
        *normal = (*normal - along * limit).normalize_or(*normal);
    }
}

impl NearGrain {
    /// The grain of a picture with this seed.
    pub fn new(seed: u64) -> Self {
        let [log_side, levels] = TILE;
        Self {
            tile: NoiseTile::new(seed, STREAM.0, log_side, levels, STREAM.1),
        }
    }

    /// The grain at a place in picture units. A pixel covers `covered` units there. `None` if it covers too much to show
    /// any grain.
    pub fn at(
        &self,
        (p, normal): (Vec3, Vec3),
        covered: f32,
        strength: GrainStrength,
    ) -> Option<Grain> {
        if covered * 2.0 * SHOWS[0] >= 1.0 {
            return None;
        }
        let weights = normal * normal * normal * normal;
        let weights = weights / greater(weights.x + weights.y + weights.z, 1e-6);
        let sides = [
            (weights.x, [p.z, p.y], [Vec3::Z, Vec3::Y]),
            (weights.y, [p.x, p.z], [Vec3::X, Vec3::Z]),
            (weights.z, [p.x, p.y], [Vec3::X, Vec3::Y]),
        ];
        let (mut light, mut slope) = (0.0, Vec3::ZERO);
        for (weight, place, [across, down]) in sides {
            if weight < LEAST {
                continue;
            }
            let [value, right, below] = self.octaves(place, covered);
            light += weight * value;
            slope += (across * right + down * below) * weight;
        }
        let light = light.clamp(-2.5, 2.5);
        // Large values are strengthened, for single grains instead of a haze.
        let factor = 1.0 + strength.speckle * (0.7 * light + 0.5 * light * light.abs());
        Some(Grain {
            factor: greater(factor, 0.0),
            slope: slope * (RAISED * strength.height),
        })
    }

    /// The sum of the visible octaves: the lightness, and the slope of heights across and down.
    fn octaves(&self, [x, y]: [f32; 2], covered: f32) -> [f32; 3] {
        let (mut sum, mut pale, mut high) = ([0.0; 3], 1.0, FALL);
        for octave in 0..OCTAVES {
            let dense = (2u32 << octave) as f32;
            let pixels = 1.0 / greater(dense * covered, 1e-6);
            let part = lesser((pixels - SHOWS[0]) / (SHOWS[1] - SHOWS[0]), 1.0);
            if part <= 0.0 {
                break;
            }
            // Octaves are turned against each other, so that their grids do not show.
            let (u, v) = match octave % 2 == 0 {
                true => (x * dense, y * dense),
                false => ((0.8 * x - 0.6 * y) * dense, (0.6 * x + 0.8 * y) * dense),
            };
            let [value, du, dv] = self.smooth(u, v);
            let (du, dv) = match octave % 2 == 0 {
                true => (du, dv),
                false => (0.8 * du + 0.6 * dv, 0.8 * dv - 0.6 * du),
            };
            sum[0] += part * pale * value;
            sum[1] += part * high * dense * du;
            sum[2] += part * high * dense * dv;
            (pale, high) = (pale * PALER, high * FALL);
        }
        sum
    }

    /// The noise between grid points, smooth also across the grid's lines: the value, and its slopes along x and y.
    fn smooth(&self, x: f32, y: f32) -> [f32; 3] {
        let (left, up) = (floor(x), floor(y));
        let ease = |t: f32| (t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t));
        let ((tx, dx), (ty, dy)) = (ease(x - left as f32), ease(y - up as f32));
        let at = |right: i32, down: i32| self.tile.at(left + right, up + down);
        let [a, b, c, d] = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
        let (upper, lower) = (a + (b - a) * tx, c + (d - c) * tx);
        let right = (b - a) * (1.0 - ty) + (d - c) * ty;
        [
            upper + (lower - upper) * ty,
            right * dx,
            (lower - upper) * dy,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STRENGTH: GrainStrength = GrainStrength {
        speckle: 0.1,
        height: 0.2,
    };

    #[test]
    fn nothing_is_added_from_afar_and_more_from_near() {
        let grain = NearGrain::new(3);
        let spread = |covered: f32| {
            let places = (0..400).map(|k| Vec3::new(0.37 * k as f32, 0.0, 0.73 * k as f32));
            let seen = places.filter_map(|p| grain.at((p, Vec3::Y), covered, STRENGTH));
            let squares = seen.map(|grain| (grain.factor - 1.0) * (grain.factor - 1.0));
            (squares.sum::<f32>() / 400.0).sqrt()
        };
        assert_eq!(spread(0.6), 0.0);
        let near = [0.45, 0.2, 0.02].map(spread);
        assert!(near[0] < near[1] && near[1] < near[2], "{near:?}");
        assert!((0.03..0.2).contains(&near[2]), "{near:?}");
    }

    #[test]
    fn slopes_are_those_of_the_heights() {
        let grain = NearGrain::new(3);
        for k in 0..200 {
            let (x, y) = (0.31 * k as f32, 0.17 * k as f32 + 0.1);
            let [_, dx, dy] = grain.smooth(x, y);
            let step = 1e-2;
            let at = |x: f32, y: f32| grain.smooth(x, y)[0];
            let across = (at(x + step, y) - at(x - step, y)) / (2.0 * step);
            let down = (at(x, y + step) - at(x, y - step)) / (2.0 * step);
            assert!((dx - across).abs() < 0.1 && (dy - down).abs() < 0.1, "{k}");
        }
    }
}
