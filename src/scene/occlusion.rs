//! Ambient occlusion from visible surfaces: how much of the sky is hidden by surfaces near a point (Mittring 2007,
//! Finding Next Gen: CryEngine 2; here weighted by the cosine to the horizon).
//!
//! It is computed at every other pixel of every other row, from twelve samples around each, in a pattern that is
//! rotated from one such pixel to the next. Each pixel gets the mean of the computed ones beside it, as far as they
//! lie on the same surface. All rotations have the same weight in the mean, so no pattern shows.

use super::View;
use super::visibility::VisibilityBuffer;
use crate::order::{greater, lesser};
use glam::Vec3;
use std::f64::consts::TAU;

/// Samples around a pixel.
const TAPS: usize = 12;
/// The distance between computed pixels, along rows and columns.
const STEP: usize = 2;
/// The pattern repeats after this many computed pixels, along rows and columns.
const PATTERN: usize = 2;
/// Weights of the three computed pixels before, at and after a pixel along an axis. The first row is for a computed
/// pixel, the second for a pixel between two computed ones.
const WEIGHTS: [[u32; 3]; STEP] = [[1, 2, 1], [0, 2, 2]];
/// The greatest reach on the screen, as a part of the frame's height.
const MOST_REACH: f32 = 0.15;
/// Samples in a direction with a smaller cosine to the normal hide nothing: they may lie on the same curved surface.
const LEAST: f32 = 0.12;
/// The strength of the darkening.
const STRENGTH: f32 = 1.5;
/// The mean takes only pixels whose inverse depth differs by at most this part.
const SAME: f32 = 0.04;

/// The occlusion of a frame, while it is computed.
pub(super) struct Occlusion {
    /// For each pixel of the pattern its samples, in units of the reach.
    pattern: Vec<[[f32; 2]; TAPS]>,
    /// The occlusion at computed pixels, as in `open`.
    raw: Vec<u8>,
    /// Computed pixels in a row.
    wide: usize,
    /// The visible part of the sky at each pixel; 255 is all of it.
    pub open: Vec<u8>,
}

/// The samples around a pixel. First they are read, then it is computed how much they hide: so the compiler makes the
/// second loop do four at a time.
struct SkySamples {
    /// The inverse depth at each sample; 0 where there is none.
    there: [f32; TAPS],
    right: [f32; TAPS],
    down: [f32; TAPS],
}

impl SkySamples {
    /// Reads the samples of a pattern around a pixel, `across` pixels wide.
    #[inline(always)]
    fn read(
        sight: &VisibilityBuffer,
        pattern: &[[f32; 2]; TAPS],
        [x, y]: [usize; 2],
        across: f32,
    ) -> Self {
        let width = sight.view().size[0];
        let [wide, high] = sight.view().size.map(|v| v as f32);
        let (mut there, mut right, mut down) = ([0.0; TAPS], [0.0; TAPS], [0.0; TAPS]);
        for (k, &[dx, dy]) in pattern.iter().enumerate() {
            let (tx, ty) = (x as f32 + 0.5 + dx * across, y as f32 + 0.5 + dy * across);
            if tx >= 0.0 && ty >= 0.0 && tx < wide && ty < high {
                // Cast through i32: the cast to unsigned is slower on x86.
                let (tx, ty) = (tx as i32, ty as i32);
                there[k] = sight.inverse[ty as usize * width + tx as usize];
                (right[k], down[k]) = (tx as f32, ty as f32);
            }
        }
        Self { there, right, down }
    }

    /// The sum of the parts of the sky that samples hide at a point with a normal. `fading` is half of the inverse of
    /// the squared reach.
    #[inline(always)]
    fn hidden(&self, view: &View, point: Vec3, normal: Vec3, fading: f32) -> f32 {
        let mut parts = [0.0; TAPS];
        for (k, hidden) in parts.iter_mut().enumerate() {
            let depth = 1.0 / greater(self.there[k], f32::MIN_POSITIVE);
            let way = at_depth(view, [self.right[k], self.down[k]], depth) - point;
            // A sample on the pixel itself hides nothing.
            let square = greater(way.length_squared(), 1e-12);
            let cosine = way.dot(normal) / square.sqrt();
            let fades = greater(1.0 - square * fading, 0.0);
            let part = greater(cosine - LEAST, 0.0) * fades;
            *hidden = if self.there[k] > 0.0 { part } else { 0.0 };
        }
        parts.iter().sum()
    }
}

/// The place at a pixel in this depth. The axes point to the right, down and into the frame.
#[inline(always)]
fn at_depth(view: &View, [x, y]: [f32; 2], depth: f32) -> Vec3 {
    let across = (x + 0.5 - view.middle[0]) * view.slope;
    let down = (y + 0.5 - view.middle[1]) * view.slope;
    Vec3::new(across * depth, down * depth, depth)
}

/// A direction along the axes of [`at_depth`].
#[inline(always)]
fn on_screen(view: &View, v: Vec3) -> Vec3 {
    Vec3::new(v.dot(view.right), -v.dot(view.up), v.dot(view.ahead))
}

impl Occlusion {
    pub fn new() -> Self {
        let cells = PATTERN * PATTERN;
        let pattern = (0..cells).map(|cell| {
            // Neighbours sample in very different directions.
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

    /// Makes room for rows of this width up to `rows`. All rows are needed before [`Occlusion::look`].
    pub fn make_room(&mut self, width: usize, rows: usize) {
        self.raw.resize(self.wide * rows.div_ceil(STEP), 255);
        self.open.resize(width * rows, 255);
    }

    /// Computes the occlusion along a row, if it is one of the computed rows. `normal` gives the normal of the
    /// surface at a column; `reach` is the distance, in the world, within which surfaces count.
    pub fn look(
        &mut self,
        sight: &VisibilityBuffer,
        normal: impl Fn(usize) -> Vec3,
        reach: f32,
        y: usize,
    ) {
        if !y.is_multiple_of(STEP) {
            return;
        }
        let view = sight.view();
        let [width, height] = view.size;
        let fading = 0.5 / (reach * reach);
        let patterns = &self.pattern[(y / STEP % PATTERN) * PATTERN..][..PATTERN];
        for x in (0..width).step_by(STEP) {
            let inverse = sight.inverse[y * width + x];
            let across = lesser(reach * view.focal * inverse, MOST_REACH * height as f32);
            // Also skips pixels without a surface.
            if across < 1.0 {
                continue;
            }
            let point = at_depth(view, [x as f32, y as f32], 1.0 / inverse);
            let samples = SkySamples::read(sight, &patterns[x / STEP % PATTERN], [x, y], across);
            let hidden = samples.hidden(view, point, on_screen(view, normal(x)), fading);
            let open = greater(1.0 - STRENGTH * hidden / TAPS as f32, 0.0);
            self.raw[y / STEP * self.wide + x / STEP] = (255.0 * open + 0.5) as u8;
        }
    }

    /// Averages a row. The computed rows around it, up to [`STEP`] rows below, must be finished.
    pub fn average(&mut self, sight: &VisibilityBuffer, y: usize) {
        let [width, height] = sight.view().size;
        // Beyond the frame, the last computed pixel counts again.
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
                // The surface is thinner than a pixel and has no computed pixel.
                false => 255,
            };
        }
    }
}
