//! Scan conversion of a stone: the height of its surface at nine points of each pixel.

use crate::order::{greater, lesser};
use crate::solid::Solid;
use glam::Vec3;
use std::ops::Range;

/// Samples across a pixel.
pub const ACROSS: usize = 3;

/// No surface at a sample.
pub const NOTHING: f32 = f32::NEG_INFINITY;

/// Samples of a row processed together; each row of the box has this many spare.
const LANES: usize = 4;

/// Tolerance of barycentric weights: closes the seams that rounding leaves between neighbouring triangles.
const SLACK: f32 = -1e-4;

/// The highest surface at each sample of a stone's box of pixels.
#[derive(Clone, Debug, Default)]
pub struct Raster {
    /// First column and row of pixels of the box.
    pub origin: [i32; 2],
    /// Columns and rows of pixels of the box.
    pub extent: [usize; 2],
    /// Rows of pixels that the stone's full box has above this box. Vertices are placed in the full box, so that
    /// rounding does not depend on the visible part.
    above: i32,
    /// Pixels for each picture unit, along a side.
    pixel_scale: f32,
    /// Samples in a row of `heights`.
    stride: usize,
    heights: Vec<f32>,
    /// The stone's vertices, x and y in samples of the full box.
    placed: Vec<Vec3>,
    /// The number of triangles done.
    drawn: usize,
}

impl Raster {
    /// Starts the scan conversion of a stone within these columns and rows of a picture with `pixel_scale`
    /// pixels for each unit, along a side.
    pub fn begin(&mut self, solid: &Solid, window: [Range<usize>; 2], pixel_scale: f32) {
        self.drawn = 0;
        self.pixel_scale = pixel_scale;
        self.frame(&solid.vertices, window);
        let [columns, rows] = self.extent;
        self.stride = columns * ACROSS + LANES;
        self.heights.clear();
        self.placed.clear();
        if columns * rows == 0 {
            return;
        }
        self.heights.resize(rows * ACROSS * self.stride, NOTHING);
        let mut placed = std::mem::take(&mut self.placed);
        placed.extend(solid.vertices.iter().map(|&v| self.in_samples(v)));
        self.placed = placed;
    }

    /// Scan-converts the parts above `floor` of at most `most` further triangles; true when finished.
    pub fn advance(&mut self, solid: &Solid, floor: f32, most: usize) -> bool {
        if self.placed.is_empty() {
            return true;
        }
        let placed = std::mem::take(&mut self.placed);
        let end = solid.triangles.len().min(self.drawn.saturating_add(most));
        for &[a, b, c] in &solid.triangles[self.drawn..end] {
            let corners = [a, b, c].map(|i| placed[i as usize]);
            if corners.iter().any(|c| c.z > floor) {
                self.triangle(corners);
            }
        }
        self.placed = placed;
        self.drawn = end;
        end == solid.triangles.len()
    }

    /// The heights of a pixel of the box, row by row; `None` if there is no surface.
    pub fn pixel(&self, x: usize, y: usize) -> Option<[f32; ACROSS * ACROSS]> {
        let mut heights = [NOTHING; ACROSS * ACROSS];
        let mut highest = NOTHING;
        for (row, three) in heights.chunks_exact_mut(ACROSS).enumerate() {
            let at = (y * ACROSS + row) * self.stride + x * ACROSS;
            three.copy_from_slice(&self.heights[at..at + ACROSS]);
            highest = three.iter().copied().fold(highest, greater);
        }
        (highest > NOTHING).then_some(heights)
    }

    fn frame(&mut self, vertices: &[Vec3], window: [Range<usize>; 2]) {
        let (mut low, mut high) = ([f32::MAX; 2], [f32::MIN; 2]);
        for v in vertices {
            low = [lesser(low[0], v.x), lesser(low[1], v.y)];
            high = [greater(high[0], v.x), greater(high[1], v.y)];
        }
        let span = |k: usize| {
            let (from, to) = (window[k].start as f32, window[k].end as f32);
            let inside = |v: f32| lesser(greater(v, from), to);
            let least = (low[k] * self.pixel_scale).floor();
            let first = inside(least) as usize;
            let last = inside((high[k] * self.pixel_scale).ceil()) as usize;
            let before = first as i32 - greater(least, 0.0) as i32;
            (first as i32, last.saturating_sub(first), before)
        };
        let ((x, columns, _), (y, rows, above)) = (span(0), span(1));
        self.above = above;
        self.origin = [x, y];
        self.extent = [columns, rows];
    }

    /// A vertex, with x and y in samples of the stone's full box; the first sample is (0, 0).
    fn in_samples(&self, v: Vec3) -> Vec3 {
        let scale = ACROSS as f32;
        let top = self.origin[1] - self.above;
        Vec3::new(
            (v.x * self.pixel_scale - self.origin[0] as f32) * scale - 0.5,
            (v.y * self.pixel_scale - top as f32) * scale - 0.5,
            v.z,
        )
    }

    /// Scan-converts a triangle. Triangles are about the size of a pixel, so every sample of a triangle's box is
    /// tested.
    fn triangle(&mut self, [a, b, c]: [Vec3; 3]) {
        let (ab, ac) = (b - a, c - a);
        let area = ab.x * ac.y - ab.y * ac.x;
        // Vertical and overhanging faces cover nothing from above.
        if area <= 1e-9 {
            return;
        }
        let [columns, rows] = self.extent.map(|pixels| (pixels * ACROSS) as i32);
        let Some((x0, x1)) = whole_between([a.x, b.x, c.x], columns) else {
            return;
        };
        let above = self.above * ACROSS as i32;
        let Some((y0, y1)) = whole_between([a.y, b.y, c.y], above + rows) else {
            return;
        };
        let inverse = 1.0 / area;
        // Barycentric weights of b and c: their rise along a row and down a column.
        let [b_across, b_down] = [ac.y * inverse, -ac.x * inverse];
        let [c_across, c_down] = [-ab.y * inverse, ab.x * inverse];
        let rise = b_across * ab.z + c_across * ac.z;
        let fall = b_down * ab.z + c_down * ac.z;
        for y in greater(y0, above)..=y1 {
            let dy = y as f32 - a.y;
            let (b_row, c_row, row) = (b_down * dy, c_down * dy, a.z + fall * dy);
            for x in (x0..=x1).step_by(LANES) {
                let start = (y - above) as usize * self.stride + x as usize;
                let slots = &mut self.heights[start..start + LANES];
                for (lane, slot) in slots.iter_mut().enumerate() {
                    let dx = (x + lane as i32) as f32 - a.x;
                    let (wb, wc) = (b_row + b_across * dx, c_row + c_across * dx);
                    let inside = (wb >= SLACK) & (wc >= SLACK) & (1.0 - wb - wc >= SLACK);
                    let height = if inside { row + rise * dx } else { NOTHING };
                    *slot = greater(*slot, height);
                }
            }
        }
    }
}

/// The first and the last integer of 0..`end` between the least and the greatest of three numbers; `None` if there is
/// none.
#[inline(always)]
fn whole_between([a, b, c]: [f32; 3], end: i32) -> Option<(i32, i32)> {
    let first = from(lesser(lesser(a, b), c));
    let greatest = greater(greater(a, b), c);
    let last = lesser(greatest as i32, end - 1);
    (greatest >= 0.0 && first <= last).then_some((first, last))
}

/// The first integer from 0 not below `v`; `f32::ceil` is a call where the target has no rounding
/// instruction.
fn from(v: f32) -> i32 {
    let whole = greater(v, 0.0) as i32;
    whole + i32::from((whole as f32) < v)
}
