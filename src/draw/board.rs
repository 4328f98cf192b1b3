//! Renders layers to pixels, antialiased, with tiny-skia. A picture unit is one pixel or more along each side.

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

    /// The same with `scale` x `scale` pixels for each unit, at least 1.
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

    /// See [`super::layer::Shape::fill`].
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
        // Columns lie as rows do.
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

/// The mean of two values with a share of the second one in 256ths, 256 times as large.
fn mixed(a: u8, b: u8, share: u32) -> u32 {
    u32::from(a) * (256 - share) + u32::from(b) * share
}

/// The two pixels around the middle of the finer pixel `k`, of which there are `by` in a pixel, and the share of the
/// second one, in 256ths.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::shapes::round;
    use crate::draw::{DrawnPath, Paper};

    const PAPER: Paper = Paper {
        surround: [0.2, 0.4, 0.6, 1.0],
        bed: [0.6, 0.4, 0.2, 1.0],
        line: [1.0, 1.0, 1.0, 1.0],
    };
    const WHITE: Colour = [1.0; 4];

    fn square(lo: f64, hi: f64) -> Vec<DVec2> {
        [(lo, lo), (hi, lo), (hi, hi), (lo, hi)]
            .map(DVec2::from)
            .to_vec()
    }

    fn edges(rings: Vec<Vec<DVec2>>, colour: Colour, width: f64, round: f64) -> Layer {
        Layer::shapes(vec![DrawnPath::bare(rings)]).edged(colour, width, round)
    }

    fn line(points: [(f64, f64); 2], colour: Colour, width: f64) -> Layer {
        Layer::lines(vec![points.map(DVec2::from).to_vec()], colour, width)
    }

    fn pixel(board: &Board, x: usize, y: usize) -> [u8; 4] {
        std::array::from_fn(|k| board.rgba()[4 * (y * 64 + x) + k])
    }

    fn bytes(colour: Colour) -> [u8; 4] {
        colour.map(|c| (255.0 * c + 0.5) as u8)
    }

    #[test]
    fn the_bed_has_its_hole() {
        let mut hole = square(24.0, 40.0);
        hole.reverse();
        let mut board = Board::new(64, PAPER.surround);
        let rings = [&square(8.0, 56.0)[..], &hole];
        board.fill(&rings, PAPER.bed, 0.0);
        assert_eq!(pixel(&board, 2, 2), bytes(PAPER.surround));
        assert_eq!(pixel(&board, 32, 32), bytes(PAPER.surround));
        assert_eq!(pixel(&board, 16, 32), bytes(PAPER.bed));
        assert!(board.rgba().chunks(4).all(|p| p[3] == 255));
    }

    #[test]
    fn what_leaves_a_tile_comes_in_again() {
        let mut board = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
        board.fill(&[&square(-6.0, 6.0)], WHITE, 0.0);
        assert_eq!(pixel(&board, 61, 61)[0], 0);
        board.repeat();
        board.fill(&[&square(-6.0, 6.0)], WHITE, 0.0);
        for (x, y) in [(2, 2), (61, 2), (2, 61), (61, 61)] {
            assert_eq!(pixel(&board, x, y)[0], 255, "{x} {y}");
        }
        assert_eq!(pixel(&board, 32, 32)[0], 0);
    }

    #[test]
    fn lines_that_leave_a_tile_come_in_again_and_fill_nothing() {
        let mut board = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
        board.repeat();
        let rings = vec![square(-10.0, 10.0), square(20.0, 40.0)];
        board.draw(&[edges(rings, WHITE, 2.0, 0.0)]);
        for (x, y) in [(10, 3), (54, 3), (54, 60), (3, 54), (20, 30)] {
            assert!(pixel(&board, x, y)[0] > 100, "{x} {y}");
        }
        for (x, y) in [(3, 3), (60, 60), (60, 3), (30, 30), (50, 50)] {
            assert_eq!(pixel(&board, x, y)[0], 0, "{x} {y}");
        }
        let mut bars = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
        bars.repeat();
        bars.draw(&[line([(60.0, 30.0), (70.0, 30.0)], WHITE, 4.0)]);
        assert_eq!([pixel(&bars, 62, 30)[0], pixel(&bars, 3, 30)[0]], [255; 2]);
        assert_eq!(pixel(&bars, 30, 30)[0], 0);
    }

    #[test]
    fn rows_are_drawn_as_they_are_with_all_others() {
        let draw = |board: &mut Board| {
            board.fill(&[&round(DVec2::new(60.0, 55.0), 23.7)], WHITE, 0.0);
            let rings = vec![square(-10.2, 33.3)];
            board.draw(&[
                edges(rings, PAPER.surround, 2.3, 4.0),
                line([(3.0, 61.7), (50.0, 9.1)], PAPER.line, 1.6),
            ]);
        };
        for tile in [false, true] {
            let [mut whole, mut pieces] = [(); 2].map(|()| Board::new(64, PAPER.bed));
            (whole.tile, pieces.tile) = (tile, tile);
            draw(&mut whole);
            for from in (0..64).step_by(16) {
                let before = pieces.rgba().to_vec();
                pieces.within(from..from + 16, draw);
                let (start, end) = (256 * from, 256 * (from + 16));
                assert_eq!(before[..start], pieces.rgba()[..start]);
                assert_eq!(before[end..], pieces.rgba()[end..]);
            }
            // Lines cut at another row may cover another of a pixel's 16 samples.
            let pairs = whole.rgba().iter().zip(pieces.rgba());
            let others: Vec<u8> = pairs
                .map(|(a, b)| a.abs_diff(*b))
                .filter(|&d| d > 0)
                .collect();
            assert!(others.len() < 400, "{} bytes", others.len());
            assert!(others.iter().all(|&d| d <= 17), "{others:?}");
        }
    }

    /// The mean of `by` x `by` pixels for each pixel of a picture.
    fn averaged(board: &Board, by: usize) -> Vec<u8> {
        let fine = board.side();
        let side = fine / by;
        let value = |k: usize| {
            let (x, y) = (k / 4 % side, k / 4 / side);
            let at = |n: usize| 4 * ((by * y + n / by) * fine + by * x + n % by) + k % 4;
            let sum: usize = (0..by * by).map(|n| usize::from(board.rgba()[at(n)])).sum();
            (sum / (by * by)) as u8
        };
        (0..4 * side * side).map(value).collect()
    }

    #[test]
    fn more_pixels_show_the_same_drawing() {
        let layers = [
            Layer::fill(vec![round(DVec2::new(60.0, 55.0), 23.7)], WHITE, 0.0),
            Layer::fill(vec![square(5.3, 20.6)], PAPER.line, 4.0),
            edges(vec![square(-10.2, 33.3)], PAPER.surround, 2.3, 4.0),
            line([(3.0, 61.7), (50.0, 9.1)], PAPER.line, 0.7),
        ];
        for tile in [false, true] {
            let [plain, two, three] = [1, 2, 3].map(|scale| {
                let mut board = Board::scaled(64, scale, PAPER.bed);
                board.tile = tile;
                board.draw(&layers);
                assert!(board.fits(64) && !board.fits(64 * scale + 1));
                board
            });
            for (fine, by) in [(&two, 2), (&three, 3)] {
                assert_eq!(fine.side(), 64 * by);
                let pairs = averaged(fine, by)
                    .into_iter()
                    .zip(plain.rgba().iter().copied());
                let off: Vec<u8> = pairs.map(|(a, b)| a.abs_diff(b)).collect();
                let sum: usize = off.iter().map(|&d| usize::from(d)).sum();
                assert!(off.iter().all(|&d| d < 40), "{by}: {:?}", off.iter().max());
                assert!(sum < off.len(), "{by}: {sum} of {}", off.len());
            }
        }
    }

    #[test]
    fn rows_of_a_finer_drawing_are_those_of_the_whole() {
        let draw = |board: &mut Board| {
            board.fill(&[&square(10.0, 50.0)], WHITE, 0.0);
            board.draw(&[line([(10.0, 60.0), (50.0, 60.0)], PAPER.line, 2.0)]);
        };
        for scale in [2, 3] {
            let [mut whole, mut pieces] = [(); 2].map(|()| Board::scaled(64, scale, PAPER.bed));
            draw(&mut whole);
            for from in (0..64 * scale).step_by(16) {
                pieces.within(from..from + 16, draw);
            }
            assert_eq!(whole.rgba(), pieces.rgba());
        }
    }

    #[test]
    fn an_enlarged_picture_is_the_same_with_colours_between() {
        let mut board = Board::new(64, PAPER.surround);
        for (k, pixel) in board.rgba_mut().chunks_exact_mut(4).enumerate() {
            pixel[0] = 3 * (k % 64) as u8;
            pixel[1] = 2 * (k / 64) as u8;
        }
        for by in [2, 3] {
            let large = board.enlarged(by);
            assert_eq!((large.side(), large.scale()), (64 * by, by));
            let pairs = averaged(&large, by)
                .into_iter()
                .zip(board.rgba().iter().copied());
            assert!(pairs.clone().all(|(a, b)| a.abs_diff(b) < 2));
            let row: Vec<u8> = large.rgba().chunks(4).take(64 * by).map(|p| p[0]).collect();
            assert!(row.is_sorted() && row.iter().zip(&row[1..]).all(|(a, b)| b - a < 3));
            assert_eq!([row[0], row[64 * by - 1]], [0, 189]);
            assert_eq!(large.enlarged(by).rgba(), large.rgba());
        }
        assert_eq!(board.enlarged(1).rgba(), board.rgba());
    }

    #[test]
    fn half_covered_pixels_are_half_filled() {
        let mut board = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
        board.fill(&[&square(10.5, 20.0)], WHITE, 0.0);
        assert_eq!(pixel(&board, 15, 15)[0], 255);
        let half = pixel(&board, 10, 15)[0];
        assert!((120..=136).contains(&half), "{half}");
        assert_eq!(pixel(&board, 9, 15)[0], 0);
    }

    #[test]
    fn rounded_corners_are_cut_and_sides_are_not() {
        let mut board = Board::new(64, [0.0, 0.0, 0.0, 1.0]);
        board.fill(&[&square(10.0, 50.0)], WHITE, 8.0);
        assert_eq!(pixel(&board, 10, 10)[0], 0);
        assert_eq!(pixel(&board, 10, 30)[0], 255);
        assert_eq!(pixel(&board, 30, 49)[0], 255);
    }

    #[test]
    fn what_reaches_beyond_the_board_is_cut() {
        let mut board = Board::new(64, PAPER.surround);
        board.fill(&[&square(-30.0, 10.0)], WHITE, 0.0);
        board.fill(&[&square(50.0, 1e7)], WHITE, 0.0);
        assert_eq!(pixel(&board, 3, 9)[0], 255);
        assert_eq!(pixel(&board, 63, 63)[0], 255);
        assert_eq!(pixel(&board, 12, 3), bytes(PAPER.surround));
        assert_eq!(pixel(&board, 48, 63), bytes(PAPER.surround));
    }

    #[test]
    fn empty_and_far_away_rings_draw_nothing() {
        let mut board = Board::new(64, PAPER.surround);
        let before = board.rgba().to_vec();
        let far = square(1e7, 2e7);
        for ring in [&[][..], &[DVec2::ZERO], &far, &[DVec2::NAN; 3]] {
            board.fill(&[ring], WHITE, 1.0);
            board.draw(&[edges(vec![ring.to_vec()], WHITE, 1.0, 1.0)]);
        }
        board.draw(&[Layer::lines(Vec::new(), WHITE, 1.0)]);
        board.draw(&[line([(f64::NAN, f64::NAN); 2], WHITE, 1.0)]);
        assert_eq!(before, board.rgba());
    }

    #[test]
    fn a_picture_is_shown_as_it_is() {
        let mut board = Board::new(64, PAPER.surround);
        let picture: Vec<u8> = (0..64 * 64 * 4).map(|k| (k % 251) as u8).collect();
        board.show(&picture);
        assert_eq!(board.rgba(), picture);
        board.show(&[]);
        assert_eq!(board.rgba(), picture);
        assert!(board.fits(64) && !board.fits(65));
    }
}
