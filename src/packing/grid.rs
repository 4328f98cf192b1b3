//! A spatial hash of points: finds neighbours in constant time.

use super::chains::Chains;
use crate::planar::Space;
use glam::DVec2;
use std::ops::Range;

/// A uniform grid of linked lists over a box; points outside go to the nearest bucket.
#[derive(Clone, Debug)]
pub struct Grid {
    origin: DVec2,
    step: f64,
    columns: usize,
    rows: usize,
    points: Chains,
}

/// Most buckets along a side, so that tiny cells in a large picture do not cost much memory.
const MOST: f64 = 1024.0;

impl Grid {
    /// An empty grid over the box `lo`..`hi` with buckets of at least `step`.
    pub fn new(lo: DVec2, hi: DVec2, step: f64) -> Self {
        let step = step.max((hi - lo).max_element() / MOST);
        let columns = ((hi.x - lo.x) / step) as usize + 1;
        let rows = ((hi.y - lo.y) / step) as usize + 1;
        Self {
            origin: lo,
            step,
            columns,
            rows,
            points: Chains::new(columns * rows),
        }
    }

    fn place(&self, p: DVec2) -> (usize, usize) {
        let at = (p - self.origin) / self.step;
        // `as` saturates, so points outside go to the outermost buckets.
        (
            (at.x as usize).min(self.columns - 1),
            (at.y as usize).min(self.rows - 1),
        )
    }

    /// The number of a point's bucket, row by row.
    pub fn bucket(&self, p: DVec2) -> usize {
        let (x, y) = self.place(p);
        y * self.columns + x
    }

    /// The number of buckets.
    pub fn buckets(&self) -> usize {
        self.points.buckets()
    }

    /// The buckets whose points may lie within `radius` of `p`, as ranges in rising order.
    pub fn runs_near(&self, p: DVec2, radius: f64) -> impl Iterator<Item = Range<usize>> {
        let (x0, y0) = self.place(p - DVec2::splat(radius));
        let (x1, y1) = self.place(p + DVec2::splat(radius));
        let columns = self.columns;
        (y0..=y1).map(move |y| y * columns + x0..y * columns + x1 + 1)
    }

    /// Adds the next point; points are numbered from 0 in order of insertion.
    pub fn push(&mut self, p: DVec2) {
        self.points.push(self.bucket(p));
    }

    /// Calls `visit` with the number of every point that may lie within `radius` of an image of `p`, until one call
    /// returns true. Returns whether one did.
    pub fn any_near(
        &self,
        space: Space,
        p: DVec2,
        radius: f64,
        mut visit: impl FnMut(usize) -> bool,
    ) -> bool {
        space.images(p, radius).any(|image| {
            let mut runs = self.runs_near(image, radius);
            runs.any(|run| self.points.any(run, &mut visit))
        })
    }

    /// Calls `visit` with the number of every point that may lie within `radius` of `p`.
    pub fn near(&self, p: DVec2, radius: f64, mut visit: impl FnMut(usize)) {
        self.any_near(Space::PLANE, p, radius, |k| {
            visit(k);
            false
        });
    }
}
