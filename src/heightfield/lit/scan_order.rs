//! Lines of pixels in the order in which shadows cross them.

use std::ops::Range;

/// Lines of one slice; this many columns are transposed at a time.
const BLOCK: usize = 16;

/// Neighbouring rows or columns, one after another.
#[derive(Clone, Debug)]
pub struct ScanOrder {
    /// Whether the lines are columns, from left to right; otherwise they are rows, from top to
    /// bottom.
    pub columns: bool,
    /// Whether the lines come in reverse order.
    pub backwards: bool,
    left: Range<usize>,
    fresh: bool,
}

impl ScanOrder {
    pub fn new(columns: bool, backwards: bool, lines: Range<usize>) -> Self {
        Self {
            columns,
            backwards,
            left: lines,
            fresh: true,
        }
    }

    /// An order of only the last `lines` lines.
    pub fn last(&self, lines: usize) -> Self {
        let left = &self.left;
        let last = if self.backwards {
            left.start..left.start + lines
        } else {
            left.end - lines..left.end
        };
        Self::new(self.columns, self.backwards, last)
    }

    /// Whether no line is done yet.
    pub fn is_fresh(&self) -> bool {
        self.fresh
    }

    /// Whether all lines are done.
    pub fn is_over(&self) -> bool {
        self.left.is_empty()
    }

    /// Takes the next few lines.
    pub fn take(&mut self) -> Range<usize> {
        let count = self.left.len().min(BLOCK);
        self.fresh = false;
        if self.backwards {
            let from = self.left.end - count;
            let taken = from..self.left.end;
            self.left.end = from;
            taken
        } else {
            let to = self.left.start + count;
            let taken = self.left.start..to;
            self.left.start = to;
            taken
        }
    }
}

/// A few columns of heights and light, transposed so that each is contiguous.
#[derive(Clone, Debug, Default)]
pub struct ColumnBlock {
    side: usize,
    heights: Vec<f32>,
    lit: Vec<u8>,
}

impl ColumnBlock {
    /// Transposes columns of the planes.
    pub fn load(&mut self, bump: &[f32], lit: &[u8], side: usize, columns: &Range<usize>) {
        self.side = side;
        self.heights.resize(BLOCK * side, 0.0);
        self.lit.resize(BLOCK * side, 0);
        for y in 0..side {
            let there = y * side + columns.start..y * side + columns.end;
            let pixels = bump[there.clone()].iter().zip(&lit[there]);
            for (k, (&height, &lit)) in pixels.enumerate() {
                self.heights[k * side + y] = height;
                self.lit[k * side + y] = lit;
            }
        }
    }

    /// Heights and light of one of the columns.
    pub fn line(&mut self, k: usize) -> (&[f32], &mut [u8]) {
        let line = k * self.side..(k + 1) * self.side;
        (&self.heights[line.clone()], &mut self.lit[line])
    }

    /// Transposes the light back.
    pub fn store(&self, lit: &mut [u8], side: usize, columns: &Range<usize>) {
        for y in 0..side {
            let there = &mut lit[y * side + columns.start..y * side + columns.end];
            for (k, lit) in there.iter_mut().enumerate() {
                *lit = self.lit[k * side + y];
            }
        }
    }
}
