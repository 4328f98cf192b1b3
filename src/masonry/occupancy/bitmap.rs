//! The free pixels of a face.

use super::claims::Claim;
use crate::masonry::footprint::Footprint;
use crate::masonry::region::Region;
use crate::order;
use glam::DVec2;
use smallvec::SmallVec;
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

/// Ranges of pixels. A brick lies on a few rows, whose list needs no allocation.
type PixelRanges = SmallVec<[Range<usize>; 12]>;

/// A raster of a face's (s, t). A pixel counts as empty by its centre.
///
/// Legakis, Dorsey, Gortler (2001), section 3.3, use a quadtree. Joints do not fall on its lines, so it divides along
/// all of them: a bitmap of the same resolution is quicker and smaller.
#[derive(Clone, Debug)]
pub struct Bitmap {
    low: DVec2,
    pixel: f64,
    width: usize,
    is_empty: Vec<bool>,
}

impl Bitmap {
    /// The raster of a region with pixels of this side (metres, above 0), usually an eighth of the pattern's module.
    /// All is occupied but the region.
    pub fn new(region: &Region, pixel: f64) -> Self {
        let [low, high] = region.bounds().unwrap_or_default();
        let size = ((high - low) / pixel).ceil().max(DVec2::ONE);
        let (width, height) = (size.x as usize, size.y as usize);
        let mut map = Self {
            low,
            pixel,
            width,
            is_empty: vec![false; width * height],
        };
        for row in 0..height {
            map.empty_row(region, row);
        }
        map
    }

    /// Makes the pixels of a row empty that lie between each pair of crossings with the region's sides.
    fn empty_row(&mut self, region: &Region, row: usize) {
        let t = self.centre(row);
        let cut = region.sides().filter(|[a, b]| (a.y > t) != (b.y > t));
        let mut places: Vec<f64> = cut
            .map(|[a, b]| a.x + (b.x - a.x) * ((t - a.y) / (b.y - a.y)))
            .collect();
        order::sort(&mut places, |&s| (order::rank(s), 0));
        for pair in places.chunks_exact(2) {
            for pixel in self.columns([pair[0], pair[1]]) {
                self.is_empty[row * self.width + pixel] = true;
            }
        }
    }

    /// For each pixel, row by row from the least t: none if it is occupied, else the number of the last of these claims
    /// that covers it. Also the number of pixels in a row.
    pub(super) fn owners(&self, claims: &[Claim]) -> (Vec<Option<Option<u32>>>, usize) {
        let free = self.is_empty.iter().map(|&empty| empty.then_some(None));
        let mut owners: Vec<Option<Option<u32>>> = free.collect();
        for claim in claims {
            for pixel in self.under(&claim.polygon).0.into_iter().flatten() {
                if let Some(owner) = &mut owners[pixel] {
                    *owner = Some(claim.cell);
                }
            }
        }
        (owners, self.width)
    }

    /// The lower corner of a pixel, by its column and its row; also beyond the raster.
    pub(super) fn corner(&self, [column, row]: [usize; 2]) -> DVec2 {
        self.low + self.pixel * DVec2::new(column as f64, row as f64)
    }

    /// The side of a pixel, in metres.
    pub fn pixel(&self) -> f64 {
        self.pixel
    }

    /// The t of the centres of a row.
    fn centre(&self, row: usize) -> f64 {
        self.low.y + (row as f64 + 0.5) * self.pixel
    }

    /// The numbers, from `low` on, of the first pixels whose centres do not lie before two places along s or t. They
    /// may lie beyond the raster.
    fn span(&self, low: f64, places: [f64; 2]) -> [f64; 2] {
        places.map(|place| ((place - low) / self.pixel - 0.5).ceil())
    }

    /// The pixels of a row whose centres lie in an interval of s.
    fn columns(&self, interval: [f64; 2]) -> Range<usize> {
        self.within(self.span(self.low.x, interval))
    }

    /// The part of a span of pixels of a row that lies in the raster.
    fn within(&self, span: [f64; 2]) -> Range<usize> {
        let [from, to] = span.map(|column| column.clamp(0.0, self.width as f64) as usize);
        from..to.max(from)
    }

    /// The pixels under a polygon, as a range of `is_empty` for each row, and the number of their centres, also of those
    /// beyond the raster.
    fn under(&self, polygon: &Footprint) -> (PixelRanges, f64) {
        let [low, high] = polygon.bounds();
        let [from, to] = self.span(self.low.y, [low.y, high.y]);
        let rows = (self.is_empty.len() / self.width) as f64;
        let inside = [from, to].map(|row| row.clamp(0.0, rows) as usize);
        let in_row = |row: usize, columns: Range<usize>| {
            let start = row * self.width;
            start + columns.start..start + columns.end
        };
        if polygon.is_rectangle() {
            let span = self.span(self.low.x, [low.x, high.x]);
            let columns = self.within(span);
            let ranges = (inside[0]..inside[1]).map(|row| in_row(row, columns.clone()));
            let count = (to - from).max(0.0) * (span[1] - span[0]).max(0.0);
            return (ranges.collect(), count);
        }
        let (mut ranges, mut count) = (PixelRanges::new(), 0.0);
        for k in 0..(to - from) as usize {
            let row = from + k as f64;
            let t = self.low.y + (row + 0.5) * self.pixel;
            let span = self.span(self.low.x, chord(polygon, t));
            count += (span[1] - span[0]).max(0.0);
            if (0.0..rows).contains(&row) {
                ranges.push(in_row(row as usize, self.within(span)));
            }
        }
        (ranges, count)
    }

    /// Makes the pixels under a polygon occupied.
    pub fn occupy(&mut self, polygon: &Footprint) {
        let (ranges, _) = self.under(polygon);
        for range in ranges {
            self.is_empty[range].fill(false);
        }
    }

    /// The share of the pixel centres under a polygon that are empty, 0 to 1; none if there are no centres. Centres
    /// beyond the raster count as occupied.
    pub fn empty_share(&self, polygon: &Footprint) -> Option<f64> {
        let (ranges, whole) = self.under(polygon);
        let count =
            |range: Range<usize>| self.is_empty[range].iter().filter(|&&empty| empty).count();
        let empty: usize = ranges.into_iter().map(count).sum();
        (whole > 0.0).then(|| (empty as f64 / whole).min(1.0))
    }

    /// Whether a place is free, partly free or occupied. A place between pixel centres is partly free: only exact
    /// claims know more.
    pub fn coverage(&self, polygon: &Footprint) -> Coverage {
        match self.empty_share(polygon) {
            Some(share) if share >= FREE => Coverage::Free,
            Some(share) if share <= OCCUPIED => Coverage::Occupied,
            _ => Coverage::Partly,
        }
    }

    /// The empty area, in square metres, as far as pixels know it.
    pub fn empty_area(&self) -> f64 {
        let empty = self.is_empty.iter().filter(|&&empty| empty).count();
        empty as f64 * self.pixel * self.pixel
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
