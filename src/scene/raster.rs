//! Triangles to pixels, without gaps or overlaps.
//!
//! Corners are rounded to a fixed grid of 1/256 of a pixel, and all that decides which pixels a triangle has is
//! worked out in whole numbers: a pixel is covered where its middle is inside, and one whose middle lies on an
//! edge belongs to exactly one of the triangles beside it (the rule of left and upper edges). Depth is the
//! inverse of the distance into the frame, which changes evenly on the screen.
//!
//! Pixels are looked at four at a time, which compilers make one instruction of where they can. The whole numbers
//! are kept in f64, where they are exact.

use crate::order::{greater, lesser};
use std::array::from_fn;

/// Places of the grid for a pixel, along a side, as a power of two.
const SUB_BITS: u32 = 8;
const SUB: f64 = (1 << SUB_BITS) as f64;
const HALF: i32 = 1 << (SUB_BITS - 1);
/// Pixels that are looked at together: those from a multiple of this on in a row.
pub(super) const LANES: usize = 4;

/// Triangles that are no larger, 8 pixels, have edge functions below 2^24, at pixels that fill up the fours, too.
const SMALL: f64 = 8.0 * SUB;

/// A corner on the screen: x to the right, y down, in places of the grid; the inverse of its depth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    at: [i32; 2],
    near: f32,
}

impl Corner {
    /// Of a place in pixels.
    #[inline(always)]
    pub fn new([x, y, near]: [f32; 3]) -> Self {
        let at = [x, y].map(|v| (v * SUB as f32).round_ties_even() as i32);
        Self { at, near }
    }
}

/// Pixels beside each other: the place of the first in the grid, which of them are covered, and the inverse depths.
pub(super) struct Four {
    pub at: usize,
    pub covered: [bool; LANES],
    pub near: [f32; LANES],
}

impl Four {
    /// Those beyond the row's end, so many pixels on, are not covered.
    #[inline(always)]
    fn within(self, room: i32) -> Self {
        let covered = from_fn(|k| self.covered[k] & ((k as i32) < room));
        Self { covered, ..self }
    }

    /// Whether each is covered, and nearer than what is there.
    #[inline(always)]
    pub fn wins(&self, there: &[f32; LANES]) -> [bool; LANES] {
        from_fn(|k| self.covered[k] & (self.near[k] > there[k]))
    }
}

/// The list's places of pixels beside each other. It has [`LANES`] - 1 places more than the grid.
#[inline(always)]
pub(super) fn four_of<T>(list: &mut [T], at: usize) -> Option<&mut [T; LANES]> {
    list.get_mut(at..)?.first_chunk_mut()
}

/// Where triangles are drawn.
pub(super) struct Grid {
    pub width: usize,
    pub height: usize,
}

impl Grid {
    /// Draws a triangle: calls `put` with pixels some of which it may cover. Triangles whose corners do not turn
    /// counter-clockwise on the screen (seen with y up) are not drawn. Answers with the number of pixels that
    /// were looked at.
    #[inline(always)]
    pub fn triangle(&self, corners: [Corner; 3], mut put: impl FnMut(Four)) -> usize {
        let fixed = corners.map(|corner| corner.at.map(f64::from));
        let [a, b, c] = fixed;
        let area = (c[0] - a[0]) * (b[1] - a[1]) - (b[0] - a[0]) * (c[1] - a[1]);
        if area <= 0.0 {
            return 0;
        }
        let span = |axis: usize, size: usize| {
            let [a, b, c] = corners.map(|corner| corner.at[axis]);
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            // The first pixel whose middle is not before, the one after the last that is not beyond.
            let first = (low + (HALF - 1)) >> SUB_BITS;
            let end = ((high - HALF) >> SUB_BITS) + 1;
            let is_small = f64::from(high) - f64::from(low) <= SMALL;
            (first.max(0), end.min(size as i32), is_small)
        };
        let ((x0, x1, is_narrow), (y0, y1, is_low)) = (span(0, self.width), span(1, self.height));
        if x0 >= x1 || y0 >= y1 {
            return 0;
        }
        let edges = [
            Edge::new(a, b, 0.0),
            Edge::new(b, c, area),
            Edge::new(c, a, 0.0),
        ];
        let depth = Depth::new(fixed, corners.map(|corner| corner.near), area);
        let from = |axis: usize, pixel: i32| f64::from(pixel) + 0.5 - a[axis] / SUB;
        let x0 = x0 - x0 % LANES as i32;
        let first: [f64; LANES] = from_fn(|k| from(0, x0 + k as i32));
        // The edge functions of small triangles are exact in f32, too.
        let is_small = is_narrow & is_low;
        let short = edges.map(|edge| edge.right as f32);
        for y in y0..y1 {
            let down = from(1, y);
            let starts = edges.map(|edge| edge.start + down * edge.down);
            let deep = down * depth.down;
            let row = y as usize * self.width;
            let mut right = first;
            if is_small {
                let starts = starts.map(|start| start as f32);
                let mut near = first.map(|right| right as f32);
                for x in (x0..x1).step_by(LANES) {
                    let covered = from_fn(|k| {
                        let at = |e: usize| starts[e] + near[k] * short[e];
                        lesser(at(0), lesser(at(1), at(2))) >= 0.0
                    });
                    let four = Four {
                        at: row + x as usize,
                        covered,
                        near: right.map(|right| depth.at(right, deep)),
                    };
                    put(four.within(self.width as i32 - x));
                    right = right.map(|right| right + LANES as f64);
                    near = near.map(|near| near + LANES as f32);
                }
                continue;
            }
            for x in (x0..x1).step_by(LANES) {
                let covered = from_fn(|k| {
                    let at = |e: usize| starts[e] + right[k] * edges[e].right;
                    lesser(at(0), lesser(at(1), at(2))) >= 0.0
                });
                let four = Four {
                    at: row + x as usize,
                    covered,
                    near: right.map(|right| depth.at(right, deep)),
                };
                put(four.within(self.width as i32 - x));
                right = right.map(|right| right + LANES as f64);
            }
        }
        ((x1 - x0) * (y1 - y0)) as usize
    }
}

/// An edge function: not negative inside. At the first corner, and what it grows by with a pixel to the right
/// and down.
#[derive(Clone, Copy)]
struct Edge {
    start: f64,
    right: f64,
    down: f64,
}

impl Edge {
    /// Of the edge from one corner to the next, counter-clockwise as the eye sees them with y down turned up. At
    /// the first corner the triangle reaches so far beyond it.
    #[inline(always)]
    fn new([ax, ay]: [f64; 2], [bx, by]: [f64; 2], start: f64) -> Self {
        let (dx, dy) = (bx - ax, by - ay);
        // Left and upper edges own their pixels.
        let owns = (dy > 0.0) | ((dy == 0.0) & (dx < 0.0));
        Self {
            start: start - if owns { 0.0 } else { 1.0 },
            right: dy * SUB,
            down: -dx * SUB,
        }
    }
}

/// The inverse depth over a triangle. Slivers have steep slopes across, which f32 is too coarse for.
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
        // Twice the area in pixels, negative as y points down.
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
        // No pixel is nearer or farther than the corners.
        lesser(greater(z, self.low), self.high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
        let grid = Grid {
            width: 40,
            height: 30,
        };
        let mut counts = vec![0; grid.width * grid.height];
        for &triangle in triangles {
            grid.triangle(triangle.map(Corner::new), |four| {
                for (k, &covered) in four.covered.iter().enumerate() {
                    if covered {
                        counts[four.at + k] += 1;
                    }
                }
            });
        }
        counts
    }

    /// A fan of triangles around a place covers each pixel of a square once, wherever its corners lie.
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
        let grid = Grid {
            width: 8,
            height: 8,
        };
        let corners = [[0.0, 0.0, 1.0], [0.0, 8.0, 1.0], [8.0, 0.0, 3.0]];
        let mut met = 0;
        grid.triangle(corners.map(Corner::new), |four| {
            for k in (0..LANES).filter(|&k| four.covered[k]) {
                met += 1;
                let x = ((four.at + k) % 8) as f32 + 0.5;
                assert!((four.near[k] - (1.0 + x / 4.0)).abs() < 1e-5);
            }
        });
        assert!(met > 20);
    }
}
