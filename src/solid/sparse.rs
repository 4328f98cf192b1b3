//! Sparse matrices of few columns, and their products.

/// A sparse matrix in compressed rows (CSR): row i holds the entries `starts[i] .. starts[i + 1]`.
#[derive(Debug)]
pub(super) struct Matrix {
    pub starts: Vec<u32>,
    pub columns: Vec<u16>,
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
        Self {
            starts: (0..=n as u32).collect(),
            columns: (0..n as u16).collect(),
            weights: vec![1.0; n],
        }
    }

    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    fn row(&self, i: usize) -> impl Iterator<Item = (u16, f64)> + '_ {
        let span = self.starts[i] as usize..self.starts[i + 1] as usize;
        let columns = self.columns[span.clone()].iter().copied();
        columns.zip(self.weights[span].iter().copied())
    }
}

/// Most entries of nearly all rows of a refined mesh: a point of Loop's surface depends on the corners around one
/// triangle.
const ENTRIES: usize = 14;

/// The product of two matrices, computed row by row. Rows of the first one are made as they are needed, because all of
/// them would take more memory than the product. The second one has few columns: sums go into a dense row that is
/// cleared after use.
#[derive(Debug)]
pub(super) struct Product {
    rows: usize,
    dense: Vec<f64>,
    pub done: Matrix,
}

impl Product {
    /// For a first matrix with this many rows, and a second one with this many columns.
    pub fn new(rows: usize, columns: usize) -> Self {
        let entries = rows * columns.min(ENTRIES);
        let mut done = Matrix::empty();
        done.starts.reserve_exact(rows);
        done.columns.reserve_exact(entries);
        done.weights.reserve_exact(entries);
        Self {
            rows,
            dense: vec![0.0; columns],
            done,
        }
    }

    /// Computes at most `most` rows and subtracts them from that number; true when finished. `row` puts a row of the
    /// first matrix into an empty list.
    pub fn advance(
        &mut self,
        row: impl Fn(usize, &mut Vec<(u32, f64)>),
        second: &Matrix,
        most: &mut usize,
    ) -> bool {
        let from = self.done.len();
        let to = self.rows.min(from.saturating_add(*most));
        let Matrix {
            starts,
            columns,
            weights,
        } = &mut self.done;
        let mut sources = Vec::new();
        for i in from..to {
            sources.clear();
            row(i, &mut sources);
            for &(source, weight) in &sources {
                for (column, inner) in second.row(source as usize) {
                    self.dense[usize::from(column)] += weight * inner;
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
        to == self.rows
    }
}
