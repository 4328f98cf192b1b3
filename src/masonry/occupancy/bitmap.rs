//! The free pixels of a face.

use super::claims::Claim;
use crate::masonry::footprint::Footprint;
use crate::masonry::grid_place::GridPlace;
use crate::masonry::region::Region;
use crate::order;
use glam::DVec2;
use std::ops::Range;

/// A place is free if at least this share of its pixels is empty.
pub const FREE: f64 = 0.985;
/// A place is occupied if at most this share of its pixels is empty.
pub const OCCUPIED: f64 = 0.04;

/// How much of a place is free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coverage {
    /// All of it: at least 98.5 % of the pixel centres are empty.
    Free,
    /// Some of it.
    Partly,
    /// Nothing: at most 4 % of the pixel centres are empty.
    Occupied,
}

/// Larger than any rounding error of a place (metres).
const NEAR: f64 = 1e-12;

/// Bits in a word.
const WORD: usize = u64::BITS as usize;

/// A raster over a face's (s, t), with a bit for each pixel. A pixel is empty if its centre is.
///
/// Legakis, Dorsey, Gortler (2001), section 3.3, use a quadtree. Joints do not fall on the lines of such a tree, so it
/// would divide along all joints. A bitmap of the same resolution is quicker and smaller.
#[derive(Clone, Debug)]
pub struct Bitmap {
    raster: Raster,
    /// A bit for each pixel, set where it is empty. Each row begins at a new word.
    bits: Vec<u64>,
}

/// The place of the pixels in (s, t), and their number.
#[derive(Clone, Copy, Debug)]
struct Raster {
    low: DVec2,
    /// The side of a pixel (metres).
    pixel: f64,
    /// Pixels in a row.
    width: usize,
    /// Rows.
    height: usize,
}

impl Raster {
    /// The t of the centres of a row.
    fn centre(&self, row: f64) -> f64 {
        self.low.y + (row + 0.5) * self.pixel
    }

    /// For each of two places along s or t: the number of the first pixel whose centre does not lie before it. Pixel 0
    /// begins at `low`. The numbers may lie beyond the raster.
    fn span(&self, low: f64, places: [f64; 2]) -> [f64; 2] {
        places.map(|place| ((place - low) / self.pixel - 0.5).ceil())
    }

    /// The pixels of a row whose centres lie in an interval of s.
    fn columns(&self, interval: [f64; 2]) -> Range<usize> {
        self.within(self.span(self.low.x, interval))
    }

    /// The columns of a span that lie in the raster.
    fn within(&self, span: [f64; 2]) -> Range<usize> {
        let [from, to] = span.map(|column| column.clamp(0.0, self.width as f64) as usize);
        from..to.max(from)
    }

    /// The rows and the columns of pixels in the raster whose centres lie in a rectangle along s and t. Also the number
    /// of all pixel centres in it, those beyond the raster included.
    fn block(&self, [low, high]: [DVec2; 2]) -> ([Range<usize>; 2], f64) {
        let [from, to] = self.span(self.low.y, [low.y, high.y]);
        let span = self.span(self.low.x, [low.x, high.x]);
        let rows = self.height as f64;
        let [first, end] = [from, to].map(|row| row.clamp(0.0, rows) as usize);
        let count = (to - from).max(0.0) * (span[1] - span[0]).max(0.0);
        ([first..end, self.within(span)], count)
    }

    /// As [`Self::block`], for a polygon that is a rectangle, or differs from one so little that it has the same
    /// pixels: a brick's claim does so by rounding. None for all other polygons.
    fn plain_block(&self, polygon: &Footprint) -> Option<([Range<usize>; 2], f64)> {
        let around = polygon.bounds();
        if polygon.is_rectangle() {
            return Some(self.block(around));
        }
        let mut places = polygon.places();
        let corners = [
            places.next()?,
            places.next()?,
            places.next()?,
            places.next()?,
        ];
        if places.next().is_some() {
            return None;
        }
        // The first side is the lower one, or the left one.
        let first = (corners[1] - corners[0]).abs();
        let lower = usize::from(first.x < first.y);
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| corners[(lower + k) % 4]);
        // A rectangle inside of the polygon, smaller by more than rounding.
        let low = DVec2::new(order::greater(a.x, d.x), order::greater(a.y, b.y)) + NEAR;
        let high = DVec2::new(order::lesser(b.x, c.x), order::lesser(c.y, d.y)) - NEAR;
        if !low.cmplt(high).all() {
            return None;
        }
        let outer = self.block([around[0] - NEAR, around[1] + NEAR]);
        (outer == self.block([low, high])).then_some(outer)
    }

    /// Calls `each` with each row of pixels under a polygon. Returns the number of all pixel centres in the polygon,
    /// those beyond the raster included.
    fn under(&self, polygon: &Footprint, mut each: impl FnMut(usize, Range<usize>)) -> f64 {
        let [low, high] = polygon.bounds();
        if let Some(([rows, columns], count)) = self.plain_block(polygon) {
            for row in rows {
                each(row, columns.clone());
            }
            return count;
        }
        let [from, to] = self.span(self.low.y, [low.y, high.y]);
        let rows = self.height as f64;
        let mut count = 0.0;
        for k in 0..(to - from) as usize {
            let row = from + k as f64;
            let span = self.span(self.low.x, chord(polygon, self.centre(row)));
            count += (span[1] - span[0]).max(0.0);
            if (0.0..rows).contains(&row) {
                each(row as usize, self.within(span));
            }
        }
        count
    }

    /// The number of words in a row.
    fn stride(&self) -> usize {
        self.width.div_ceil(WORD)
    }

    /// The words that have some pixels of a row, each with the bits of these pixels.
    fn words(&self, row: usize, pixels: Range<usize>) -> impl Iterator<Item = (usize, u64)> {
        let start = row * self.stride();
        let words = pixels.start / WORD..pixels.end.div_ceil(WORD);
        words.map(move |word| {
            let first = word * WORD;
            let above = u64::MAX << pixels.start.saturating_sub(first);
            let below = u64::MAX >> (WORD - (pixels.end - first).min(WORD));
            (start + word, above & below)
        })
    }
}

impl Bitmap {
    /// The raster of a region with pixels of this side (metres, above 0), usually an eighth of the pattern's module.
    /// Pixels outside of the region are occupied.
    pub fn new(region: &Region, pixel: f64) -> Self {
        let [low, high] = region.bounds().unwrap_or_default();
        let size = ((high - low) / pixel).ceil().max(DVec2::ONE);
        let (width, height) = (size.x as usize, size.y as usize);
        let raster = Raster {
            low,
            pixel,
            width,
            height,
        };
        let mut map = Self {
            raster,
            bits: vec![0; width.div_ceil(WORD) * height],
        };
        let sides: Vec<[DVec2; 2]> = region.sides().collect();
        for row in 0..height {
            map.empty_row(&sides, row);
        }
        map
    }

    /// Makes the pixels of a row empty that lie between each pair of crossings with the region's sides.
    fn empty_row(&mut self, sides: &[[DVec2; 2]], row: usize) {
        let t = self.raster.centre(row as f64);
        let cut = sides.iter().filter(|[a, b]| (a.y > t) != (b.y > t));
        let mut places: Vec<f64> = cut
            .map(|[a, b]| a.x + (b.x - a.x) * ((t - a.y) / (b.y - a.y)))
            .collect();
        order::sort(&mut places, |&s| (order::rank(s), 0));
        for pair in places.chunks_exact(2) {
            let columns = self.raster.columns([pair[0], pair[1]]);
            for (word, bits) in self.raster.words(row, columns) {
                self.bits[word] |= bits;
            }
        }
    }

    /// For each pixel, row by row from the least t: `None` if it is occupied, `Some(None)` if it is empty and under no
    /// claim, else the cell of the last claim that covers it. Also the number of pixels in a row.
    pub(super) fn owners(&self, claims: &[Claim]) -> (Vec<Option<Option<u32>>>, usize) {
        let (width, height) = (self.raster.width, self.raster.height);
        let pixels = (0..height).flat_map(|row| (0..width).map(move |column| [row, column]));
        let free = pixels.map(|pixel| self.is_empty(pixel).then_some(None));
        let mut owners: Vec<Option<Option<u32>>> = free.collect();
        for claim in claims {
            self.raster.under(&claim.polygon, |row, columns| {
                for owner in owners[row * width..][columns].iter_mut().flatten() {
                    *owner = Some(claim.cell);
                }
            });
        }
        (owners, width)
    }

    fn is_empty(&self, [row, column]: [usize; 2]) -> bool {
        let mut words = self.raster.words(row, column..column + 1);
        words.all(|(word, bit)| self.bits[word] & bit != 0)
    }

    /// The lower corner of a pixel, by its column and its row; also beyond the raster.
    pub(super) fn corner(&self, [column, row]: [usize; 2]) -> DVec2 {
        self.raster.low + self.raster.pixel * DVec2::new(column as f64, row as f64)
    }

    /// The side of a pixel, in metres.
    pub fn pixel(&self) -> f64 {
        self.raster.pixel
    }

    /// Makes the pixels under a polygon occupied.
    pub fn occupy(&mut self, polygon: &Footprint) {
        let (raster, all) = (self.raster, &mut self.bits);
        if let Some(([rows, columns], _)) = raster.plain_block(polygon) {
            for (word, bits) in raster.words(0, columns) {
                for row in rows.clone() {
                    all[row * raster.stride() + word] &= !bits;
                }
            }
            return;
        }
        raster.under(polygon, |row, columns| {
            for (word, bits) in raster.words(row, columns) {
                all[word] &= !bits;
            }
        });
    }

    /// The share of the pixel centres under a polygon that are empty, 0 to 1; none if there are no centres. Centres
    /// beyond the raster count as occupied.
    pub fn empty_share(&self, polygon: &Footprint) -> Option<f64> {
        if polygon.is_rectangle() {
            let (empty, whole) = self.empty_under(polygon.bounds());
            return share(empty, whole);
        }
        let mut empty = 0;
        let whole = self.raster.under(polygon, |row, columns| {
            let words = self.raster.words(row, columns);
            let counts = words.map(|(word, bits)| (self.bits[word] & bits).count_ones());
            empty += counts.sum::<u32>();
        });
        share(empty, whole)
    }

    /// The number of empty pixel centres in a rectangle along s and t, and that of all pixel centres in it.
    fn empty_under(&self, place: [DVec2; 2]) -> (u32, f64) {
        let ([rows, columns], whole) = self.raster.block(place);
        let stride = self.raster.stride();
        let mut empty = 0;
        for (word, bits) in self.raster.words(0, columns) {
            let mut full = 0;
            for row in rows.clone() {
                let found = self.bits[row * stride + word] & bits;
                // Most rows are all empty or all occupied.
                match found {
                    0 => {}
                    _ if found == bits => full += 1,
                    _ => empty += found.count_ones(),
                }
            }
            empty += full * bits.count_ones();
        }
        (empty, whole)
    }

    /// Whether all pixels under a rectangle along s and t are empty.
    pub fn is_empty_under(&self, place: &GridPlace) -> bool {
        let (empty, whole) = self.empty_under([place.low, place.high]);
        whole > 0.0 && f64::from(empty) >= whole
    }

    /// Whether a place is free, partly free or occupied. A place without a pixel centre counts as partly free: only
    /// exact claims can tell more.
    pub fn coverage(&self, polygon: &Footprint) -> Coverage {
        coverage(self.empty_share(polygon))
    }

    /// As [`Self::coverage`], for a rectangle along s and t.
    pub fn coverage_of(&self, place: &GridPlace) -> Coverage {
        self.coverage_of_all(std::slice::from_ref(place))
    }

    /// As [`Self::coverage_of`], for several rectangles together. One without an area counts nothing.
    pub fn coverage_of_all(&self, places: &[GridPlace]) -> Coverage {
        let counts = places
            .iter()
            .map(|place| self.empty_under([place.low, place.high]));
        let (empty, whole) = counts.fold((0, 0.0), |sum, (empty, whole)| {
            (sum.0 + empty, sum.1 + whole)
        });
        coverage(share(empty, whole))
    }

    /// The least s and t of the raster (metres).
    pub fn low(&self) -> DVec2 {
        self.raster.low
    }

    /// The empty area: that of all empty pixels, in square metres.
    pub fn empty_area(&self) -> f64 {
        let empty: u32 = self.bits.iter().map(|word| word.count_ones()).sum();
        let pixel = self.raster.pixel;
        f64::from(empty) * pixel * pixel
    }
}

/// The share of pixel centres that are empty, 0 to 1; none if there are no centres.
fn share(empty: u32, whole: f64) -> Option<f64> {
    (whole > 0.0).then(|| (f64::from(empty) / whole).min(1.0))
}

fn coverage(share: Option<f64>) -> Coverage {
    match share {
        Some(share) if share >= FREE => Coverage::Free,
        Some(share) if share <= OCCUPIED => Coverage::Occupied,
        _ => Coverage::Partly,
    }
}

/// The interval of s of a polygon at a height t; empty, with its ends swapped, above and below it.
fn chord(polygon: &Footprint, t: f64) -> [f64; 2] {
    let sides = (0..polygon.corners().len()).map(|k| polygon.side(k));
    let cut = sides.filter(|[a, b]| (a.y > t) != (b.y > t));
    let places = cut.map(|[a, b]| a.x + (b.x - a.x) * ((t - a.y) / (b.y - a.y)));
    places.fold([f64::MAX, f64::MIN], |[from, to], s| {
        [from.min(s), to.max(s)]
    })
}
