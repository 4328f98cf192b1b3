//! Sparse matrices and their products.

/// A sparse matrix in compressed rows (CSR): row i holds the entries `starts[i] .. starts[i + 1]`.
#[derive(Debug)]
pub(super) struct Matrix {
    pub starts: Vec<u32>,
    pub columns: Vec<u32>,
    pub weights: Vec<f64>,
}

impl Matrix {
    pub fn empty() -> Self {
        Self {
            starts: vec![0],
            columns: Vec::new(),
            weights: Vec::new(),
        }
    }

    pub fn identity(n: usize) -> Self {
        let mut rows = Self::empty();
        (0..n as u32).for_each(|i| rows.push([(i, 1.0)]));
        rows
    }

    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    pub fn push(&mut self, row: impl IntoIterator<Item = (u32, f64)>) {
        for (column, weight) in row {
            self.columns.push(column);
            self.weights.push(weight);
        }
        self.starts.push(self.columns.len() as u32);
    }

    pub fn row(&self, i: usize) -> impl Iterator<Item = (u32, f64)> + '_ {
        let span = self.starts[i] as usize..self.starts[i + 1] as usize;
        let columns = self.columns[span.clone()].iter().copied();
        columns.zip(self.weights[span].iter().copied())
    }
}

/// The product of two matrices, computed row by row. The second one has few columns: sums go into a dense row
/// that is cleared after use.
#[derive(Debug)]
pub(super) struct Product {
    first: Matrix,
    dense: Vec<f64>,
    pub done: Matrix,
}

impl Product {
    pub fn new(first: Matrix, columns: usize) -> Self {
        let mut done = Matrix::empty();
        done.starts.reserve(first.len());
        done.columns.reserve(first.len() * columns / 2);
        done.weights.reserve(first.len() * columns / 2);
        Self {
            first,
            dense: vec![0.0; columns],
            done,
        }
    }

    /// Computes at most `most` rows and subtracts them from that number; true when finished.
    pub fn advance(&mut self, second: &Matrix, most: &mut usize) -> bool {
        let from = self.done.len();
        let to = self.first.len().min(from.saturating_add(*most));
        let Matrix {
            starts,
            columns,
            weights,
        } = &mut self.done;
        for i in from..to {
            for (source, weight) in self.first.row(i) {
                for (column, inner) in second.row(source as usize) {
                    self.dense[column as usize] += weight * inner;
                }
            }
            for (column, sum) in (0..).zip(&mut self.dense) {
                if *sum != 0.0 {
                    columns.push(column);
                    weights.push(std::mem::take(sum));
                }
            }
            starts.push(columns.len() as u32);
        }
        *most -= to - from;
        to == self.first.len()
    }
}
