//! Triangles to pixels, without gaps or overlaps.
//!
//! Corners are rounded to a fixed grid of 1/256 of a pixel, and all that decides which pixels a triangle has is
//! worked out in whole numbers: a pixel is covered where its middle is inside, and one whose middle lies on an
//! edge belongs to exactly one of the triangles beside it (the rule of left and upper edges). Depth is the
//! inverse of the distance into the frame, which changes evenly on the screen.

use crate::order::{greater, lesser};

/// Places of the grid for a pixel, along a side, as a power of two.
const SUB_BITS: u32 = 8;
const SUB: f32 = (1 << SUB_BITS) as f32;
const HALF: i64 = 1 << (SUB_BITS - 1);

/// A corner on the screen: x to the right, y down, in pixels; the inverse of its depth.
pub(super) type Corner = [f32; 3];

/// Where triangles are drawn.
pub(super) struct Grid {
    pub width: usize,
    pub height: usize,
}

/// An edge function: not negative inside.
#[derive(Clone, Copy)]
struct Edge {
    /// At the first pixel.
    start: i64,
    right: i64,
    down: i64,
}

impl Edge {
    /// Of the edge from one corner to the next, counter-clockwise as the eye sees them with y down turned up.
    #[inline(always)]
    fn new([ax, ay]: [i64; 2], [bx, by]: [i64; 2], first: [i64; 2]) -> Self {
        let (dx, dy) = (bx - ax, by - ay);
        // y points down: the inside is where this is positive for corners that turn counter-clockwise.
        let at = (first[1] - ay) * dx - (first[0] - ax) * dy;
        // Left and upper edges own their pixels.
        let owns = dy > 0 || (dy == 0 && dx < 0);
        Self {
            start: -at - i64::from(!owns),
            right: dy << SUB_BITS,
            down: -(dx << SUB_BITS),
        }
    }
}

impl Grid {
    /// Draws a triangle: calls `put` with each pixel's place in the grid and the inverse depth there. Triangles
    /// whose corners do not turn counter-clockwise on the screen (seen with y up) are not drawn. Answers with the
    /// number of pixels that were looked at.
    #[inline(always)]
    pub fn triangle(&self, corners: [Corner; 3], mut put: impl FnMut(usize, f32)) -> usize {
        let fixed = corners.map(|[x, y, _]| [x, y].map(|v| (v * SUB).round_ties_even() as i64));
        let [a, b, c] = fixed;
        let area = (c[0] - a[0]) * (b[1] - a[1]) - (b[0] - a[0]) * (c[1] - a[1]);
        if area <= 0 {
            return 0;
        }
        let span = |axis: usize, size: usize| {
            let low = a[axis].min(b[axis]).min(c[axis]);
            let high = a[axis].max(b[axis]).max(c[axis]);
            // The first pixel whose middle is not before, the one after the last that is not beyond.
            let first = (low - HALF + (1 << SUB_BITS) - 1) >> SUB_BITS;
            let end = ((high - HALF) >> SUB_BITS) + 1;
            (first.max(0), end.min(size as i64))
        };
        let ((x0, x1), (y0, y1)) = (span(0, self.width), span(1, self.height));
        if x0 >= x1 || y0 >= y1 {
            return 0;
        }
        let first = [(x0 << SUB_BITS) + HALF, (y0 << SUB_BITS) + HALF];
        let edges = [
            Edge::new(b, c, first),
            Edge::new(c, a, first),
            Edge::new(a, b, first),
        ];
        let depth = Depth::new(corners, fixed, area);
        let mut rows = edges.map(|edge| edge.start);
        for y in y0..y1 {
            let mut at = rows;
            let row = y as usize * self.width;
            let down = y as f32 + 0.5;
            let mut inside = false;
            for x in x0..x1 {
                if at[0] | at[1] | at[2] >= 0 {
                    inside = true;
                    put(row + x as usize, depth.at(x as f32 + 0.5, down));
                } else if inside {
                    break;
                }
                for k in 0..3 {
                    at[k] += edges[k].right;
                }
            }
            for k in 0..3 {
                rows[k] += edges[k].down;
            }
        }
        ((x1 - x0) * (y1 - y0)) as usize
    }
}

/// The inverse depth over a triangle. Slivers have steep slopes across, which f32 is too coarse for.
struct Depth {
    origin: [f64; 3],
    right: f64,
    down: f64,
    low: f32,
    high: f32,
}

impl Depth {
    #[inline(always)]
    fn new(corners: [Corner; 3], fixed: [[i64; 2]; 3], area: i64) -> Self {
        let [a, b, c] = fixed;
        let part = |v: i64| v as f64 / f64::from(SUB);
        let [bx, by] = [part(b[0] - a[0]), part(b[1] - a[1])];
        let [cx, cy] = [part(c[0] - a[0]), part(c[1] - a[1])];
        let [za, zb, zc] = corners.map(|corner| f64::from(corner[2]));
        let (zb, zc) = (zb - za, zc - za);
        // Twice the area in pixels, negative as y points down.
        let inverse = -f64::from(SUB * SUB) / area as f64;
        Self {
            right: (zb * cy - zc * by) * inverse,
            down: (zc * bx - zb * cx) * inverse,
            low: lesser(corners[0][2], lesser(corners[1][2], corners[2][2])),
            high: greater(corners[0][2], greater(corners[1][2], corners[2][2])),
            origin: [part(a[0]), part(a[1]), za],
        }
    }

    #[inline(always)]
    fn at(&self, x: f32, y: f32) -> f32 {
        let [ox, oy, oz] = self.origin;
        let (x, y) = (f64::from(x) - ox, f64::from(y) - oy);
        let z = (oz + x * self.right + y * self.down) as f32;
        // No pixel is nearer or farther than the corners.
        lesser(greater(z, self.low), self.high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(triangles: &[[Corner; 3]]) -> Vec<u8> {
        let grid = Grid {
            width: 40,
            height: 30,
        };
        let mut counts = vec![0; grid.width * grid.height];
        for &triangle in triangles {
            grid.triangle(triangle, |at, _| counts[at] += 1);
        }
        counts
    }

    /// A fan of triangles around a place covers each pixel of a square once, wherever its corners lie.
    #[test]
    fn neighbours_share_no_pixel_and_leave_none() {
        let ring: Vec<Corner> = [
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
            let fan: Vec<[Corner; 3]> = (0..ring.len())
                .map(|k| [ring[k], ring[(k + 1) % ring.len()], [x, y, 1.0]])
                .collect();
            assert!(counts(&fan).iter().all(|&n| n == 1), "{middle:?}");
            let turned: Vec<[Corner; 3]> = fan.iter().map(|&[a, b, c]| [b, a, c]).collect();
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
        grid.triangle(corners, |at, inverse| {
            met += 1;
            let x = (at % 8) as f32 + 0.5;
            assert!((inverse - (1.0 + x / 4.0)).abs() < 1e-5);
        });
        assert!(met > 20);
    }
}
