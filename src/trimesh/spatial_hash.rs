//! A spatial hash: boxes of points in space, to find neighbours in constant time.

use super::SurfacePoint;
use crate::packing::chains::Chains;
use crate::packing::packing_domain::SpatialHash;
use glam::DVec3;
use std::ops::Range;

/// The most boxes: more would cost more than they save.
const MOST: f64 = 1_048_576.0;

/// A uniform grid of linked lists; points outside go to the nearest box.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceHash {
    origin: DVec3,
    step: f64,
    counts: [usize; 3],
    points: Chains,
}

impl SurfaceHash {
    /// Empty boxes over `lo`..`hi`, with sides of at least `step`.
    pub fn new((lo, hi): (DVec3, DVec3), mut step: f64) -> Self {
        let span = hi - lo;
        step = step.max(span.max_element() / 1e5).max(f64::MIN_POSITIVE);
        let along = |side: f64, step: f64| (side / step).floor() + 1.0;
        while along(span.x, step) * along(span.y, step) * along(span.z, step) > MOST {
            step *= 1.1;
        }
        let counts = [span.x, span.y, span.z].map(|side| along(side, step) as usize);
        Self {
            origin: lo,
            step,
            counts,
            points: Chains::new(counts[0] * counts[1] * counts[2]),
        }
    }

    /// Empty boxes over these points, with sides of at least `step`.
    pub fn around(mut points: impl Iterator<Item = DVec3>, step: f64) -> Self {
        let first = points.next().unwrap_or_default();
        let bounds = points.fold((first, first), |(lo, hi), p| (lo.min(p), hi.max(p)));
        Self::new(bounds, step)
    }

    fn place(&self, p: DVec3) -> [usize; 3] {
        let at = ((p - self.origin) / self.step).to_array();
        // `as` saturates, so points outside go to the boxes at the edge.
        std::array::from_fn(|k| (at[k] as usize).min(self.counts[k] - 1))
    }

    fn number(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    /// Adds the next point; points are numbered from 0 in the order of adding.
    pub fn push_at(&mut self, p: DVec3) {
        let own = self.number(self.place(p));
        self.points.push(own);
    }

    /// Runs of boxes along x that may hold points within `radius` of `p`.
    fn runs(&self, p: DVec3, radius: f64) -> impl Iterator<Item = Range<usize>> + '_ {
        let lo = self.place(p - DVec3::splat(radius));
        let hi = self.place(p + DVec3::splat(radius));
        (lo[2]..=hi[2]).flat_map(move |z| {
            (lo[1]..=hi[1]).map(move |y| {
                let first = self.number([lo[0], y, z]);
                first..first + hi[0] - lo[0] + 1
            })
        })
    }

    /// Calls `visit` with the number of every point that may lie within `radius` of `p`, until it returns true; returns
    /// whether `visit` has returned true.
    pub fn any_near(&self, p: DVec3, radius: f64, mut visit: impl FnMut(usize) -> bool) -> bool {
        let mut runs = self.runs(p, radius);
        runs.any(|run| self.points.any(run, &mut visit))
    }
}

impl SpatialHash<SurfacePoint> for SurfaceHash {
    fn bucket(&self, p: SurfacePoint) -> usize {
        self.number(self.place(p.at))
    }

    fn buckets(&self) -> usize {
        self.points.buckets()
    }

    fn runs_near(&self, p: SurfacePoint, radius: f64) -> impl Iterator<Item = Range<usize>> {
        self.runs(p.at, radius)
    }

    fn push(&mut self, p: SurfacePoint) {
        self.push_at(p.at);
    }
}
