//! The bond of random ashlar: stones of whole units that fill a face and hardly ever meet in crosses.

mod mending;

use super::rectangles::{Most, Rectangle, Unit, Units};
use crate::random::Random;

/// Fills the free units of a face with stones of at most a size. The stones of units that are partly free follow after
/// the others.
pub(super) fn stones(units: &mut Units, most: Most, random: &mut Random) -> Vec<Rectangle> {
    let cut = units.cut_stones();
    let mut bond = Bond::new(units, most);
    bond.lay(units, random);
    bond.merge(random);
    bond.mend();
    let whole = bond.stones.into_iter().flatten();
    whole.chain(cut).collect()
}

/// A unit without a stone.
const OPEN: u32 = u32::MAX;
/// A unit that belongs to another feature.
const TAKEN: u32 = u32::MAX - 1;
/// A unit with a stone of its own, as it is partly free.
const PARTLY: u32 = u32::MAX - 2;
/// How many sizes a stone may choose from.
const CHOICES: usize = 6;
/// The stones of a face and who owns each unit.
struct Bond {
    columns: usize,
    is_round: bool,
    rows: usize,
    most: Most,
    owners: Vec<u32>,
    /// The stones by number; none where one was merged into another.
    stones: Vec<Option<Rectangle>>,
}

impl Bond {
    fn new(units: &Units, most: Most) -> Self {
        let owner = |state: &Unit| match state {
            Unit::Free => OPEN,
            Unit::Partly | Unit::Sliver => PARTLY,
            Unit::Taken => TAKEN,
        };
        Self {
            columns: units.columns,
            is_round: units.is_round,
            rows: units.rows(),
            most,
            owners: units.states.iter().map(owner).collect(),
            stones: Vec::new(),
        }
    }

    fn owner(&self, column: usize, row: usize) -> u32 {
        self.owners[row * self.columns + column % self.columns]
    }

    fn own(&mut self, number: u32, stone: &Rectangle) {
        for row in stone.rows[0]..stone.rows[1] {
            for column in stone.columns[0]..stone.columns[1] {
                self.owners[row * self.columns + column % self.columns] = number;
            }
        }
    }

    fn is_open(&self, stone: &Rectangle) -> bool {
        let most = match self.is_round {
            true => stone.columns[0] + self.columns,
            false => self.columns,
        };
        stone.columns[1] <= most
            && stone.rows[1] <= self.rows
            && (stone.rows[0]..stone.rows[1]).all(|row| {
                (stone.columns[0]..stone.columns[1]).all(|column| self.owner(column, row) == OPEN)
            })
    }

    /// Two stones that make a rectangle together, on the turns of a cylinder on which they touch, and that rectangle.
    fn joined(&self, numbers: [u32; 2]) -> Option<([Rectangle; 2], Rectangle)> {
        let [first, second] = numbers.map(|number| self.stones[number as usize]);
        let (first, second) = (first?, second?);
        let on = |stone: Rectangle| Rectangle {
            columns: stone.columns.map(|column| column + self.columns),
            ..stone
        };
        let turns = [[first, second], [first, on(second)], [on(first), second]];
        let count = if self.is_round { 3 } else { 1 };
        let mut turns = turns.into_iter().take(count);
        turns.find_map(|pair| Some((pair, pair[0].joined(&pair[1])?)))
    }

    /// Lays stones at free units. Each takes the best of a few random sizes.
    fn lay(&mut self, units: &Units, random: &mut Random) {
        for k in units.nearly_in_rows(random) {
            if self.owners[k] != OPEN {
                continue;
            }
            let number = self.stones.len() as u32;
            let sizes = (0..CHOICES)
                .map(|_| self.fitting(k, random))
                .collect::<Vec<_>>();
            let faults = sizes.iter().map(|stone| {
                self.own(number, stone);
                let count = self.faults(stone, [Some(*stone), None]);
                self.own(OPEN, stone);
                count
            });
            let faults: Vec<usize> = faults.collect();
            let best = (0..CHOICES).min_by_key(|&k| faults[k]).unwrap_or(0);
            self.own(number, &sizes[best]);
            self.stones.push(Some(sizes[best]));
        }
    }

    /// A stone of a random size from a unit on: a width of two units at least, and a height of at most its width. It
    /// is shrunk until it fits.
    fn fitting(&self, k: usize, random: &mut Random) -> Rectangle {
        let most = self.most;
        let least = 2.min(most.width);
        let mut width = least + random.below(most.width + 1 - least);
        let mut height = 1 + random.below(most.height.min(width));
        loop {
            let [column, row] = [k % self.columns, k / self.columns];
            let stone = Rectangle {
                columns: [column, column + width],
                rows: [row, row + height],
            };
            if width * height == 1 || self.is_open(&stone) {
                return stone;
            }
            if width > height || height == 1 {
                width -= 1
            } else {
                height -= 1
            }
        }
    }

    /// The four units around a corner of the grid, if it has four.
    fn around(&self, [column, row]: [usize; 2]) -> Option<[u32; 4]> {
        let is_inside = self.is_round || (1..self.columns).contains(&column);
        let left = column + self.columns - 1;
        (is_inside && (1..self.rows).contains(&row)).then(|| {
            let row_owners = |row| [self.owner(left, row), self.owner(column, row)];
            let ([a, b], [c, d]) = (row_owners(row - 1), row_owners(row));
            [a, b, c, d]
        })
    }

    /// Whether four stones meet at a corner of the grid.
    fn is_cross(&self, corner: [usize; 2]) -> bool {
        self.around(corner).is_some_and(|[a, b, c, d]| {
            let is_stone = |owner| owner < TAKEN;
            let differ = |a, b| a != b || a == PARTLY;
            [a, b, c, d].into_iter().all(is_stone)
                && differ(a, b)
                && differ(c, d)
                && differ(a, c)
                && differ(b, d)
        })
    }

    /// The number of crosses at the border of a rectangle and within it.
    fn crosses_around(&self, part: &Rectangle) -> usize {
        let rows = part.rows[0]..=part.rows[1];
        let corners = rows.flat_map(|row| {
            let columns = part.columns[0]..=part.columns[1];
            columns.map(move |column| [column, row])
        });
        corners.filter(|&corner| self.is_cross(corner)).count()
    }

    /// How bad the bond is at some stones and around them: crosses count twice, and stones of one unit once.
    fn faults(&self, part: &Rectangle, stones: [Option<Rectangle>; 2]) -> usize {
        let single = stones.iter().flatten().filter(|stone| stone.is_single());
        2 * self.crosses_around(part) + single.count()
    }

    /// The stones at the four sides of a stone of one unit, by rising numbers.
    fn beside(&self, stone: &Rectangle) -> Vec<u32> {
        let [column, row] = [stone.columns[0], stone.rows[0]];
        let is_inner = |column: usize| self.is_round || column < self.columns;
        let left = (self.is_round || column > 0).then(|| column + self.columns - 1);
        let sides = [
            (row > 0).then(|| [column, row - 1]),
            left.map(|column| [column, row]),
            is_inner(column + 1).then_some([column + 1, row]),
            (row + 1 < self.rows).then_some([column, row + 1]),
        ];
        let owners = sides.into_iter().flatten().map(|[x, y]| self.owner(x, y));
        let mut found: Vec<u32> = owners.filter(|&owner| owner < PARTLY).collect();
        found.sort_unstable();
        found
    }

    fn is_single(&self, number: u32) -> bool {
        let stone = self.stones[number as usize];
        stone.is_some_and(|stone| stone.is_single())
    }

    /// Merges stones of one unit with a neighbour at random, until none can be merged.
    fn merge(&mut self, random: &mut Random) {
        let all = 0..self.stones.len() as u32;
        let mut due: Vec<u32> = all.filter(|&number| self.is_single(number)).collect();
        while !due.is_empty() {
            let number = due.swap_remove(random.below(due.len()));
            let Some(stone) = self.stones[number as usize].filter(|_| self.is_single(number))
            else {
                continue;
            };
            let unions = self.beside(&stone).into_iter();
            let unions = unions.filter_map(|other| Some((other, self.union(number, other)?)));
            let unions: Vec<(u32, Rectangle)> = unions.collect();
            if let Some(&(other, union)) = unions.get(random.below(unions.len())) {
                self.set([number, other], [None, Some(union)]);
            }
        }
    }

    /// The union of two stones, if it is a stone that is not too large.
    fn union(&self, a: u32, b: u32) -> Option<Rectangle> {
        let (_, union) = self.joined([a, b])?;
        self.most.allows(&union).then_some(union)
    }

    /// Replaces two stones.
    fn set(&mut self, numbers: [u32; 2], stones: [Option<Rectangle>; 2]) {
        for (number, stone) in numbers.into_iter().zip(stones) {
            self.stones[number as usize] = stone.map(|stone| self.first_turn(stone));
            if let Some(stone) = stone {
                self.own(number, &stone);
            }
        }
    }

    /// A stone that begins on the first turn of a cylinder.
    fn first_turn(&self, stone: Rectangle) -> Rectangle {
        let turns = stone.columns[0] / self.columns * self.columns;
        Rectangle {
            columns: stone.columns.map(|column| column - turns),
            ..stone
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Purpose;

    const MOST: Most = Most {
        width: 4,
        height: 3,
    };

    /// Stones of a face of 17 by 11 units with some that are partly free, and some slivers.
    fn stones_with_gaps(seed: u64) -> (Units, Vec<Rectangle>) {
        let mut random = Random::new(seed, Purpose::Placement, 0);
        let state = |k| match k % 13 {
            5 => Unit::Partly,
            6 | 11 => Unit::Sliver,
            _ => Unit::Free,
        };
        let mut units = Units {
            columns: 17,
            is_round: seed % 2 == 1,
            states: (0..17 * 11).map(state).collect(),
        };
        let stones = stones(&mut units, MOST, &mut random);
        (units, stones)
    }

    #[test]
    fn stones_fill_all_units_once() {
        for seed in 0..20 {
            let (units, stones) = stones_with_gaps(seed);
            let mut covered = vec![0; units.states.len()];
            for stone in &stones {
                assert!(MOST.allows(stone), "{stone:?}");
                for row in stone.rows[0]..stone.rows[1] {
                    (stone.columns[0]..stone.columns[1])
                        .for_each(|column| covered[row * 17 + column % 17] += 1);
                }
            }
            assert!(covered.into_iter().all(|count| count == 1));
        }
    }

    #[test]
    fn stones_of_plain_walls_and_cylinders_hardly_ever_meet_in_crosses() {
        for seed in 0..20 {
            let mut units = Units {
                columns: 40,
                is_round: seed % 2 == 1,
                states: vec![Unit::Free; 40 * 24],
            };
            let mut random = Random::new(seed, Purpose::Placement, 0);
            let mut bond = Bond::new(&units, MOST);
            for (number, stone) in (0..).zip(stones(&mut units, MOST, &mut random)) {
                bond.own(number, &stone);
                bond.stones.push(Some(stone));
            }
            let corners = (1..24).flat_map(|row| (0..40).map(move |column| [column, row]));
            let crosses = corners.filter(|&corner| bond.is_cross(corner)).count();
            let all = bond.stones.len();
            assert!(crosses * 15 < all, "{crosses} crosses of {all} stones");
            let singles = (0..all).filter(|&k| bond.is_single(k as u32)).count();
            assert!(singles * 8 < all, "{singles} of {all} stones are single");
            let over_the_end = bond
                .stones
                .iter()
                .flatten()
                .filter(|stone| stone.columns[1] > 40);
            assert_eq!(over_the_end.count() > 3, units.is_round);
        }
    }
}
