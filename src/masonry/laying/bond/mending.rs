//! Mends the bond of random ashlar: crosses of four stones, and stones of one unit.

use super::super::rectangles::Rectangle;
use super::{Bond, PARTLY};

/// How many times the crosses of a face are looked through.
const ROUNDS: usize = 6;
/// How many units a joint between two stones may move.
const SHIFTS: [isize; 4] = [1, -1, 2, -2];

impl Bond {
    /// Looks through the crosses and the stones of one unit: two stones become one, or the joint between them moves,
    /// where that leaves fewer faults.
    pub(super) fn mend(&mut self) {
        for _ in 0..ROUNDS {
            let mut is_done = true;
            for row in 1..self.rows {
                for column in 0..self.columns {
                    if self.is_cross([column, row]) {
                        is_done &= !self.mend_cross([column, row]);
                    }
                }
            }
            for number in 0..self.stones.len() as u32 {
                if self.is_single(number) {
                    is_done &= !self.mend_single(number);
                }
            }
            if is_done {
                break;
            }
        }
    }

    fn mend_cross(&mut self, corner: [usize; 2]) -> bool {
        self.around(corner)
            .is_some_and(|[a, b, c, d]| self.mend_pairs(&[[a, b], [c, d], [a, c], [b, d]]))
    }

    fn mend_single(&mut self, number: u32) -> bool {
        let beside = self.stones[number as usize].map(|stone| self.beside(&stone));
        let pairs = beside.into_iter().flatten().map(|other| [number, other]);
        self.mend_pairs(&pairs.collect::<Vec<_>>())
    }

    /// Divides the rectangle of one of some pairs of stones anew, where that saves most faults.
    fn mend_pairs(&mut self, pairs: &[[u32; 2]]) -> bool {
        let mut best: Option<(usize, [u32; 2], [Option<Rectangle>; 2])> = None;
        for &pair in pairs
            .iter()
            .filter(|pair| pair.iter().all(|&owner| owner < PARTLY))
        {
            let Some((both, whole)) = self.joined(pair) else {
                continue;
            };
            let today = both.map(Some);
            let now = self.faults(&whole, today);
            for stones in self.divisions(&whole, both) {
                self.set(pair, stones);
                let saved = now.saturating_sub(self.faults(&whole, stones));
                if saved > best.map_or(0, |(most, ..)| most) {
                    best = Some((saved, pair, stones));
                }
                self.set(pair, today);
            }
        }
        if let Some((_, pair, stones)) = best {
            self.set(pair, stones);
        }
        best.is_some()
    }

    /// The other ways to fill a rectangle that two stones fill: one stone, or two with their joint elsewhere.
    fn divisions(
        &self,
        whole: &Rectangle,
        [first, second]: [Rectangle; 2],
    ) -> Vec<[Option<Rectangle>; 2]> {
        let is_beside = first.rows == second.rows;
        let is_first_low = match is_beside {
            true => first.columns[0] < second.columns[0],
            false => first.rows[0] < second.rows[0],
        };
        let low = if is_first_low { first } else { second };
        let joint = if is_beside {
            low.columns[1]
        } else {
            low.rows[1]
        };
        let divided = SHIFTS.into_iter().filter_map(|shift| {
            let at = joint.checked_add_signed(shift)?;
            let mut parts = [*whole; 2];
            for (k, part) in parts.iter_mut().enumerate() {
                let range = if is_beside {
                    &mut part.columns
                } else {
                    &mut part.rows
                };
                range[1 - k] = at;
            }
            let is_whole = |part: &Rectangle| {
                part.columns[0] < part.columns[1]
                    && part.rows[0] < part.rows[1]
                    && self.most.allows(part)
            };
            let [low, high] = parts;
            parts.iter().all(is_whole).then_some(match is_first_low {
                true => [Some(low), Some(high)],
                false => [Some(high), Some(low)],
            })
        });
        let one = self.most.allows(whole).then_some([Some(*whole), None]);
        one.into_iter().chain(divided).collect()
    }
}
