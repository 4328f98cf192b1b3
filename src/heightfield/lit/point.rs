//! The shadows of a point light.
//!
//! The diagonals through the foot of the lamp divide the picture into four quarters, each scanned outwards in
//! lines: rows above and below, columns to the sides. The steepest slope of the surface so far, seen from the
//! lamp's rims, passes from line to line. The ray from the lamp to a pixel `away` pixels along line k crosses
//! line k - 1 nearer to the axis, between two of its pixels:
//!
//! ```text
//!   line k - 1   . inner . outer        inner has the weight away / k
//!   line k       .       . pixel        (away = 0 is the axis, away = k the diagonal)
//! ```

use super::penumbra::{NOWHERE, visible};
use super::scan_order::ScanOrder;
use crate::order::greater;
use std::ops::Range;

/// Half the vertical extent of the lamp, relative to its height.
const HALF_LAMP: f32 = 0.10;

/// The steepest slopes along the lines of one quarter.
pub struct PointShadows {
    side: usize,
    /// Column and row of the lamp's foot, in the picture or not.
    foot: [i32; 2],
    /// The foot's coordinates along the lines of this quarter and across them.
    axis: i32,
    start: i32,
    /// Heights of the lamp's upper and lower rim.
    upper: f32,
    lower: f32,
    /// Slopes from the two rims along the previous line, with one more pixel on both sides.
    before: [Vec<f32>; 2],
    now: [Vec<f32>; 2],
}

impl PointShadows {
    /// Shadows of a lamp at a place in fractions of the picture's side, in a picture with `side` pixels and
    /// `pixel_scale` for each picture unit; also the four quarters.
    pub fn new(x: f64, y: f64, z: f64, [side, pixel_scale]: [usize; 2]) -> (Self, [ScanOrder; 4]) {
        let span = side as i32;
        let place = |v: f64| ((v * side as f64).floor() as i32).clamp(-8 * span, 8 * span);
        let foot = [place(x), place(y)];
        let height = (z * (side / pixel_scale) as f64).max(1.0) as f32;
        let line = || vec![NOWHERE; side + 2];
        let shadows = Self {
            side,
            foot,
            axis: 0,
            start: 0,
            upper: height * (1.0 + HALF_LAMP),
            lower: height * (1.0 - HALF_LAMP),
            before: [line(), line()],
            now: [line(), line()],
        };
        let inside = |v: i32| v.clamp(0, span) as usize;
        let quarters = |columns: bool| {
            let foot = foot[usize::from(!columns)];
            [
                ScanOrder::new(columns, true, 0..inside(foot)),
                ScanOrder::new(columns, false, inside(foot + 1)..side),
            ]
        };
        let ([up, down], [left, right]) = (quarters(false), quarters(true));
        (shadows, [up, down, left, right])
    }

    /// Sets the lamp on ground of this height.
    pub fn raise(&mut self, ground: f32) {
        self.upper += ground;
        self.lower += ground;
    }

    /// Starts a quarter, with the surface at the lamp's foot.
    pub fn begin(&mut self, order: &ScanOrder, bump: &[f32]) {
        let [x, y] = self.foot;
        (self.axis, self.start) = if order.columns { (y, x) } else { (x, y) };
        for line in self.before.iter_mut().chain(&mut self.now) {
            line.fill(NOWHERE);
        }
        let span = 0..self.side as i32;
        if span.contains(&x) && span.contains(&y) {
            let height = bump[y as usize * self.side + x as usize];
            let at = self.axis as usize;
            for (line, rim) in self.before.iter_mut().zip([self.upper, self.lower]) {
                // The ray to the foot is vertical; a small distance replaces zero. The pixels beside the foot get the
                // same slope, as at the ends of a line (see `line`).
                line[at..at + 3].fill((height - rim) / 0.5);
            }
        }
    }

    /// Does the next line, line `index` of the picture: takes its heights, and writes the visible share of
    /// the lamp.
    pub fn line(&mut self, index: usize, heights: &[f32], lit: &mut [u8]) {
        let k = (index as i32 - self.start).abs();
        let side = self.side as i32;
        let inside = |v: i32| v.clamp(0, side) as usize;
        let (first, axis, end) = (
            inside(self.axis - k),
            inside(self.axis),
            inside(self.axis + k + 1),
        );
        if first == end {
            return;
        }
        self.half(k, first..axis, 2, heights, lit);
        self.half(k, axis..end, 0, heights, lit);
        std::mem::swap(&mut self.before, &mut self.now);
        // The next line reads one pixel beyond each end, with no weight, as on the diagonal only the inner pixel
        // counts. Any number near the last one will do.
        for line in &mut self.before {
            line[first] = line[first + 1];
            line[end + 1] = line[end];
        }
    }

    /// Does the pixels of line `k` on one side of the axis; `inner` is 0 if the axis is to the left and 2 if
    /// it is to the right.
    fn half(
        &mut self,
        k: i32,
        pixels: Range<usize>,
        inner: usize,
        heights: &[f32],
        lit: &mut [u8],
    ) {
        let n = pixels.len();
        let (first, axis) = (pixels.start as i32, self.axis);
        let along = k as f32;
        let share = 1.0 / along;
        let [dark, light] = &self.before;
        let dark = [
            &dark[pixels.start + 1..][..n],
            &dark[pixels.start + inner..][..n],
        ];
        let light = [
            &light[pixels.start + 1..][..n],
            &light[pixels.start + inner..][..n],
        ];
        let [now_dark, now_light] = &mut self.now;
        let now_dark = &mut now_dark[pixels.start + 1..][..n];
        let now_light = &mut now_light[pixels.start + 1..][..n];
        let heights = &heights[pixels.clone()];
        let lit = &mut lit[pixels];
        for i in 0..n {
            let away = (first + i as i32 - axis).abs() as f32;
            let distance = (away * away + along * along).sqrt();
            let inverse = 1.0 / distance;
            let weight = away * share;
            let rise = |[outer, inner]: [&[f32]; 2]| outer[i] + (inner[i] - outer[i]) * weight;
            let (low, high) = (rise(dark), rise(light));
            let [a, b] = [self.upper + low * distance, self.lower + high * distance];
            // The shadow lines of the two rims cross only if the surface is above the lamp.
            lit[i] = visible(heights[i], if b < a { b } else { a }, greater(a, b));
            now_dark[i] = greater(low, (heights[i] - self.upper) * inverse);
            now_light[i] = greater(high, (heights[i] - self.lower) * inverse);
        }
    }
}
