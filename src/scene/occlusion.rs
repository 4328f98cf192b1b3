//! Ambient occlusion from what is seen: how much of the sky is hidden by surfaces near a place (Mittring 2007,
//! Finding Next Gen: CryEngine 2; here with the horizon's cosine).
//!
//! Twelve places around each pixel are looked at, in a pattern that is turned from pixel to pixel over squares
//! of four by four; the mean over such a square, as far as it lies on the same surface, has no pattern left.

use super::sight::{NOTHING, Sight};
use crate::order::{greater, lesser};
use glam::Vec3;
use std::f64::consts::TAU;

/// Places looked at for each pixel.
const TAPS: usize = 12;
/// Side of the squares of pixels over which the pattern turns.
const PATTERN: usize = 4;
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
    raw: Vec<u8>,
    /// Part of the sky that is seen, 255 all of it.
    pub open: Vec<u8>,
    row: usize,
    means: usize,
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
            open: Vec::new(),
            row: 0,
            means: 0,
        }
    }

    pub fn begin(&mut self, pixels: usize) {
        for list in [&mut self.raw, &mut self.open] {
            list.clear();
            list.resize(pixels, 255);
        }
        (self.row, self.means) = (0, 0);
    }

    /// Goes on for so many rows; true when done. `normals` are those of the surfaces seen, `reach` how far
    /// surfaces are looked for, in the world.
    pub fn advance(&mut self, sight: &Sight, normals: &[Vec3], reach: f32, rows: usize) -> bool {
        let height = sight.view().size[1];
        if self.row < height {
            let end = height.min(self.row + rows);
            for y in self.row..end {
                self.look(sight, normals, reach, y);
            }
            self.row = end;
            return false;
        }
        let end = height.min(self.means + 4 * rows);
        for y in self.means..end {
            self.average(sight, y);
        }
        self.means = end;
        end == height
    }

    fn look(&mut self, sight: &Sight, normals: &[Vec3], reach: f32, y: usize) {
        let view = sight.view();
        let [width, height] = view.size;
        for x in 0..width {
            let at = y * width + x;
            if sight.owner[at] == NOTHING {
                continue;
            }
            let inverse = sight.inverse[at];
            let point = view.ray(x as f32 + 0.5, y as f32 + 0.5) / inverse;
            let normal = normals[at];
            let across = lesser(reach * view.focal * inverse, MOST_REACH * height as f32);
            if across < 1.0 {
                continue;
            }
            let pattern = &self.pattern[(y % PATTERN) * PATTERN + x % PATTERN];
            let mut hidden = 0.0;
            for &[dx, dy] in pattern {
                let (tx, ty) = (x as f32 + 0.5 + dx * across, y as f32 + 0.5 + dy * across);
                if tx < 0.0 || ty < 0.0 || tx >= width as f32 || ty >= height as f32 {
                    continue;
                }
                let (tx, ty) = (tx as usize, ty as usize);
                let there = ty * width + tx;
                if sight.owner[there] == NOTHING || there == at {
                    continue;
                }
                let other = view.ray(tx as f32 + 0.5, ty as f32 + 0.5) / sight.inverse[there];
                let way = other - point;
                let square = greater(way.length_squared(), 1e-12);
                let cosine = way.dot(normal) / square.sqrt();
                let part = square / (reach * reach);
                let fades = greater(1.0 - part * 0.5, 0.0);
                hidden += greater(cosine - LEAST, 0.0) * fades;
            }
            let open = greater(1.0 - STRENGTH * hidden / TAPS as f32, 0.0);
            self.raw[at] = (255.0 * open + 0.5) as u8;
        }
    }

    fn average(&mut self, sight: &Sight, y: usize) {
        let [width, height] = sight.view().size;
        let span = |v: usize, size: usize| v.saturating_sub(1)..size.min(v + PATTERN - 1);
        for x in 0..width {
            let at = y * width + x;
            if sight.owner[at] == NOTHING {
                continue;
            }
            let inverse = sight.inverse[at];
            let (mut sum, mut count) = (0u32, 0u32);
            for row in span(y, height) {
                for there in span(x, width).map(|column| row * width + column) {
                    if (sight.inverse[there] - inverse).abs() <= SAME * inverse {
                        sum += u32::from(self.raw[there]);
                        count += 1;
                    }
                }
            }
            self.open[at] = (sum / count.max(1)) as u8;
        }
    }
}
