//! The height field as a closed slab in an STL file, for 3D printing: millimetres, right-handed with z up. Seen from
//! above it looks like the picture.
//!
//! The file is binary (3D Systems, 1989): 80 bytes of title, the count of triangles, and for each its normal and
//! corners as floats and two zero bytes. The top is a grid of squares with two triangles each. Below each of its
//! outer sides the walls have one such square. The base is a fan.
//!
//! Only native programs use it. The page has its own writer in `www/take/files/slab.ts`, which keeps the module small.

use super::bytes::{put, put_floats};
use crate::heightfield::{Planes, means};
use glam::Vec3;

/// The measures of a slab, in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab {
    /// The length of a side.
    pub side: f32,
    /// The thickness under the lowest point.
    pub base: f32,
    /// The height from the lowest to the highest point.
    pub relief: f32,
    /// Squares along a side of the grid.
    pub squares: usize,
}

/// The least and the greatest value of each measure, in millimetres; the greatest is beyond any printer.
const MEASURES: [f32; 2] = [0.1, 10_000.0];
/// The least and the greatest number of squares along a side.
const SQUARES: [usize; 2] = [8, 1024];
/// Bytes of a triangle, and of the head.
const TRIANGLE: usize = 50;
const HEAD: usize = 84;
const TITLE: &[u8; HEAD - 4] =
    b"Made by Bubblestone. Millimetres.                                               ";

impl Slab {
    /// The same slab with all measures clamped to their limits.
    pub fn checked(self) -> Self {
        let [least, most] = MEASURES;
        // Not `clamp`, which would keep NaN.
        let within = |v: f32| v.max(least).min(most);
        Self {
            side: within(self.side),
            base: within(self.base),
            relief: within(self.relief),
            squares: self.squares.clamp(SQUARES[0], SQUARES[1]),
        }
    }

    /// The number of triangles: top, walls, base.
    pub fn triangles(&self) -> usize {
        let n = self.squares;
        2 * n * n + 4 * 2 * n + 4 * n
    }

    /// The bytes of the file.
    pub fn bytes(&self) -> usize {
        HEAD + TRIANGLE * self.triangles()
    }
}

/// An STL file that is being made.
pub struct SlabFile {
    slab: Slab,
    /// The lowest height of the picture, and millimetres for each unit above it.
    low: f32,
    rise: f32,
    /// The next row of squares, and the heights at its upper grid points.
    row: usize,
    above: Vec<f32>,
}

impl SlabFile {
    /// A file of the slab of these planes.
    pub fn new(slab: Slab, planes: &Planes) -> Self {
        let slab = slab.checked();
        let (low, high) = planes.height_range();
        let rise = if high > low {
            slab.relief / (high - low)
        } else {
            0.0
        };
        Self {
            slab,
            low,
            rise,
            row: 0,
            above: Vec::new(),
        }
    }

    /// The file's next part; `None` at its end.
    pub fn next(&mut self, planes: &Planes) -> Option<Vec<u8>> {
        let n = self.slab.squares;
        if self.row >= n {
            return None;
        }
        let mut out = Vec::new();
        if self.row == 0 {
            out.extend_from_slice(TITLE);
            put(&mut out, &[self.slab.triangles() as u32]);
            self.above = means(planes, n, 0);
            self.wall(&mut out, &|k| [k, 0]);
        }
        let below = means(planes, n, self.row + 1);
        let above = std::mem::replace(&mut self.above, below);
        self.squares(&mut out, &above);
        self.row += 1;
        if self.row == n {
            self.wall(&mut out, &|k| [n - k, n]);
        }
        Some(out)
    }

    /// A corner at a grid point, with y up the picture.
    fn corner(&self, [i, j]: [usize; 2], z: f32) -> Vec3 {
        let step = self.slab.side / self.slab.squares as f32;
        Vec3::new(i as f32 * step, (self.slab.squares - j) as f32 * step, z)
    }

    fn top(&self, i: usize, j: usize, height: f32) -> Vec3 {
        self.corner([i, j], self.slab.base + (height - self.low) * self.rise)
    }

    /// The squares of the row, and the walls at its ends.
    fn squares(&self, out: &mut Vec<u8>, above: &[f32]) {
        let (n, j, below) = (self.slab.squares, self.row, &self.above);
        let pair = |i: usize| [self.top(i, j, above[i]), self.top(i, j + 1, below[i])];
        for i in 0..n {
            let ([a, c], [b, d]) = (pair(i), pair(i + 1));
            put_triangle(out, [a, d, b]);
            put_triangle(out, [a, c, d]);
        }
        let [a, c] = pair(0);
        self.side(out, [c, a], [[0, j + 1], [0, j]]);
        let [b, d] = pair(n);
        self.side(out, [b, d], [[n, j], [n, j + 1]]);
    }

    /// A wall under the current row of grid points. `place` maps 0..=n to grid points, clockwise seen from above.
    fn wall(&self, out: &mut Vec<u8>, place: &dyn Fn(usize) -> [usize; 2]) {
        for k in 0..self.slab.squares {
            let places = [place(k), place(k + 1)];
            let tops = places.map(|[i, j]| self.top(i, j, self.above[i]));
            self.side(out, tops, places);
        }
    }

    /// A square of a wall and its part of the base, below two grid points in clockwise order seen from above.
    fn side(&self, out: &mut Vec<u8>, [a, b]: [Vec3; 2], places: [[usize; 2]; 2]) {
        let [c, d] = places.map(|place| self.corner(place, 0.0));
        let half = 0.5 * self.slab.side;
        put_triangle(out, [a, b, d]);
        put_triangle(out, [a, d, c]);
        put_triangle(out, [c, d, Vec3::new(half, half, 0.0)]);
    }
}

/// Adds a triangle, counter-clockwise seen from outside.
fn put_triangle(out: &mut Vec<u8>, [a, b, c]: [Vec3; 3]) {
    let normal = (b - a).cross(c - a).try_normalize().unwrap_or_default();
    for v in [normal, a, b, c] {
        put_floats(out, &v.to_array());
    }
    out.extend_from_slice(&[0; 2]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn a_slab_is_closed_and_as_large_as_asked_for() {
        let mut planes = Planes::new(20);
        for at in 0..400 {
            planes.bump[at] = if at % 20 < 10 { 1.0 } else { 5.0 };
        }
        let slab = Slab {
            side: 60.0,
            base: 3.0,
            relief: 4.0,
            squares: 10,
        };
        let mut file = SlabFile::new(slab, &planes);
        let bytes: Vec<u8> = std::iter::from_fn(|| file.next(&planes))
            .flatten()
            .collect();
        assert_eq!(bytes.len(), slab.bytes());
        let mut sides = HashSet::new();
        let mut six = 0.0;
        for triangle in bytes[HEAD..].chunks(TRIANGLE) {
            let floats = triangle[..48].chunks(4).map(|b| b.try_into().unwrap());
            let floats: Vec<f32> = floats.map(f32::from_le_bytes).collect();
            let [n, a, b, c] = [0, 3, 6, 9].map(|k| Vec3::from_slice(&floats[k..]));
            assert!((n.length() - 1.0).abs() < 1e-5);
            six += a.dot(b.cross(c));
            for side in [[a, b], [b, c], [c, a]] {
                assert!(sides.insert(side.map(|p| p.to_array().map(f32::to_bits))));
            }
        }
        assert!(sides.iter().all(|&[a, b]| sides.contains(&[b, a])));
        // Half of it is 3 millimetres high and half 7, but for the slope between them.
        let mean = six / 6.0 / 3600.0;
        assert!((4.7..5.3).contains(&mean), "{mean}");
    }

    #[test]
    fn measures_are_kept_within_limits() {
        let wild = Slab {
            side: f32::NAN,
            base: -1.0,
            relief: f32::INFINITY,
            squares: 1 << 20,
        };
        let Slab {
            side,
            base,
            relief,
            squares,
        } = wild.checked();
        assert_eq!((side, base, relief, squares), (0.1, 0.1, 10_000.0, 1024));
    }
}
