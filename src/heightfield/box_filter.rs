//! Means of the heights around each pixel: a box filter by running sums.
//!
//! Sums along rows are kept only for the rows around the current one. Heights of earlier rows may therefore change, row
//! by row, while the filter goes on.

use super::Planes;

/// The mean height of the square around each pixel: sums along rows first, then running sums of these.
pub(super) struct BoxFilter {
    radius: usize,
    side: usize,
    /// Sums along rows, in a ring buffer: row `y` is at `y` modulo its length. Row numbers continue beyond
    /// the edges.
    along: Vec<f32>,
    /// On a tile, the sums along its first rows, which follow its last ones.
    first: Vec<f32>,
    /// The number of rows entered, starting `radius` rows above the picture.
    entered: usize,
    /// Sums of `along` over the rows around the current one.
    sums: Vec<f64>,
}

impl BoxFilter {
    pub fn new(radius: usize, side: usize) -> Self {
        Self {
            radius: radius.clamp(1, side / 2),
            side,
            along: Vec::new(),
            first: Vec::new(),
            entered: 0,
            sums: Vec::new(),
        }
    }

    /// Sums some of the rows that precede the first means; false when all are done.
    pub fn prepare(&mut self, planes: &Planes, rows: usize) -> bool {
        let around = 2 * self.radius + 1;
        let end = around.min(self.entered.saturating_add(rows));
        if self.entered >= around {
            return false;
        }
        // One more row than the sums cover: the row that is subtracted next.
        self.along.resize((around + 1) * self.side, 0.0);
        while self.entered < end {
            self.enter(planes);
        }
        true
    }

    /// The means of a row. Rows must be requested in turn, and the heights of a row must not change before
    /// that.
    pub fn row(&mut self, y: usize, planes: &Planes, out: &mut [f32]) {
        let reach = self.radius as i64;
        let y = y as i64;
        if y == 0 {
            self.sums = vec![0.0; self.side];
            for y in -reach..=reach {
                self.add(y, 1.0);
            }
        } else {
            self.enter(planes);
            self.add(y + reach, 1.0);
            self.add(y - reach - 1, -1.0);
        }
        let width = (2 * self.radius + 1) as f64;
        for (out, sum) in out.iter_mut().zip(&self.sums) {
            *out = (sum / (width * width)) as f32;
        }
    }

    /// Sums along the next row.
    fn enter(&mut self, planes: &Planes) {
        let (side, tile) = (self.side, planes.tile);
        let y = self.entered as i64 - self.radius as i64;
        self.entered += 1;
        let slot = self.slot(y);
        let to = &mut self.along[slot..][..side];
        if tile && y >= side as i64 {
            to.copy_from_slice(&self.first[(y as usize - side) * side..][..side]);
            return;
        }
        let row = &planes.bump[place(y, side, tile) * side..][..side];
        let of = |x: i64| f64::from(row[place(x, side, tile)]);
        let reach = self.radius as i64;
        let mut sum: f64 = (-reach..=reach).map(of).sum();
        for (x, to) in (0..).zip(&mut *to) {
            *to = sum as f32;
            sum += of(x + reach + 1) - of(x - reach);
        }
        if tile && (0..reach).contains(&y) {
            self.first.extend_from_slice(to);
        }
    }

    /// The index in `along` at which the sums of a row begin.
    fn slot(&self, y: i64) -> usize {
        let room = 2 * self.radius as i64 + 2;
        y.rem_euclid(room) as usize * self.side
    }

    fn add(&mut self, y: i64, factor: f64) {
        let row = &self.along[self.slot(y)..][..self.side];
        for (sum, &v) in self.sums.iter_mut().zip(row) {
            *sum += factor * f64::from(v);
        }
    }
}

/// The pixel for a position beyond an edge: the last one there, or on a tile the one at the opposite edge.
fn place(at: i64, side: usize, tile: bool) -> usize {
    let side = side as i64;
    let at = if tile {
        at.rem_euclid(side)
    } else {
        at.clamp(0, side - 1)
    };
    at as usize
}
