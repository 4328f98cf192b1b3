//! The shadows of a parallel light.
//!
//! A shadow height passes from line to line: below it the lamp is hidden. It is the height of the previous
//! line, interpolated between two pixels, minus the light's fall between lines; or the surface, if that is
//! higher.

use super::penumbra::{NOWHERE, visible};
use super::scan_order::ScanOrder;
use crate::order::greater;

/// Half the angular size of the lamp, in radians: more than the sun's, as in haze.
const HALF_DISC: f64 = 0.055;
/// Pixels kept before the first of a line, and after the last one.
const BEFORE: usize = 1;
const AFTER: usize = 2;

/// Shadow heights of the lamp's two rims, passed from line to line.
pub struct ParallelShadows {
    /// Offset along the previous line that the light comes from, in pixels, -1..1.
    shift: f32,
    /// Whether lines wrap around.
    tile: bool,
    fall: Rims<f32>,
    /// The greater of surface and shadow along the previous line; its ends are repeated, or on a tile
    /// continue at the other end.
    before: Rims<Vec<f32>>,
    now: Rims<Vec<f32>>,
}

/// Values for the lamp's upper rim (below its shadow it is dark) and for the lower rim (above: lit).
struct Rims<T> {
    dark: T,
    lit: T,
}

impl ParallelShadows {
    /// Shadows of a light with this azimuth and elevation, in radians, in a picture with `side` pixels and
    /// `pixel_scale` for each picture unit; also the order in which the light crosses the lines.
    pub fn new(azimuth: f64, elevation: f64, [side, pixel_scale]: [usize; 2]) -> (Self, ScanOrder) {
        // Direction away from the light.
        let (x, y) = (-libm::cos(azimuth), -libm::sin(azimuth));
        let columns = x.abs() >= y.abs();
        let (along, across) = if columns { (x, y) } else { (y, x) };
        let step = 1.0 / along.abs();
        let steepest = std::f64::consts::FRAC_PI_2 - 1e-3;
        let line_step = step / pixel_scale as f64;
        let fall = |angle: f64| (libm::tan(angle.clamp(0.01, steepest)) * line_step) as f32;
        let line = || vec![NOWHERE; BEFORE + side + AFTER];
        let lines = || Rims {
            dark: line(),
            lit: line(),
        };
        let shadows = Self {
            tile: false,
            shift: (-across * step).clamp(-1.0, 1.0) as f32,
            fall: Rims {
                dark: fall(elevation + HALF_DISC),
                lit: fall(elevation - HALF_DISC),
            },
            before: lines(),
            now: lines(),
        };
        (shadows, ScanOrder::new(columns, along < 0.0, 0..side))
    }

    /// Makes lines wrap around from now on. Gives the number of lines that a shadow of this height reaches.
    pub fn wrap(&mut self, height: f32) -> usize {
        self.tile = true;
        // A number that is too large saturates.
        (height / self.fall.lit) as usize + 2
    }

    /// Does the next line: takes its heights, and writes the visible share of the lamp.
    pub fn line(&mut self, heights: &[f32], lit: &mut [u8]) {
        let n = heights.len();
        let whole = self.shift.floor();
        let t = self.shift - whole;
        let first = (BEFORE as i32 + whole as i32) as usize;
        let dark = [
            &self.before.dark[first..][..n],
            &self.before.dark[first + 1..][..n],
        ];
        let light = [
            &self.before.lit[first..][..n],
            &self.before.lit[first + 1..][..n],
        ];
        let now_dark = &mut self.now.dark[BEFORE..][..n];
        let now_lit = &mut self.now.lit[BEFORE..][..n];
        let lit = &mut lit[..n];
        for i in 0..n {
            let met =
                |line: [&[f32]; 2], fall: f32| line[0][i] + (line[1][i] - line[0][i]) * t - fall;
            let (low, high) = (met(dark, self.fall.dark), met(light, self.fall.lit));
            lit[i] = visible(heights[i], low, high);
            now_dark[i] = greater(low, heights[i]);
            now_lit[i] = greater(high, heights[i]);
        }
        std::mem::swap(&mut self.before, &mut self.now);
        for line in [&mut self.before.dark, &mut self.before.lit] {
            let last = line[BEFORE + n - 1];
            line[BEFORE - 1] = if self.tile { last } else { line[BEFORE] };
            for k in 0..AFTER {
                line[BEFORE + n + k] = if self.tile {
                    line[BEFORE + k % n]
                } else {
                    last
                };
            }
        }
    }
}
