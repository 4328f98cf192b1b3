//! The size field as a heat map with contours, over whatever is below.
//!
//! The heat map is kept from frame to frame, because it changes only with the fields.

use super::{Board, Colour, blend};
use crate::domain::Domain;
use crate::field::Fields;
use glam::DVec2;

/// Colours of the smallest size, the middle, and the largest.
pub(crate) const SMALL: Colour = [0.04, 0.26, 0.56, 0.66];
const MIDDLE: Colour = [0.98, 0.82, 0.40, 0.42];
pub(crate) const LARGE: Colour = [0.80, 0.10, 0.10, 0.66];
const CONTOUR: Colour = [0.10, 0.07, 0.05, 0.80];
const WIDTH: f32 = 1.1;
/// The number of contours from the middle of the scale to either end.
pub(crate) const CONTOURS: f32 = 5.0;
/// The scale covers at least this many doublings of the size each way from the middle.
const LEAST: f32 = 0.35;
/// Distance of sampled points, in pixels.
const STEP: usize = 4;

/// The colour of a place on the scale, -1..1.
pub(crate) fn heat(v: f32) -> Colour {
    blend(MIDDLE, if v < 0.0 { SMALL } else { LARGE }, v.abs())
}

/// The strength of contours at a place on the scale, 0..1, if a pixel covers `pixel` contours. There is no contour in
/// the middle, because the size may be constant.
pub(crate) fn contour(v: f32, pixel: f32) -> f32 {
    let lines = CONTOURS * v;
    let off = (lines - lines.floor() - 0.5).abs() / pixel;
    (0.5 * WIDTH + 0.5 - off).clamp(0.0, 1.0)
}

/// The size field as colours, kept from frame to frame: it does not change while cells are packed.
#[derive(Clone, Debug, Default)]
pub struct HeatMap {
    stamp: u64,
    side: usize,
    /// For each pixel colour times opacity, and the remaining share of the background, in 255ths.
    pixels: Vec<[u8; 4]>,
}

impl HeatMap {
    /// Draws the heat map over a board. It is computed again if the stamp or the side has changed.
    pub fn draw(
        &mut self,
        board: &mut Board,
        stamp: u64,
        side: usize,
        domain: &Domain,
        fields: &Fields,
    ) {
        if (self.stamp, self.side) != (stamp, side) || self.pixels.is_empty() {
            (self.stamp, self.side) = (stamp, side);
            self.pixels = pixels(side, domain, fields);
        }
        for (below, &[r, g, b, rest]) in board.rgba_mut().chunks_exact_mut(4).zip(&self.pixels) {
            for (c, over) in below.iter_mut().zip([r, g, b]) {
                let kept = u32::from(*c) * u32::from(rest);
                *c = over.saturating_add((((kept + 128) * 257) >> 16) as u8);
            }
        }
    }
}

/// The area inside the outline in white on black; grey where the outline covers a part of a pixel.
fn mask(side: usize, domain: &Domain) -> Board {
    let mut board = Board::new(side, [0.0, 0.0, 0.0, 1.0]);
    let all = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|p| side as f64 * p);
    let rings: Vec<&[DVec2]> = match domain.space().period() {
        Some(_) => vec![&all],
        None => domain.rings().iter().map(Vec::as_slice).collect(),
    };
    board.fill(&rings, [1.0; 4], 0.0);
    board
}

fn pixels(side: usize, domain: &Domain, fields: &Fields) -> Vec<[u8; 4]> {
    let mask = mask(side, domain);
    let inside = |x: usize, y: usize| mask.rgba()[4 * (y.min(side - 1) * side + x.min(side - 1))];
    let count = side / STEP + 2;
    let mean = fields.params().size;
    let mut nodes = Vec::with_capacity(count * count);
    let (mut low, mut high) = (f32::INFINITY, f32::NEG_INFINITY);
    for k in 0..count * count {
        let (x, y) = (STEP * (k % count), STEP * (k / count));
        let doublings = libm::log2(fields.size(DVec2::new(x as f64, y as f64)) / mean) as f32;
        nodes.push(doublings);
        if inside(x, y) > 0 {
            (low, high) = (low.min(doublings), high.max(doublings));
        }
    }
    let middle = 0.5 * (low + high);
    let reach = LEAST.max(0.5 * (high - low));
    nodes.iter_mut().for_each(|v| *v = (*v - middle) / reach);
    let level = |x: usize, y: usize| between(&nodes, count, x, y);
    let mut pixels = Vec::with_capacity(side * side);
    for k in 0..side * side {
        let (x, y) = (k % side, k / side);
        let share = f32::from(inside(x, y)) / 255.0;
        if share == 0.0 {
            pixels.push([0, 0, 0, 255]);
            continue;
        }
        let v = level(x, y);
        let slope = DVec2::new(
            f64::from(level(x + 1, y) - v),
            f64::from(level(x, y + 1) - v),
        );
        let dark = contour(v, CONTOURS * slope.length() as f32 + 1e-6) * CONTOUR[3];
        let [r, g, b, a] = blend(heat(v), CONTOUR, dark);
        let alpha = (a + (1.0 - a) * 0.5 * dark) * share;
        let byte = |c: f32| (255.0 * c + 0.5) as u8;
        pixels.push([
            byte(r * alpha),
            byte(g * alpha),
            byte(b * alpha),
            byte(1.0 - alpha),
        ]);
    }
    pixels
}

/// Interpolates between the nodes, `count` in a row.
fn between(nodes: &[f32], count: usize, x: usize, y: usize) -> f32 {
    let at = (y / STEP) * count + x / STEP;
    let [s, t] = [x, y].map(|v| (v % STEP) as f32 / STEP as f32);
    let row = |at: usize| nodes[at] + s * (nodes[at + 1] - nodes[at]);
    row(at) + t * (row(at + count) - row(at))
}
