//! Mends conflicts of phases: one column more or less in single intervals of walls.

use super::parity::{Columns, PhaseEdge, PhasePlan, count_conflicts, solve};
use crate::order;
use std::collections::BTreeSet;

/// About how many steps of trials are in a slice of the work.
const SLICE: usize = 200_000;

/// A change of a wall's columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Change {
    /// The wall.
    pub wall: u32,
    /// The number of the interval between fixed lines of the wall.
    pub interval: u32,
    /// One column more (1) or less (-1).
    pub by: i8,
}

/// Changes the columns of single intervals by one until no conflict is left, or no change makes fewer. The best change
/// leaves the fewest conflicts; then the least |ln(column width / module)| counts, then the order. Sets of connected
/// walls are mended one after the other, each for itself.
#[derive(Debug)]
pub struct RepairWork {
    edges: Vec<PhaseEdge>,
    /// The width of columns (metres).
    module: f64,
    /// The phases before any change.
    plan: PhasePlan,
    /// The sets with conflicts, the next one last.
    sets: Vec<ConflictSet>,
    changes: Vec<Change>,
}

/// Connected walls, and the search for the best change of their columns.
#[derive(Debug)]
struct ConflictSet {
    walls: Vec<u32>,
    edges: Vec<PhaseEdge>,
    /// About the number of steps of a trial.
    steps: usize,
    /// How many conflicts are left.
    left: usize,
    /// The changes to be tried, the next one last.
    trials: Vec<Change>,
    /// The best change so far. Before it stands its key: the conflicts that it leaves, and the rank of its cost.
    best: Option<((usize, u64), Change)>,
}

impl RepairWork {
    /// Begins with the columns of all walls and the edges between them.
    pub fn new(columns: &[Columns], edges: Vec<PhaseEdge>, module: f64) -> Self {
        let plan = solve(columns, &edges);
        let root = |edge: &PhaseEdge| plan.roots[edge.walls[0] as usize];
        let in_conflict = edges
            .iter()
            .filter(|edge| plan.conflicts.contains(&edge.edge));
        let roots: BTreeSet<u32> = in_conflict.map(root).collect();
        let sets = roots.into_iter().rev().map(|set| {
            let own = edges.iter().copied().filter(|edge| root(edge) == set);
            let walls = (0u32..).zip(&plan.roots).filter(|(_, root)| **root == set);
            ConflictSet::new(
                columns,
                walls.map(|(wall, _)| wall).collect(),
                own.collect(),
            )
        });
        Self {
            sets: sets.collect(),
            edges,
            module,
            plan,
            changes: Vec::new(),
        }
    }

    /// Tries some changes of `columns`, which must be the same list in all calls. Returns the changes made and the
    /// phases at the end.
    pub fn advance(&mut self, columns: &mut [Columns]) -> Option<(Vec<Change>, PhasePlan)> {
        let Some(set) = self.sets.last_mut() else {
            let plan = match self.changes.is_empty() {
                true => std::mem::take(&mut self.plan),
                false => solve(columns, &self.edges),
            };
            return Some((std::mem::take(&mut self.changes), plan));
        };
        let made = set.advance(columns, self.module);
        self.changes.extend(made);
        if set.is_done() {
            self.sets.pop();
        }
        None
    }
}

impl ConflictSet {
    fn new(columns: &[Columns], walls: Vec<u32>, edges: Vec<PhaseEdge>) -> Self {
        let lines = edges.iter().map(|edge| 1 + edge.lines[0] + edge.lines[1]);
        Self {
            steps: columns.len() + lines.sum::<u32>() as usize,
            left: count_conflicts(columns, &edges),
            trials: trials(columns, &walls),
            best: None,
            walls,
            edges,
        }
    }

    /// Tries some changes. When all are tried, makes and returns the best one.
    fn advance(&mut self, columns: &mut [Columns], module: f64) -> Option<Change> {
        for _ in 0..(SLICE / self.steps).max(1) {
            let Some(change) = self.trials.pop() else {
                break;
            };
            self.attempt(columns, change, module);
        }
        if !self.trials.is_empty() {
            return None;
        }
        let ((left, _), change) = self.best.take()?;
        apply(columns, change);
        self.left = left;
        if left > 0 {
            self.trials = trials(columns, &self.walls);
        }
        Some(change)
    }

    /// Whether no conflict is left, or no change makes fewer.
    fn is_done(&self) -> bool {
        self.trials.is_empty()
    }

    /// Keeps a change if it is the best one so far.
    fn attempt(&mut self, columns: &mut [Columns], change: Change, module: f64) {
        let wall = &columns[change.wall as usize];
        let cost = wall.cost(change.interval as usize, change.by.into(), module);
        apply(columns, change);
        let left = count_conflicts(columns, &self.edges);
        let by = -change.by;
        apply(columns, Change { by, ..change });
        let key = (left, order::rank(cost));
        if left < self.left && self.best.as_ref().is_none_or(|(least, _)| key < *least) {
            self.best = Some((key, change));
        }
    }
}

fn apply(columns: &mut [Columns], change: Change) {
    let count = &mut columns[change.wall as usize].counts[change.interval as usize];
    *count = count.wrapping_add_signed(change.by.into());
}

/// All changes of some walls that may be tried, the first one last. Cylinders are left out, as they must stay even, and
/// so are intervals with a single column.
fn trials(columns: &[Columns], walls: &[u32]) -> Vec<Change> {
    let all = walls.iter().map(|&wall| (wall, &columns[wall as usize]));
    let all = all.filter(|(_, columns)| !columns.is_closed);
    let all = all.flat_map(|(wall, columns)| {
        let intervals = (0u32..).zip(&columns.counts);
        intervals.flat_map(move |(interval, &count)| {
            let signs = if count > 1 { &[1, -1][..] } else { &[] };
            signs.iter().map(move |&by| Change { wall, interval, by })
        })
    });
    let mut all: Vec<Change> = all.collect();
    all.reverse();
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ring of an odd number of walls takes many short slices, and one change.
    #[test]
    fn a_long_ring_is_mended_in_slices() {
        const W: f64 = 0.125;
        let wall = |k: u32| Columns::new(&[W * (8.0 + 0.4 * f64::from(k % 7) / 7.0)], W, false);
        let mut columns: Vec<Columns> = (0..601).map(wall).collect();
        let edge = |edge| PhaseEdge {
            edge,
            walls: [edge, (edge + 1) % 601],
            lines: [1, 0],
        };
        let mut work = RepairWork::new(&columns, (0..601).map(edge).collect(), W);
        let mut slices = 0;
        let (changes, plan) = loop {
            slices += 1;
            if let Some(found) = work.advance(&mut columns) {
                break found;
            }
        };
        // The first of the widest walls gets the column.
        let change = Change {
            wall: 6,
            interval: 0,
            by: 1,
        };
        assert_eq!((changes, plan.conflicts.len()), (vec![change], 0));
        assert!(slices > 6, "{slices} slices");
    }
}
