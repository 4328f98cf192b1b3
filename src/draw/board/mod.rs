//! Renders layers to pixels, antialiased, with tiny-skia. A picture unit is one pixel or more along each side.

#[cfg(test)]
mod tests;

use super::colour::Colour;
use super::layer::{Layer, Pen};
use super::shapes::{MITRE, bar, beside, copies, rounded};
use glam::DVec2;
use std::ops::Range;
use tiny_skia::{Color, FillRule, Paint, Path, PathBuilder, Pixmap, PixmapMut, Shader, Transform};

/// A square picture to draw on; all its pixels are opaque.
#[derive(Clone, Debug)]
pub struct Board {
    pixmap: Pixmap,
    /// Pixels along a picture unit, at least 1.
    scale: usize,
    /// Whether shapes that cross an edge continue at the opposite one.
    tile: bool,
    /// The rows of pixels to draw on; all others stay unchanged.
    rows: Range<usize>,
}

impl Board {
    /// A blank board of `side` x `side` picture units, at least 1, with a pixel each.
    ///
    /// # Panics
    /// If a picture of that size does not fit into memory.
    pub fn new(side: usize, ground: Colour) -> Self {
        Self::scaled(side, 1, ground)
    }

    /// A blank board of `side` x `side` picture units, with `scale` x `scale` pixels for each unit; both at least 1.
    ///
    /// # Panics
    /// If a picture of that size does not fit into memory.
    pub fn scaled(side: usize, scale: usize, ground: Colour) -> Self {
        let scale = scale.max(1);
        let side = (side.max(1) * scale) as u32;
        let mut pixmap = Pixmap::new(side, side).expect("a picture fits into memory");
        pixmap.fill(skia_colour(ground));
        Self {
            pixmap,
            scale,
            tile: false,
            rows: 0..side as usize,
        }
    }

    /// Pixels along a side.
    pub fn side(&self) -> usize {
        self.pixmap.width() as usize
    }

    /// Pixels along a picture unit.
    pub fn scale(&self) -> usize {
        self.scale
    }

    /// Picture units along a side.
    fn units(&self) -> f64 {
        self.in_units(self.side())
    }

    fn in_units(&self, pixels: usize) -> f64 {
        pixels as f64 / self.scale as f64
    }

    /// From now on, shapes that cross an edge continue at the opposite one.
    pub fn repeat(&mut self) {
        self.tile = true;
    }

    /// Draws on these rows of pixels only.
    pub fn within(&mut self, rows: Range<usize>, draw: impl FnOnce(&mut Self)) {
        let all = 0..self.side();
        self.rows = rows.start.min(all.end)..rows.end.min(all.end);
        draw(self);
        self.rows = all;
    }

    /// Draws layers, each over those before it.
    pub fn draw(&mut self, layers: &[Layer]) {
        for layer in layers {
            for shape in &layer.shapes {
                if let Some(colour) = shape.fill {
                    self.fill(&refs(&shape.paths), colour, shape.round);
                }
            }
            let Some(pen) = layer.pen else {
                continue;
            };
            let paths = layer.shapes.iter().flat_map(|shape| &shape.paths);
            let paths: Vec<&[DVec2]> = paths.map(Vec::as_slice).collect();
            match pen.is_open {
                true => self.strokes(&paths, pen.colour, pen.width),
                false => self.edges(&paths, &pen),
            }
        }
    }

    /// Fills the area inside rings; see [`super::layer::DrawnPath::fill`].
    pub(super) fn fill(&mut self, rings: &[&[DVec2]], colour: Colour, round: f64) {
        let mut builder = PathBuilder::new();
        for ring in rings.iter().filter(|ring| self.reaches(ring, 0.0)) {
            self.trace(&mut builder, &[&rounded(ring, round)]);
        }
        self.fill_path(builder.finish(), colour);
    }

    /// Draws the lines of rings.
    fn edges(&mut self, rings: &[&[DVec2]], pen: &Pen) {
        let mut builder = PathBuilder::new();
        let reach = MITRE * pen.width;
        for ring in rings.iter().filter(|ring| self.reaches(ring, reach)) {
            let ring = rounded(ring, pen.round);
            let outer = beside(&ring, pen.width / 2.0);
            let mut inner = beside(&ring, -pen.width / 2.0);
            inner.reverse();
            self.trace(&mut builder, &[&outer, &inner]);
        }
        self.fill_path(builder.finish(), pen.colour);
    }

    /// Draws lines through points, as filled bars: tiny-skia's own strokes would add a twentieth to the
    /// WebAssembly module.
    fn strokes(&mut self, lines: &[&[DVec2]], colour: Colour, width: f64) {
        let mut builder = PathBuilder::new();
        for piece in lines.iter().flat_map(|line| line.windows(2)) {
            let bar = bar([piece[0], piece[1]], width);
            if self.reaches(&bar, 0.0) {
                self.trace(&mut builder, &[&bar]);
            }
        }
        self.fill_path(builder.finish(), colour);
    }

    fn fill_path(&mut self, path: Option<Path>, colour: Colour) {
        let (Some(path), rows) = (path, self.rows.clone()) else {
            return;
        };
        let (paint, rule) = (paint(colour), FillRule::Winding);
        let (side, count) = (self.side(), rows.len() as u32);
        let bytes = &mut self.pixmap.data_mut()[4 * side * rows.start..4 * side * rows.end];
        if let Some(mut pixmap) = PixmapMut::from_bytes(bytes, side as u32, count) {
            pixmap.fill_path(&path, &paint, rule, Transform::identity(), None);
        }
    }

    /// Whether a ring, or on a tile an image of it, reaches within `by` units of the rows to draw on.
    fn reaches(&self, ring: &[DVec2], by: f64) -> bool {
        let side = self.units();
        let lo = ring.iter().fold(f64::INFINITY, |lo, p| lo.min(p.y)) - by;
        let hi = ring.iter().fold(f64::NEG_INFINITY, |hi, p| hi.max(p.y)) + by;
        let [from, to] = [self.rows.start, self.rows.end].map(|row| self.in_units(row));
        let images: &[f64] = if self.tile {
            &[0.0, side, -side]
        } else {
            &[0.0]
        };
        images.iter().any(|y| lo + y <= to && hi + y >= from)
    }

    /// Adds rings to a path, and on a tile their copies. The first ring encloses the others.
    fn trace(&self, builder: &mut PathBuilder, rings: &[&[DVec2]]) {
        let side = self.units();
        let around = rings.first().filter(|_| self.tile);
        let copies = around.map_or_else(Vec::new, |ring| copies(ring, side));
        let origin = DVec2::new(0.0, self.in_units(self.rows.start));
        let scale = self.scale as f64;
        for shift in std::iter::once(DVec2::ZERO).chain(copies) {
            rings
                .iter()
                .for_each(|ring| trace(builder, ring, shift - origin, scale));
        }
    }

    /// The pixels: red, green, blue, opacity, all opaque, row by row from the top.
    pub fn rgba(&self) -> &[u8] {
        self.pixmap.data()
    }

    /// The pixels, for changes; they must stay opaque.
    pub fn rgba_mut(&mut self) -> &mut [u8] {
        self.pixmap.data_mut()
    }

    /// Copies a finished opaque picture of the same size; pixels it lacks stay as they were.
    pub fn show(&mut self, rgba: &[u8]) {
        let pixels = self.pixmap.data_mut();
        let length = pixels.len().min(rgba.len());
        pixels[..length].copy_from_slice(&rgba[..length]);
    }

    /// Whether the board has `side` picture units along a side.
    pub fn fits(&self, side: usize) -> bool {
        self.side() == side * self.scale
    }

    /// The same picture with at least `scale` pixels along a unit. Colours between its own pixels are interpolated.
    #[must_use]
    pub fn enlarged(&self, scale: usize) -> Self {
        let by = scale / self.scale;
        if by < 2 {
            return self.clone();
        }
        let side = self.side();
        let mut larger = Self::scaled(side, by, [0.0; 4]);
        larger.scale = self.scale * by;
        // Columns are placed like rows.
        let places: Vec<_> = (0..side * by).map(|k| around(k, by, side)).collect();
        let rows = larger.pixmap.data_mut().chunks_exact_mut(4 * side * by);
        for (row, &(pair, below)) in rows.zip(&places) {
            let [upper, lower] = pair.map(|y| &self.rgba()[4 * side * y..][..4 * side]);
            for (pixel, &([left, right], beside)) in row.chunks_exact_mut(4).zip(&places) {
                for (k, value) in pixel.iter_mut().enumerate() {
                    let of_row = |row: &[u8]| mixed(row[4 * left + k], row[4 * right + k], beside);
                    let [a, b] = [upper, lower].map(of_row);
                    *value = ((a * (256 - below) + b * below + (1 << 15)) >> 16) as u8;
                }
            }
        }
        larger
    }
}

/// 256 times the mean of `a` and `b`, where `b` has this share, in 256ths.
fn mixed(a: u8, b: u8, share: u32) -> u32 {
    u32::from(a) * (256 - share) + u32::from(b) * share
}

/// Interpolates along an axis whose `side` pixels are each divided into `by` finer ones. Returns the two pixels between
/// whose middles the finer pixel `k` lies, and the weight of the second, in 256ths.
fn around(k: usize, by: usize, side: usize) -> ([usize; 2], u32) {
    let middle = 2 * k + 1 + by;
    let (second, share) = (middle / (2 * by), middle % (2 * by));
    let share = (256 * share + by) / (2 * by);
    ([second.max(1) - 1, second.min(side - 1)], share as u32)
}

/// Adds a closed ring to a path, moved by `shift`, with `scale` pixels along a unit.
fn trace(builder: &mut PathBuilder, ring: &[DVec2], shift: DVec2, scale: f64) {
    for (k, &p) in ring.iter().enumerate() {
        let p = scale * (p + shift);
        let (x, y) = (p.x as f32, p.y as f32);
        if k == 0 {
            builder.move_to(x, y);
        } else {
            builder.line_to(x, y);
        }
    }
    if !ring.is_empty() {
        builder.close();
    }
}

fn refs(paths: &[Vec<DVec2>]) -> Vec<&[DVec2]> {
    paths.iter().map(Vec::as_slice).collect()
}

fn skia_colour(colour: Colour) -> Color {
    let [r, g, b, a] = colour.map(|c| c.clamp(0.0, 1.0));
    Color::from_rgba(r, g, b, a).unwrap_or(Color::BLACK)
}

fn paint(colour: Colour) -> Paint<'static> {
    Paint {
        shader: Shader::SolidColor(skia_colour(colour)),
        ..Paint::default()
    }
}
