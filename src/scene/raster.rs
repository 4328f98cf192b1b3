//! Rasterises triangles without gaps or overlaps.
//!
//! Corners are rounded to a grid of 1/256 of a pixel, and coverage is computed in integers. A pixel is covered if its
//! middle is inside. If the middle lies on an edge, the pixel belongs to exactly one of the two triangles there (the
//! top-left rule). Depth is stored as its inverse, which is linear on the screen.
//!
//! Pixels are processed four at a time. Integers are kept in i32; those of the few large triangles in f64, which
//! holds them exactly, too.

use super::four_pixels::{FourPixels, LANES};
use crate::order::{greater, lesser};
use std::array::from_fn;
use std::ops::Range;
use wide::{f32x4, i32x4};

/// Grid steps in a pixel along a side, as a power of two.
const SUB_BITS: u32 = 8;
const SUB: f64 = (1 << SUB_BITS) as f64;
const HALF: i32 = 1 << (SUB_BITS - 1);

/// Adding this to a number rounds it to an integer, ties to even.
const WHOLE: f64 = 1.5 * (1u64 << 52) as f64;

/// Edge functions of triangles up to this size (64 pixels) fit into i32, also at pixels that fill up a group of four.
const SMALL: u32 = 64 << SUB_BITS;

/// A corner on the screen: x to the right and y down in grid steps, and the inverse of its depth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    at: [i32; 2],
    near: f32,
}

impl Corner {
    /// The corner at a place in pixels.
    #[inline(always)]
    pub fn new([x, y, near]: [f32; 3]) -> Self {
        // The low bits of the sum are those of the integer, as no place is as large as 2^31. This needs no call:
        // processors have no single instruction for rounding.
        let at = [x, y].map(|v| (f64::from(v) * SUB + WHOLE).to_bits() as i32);
        Self { at, near }
    }
}

/// The pixels into which triangles are drawn.
pub(super) struct PixelGrid {
    pub width: usize,
    pub height: usize,
}

impl PixelGrid {
    /// Draws a triangle: calls `put` with groups of pixels, of which it may cover some. Triangles whose corners do
    /// not run counter-clockwise on the screen (seen with y up) are skipped. Returns the number of pixels that were
    /// examined.
    #[inline(always)]
    pub fn triangle(&self, corners: [Corner; 3], put: impl FnMut(FourPixels)) -> usize {
        let [a, b, c] = corners.map(|corner| corner.at.map(i64::from));
        let area = (c[0] - a[0]) * (b[1] - a[1]) - (b[0] - a[0]) * (c[1] - a[1]);
        if area <= 0 {
            return 0;
        }
        let span = |axis: usize, size: usize| {
            let [a, b, c] = corners.map(|corner| corner.at[axis]);
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            // The first pixel whose middle is not before the span, and the one after the last whose middle is not
            // beyond it.
            let first = (low + (HALF - 1)) >> SUB_BITS;
            let end = ((high - HALF) >> SUB_BITS) + 1;
            let span = first.max(0)..end.min(size as i32);
            (span, high.wrapping_sub(low) as u32 <= SMALL)
        };
        let ((columns, is_narrow), (rows, is_low)) = (span(0, self.width), span(1, self.height));
        if columns.is_empty() || rows.is_empty() {
            return 0;
        }
        let looked_at = columns.len() * rows.len();
        let columns = columns.start - columns.start % LANES as i32..columns.end;
        if is_narrow & is_low {
            self.small(corners, area, [columns, rows], put);
            return looked_at;
        }
        self.large(corners, area, [columns, rows], put)
    }

    /// Draws a triangle whose edge functions fit into i32.
    #[inline(always)]
    fn small(
        &self,
        corners: [Corner; 3],
        area: i64,
        [columns, rows]: [Range<i32>; 2],
        mut put: impl FnMut(FourPixels),
    ) {
        let depth = Parts::new(&corners, area as f32);
        let [a, b, c] = corners.map(|corner| corner.at);
        let middle = [columns.start, rows.start].map(|pixel| (pixel << SUB_BITS) + HALF);
        let edges = [[a, b], [b, c], [c, a]].map(|[a, b]| {
            let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
            let start = dy * (middle[0] - a[0]) - dx * (middle[1] - a[1]) - less(dx, dy);
            [start, dy << SUB_BITS, -(dx << SUB_BITS)]
        });
        let steps = edges.map(|[_, right, _]| i32x4::splat(right << 2));
        let downs = edges.map(|[.., down]| i32x4::splat(down));
        let mut starts = edges.map(|[start, right, _]| {
            i32x4::new([
                start,
                start + right,
                start + (right << 1),
                start + (right << 1) + right,
            ])
        });
        for y in rows {
            let row = y as usize * self.width;
            let mut at = starts;
            for x in columns.clone().step_by(LANES) {
                let [a, b, c] = at;
                let four = FourPixels {
                    at: row + x as usize,
                    covered: !(a | b | c).simd_lt(i32x4::ZERO),
                    near: depth.at(a.round_float(), c.round_float()),
                };
                put(four.within(self.width as i32 - x));
                at = from_fn(|e| at[e] + steps[e]);
            }
            starts = from_fn(|e| starts[e] + downs[e]);
        }
    }

    /// Draws a triangle of any size; returns the number of pixels that were examined. Most of a sliver's box is
    /// outside of it, so each row is examined only between the edges.
    #[inline(never)]
    fn large(
        &self,
        corners: [Corner; 3],
        area: i64,
        [columns, rows]: [Range<i32>; 2],
        mut put: impl FnMut(FourPixels),
    ) -> usize {
        let area = area as f64;
        let fixed = corners.map(|corner| corner.at.map(f64::from));
        let [a, b, c] = fixed;
        let edges = [
            EdgeFunction::new(a, b, 0.0),
            EdgeFunction::new(b, c, area),
            EdgeFunction::new(c, a, 0.0),
        ];
        let depth = Depth::new(fixed, corners.map(|corner| corner.near), area);
        let from = |axis: usize, pixel: i32| f64::from(pixel) + 0.5 - a[axis] / SUB;
        let mut looked_at = 0;
        for y in rows {
            let down = from(1, y);
            let starts = edges.map(|edge| edge.start + down * edge.down);
            let deep = down * depth.down;
            let row = y as usize * self.width;
            let begin = from(0, columns.start);
            let near = starts
                .iter()
                .zip(&edges)
                .fold(columns.clone(), |near, (&start, edge)| {
                    edge.narrow(near, columns.start, start + begin * edge.right)
                });
            looked_at += LANES + near.len();
            let mut across: [f64; LANES] = from_fn(|k| from(0, near.start + k as i32));
            for x in near.step_by(LANES) {
                let at: [[f64; LANES]; 3] =
                    from_fn(|e| from_fn(|k| starts[e] + across[k] * edges[e].right));
                let four = FourPixels {
                    at: row + x as usize,
                    covered: i32x4::new(from_fn(|k| {
                        let least = lesser(at[0][k], lesser(at[1][k], at[2][k]));
                        -i32::from(least >= 0.0)
                    })),
                    near: f32x4::new(across.map(|across| depth.at(across, deep))),
                };
                put(four.within(self.width as i32 - x));
                across = across.map(|across| across + LANES as f64);
            }
        }
        looked_at
    }
}

/// An edge function, not negative inside: its value at the first corner, and its steps for a pixel to the right and
/// down.
#[derive(Clone, Copy)]
struct EdgeFunction {
    start: f64,
    right: f64,
    down: f64,
}

impl EdgeFunction {
    /// The function of the edge from one corner to the next, counter-clockwise with y up. `start` is its value at the
    /// triangle's first corner.
    #[inline(always)]
    fn new([ax, ay]: [f64; 2], [bx, by]: [f64; 2], start: f64) -> Self {
        let (dx, dy) = (bx - ax, by - ay);
        Self {
            start: start - f64::from(less(dx, dy)),
            right: dy * SUB,
            down: -dx * SUB,
        }
    }

    /// The columns of a row that can be inside of the edge, with one more at each end against rounding; they begin
    /// with a whole group. `value` is the function at the column `first`.
    #[inline(always)]
    fn narrow(&self, columns: Range<i32>, first: i32, value: f64) -> Range<i32> {
        if self.right == 0.0 {
            return if value < 0.0 { first..first } else { columns };
        }
        // Where the edge crosses the row; the conversion saturates.
        let cross = (-value / self.right) as i32;
        if self.right > 0.0 {
            let start = first.saturating_add(cross).saturating_sub(1);
            let start = start.max(columns.start);
            start - start % LANES as i32..columns.end
        } else {
            let end = first.saturating_add(cross).saturating_add(2);
            columns.start..columns.end.min(end)
        }
    }
}

/// The offset of an edge function from the exact one: 0 for left and upper edges, which own their pixels, and 1 for
/// others.
#[inline(always)]
fn less<T: PartialOrd + From<i8>>(dx: T, dy: T) -> i32 {
    let zero = T::from(0);
    let owns = (dy > zero) | ((dy == zero) & (dx < zero));
    i32::from(!owns)
}

/// The inverse depth over a small triangle, as a sum of its edge functions weighted by its corners.
struct Parts {
    start: f32,
    first: f32,
    last: f32,
    low: f32,
    high: f32,
}

impl Parts {
    #[inline(always)]
    fn new([a, b, c]: &[Corner; 3], area: f32) -> Self {
        let less = |a: &Corner, b: &Corner| less(b.at[0] - a.at[0], b.at[1] - a.at[1]) as f32;
        // The first edge is opposite the third corner, the last one opposite the second.
        let one = 1.0 / area;
        let (first, last) = ((c.near - a.near) * one, (b.near - a.near) * one);
        Self {
            start: a.near + (first * less(a, b) + last * less(c, a)),
            first,
            last,
            low: lesser(a.near, lesser(b.near, c.near)),
            high: greater(a.near, greater(b.near, c.near)),
        }
    }

    #[inline(always)]
    fn at(&self, first: f32x4, last: f32x4) -> f32x4 {
        let s = f32x4::splat;
        let z = s(self.start) + (first * s(self.first) + last * s(self.last));
        // Rounding must not make a pixel nearer or farther than the corners.
        z.fast_max(s(self.low)).fast_min(s(self.high))
    }
}

/// The inverse depth over a triangle. It is steep across slivers, for which f32 is too coarse.
struct Depth {
    start: f64,
    right: f64,
    down: f64,
    low: f32,
    high: f32,
}

impl Depth {
    #[inline(always)]
    fn new([a, b, c]: [[f64; 2]; 3], near: [f32; 3], area: f64) -> Self {
        let part = |v: f64| v / SUB;
        let [bx, by] = [part(b[0] - a[0]), part(b[1] - a[1])];
        let [cx, cy] = [part(c[0] - a[0]), part(c[1] - a[1])];
        let [za, zb, zc] = near.map(f64::from);
        let (zb, zc) = (zb - za, zc - za);
        // Twice the area in pixels, negative because y points down.
        let inverse = -SUB * SUB / area;
        Self {
            right: (zb * cy - zc * by) * inverse,
            down: (zc * bx - zb * cx) * inverse,
            low: lesser(near[0], lesser(near[1], near[2])),
            high: greater(near[0], greater(near[1], near[2])),
            start: za,
        }
    }

    #[inline(always)]
    fn at(&self, across: f64, down: f64) -> f32 {
        let z = (self.start + across * self.right + down) as f32;
        // Rounding must not make a pixel nearer or farther than the corners.
        lesser(greater(z, self.low), self.high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
        let grid = PixelGrid {
            width: 40,
            height: 30,
        };
        let mut counts = vec![0; grid.width * grid.height];
        for &triangle in triangles {
            grid.triangle(triangle.map(Corner::new), |four| {
                for (k, covered) in four.covered.to_array().into_iter().enumerate() {
                    if covered != 0 {
                        counts[four.at + k] += 1;
                    }
                }
            });
        }
        counts
    }

    /// A fan of triangles around a point covers each pixel of a square once, wherever the point lies.
    #[test]
    fn neighbours_share_no_pixel_and_leave_none() {
        let ring: Vec<[f32; 3]> = [
            [-3.0, -2.0],
            [-3.0, 33.0],
            [20.5, 35.0],
            [44.0, 31.0],
            [43.0, -5.0],
            [11.5, -1.0],
        ]
        .map(|[x, y]| [x, y, 1.0])
        .to_vec();
        for middle in [[20.5, 15.5], [0.5, 0.5], [20.0, 15.0], [39.51, 3.127]] {
            let [x, y] = middle;
            let fan: Vec<[[f32; 3]; 3]> = (0..ring.len())
                .map(|k| [ring[k], ring[(k + 1) % ring.len()], [x, y, 1.0]])
                .collect();
            assert!(counts(&fan).iter().all(|&n| n == 1), "{middle:?}");
            let turned: Vec<[[f32; 3]; 3]> = fan.iter().map(|&[a, b, c]| [b, a, c]).collect();
            assert!(counts(&turned).iter().all(|&n| n == 0));
        }
    }

    #[test]
    fn depth_changes_evenly() {
        let grid = PixelGrid {
            width: 8,
            height: 8,
        };
        let corners = [[0.0, 0.0, 1.0], [0.0, 8.0, 1.0], [8.0, 0.0, 3.0]];
        let mut met = 0;
        grid.triangle(corners.map(Corner::new), |four| {
            for k in (0..LANES).filter(|&k| four.covered.to_array()[k] != 0) {
                met += 1;
                let x = ((four.at + k) % 8) as f32 + 0.5;
                assert!((four.near.to_array()[k] - (1.0 + x / 4.0)).abs() < 1e-5);
            }
        });
        assert!(met > 20);
    }
}
