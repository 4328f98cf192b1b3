//! The background grid that fields are sampled on.

use crate::planar::Space;
use glam::DVec2;
use std::ops::{Add, Mul};

/// Nodes of the first pass are this many steps apart; the numbers of grid squares along both sides are multiples of it.
pub(super) const COARSE: usize = 4;

/// Evenly spaced nodes, row by row from the top.
#[derive(Clone, Copy, Debug)]
pub(super) struct SampleGrid {
    pub origin: DVec2,
    pub step: f64,
    pub columns: usize,
    pub rows: usize,
    space: Space,
}

impl SampleGrid {
    /// A grid over a box with about this step. In the plane it extends at least two squares beyond the box. On a torus
    /// a whole number of squares goes round, and the last column and row repeat the first.
    pub fn new(space: Space, (lo, hi): (DVec2, DVec2), step: f64) -> Self {
        if let Some(side) = space.period() {
            let squares = ((side / step) as usize).max(1).next_multiple_of(COARSE);
            return Self {
                origin: DVec2::ZERO,
                step: side / squares as f64,
                columns: squares + 1,
                rows: squares + 1,
                space,
            };
        }
        let squares = |span: f64| (span / step).ceil() as usize + 4;
        let count = |span: f64| squares(span).next_multiple_of(COARSE) + 1;
        Self {
            origin: lo - DVec2::splat(2.0 * step),
            step,
            columns: count(hi.x - lo.x),
            rows: count(hi.y - lo.y),
            space,
        }
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.columns * self.rows
    }

    /// The place of a node.
    pub fn node(&self, column: usize, row: usize) -> DVec2 {
        self.origin + self.step * DVec2::new(column as f64, row as f64)
    }

    /// On a torus, copies the first column and row to the last; does nothing in the plane.
    pub fn close<T: Copy>(&self, values: &mut [T]) {
        if self.space != Space::PLANE && !values.is_empty() {
            for row in 0..self.rows {
                values[(row + 1) * self.columns - 1] = values[row * self.columns];
            }
            let (first, last) = values.split_at_mut((self.rows - 1) * self.columns);
            last.copy_from_slice(&first[..self.columns]);
        }
    }

    /// Bilinear interpolation of node values at a point; outside the grid, the value at its edge.
    pub fn interpolated<T>(&self, values: &[T], p: DVec2) -> T
    where
        T: Copy + Add<Output = T> + Mul<f64, Output = T>,
    {
        let at = (self.space.wrap(p) - self.origin) / self.step;
        let last = DVec2::new((self.columns - 2) as f64, (self.rows - 2) as f64);
        let base = at.floor().clamp(DVec2::ZERO, last);
        let t = (at - base).clamp(DVec2::ZERO, DVec2::ONE);
        let first = base.y as usize * self.columns + base.x as usize;
        let (n, below) = (&values[first..], &values[first + self.columns..]);
        let top = n[0] * (1.0 - t.x) + n[1] * t.x;
        let bottom = below[0] * (1.0 - t.x) + below[1] * t.x;
        top * (1.0 - t.y) + bottom * t.y
    }
}
