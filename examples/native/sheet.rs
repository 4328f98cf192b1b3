//! Contact sheets: small pictures side by side, each with its name below it.

use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};

/// Pixels along the side of a picture on the sheet.
const SMALL: usize = 256;
/// Pixels between two pictures, and between a picture and its name.
const GAP: usize = 8;
const COLUMNS: usize = 5;
const HEIGHT: RasterHeight = RasterHeight::Size16;
const WEIGHT: FontWeight = FontWeight::Regular;
/// Pixels from one row of pictures to the next.
const ROW: usize = SMALL + GAP / 2 + HEIGHT.val() + GAP;
const PAPER: [u8; 3] = [38, 34, 30];
const INK: [u8; 3] = [235, 228, 216];

/// All pictures of a generator.
pub struct Sheet {
    pub width: usize,
    pub pixels: Vec<[u8; 3]>,
    count: usize,
}

impl Sheet {
    /// A sheet with room for this number of pictures.
    pub fn new(room: usize) -> Self {
        let columns = COLUMNS.min(room.max(1));
        let width = columns * (SMALL + GAP) + GAP;
        let height = room.div_ceil(columns) * ROW + GAP;
        Self {
            width,
            pixels: vec![PAPER; width * height],
            count: 0,
        }
    }

    /// Puts a square RGBA picture of `side` pixels, at least [`SMALL`], into the next place.
    pub fn add(&mut self, name: &str, side: usize, rgba: &[u8]) {
        let (column, row) = (self.count % COLUMNS, self.count / COLUMNS);
        let corner = (GAP + column * (SMALL + GAP), GAP + row * ROW);
        self.draw(corner, side, rgba);
        self.write((corner.0, corner.1 + SMALL + GAP / 2), name);
        self.count += 1;
    }

    /// Draws a picture; each pixel is the mean light of the pixels that it replaces.
    fn draw(&mut self, (left, top): (usize, usize), side: usize, rgba: &[u8]) {
        let span = |k: usize| k * side / SMALL..(k + 1) * side / SMALL;
        for y in 0..SMALL {
            for x in 0..SMALL {
                let rows = span(y).flat_map(|v| span(x).map(move |u| 4 * (v * side + u)));
                self.pixels[(top + y) * self.width + left + x] = mean(rgba, rows);
            }
        }
    }

    /// Writes as many characters as fit under a picture, from this corner.
    fn write(&mut self, (left, top): (usize, usize), words: &str) {
        let advance = get_raster_width(WEIGHT, HEIGHT);
        for (k, character) in words.chars().take(SMALL / advance).enumerate() {
            let Some(raster) = get_raster(character, WEIGHT, HEIGHT) else {
                continue;
            };
            for (y, row) in raster.rows().enumerate() {
                for (x, &cover) in row.iter().enumerate() {
                    let at = (top + y) * self.width + left + k * advance + x;
                    self.pixels[at] = mix(PAPER, INK, f64::from(cover) / 255.0);
                }
            }
        }
    }
}

fn mean(rgba: &[u8], places: impl Iterator<Item = usize>) -> [u8; 3] {
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for at in places {
        (0..3).for_each(|c| sum[c] += linear(rgba[at + c]));
        count += 1.0;
    }
    sum.map(|light| encoded(light / count))
}

fn mix(a: [u8; 3], b: [u8; 3], share: f64) -> [u8; 3] {
    std::array::from_fn(|c| encoded(linear(a[c]) * (1.0 - share) + linear(b[c]) * share))
}

/// The approximate linear light of an sRGB byte, 0 to 1; exact enough for small pictures.
fn linear(byte: u8) -> f64 {
    let share = f64::from(byte) / 255.0;
    share * share
}

fn encoded(light: f64) -> u8 {
    (light.sqrt() * 255.0).round() as u8
}
