//! Finds the segments near a place with a uniform grid.

use crate::csr::Csr;
use crate::planar::closest_on_segment;
use glam::DVec2;

/// Squares over a box, each with the segments within a given reach of any of its points.
#[derive(Clone, Debug, Default)]
pub(super) struct SegmentGrid {
    origin: DVec2,
    step: f64,
    columns: usize,
    rows: usize,
    /// The segments of each square.
    lists: Csr<u32>,
}

impl SegmentGrid {
    /// Covers a box widened by `margin` with squares of the side `step`.
    pub fn new(
        (lo, hi): (DVec2, DVec2),
        margin: f64,
        step: f64,
        segments: &[[DVec2; 2]],
        reach: f64,
    ) -> Self {
        let origin = lo - DVec2::splat(margin);
        let span = (hi - origin + DVec2::splat(margin)) / step;
        let mut grid = Self {
            origin,
            step,
            columns: span.x as usize + 1,
            rows: span.y as usize + 1,
            ..Self::default()
        };
        grid.fill(segments, reach);
        grid
    }

    fn fill(&mut self, segments: &[[DVec2; 2]], reach: f64) {
        let near = reach + 0.708 * self.step;
        let mut entries = Vec::new();
        for (index, &[a, b]) in segments.iter().enumerate() {
            let lo = ((a.min(b) - self.origin - DVec2::splat(near)) / self.step).max(DVec2::ZERO);
            let hi = (a.max(b) - self.origin + DVec2::splat(near)) / self.step;
            for row in lo.y as usize..(hi.y as usize + 1).min(self.rows) {
                for column in lo.x as usize..(hi.x as usize + 1).min(self.columns) {
                    let at = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                    let middle = self.origin + self.step * at;
                    if closest_on_segment(middle, a, b).distance(middle) <= near {
                        entries.push((row * self.columns + column, index as u32));
                    }
                }
            }
        }
        // The segments come in rising order, so every square lists them in that order.
        self.lists = Csr::from_pairs(self.columns * self.rows, entries.into_iter());
    }

    /// The segments within the reach of a point, and a few more; none outside the grid.
    pub fn at(&self, p: DVec2) -> &[u32] {
        let at = (p - self.origin) / self.step;
        if !(at.x >= 0.0 && at.y >= 0.0 && at.x < self.columns as f64 && at.y < self.rows as f64) {
            return &[];
        }
        self.lists.row(at.y as usize * self.columns + at.x as usize)
    }

    /// Whether a test holds for any segment near the box around two points. It may be called more than once
    /// for a segment.
    pub fn any(&self, a: DVec2, b: DVec2, test: impl Fn(usize) -> bool) -> bool {
        // Casts of negative numbers give 0: places outside the grid use the outermost squares.
        let (lo, hi) = (
            (a.min(b) - self.origin) / self.step,
            (a.max(b) - self.origin) / self.step,
        );
        let (last_row, last_column) = (self.rows - 1, self.columns - 1);
        (lo.y as usize..=(hi.y as usize).min(last_row)).any(|row| {
            (lo.x as usize..=(hi.x as usize).min(last_column)).any(|column| {
                let near = self.lists.row(row * self.columns + column);
                near.iter().any(|&index| test(index as usize))
            })
        })
    }
}
