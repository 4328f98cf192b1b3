//! Ambient occlusion from what is seen: how much of the sky is hidden by surfaces near a place (Mittring 2007,
//! Finding Next Gen: CryEngine 2; here with the horizon's cosine).
//!
//! It is looked for at every other pixel of every other row, at twelve places around each, in a pattern that is turned
//! from one of them to the next. Each pixel has the mean of those beside it, as far as they lie on the same surface: all
//! turns have the same weight in it, so that no pattern is left.

use super::sight::Sight;
use crate::order::{greater, lesser};
use glam::Vec3;
use std::f64::consts::TAU;

/// Places looked at around a pixel.
const TAPS: usize = 12;
/// Pixels from one that is looked around from to the next.
const STEP: usize = 2;
/// The pattern turns over squares of so many of them.
const PATTERN: usize = 2;
/// What the three of them around a pixel count, from the one before: at a pixel that is one of them, and between two.
const WEIGHTS: [[u32; 3]; STEP] = [[1, 2, 1], [0, 2, 2]];
/// On the screen the reach has at most so many parts of the frame's height.
const MOST_REACH: f32 = 0.15;
/// Cosine below which a surface beside a place hides nothing: its own curvature.
const LEAST: f32 = 0.12;
/// How dark it gets.
const STRENGTH: f32 = 1.5;
/// The mean is over pixels whose inverse depth differs by no more than this part.
const SAME: f32 = 0.04;

/// Occlusion of a frame, in the making.
pub(super) struct Occlusion {
    /// The places of the pattern, in parts of the reach, for each pixel of a square.
    pattern: Vec<[[f32; 2]; TAPS]>,
    /// At the pixels that are looked around from.
    raw: Vec<u8>,
    /// Of those in a row.
    wide: usize,
    /// Part of the sky that is seen, 255 all of it.
    pub open: Vec<u8>,
}

impl Occlusion {
    pub fn new() -> Self {
        let cells = PATTERN * PATTERN;
        let pattern = (0..cells).map(|cell| {
            // Neighbours look in directions far from each other.
            let turn = ((cell * 7) % cells) as f64 / cells as f64;
            std::array::from_fn(|k| {
                let part = (k as f64 + 0.5) / TAPS as f64;
                let angle = TAU * (2.0 * part + turn);
                let away = part.sqrt();
                [libm::cos(angle) * away, libm::sin(angle) * away].map(|v| v as f32)
            })
        });
        Self {
            pattern: pattern.collect(),
            raw: Vec::new(),
            wide: 0,
            open: Vec::new(),
        }
    }

    pub fn begin(&mut self, [width, height]: [usize; 2]) {
        self.wide = width.div_ceil(STEP);
        self.raw.clear();
        self.raw.reserve_exact(self.wide * height.div_ceil(STEP));
        self.open.clear();
        self.open.reserve_exact(width * height);
    }

    /// Makes room for rows up to this one of that width: for all of them before [`Occlusion::look`].
    pub fn make_room(&mut self, width: usize, rows: usize) {
        self.raw.resize(self.wide * rows.div_ceil(STEP), 255);
        self.open.resize(width * rows, 255);
    }

    /// Looks around from pixels of a row, whose surfaces have these normals, if it is one of those. `reach` is how far
    /// surfaces are looked for, in the world.
    pub fn look(&mut self, sight: &Sight, normal: impl Fn(usize) -> Vec3, reach: f32, y: usize) {
        if !y.is_multiple_of(STEP) {
            return;
        }
        let view = sight.view();
        let [width, height] = view.size;
        let [wide, high] = [width as f32, height as f32];
        let (slope, fading) = (view.slope, 0.5 / (reach * reach));
        // To the right, down and into the frame.
        let at_depth = |x: f32, y: f32, depth: f32| {
            let across = (x + 0.5 - view.middle[0]) * slope;
            let down = (y + 0.5 - view.middle[1]) * slope;
            Vec3::new(across * depth, down * depth, depth)
        };
        let patterns = &self.pattern[(y / STEP % PATTERN) * PATTERN..][..PATTERN];
        for x in (0..width).step_by(STEP) {
            let at = y * width + x;
            let inverse = sight.inverse[at];
            let across = lesser(reach * view.focal * inverse, MOST_REACH * high);
            // Where nothing is, too.
            if across < 1.0 {
                continue;
            }
            let point = at_depth(x as f32, y as f32, 1.0 / inverse);
            let normal = normal(x);
            let normal = Vec3::new(
                normal.dot(view.right),
                -normal.dot(view.up),
                normal.dot(view.ahead),
            );
            // First what is seen at the places, then what it hides: the second loop does four at a time.
            let (mut there, mut right, mut down) = ([0.0; TAPS], [0.0; TAPS], [0.0; TAPS]);
            for (k, &[dx, dy]) in patterns[x / STEP % PATTERN].iter().enumerate() {
                let (tx, ty) = (x as f32 + 0.5 + dx * across, y as f32 + 0.5 + dy * across);
                if tx >= 0.0 && ty >= 0.0 && tx < wide && ty < high {
                    // Through i32: the cast to unsigned takes a detour on x86.
                    let (tx, ty) = (tx as i32, ty as i32);
                    there[k] = sight.inverse[ty as usize * width + tx as usize];
                    (right[k], down[k]) = (tx as f32, ty as f32);
                }
            }
            let mut parts = [0.0; TAPS];
            for k in 0..TAPS {
                let depth = 1.0 / greater(there[k], f32::MIN_POSITIVE);
                let way = at_depth(right[k], down[k], depth) - point;
                // The pixel itself is none of its surroundings.
                let square = greater(way.length_squared(), 1e-12);
                let cosine = way.dot(normal) / square.sqrt();
                let fades = greater(1.0 - square * fading, 0.0);
                let part = greater(cosine - LEAST, 0.0) * fades;
                parts[k] = if there[k] > 0.0 { part } else { 0.0 };
            }
            let hidden: f32 = parts.iter().sum();
            let open = greater(1.0 - STRENGTH * hidden / TAPS as f32, 0.0);
            self.raw[y / STEP * self.wide + x / STEP] = (255.0 * open + 0.5) as u8;
        }
    }

    /// The means of a row: those beside it are looked around from, up to [`STEP`] rows below.
    pub fn average(&mut self, sight: &Sight, y: usize) {
        let [width, height] = sight.view().size;
        // Beyond the frame is the last one again.
        let three = |v: usize, size: usize| {
            let last = (size - 1) / STEP;
            [
                (v / STEP).saturating_sub(1),
                v / STEP,
                (v / STEP + 1).min(last),
            ]
        };
        let rows = three(y, height);
        for x in 0..width {
            let at = y * width + x;
            let inverse = sight.inverse[at];
            if inverse == 0.0 {
                continue;
            }
            let (near, columns) = (SAME * inverse, three(x, width));
            let (mut sum, mut count) = (0, 0);
            for (row, down) in rows.into_iter().zip(WEIGHTS[y % STEP]) {
                for (column, across) in columns.into_iter().zip(WEIGHTS[x % STEP]) {
                    let there = sight.inverse[STEP * (row * width + column)];
                    let is_same = u32::from((there - inverse).abs() <= near);
                    let weight = down * across * is_same;
                    sum += weight * u32::from(self.raw[row * self.wide + column]);
                    count += weight;
                }
            }
            self.open[at] = match count > 0 {
                true => (sum / count) as u8,
                // Alone on a thing that is thinner than a pixel.
                false => 255,
            };
        }
    }
}
