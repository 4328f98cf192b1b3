//! Means of the heights around each pixel: a box filter by running sums.

use super::Planes;

/// The mean height of the square around each pixel: sums of rows first, then running sums of these.
pub(super) struct BoxFilter {
    radius: usize,
    /// Sums along rows.
    along: Vec<f32>,
    filled: usize,
    /// Sums of `along` over the rows around the one at hand.
    sums: Vec<f64>,
}

impl BoxFilter {
    pub fn new(radius: usize, side: usize) -> Self {
        Self {
            radius: radius.clamp(1, side / 2),
            along: Vec::new(),
            filled: 0,
            sums: Vec::new(),
        }
    }

    /// Some more sums along rows; false when all are there.
    pub fn fill(&mut self, planes: &Planes, rows: usize) -> bool {
        let (side, tile) = (planes.side, planes.tile);
        let end = side.min(self.filled.saturating_add(rows));
        for y in self.filled..end {
            let row = &planes.bump[y * side..][..side];
            let of = |x: i64| f64::from(row[place(x, side, tile)]);
            let reach = self.radius as i64;
            let mut sum: f64 = (-reach..=reach).map(of).sum();
            for x in 0..side as i64 {
                self.along.push(sum as f32);
                sum += of(x + reach + 1) - of(x - reach);
            }
        }
        let more = self.filled < end;
        self.filled = end;
        more
    }

    /// The means of a row; rows must be asked for in turn.
    pub fn row(&mut self, y: usize, tile: bool, out: &mut [f32]) {
        let side = out.len();
        let (y, reach) = (y as i64, self.radius as i64);
        let along = &self.along;
        let of = |y: i64| &along[place(y, side, tile) * side..][..side];
        if y == 0 {
            self.sums = vec![0.0; side];
            for row in (-reach..=reach).map(of) {
                add(&mut self.sums, row, 1.0);
            }
        } else {
            add(&mut self.sums, of(y + reach), 1.0);
            add(&mut self.sums, of(y - reach - 1), -1.0);
        }
        let width = (2 * self.radius + 1) as f64;
        for (out, sum) in out.iter_mut().zip(&self.sums) {
            *out = (sum / (width * width)) as f32;
        }
    }
}

fn add(sums: &mut [f64], row: &[f32], factor: f64) {
    for (sum, &v) in sums.iter_mut().zip(row) {
        *sum += factor * f64::from(v);
    }
}

/// The pixel at a place beyond an edge: the last one there, or on a tile that at the other edge.
fn place(at: i64, side: usize, tile: bool) -> usize {
    let side = side as i64;
    let at = if tile {
        at.rem_euclid(side)
    } else {
        at.clamp(0, side - 1)
    };
    at as usize
}
