//! Ambient occlusion: the share of the sky that a point sees past its surroundings.
//!
//! For each of eight directions the horizon is the steepest rise to a few points at growing distance. The plane holds
//! the mean of 1 - sin(elevation of the horizon), as is usual for occlusion maps; 255 is the whole sky.

use super::Planes;
use crate::order::greater;

/// Directions in pixels, of length 1 or sqrt 2.
const DIRECTIONS: [(i32, i32); 8] = [
    (1, 0),
    (1, 1),
    (0, 1),
    (-1, 1),
    (-1, 0),
    (-1, -1),
    (0, -1),
    (1, -1),
];
/// Sampling distances, as shares of the reach.
const STEPS: [f64; 6] = [0.0, 0.08, 0.18, 0.34, 0.6, 1.0];
/// Search radius, in cell sizes.
const REACH: f64 = 0.6;

/// The occlusion plane, in progress.
#[derive(Clone, Debug)]
pub struct Occlusion {
    /// Distances along an axis and along a diagonal, in pixels.
    straight: Vec<i32>,
    diagonal: Vec<i32>,
    /// Whether the picture is a torus.
    tile: bool,
    /// Pixels for each picture unit, along a side.
    pixel_scale: usize,
    row: usize,
}

impl Occlusion {
    /// For cells of about `size` picture units, with `pixel_scale` pixels a unit along a side. With `tile`
    /// the picture continues at the opposite edge.
    pub fn new(size: f64, pixel_scale: usize, tile: bool) -> Self {
        let reach = (REACH * size).max(4.0) * pixel_scale as f64;
        let distances = |unit: f64| {
            let mut distances: Vec<i32> = STEPS
                .iter()
                .map(|s| ((s * reach / unit).round() as i32).max(pixel_scale as i32))
                .collect();
            distances.dedup();
            distances
        };
        Self {
            straight: distances(1.0),
            diagonal: distances(std::f64::consts::SQRT_2),
            tile,
            pixel_scale,
            row: 0,
        }
    }

    /// Does the next `rows` rows; true when finished.
    pub fn advance(&mut self, planes: &mut Planes, rows: usize) -> bool {
        let side = planes.side;
        let end = side.min(self.row.saturating_add(rows));
        let mut closed = vec![0.0f32; side];
        let mut steepest = vec![0.0f32; side];
        for y in self.row..end {
            closed.fill(0.0);
            for (k, &direction) in DIRECTIONS.iter().enumerate() {
                steepest.fill(0.0);
                self.horizon(&planes.bump, side, y, k % 2 == 1, direction, &mut steepest);
                for (sum, &s) in closed.iter_mut().zip(&steepest) {
                    *sum += s / (1.0 + s * s).sqrt();
                }
            }
            let row = &mut planes.occlusion[y * side..(y + 1) * side];
            for (open, &sum) in row.iter_mut().zip(&closed) {
                *open = (255.0 * (1.0 - sum / DIRECTIONS.len() as f32) + 0.5) as u8;
            }
        }
        self.row = end;
        end == side
    }

    /// The steepest rises from a row in one direction; compares whole rows at a time, shifted.
    fn horizon(
        &self,
        bump: &[f32],
        side: usize,
        y: usize,
        diagonal: bool,
        (dx, dy): (i32, i32),
        steepest: &mut [f32],
    ) {
        let (distances, unit) = if diagonal {
            (&self.diagonal, std::f32::consts::SQRT_2)
        } else {
            (&self.straight, 1.0)
        };
        let here = &bump[y * side..(y + 1) * side];
        for &d in distances {
            let (shift, row) = (dx * d, y as i32 + dy * d);
            let rim = side as i32;
            let off = row < 0 || row >= rim || shift.abs() >= rim;
            if off && !self.tile {
                break;
            }
            let per = self.pixel_scale as f32 / (d as f32 * unit);
            let there = &bump[row.rem_euclid(rim) as usize * side..][..side];
            let shift = if self.tile { shift % rim } else { shift };
            let mut compare = |first: usize, at: usize, span: usize| {
                let slopes = steepest[first..first + span].iter_mut();
                let pairs = here[first..first + span].iter().zip(&there[at..at + span]);
                for (slope, (&h, &t)) in slopes.zip(pairs) {
                    *slope = greater(*slope, (t - h) * per);
                }
            };
            let beyond = shift.unsigned_abs() as usize;
            let span = side - beyond;
            let (first, at) = if shift < 0 { (beyond, 0) } else { (0, beyond) };
            compare(first, at, span);
            if self.tile {
                // The rest of the row continues at the opposite edge.
                let (first, at) = if shift < 0 { (0, span) } else { (span, 0) };
                compare(first, at, beyond);
            }
        }
    }
}
