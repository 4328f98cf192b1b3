//! The shadows of a parallel light.
//!
//! Carried is the height below which the lamp is not seen: of the line before, less what the light
//! falls from line to line, or the surface where that is higher. Between two pixels of the line before
//! it is interpolated.

use super::course::Course;
use super::shadow::{NOWHERE, seen};
use crate::order::greater;

/// Half the angle under which the lamp is seen, in radians: more than the sun's, as in haze.
const HALF_DISC: f64 = 0.055;
/// Pixels before the first of a line that are kept, and after the last one.
const BEFORE: usize = 1;
const AFTER: usize = 2;

/// Shadow heights of the lamp's two rims, in the making.
pub struct Sweep {
    /// Where the line before is met, in pixels along it, -1..1.
    shift: f32,
    fall: Rims<f32>,
    /// Greater of surface and shadow along the line before, its ends repeated.
    before: Rims<Vec<f32>>,
    now: Rims<Vec<f32>>,
}

/// One for the lamp's upper rim (below its shadow it is dark) and one for the lower (above: lit).
struct Rims<T> {
    dark: T,
    lit: T,
}

impl Sweep {
    /// The light's azimuth and elevation in radians; and the lines it crosses.
    pub fn new(azimuth: f64, elevation: f64, side: usize) -> (Self, Course) {
        // Away from the light.
        let (x, y) = (-libm::cos(azimuth), -libm::sin(azimuth));
        let columns = x.abs() >= y.abs();
        let (along, across) = if columns { (x, y) } else { (y, x) };
        let step = 1.0 / along.abs();
        let steepest = std::f64::consts::FRAC_PI_2 - 1e-3;
        let fall = |angle: f64| (libm::tan(angle.clamp(0.01, steepest)) * step) as f32;
        let line = || vec![NOWHERE; BEFORE + side + AFTER];
        let lines = || Rims {
            dark: line(),
            lit: line(),
        };
        let sweep = Self {
            shift: (-across * step).clamp(-1.0, 1.0) as f32,
            fall: Rims {
                dark: fall(elevation + HALF_DISC),
                lit: fall(elevation - HALF_DISC),
            },
            before: lines(),
            now: lines(),
        };
        (sweep, Course::new(columns, along < 0.0, 0..side))
    }

    /// The next line: its heights, and what is seen of the lamp.
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
            lit[i] = seen(heights[i], low, high);
            now_dark[i] = greater(low, heights[i]);
            now_lit[i] = greater(high, heights[i]);
        }
        std::mem::swap(&mut self.before, &mut self.now);
        for line in [&mut self.before.dark, &mut self.before.lit] {
            line[BEFORE - 1] = line[BEFORE];
            let last = line[BEFORE + n - 1];
            line[BEFORE + n..].fill(last);
        }
    }
}
