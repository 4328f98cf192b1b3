//! Rectangles of random size on the units of a grid (Legakis, Dorsey, Gortler 2001, section 5.2, Random Ashlar).

use crate::order;
use crate::random::Random;
use std::collections::BTreeMap;

/// How far units may be visited out of the order of rows, in rows.
const SHUFFLE: f64 = 1.5;

/// A state of a unit of the face's grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unit {
    Free,
    /// Partly free: it gets a stone of its own, cut to the free space.
    Partly,
    /// So little of it is free that the stone of a neighbour in its row takes it.
    Sliver,
    Taken,
}

/// A stone in the making: columns and rows of the grid, the ends excluded. Around a cylinder, the columns of a stone over
/// the end of the grid go on after the last one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rectangle {
    pub columns: [usize; 2],
    pub rows: [usize; 2],
}

impl Rectangle {
    pub fn width(&self) -> usize {
        self.columns[1] - self.columns[0]
    }

    pub fn height(&self) -> usize {
        self.rows[1] - self.rows[0]
    }

    pub fn is_single(&self) -> bool {
        self.width() * self.height() == 1
    }

    /// The union of two rectangles if that is a rectangle.
    pub fn joined(&self, other: &Self) -> Option<Self> {
        let touch = |a: [usize; 2], b: [usize; 2]| a[1] == b[0] || b[1] == a[0];
        let is_beside = self.rows == other.rows && touch(self.columns, other.columns);
        let is_above = self.columns == other.columns && touch(self.rows, other.rows);
        let union = |a: [usize; 2], b: [usize; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        (is_beside || is_above).then(|| Self {
            columns: union(self.columns, other.columns),
            rows: union(self.rows, other.rows),
        })
    }
}

/// The largest size of stones, in units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Most {
    pub width: usize,
    pub height: usize,
}

impl Most {
    pub fn allows(&self, stone: &Rectangle) -> bool {
        let (w, h) = (stone.width(), stone.height());
        w <= self.width && h <= self.height && 2 * w >= h
    }
}

/// The units of a face's grid, row by row.
pub(super) struct Units {
    pub columns: usize,
    /// Whether the first column is beside the last one, around a cylinder.
    pub is_round: bool,
    pub states: Vec<Unit>,
}

impl Units {
    fn single(&self, k: usize) -> Rectangle {
        let (column, row) = (k % self.columns, k / self.columns);
        Rectangle {
            columns: [column, column + 1],
            rows: [row, row + 1],
        }
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.states.len() / self.columns
    }

    /// The numbers of all units in a state.
    fn all(&self, state: Unit) -> Vec<usize> {
        let all = 0..self.states.len();
        all.filter(|&k| self.states[k] == state).collect()
    }

    /// The stones of units that are partly free: each has one of its own, but slivers join a neighbour in their row,
    /// a partly free one if there is one. `states` then has such neighbours as partly free.
    pub fn cut_stones(&mut self) -> Vec<Rectangle> {
        let mut stones: BTreeMap<usize, Rectangle> = BTreeMap::new();
        for k in self.all(Unit::Sliver) {
            let column = k % self.columns;
            let before = (column > 0).then(|| k - 1);
            let after = (column + 1 < self.columns).then_some(k + 1);
            let beside = || [before, after].into_iter().flatten();
            let is_open =
                |state: Unit, at: &usize| self.states[*at] == state && !stones.contains_key(at);
            let other = beside()
                .find(|at| is_open(Unit::Partly, at))
                .or_else(|| beside().find(|at| is_open(Unit::Free, at)));
            let both = other.and_then(|at| Some((at, self.single(k).joined(&self.single(at))?)));
            if let Some((at, both)) = both {
                stones.insert(at, both);
                self.states[at] = Unit::Partly;
            } else {
                stones.insert(k, self.single(k));
            }
        }
        for k in self.all(Unit::Partly) {
            stones.entry(k).or_insert_with(|| self.single(k));
        }
        stones.into_values().collect()
    }

    /// The free units in nearly the order of rows.
    pub fn nearly_in_rows(&self, random: &mut Random) -> Vec<usize> {
        let keys = (0..self.states.len()).map(|k| {
            let row = (k / self.columns) as f64;
            (order::rank(row + SHUFFLE * random.unit()), k)
        });
        let mut keys: Vec<(u64, usize)> = keys.collect();
        keys.sort_unstable();
        let order = keys.into_iter().map(|(_, k)| k);
        order.filter(|&k| self.states[k] == Unit::Free).collect()
    }
}
