//! Renders layers to pixels, antialiased, with tiny-skia. A picture unit is a pixel.

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
    /// Whether shapes that cross an edge continue at the opposite one.
    tile: bool,
    /// The rows to draw on; all others stay unchanged.
    rows: Range<usize>,
}

impl Board {
    /// A blank board of `side` x `side` pixels, at least 1.
    ///
    /// # Panics
    /// If a picture of that size does not fit into memory.
    pub fn new(side: usize, ground: Colour) -> Self {
        let side = side.max(1) as u32;
        let mut pixmap = Pixmap::new(side, side).expect("a picture fits into memory");
        pixmap.fill(skia_colour(ground));
        Self {
            pixmap,
            tile: false,
            rows: 0..side as usize,
        }
    }

    /// Pixels along a side.
    pub fn side(&self) -> usize {
        self.pixmap.width() as usize
    }

    /// From now on, shapes that cross an edge continue at the opposite one.
    pub fn repeat(&mut self) {
        self.tile = true;
    }

    /// Draws on these rows only.
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

    /// Whether a ring, or on a tile an image of it, reaches within `by` pixels of the rows to draw on.
    fn reaches(&self, ring: &[DVec2], by: f64) -> bool {
        let side = self.side() as f64;
        let lo = ring.iter().fold(f64::INFINITY, |lo, p| lo.min(p.y)) - by;
        let hi = ring.iter().fold(f64::NEG_INFINITY, |hi, p| hi.max(p.y)) + by;
        let (from, to) = (self.rows.start as f64, self.rows.end as f64);
        let images: &[f64] = if self.tile {
            &[0.0, side, -side]
        } else {
            &[0.0]
        };
        images.iter().any(|y| lo + y <= to && hi + y >= from)
    }

    /// Adds rings to a path, and on a tile their copies. The first ring encloses the others.
    fn trace(&self, builder: &mut PathBuilder, rings: &[&[DVec2]]) {
        let side = self.side() as f64;
        let around = rings.first().filter(|_| self.tile);
        let copies = around.map_or_else(Vec::new, |ring| copies(ring, side));
        let origin = DVec2::new(0.0, self.rows.start as f64);
        for shift in std::iter::once(DVec2::ZERO).chain(copies) {
            rings
                .iter()
                .for_each(|ring| trace(builder, ring, shift - origin));
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

    /// Whether the board has `side` pixels along a side.
    pub fn fits(&self, side: usize) -> bool {
        self.side() == side
    }
}

/// Adds a closed ring to a path, moved by `shift`.
fn trace(builder: &mut PathBuilder, ring: &[DVec2], shift: DVec2) {
    for (k, &p) in ring.iter().enumerate() {
        let (x, y) = ((p + shift).x as f32, (p + shift).y as f32);
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
