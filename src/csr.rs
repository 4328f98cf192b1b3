//! Many short lists in one vector: compressed rows, as of a sparse matrix (CSR).

/// Stands for a missing row, vertex, cell or triangle in place of its index.
pub(crate) const NONE: u32 = u32::MAX;

/// A list of values for each row; rows are numbered from 0.
#[derive(Clone, Debug)]
pub(crate) struct Csr<T> {
    /// Row k holds the values `starts[k]..starts[k + 1]`.
    starts: Vec<u32>,
    values: Vec<T>,
}

impl<T> Default for Csr<T> {
    fn default() -> Self {
        Self {
            starts: vec![0],
            values: Vec::new(),
        }
    }
}

impl<T> Csr<T> {
    /// The values of a row.
    #[inline]
    pub fn row(&self, row: usize) -> &[T] {
        &self.values[self.starts[row] as usize..self.starts[row + 1] as usize]
    }

    /// The number of values in all rows.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// The number of rows.
    #[cfg(house)]
    pub fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The values of a row, mutable.
    pub fn row_mut(&mut self, row: usize) -> &mut [T] {
        &mut self.values[self.starts[row] as usize..self.starts[row + 1] as usize]
    }

    /// Adds a row behind the others.
    pub fn push(&mut self, values: impl IntoIterator<Item = T>) {
        self.values.extend(values);
        self.starts.push(self.values.len() as u32);
    }

    /// Removes all rows, but keeps the memory.
    pub fn clear(&mut self) {
        self.starts.truncate(1);
        self.values.clear();
    }

    /// The index of each row's first value, followed by the end of the last row; and all values.
    pub fn into_parts(self) -> (Vec<u32>, Vec<T>) {
        (self.starts, self.values)
    }
}

impl<T: Copy> Csr<T> {
    /// Groups values by their rows, in one counting sort. The values of a row keep their order.
    pub fn from_pairs(rows: usize, pairs: impl Iterator<Item = (usize, T)> + Clone) -> Self {
        let mut starts = vec![0; rows + 1];
        for (row, _) in pairs.clone() {
            starts[row + 1] += 1;
        }
        for row in 0..rows {
            starts[row + 1] += starts[row];
        }
        let Some((_, filler)) = pairs.clone().next() else {
            return Self {
                starts,
                values: Vec::new(),
            };
        };
        let mut values = vec![filler; starts[rows] as usize];
        let mut free = starts.clone();
        for (row, value) in pairs {
            values[free[row] as usize] = value;
            free[row] += 1;
        }
        Self { starts, values }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_keep_their_order_within_a_row() {
        let pairs = [(2, 'a'), (0, 'b'), (2, 'c'), (0, 'd'), (2, 'a')];
        let lists = Csr::from_pairs(4, pairs.into_iter());
        let wanted: [&[char]; 4] = [&['b', 'd'], &[], &['a', 'c', 'a'], &[]];
        for (row, wanted) in wanted.into_iter().enumerate() {
            assert_eq!(lists.row(row), wanted);
        }
        let mut pushed = Csr::default();
        wanted
            .iter()
            .for_each(|row| pushed.push(row.iter().copied()));
        assert_eq!(pushed.into_parts(), lists.into_parts());
    }

    #[test]
    fn no_pairs_make_empty_rows() {
        let lists = Csr::<u8>::from_pairs(2, std::iter::empty());
        assert_eq!(lists.into_parts(), (vec![0; 3], vec![]));
    }
}
