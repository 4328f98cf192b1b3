//! Rectangles of random size on the units of a grid (Legakis, Dorsey, Gortler 2001, section 5.2, Random Ashlar).

use crate::order;
use crate::random::Random;

/// How far units may be visited out of the order of rows, in rows.
const SHUFFLE: f64 = 1.5;

/// A state of a unit of the face's grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unit {
    Free,
    /// Partly free: it gets a stone of its own, cut to the free space.
    Partly,
    Taken,
}

/// A stone in the making: columns and rows of the grid, the ends excluded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rectangle {
    pub columns: [usize; 2],
    pub rows: [usize; 2],
}

impl Rectangle {
    fn width(&self) -> usize {
        self.columns[1] - self.columns[0]
    }

    fn height(&self) -> usize {
        self.rows[1] - self.rows[0]
    }

    /// The union of two rectangles if that is a rectangle.
    fn joined(&self, other: &Self) -> Option<Self> {
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
    fn allows(&self, stone: &Rectangle) -> bool {
        let (w, h) = (stone.width(), stone.height());
        w <= self.width && h <= self.height && 2 * w >= h
    }
}

/// The units of a face's grid, row by row.
pub(super) struct Units {
    pub columns: usize,
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

    /// The units that are partly free.
    pub fn partly(&self) -> Vec<Rectangle> {
        let partly = (0..self.states.len()).filter(|&k| self.states[k] == Unit::Partly);
        partly.map(|k| self.single(k)).collect()
    }

    fn is_free(&self, stone: &Rectangle) -> bool {
        let rows = self.states.len() / self.columns;
        stone.columns[1] <= self.columns
            && stone.rows[1] <= rows
            && (stone.rows[0]..stone.rows[1]).all(|row| {
                let start = row * self.columns;
                self.states[start + stone.columns[0]..start + stone.columns[1]]
                    .iter()
                    .all(|&state| state == Unit::Free)
            })
    }

    fn take(&mut self, stone: &Rectangle) {
        for row in stone.rows[0]..stone.rows[1] {
            let start = row * self.columns;
            self.states[start + stone.columns[0]..start + stone.columns[1]].fill(Unit::Taken);
        }
    }

    /// Lays stones at free units, visited in nearly the order of rows. A stone has a random width, of two units at
    /// least, and a random height of at most its width. It is shrunk until it fits.
    pub fn greedy(&mut self, most: Most, random: &mut Random) -> Vec<Rectangle> {
        let keys = (0..self.states.len()).map(|k| {
            let row = (k / self.columns) as f64;
            (order::rank(row + SHUFFLE * random.unit()), k as u64)
        });
        let mut order: Vec<(u64, u64)> = keys.collect();
        order.sort_unstable();
        let mut stones = Vec::new();
        for (_, k) in order {
            let k = k as usize;
            if self.states[k] == Unit::Free {
                let stone = self.fitting(k, most, random);
                self.take(&stone);
                stones.push(stone);
            }
        }
        stones
    }

    fn fitting(&self, k: usize, most: Most, random: &mut Random) -> Rectangle {
        let least = 2.min(most.width);
        let mut width = least + random.below(most.width + 1 - least);
        let mut height = 1 + random.below(most.height.min(width));
        loop {
            let [column, row] = [k % self.columns, k / self.columns];
            let stone = Rectangle {
                columns: [column, column + width],
                rows: [row, row + height],
            };
            if width * height == 1 || self.is_free(&stone) {
                return stone;
            }
            if width > height || height == 1 {
                width -= 1
            } else {
                height -= 1
            }
        }
    }
}

/// Writes the number of a stone into its units.
fn own(owners: &mut [usize], columns: usize, (number, stone): (usize, &Rectangle)) {
    for row in stone.rows[0]..stone.rows[1] {
        let start = row * columns;
        owners[start + stone.columns[0]..start + stone.columns[1]].fill(number);
    }
}

/// The stones at the four sides of a stone of one unit, by rising numbers.
fn beside(owners: &[usize], columns: usize, stone: &Rectangle) -> Vec<usize> {
    let (column, k) = (stone.columns[0], stone.rows[0] * columns + stone.columns[0]);
    let sides = [
        k.checked_sub(columns),
        (column > 0).then(|| k - 1),
        (column + 1 < columns).then_some(k + 1),
        Some(k + columns),
    ];
    let numbers = sides.into_iter().flatten().filter_map(|k| owners.get(k));
    let mut found: Vec<usize> = numbers.copied().filter(|&k| k != usize::MAX).collect();
    found.sort_unstable();
    found
}

/// Merges stones of one unit with a neighbour at random, until none can be merged. A row has `columns` units.
pub(super) fn merge(
    stones: &mut Vec<Rectangle>,
    columns: usize,
    (most, random): (Most, &mut Random),
) {
    let rows = stones.iter().map(|stone| stone.rows[1]).max().unwrap_or(0);
    let mut owners = vec![usize::MAX; rows * columns];
    for numbered in stones.iter().enumerate() {
        own(&mut owners, columns, numbered);
    }
    let mut due: Vec<usize> = (0..stones.len())
        .filter(|&k| stones[k].width() * stones[k].height() == 1)
        .collect();
    let mut is_gone = vec![false; stones.len()];
    while !due.is_empty() {
        let k = due.swap_remove(random.below(due.len()));
        if is_gone[k] || stones[k].width() * stones[k].height() > 1 {
            continue;
        }
        let others = beside(&owners, columns, &stones[k]).into_iter();
        let unions = others.filter_map(|j| Some((j, stones[k].joined(&stones[j])?)));
        let unions: Vec<(usize, Rectangle)> =
            unions.filter(|(_, union)| most.allows(union)).collect();
        if let Some(&(j, union)) = unions.get(random.below(unions.len())) {
            stones[j] = union;
            own(&mut owners, columns, (j, &union));
            is_gone[k] = true;
        }
    }
    let mut gone = is_gone.into_iter();
    stones.retain(|_| !gone.next().unwrap_or(false));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Purpose;

    const MOST: Most = Most {
        width: 4,
        height: 3,
    };

    #[test]
    fn stones_fill_all_free_units_once() {
        for seed in 0..20 {
            let mut random = Random::new(seed, Purpose::Placement, 0);
            let states: Vec<Unit> = (0..17 * 11)
                .map(|k| {
                    if k % 13 == 5 {
                        Unit::Partly
                    } else {
                        Unit::Free
                    }
                })
                .collect();
            let mut units = Units {
                columns: 17,
                states: states.clone(),
            };
            let mut stones = units.greedy(MOST, &mut random);
            merge(&mut stones, 17, (MOST, &mut random));
            let mut covered = vec![0; states.len()];
            for stone in &stones {
                assert!(MOST.allows(stone), "{stone:?}");
                for row in stone.rows[0]..stone.rows[1] {
                    (stone.columns[0]..stone.columns[1])
                        .for_each(|column| covered[row * 17 + column] += 1);
                }
            }
            let wanted = states.iter().map(|&state| i32::from(state == Unit::Free));
            assert!(covered.into_iter().eq(wanted));
            let single = stones
                .iter()
                .filter(|stone| stone.width() * stone.height() == 1)
                .count();
            assert!(single * 4 < stones.len(), "{single} of {}", stones.len());
        }
    }
}
