//! Which way the bricks at vertical edges point, and the phases of walls.
//!
//! A wall in running bond has a phase: in row k, a brick starts at column line c if c + k + phase is even. At an edge
//! between two walls, exactly one of them must show the stretcher in each row:
//!
//! `phase(A) xor phase(B) = 1 xor parity(c(A) + c(B))`.
//!
//! Legakis, Dorsey, Gortler (2001), section 5.2, flip the bricks of edges by hand, with a bit for each edge. Here a
//! union-find with parities finds the phases. Where a ring of walls has no solution, [`super::RepairWork`] makes one
//! column more or less.

use super::lines::pieces;

/// A vertical edge between two walls. On each wall it lies at a fixed line, which is given by its number; line 0 is the
/// wall's first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PhaseEdge {
    /// The number of the edge, by which conflicts name it.
    pub edge: u32,
    /// The two walls.
    pub walls: [u32; 2],
    /// The fixed line of the edge on each wall.
    pub lines: [u32; 2],
}

/// The columns of a wall: the widths between its fixed lines, and the pieces of each.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// Distances between one fixed line and the next (metres, above 0).
    pub widths: Vec<f64>,
    /// The number of columns in each interval between fixed lines.
    pub counts: Vec<usize>,
    /// Whether the wall is a whole cylinder, whose number of columns must be even.
    pub is_closed: bool,
}

impl Columns {
    /// The columns of a wall, as near as possible to the width `module` (metres, above 0).
    pub fn new(widths: &[f64], module: f64, is_closed: bool) -> Self {
        let mut columns = Self {
            counts: widths.iter().map(|&width| pieces(width, module)).collect(),
            widths: widths.to_vec(),
            is_closed,
        };
        if is_closed && columns.total() % 2 == 1 {
            columns.make_even(module);
        }
        columns
    }

    /// Adds or removes a column in the interval where this costs least (see [`Self::cost`]).
    fn make_even(&mut self, module: f64) {
        let trials = (0..self.counts.len()).flat_map(|k| [(k, 1isize), (k, -1)]);
        let allowed = trials.filter(|&(k, by)| by > 0 || self.counts[k] > 1);
        let sized = allowed.map(|(k, by)| (self.cost(k, by, module), k, by));
        let best = sized.reduce(|best, next| if next.0 < best.0 { next } else { best });
        if let Some((_, k, by)) = best {
            self.counts[k] = self.counts[k].wrapping_add_signed(by);
        }
    }

    /// |ln(column width / module)| of interval `k` with `by` columns more.
    pub(super) fn cost(&self, k: usize, by: isize, module: f64) -> f64 {
        let count = self.counts[k].wrapping_add_signed(by);
        libm::log(self.widths[k] / (count as f64 * module)).abs()
    }

    /// The number of columns before a fixed line.
    pub fn before(&self, line: u32) -> usize {
        self.counts[..line as usize].iter().sum()
    }

    /// The number of all columns.
    pub fn total(&self) -> usize {
        self.counts.iter().sum()
    }
}

/// A union-find over walls: for each wall its parent in the set, and whether the phases of the two differ.
struct Phases {
    parents: Vec<(u32, bool)>,
}

impl Phases {
    fn new(walls: usize) -> Self {
        Self {
            parents: (0..walls as u32).map(|wall| (wall, false)).collect(),
        }
    }

    /// The root of a wall's set, and whether the phases of the two differ.
    fn root(&mut self, mut wall: u32) -> (u32, bool) {
        let mut odd = false;
        while self.parents[wall as usize].0 != wall {
            let (parent, differs) = self.parents[wall as usize];
            let (above, more) = self.parents[parent as usize];
            // Path halving makes the next search shorter.
            self.parents[wall as usize] = (above, differs ^ more);
            odd ^= differs ^ more;
            wall = above;
        }
        (wall, odd)
    }

    /// Demands that the phases of two walls differ, or that they are equal. False if earlier demands contradict this.
    fn join(&mut self, [a, b]: [u32; 2], differ: bool) -> bool {
        let ((root_a, odd_a), (root_b, odd_b)) = (self.root(a), self.root(b));
        let odd = odd_a ^ odd_b ^ differ;
        if root_a == root_b {
            return !odd;
        }
        // The smaller number becomes the root, so the result does not depend on the order of edges.
        let (low, high) = (root_a.min(root_b), root_a.max(root_b));
        self.parents[high as usize] = (low, odd);
        true
    }
}

/// The phases found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PhasePlan {
    /// The phase of each wall.
    pub phases: Vec<bool>,
    /// For each wall the first wall of its set: the walls whose phases depend on each other.
    pub roots: Vec<u32>,
    /// The numbers of the edges at which the bricks of two walls do not alternate.
    pub conflicts: Vec<u32>,
}

/// Solves the phases of all walls. Each edge that contradicts those before it is a conflict. A set of connected walls
/// has two solutions; the wall with the smallest number has phase 0.
pub fn solve(columns: &[Columns], edges: &[PhaseEdge]) -> PhasePlan {
    let mut phases = Phases::new(columns.len());
    let mut conflicts = Vec::new();
    for edge in edges {
        if !phases.join(edge.walls, differ(columns, edge)) {
            conflicts.push(edge.edge);
        }
    }
    let walls = 0..columns.len() as u32;
    let (roots, phases) = walls.map(|wall| phases.root(wall)).unzip();
    PhasePlan {
        phases,
        roots,
        conflicts,
    }
}

/// Whether the phases at an edge must differ: `1 xor parity(c_A + c_B)`.
fn differ(columns: &[Columns], edge: &PhaseEdge) -> bool {
    let before = |k: usize| columns[edge.walls[k] as usize].before(edge.lines[k]);
    (before(0) + before(1)).is_multiple_of(2)
}

/// The number of edges that contradict those before them.
pub(super) fn count_conflicts(columns: &[Columns], edges: &[PhaseEdge]) -> usize {
    let mut phases = Phases::new(columns.len());
    let contradicts = |edge: &&PhaseEdge| !phases.join(edge.walls, differ(columns, edge));
    edges.iter().filter(contradicts).count()
}

#[cfg(test)]
mod tests {
    use super::super::repair::{Change, RepairWork};
    use super::*;
    use crate::random::{Purpose, Random};

    const W: f64 = 0.125;

    fn repair(columns: &mut [Columns], edges: &[PhaseEdge]) -> (Vec<Change>, PhasePlan) {
        let mut work = RepairWork::new(columns, edges.to_vec(), W);
        loop {
            if let Some(found) = work.advance(columns) {
                return found;
            }
        }
    }

    /// A closed ring of walls: the end of each is the start of the next.
    fn ring(lengths: &[f64]) -> (Vec<Columns>, Vec<PhaseEdge>) {
        let columns = lengths
            .iter()
            .map(|&length| Columns::new(&[length], W, false))
            .collect();
        let count = lengths.len() as u32;
        let edges = (0..count).map(|k| PhaseEdge {
            edge: k,
            walls: [k, (k + 1) % count],
            lines: [1, 0],
        });
        (columns, edges.collect())
    }

    /// Exactly one wall has the stretcher in each row, at each edge that is no conflict.
    fn check(columns: &[Columns], edges: &[PhaseEdge], plan: &PhasePlan) {
        for edge in edges
            .iter()
            .filter(|edge| !plan.conflicts.contains(&edge.edge))
        {
            for row in 0..4 {
                let is_stretcher = |k: usize| {
                    let wall = edge.walls[k] as usize;
                    let at =
                        columns[wall].before(edge.lines[k]) + row + usize::from(plan.phases[wall]);
                    at.is_multiple_of(2)
                };
                assert_ne!(is_stretcher(0), is_stretcher(1), "{edge:?} {row}");
            }
        }
    }

    #[test]
    fn rectilinear_rings_of_whole_modules_never_conflict() {
        let mut random = Random::new(1, Purpose::Scatter, 0);
        for _ in 0..100 {
            let mut side = || (3 + random.below(30)) as f64;
            let [a, b, c, d] = [side(), side(), side(), side()];
            // An L: out and back along both axes.
            let lengths = [a + b, c, b, d, a, c + d].map(|n| n * W);
            let (columns, edges) = ring(&lengths);
            let plan = solve(&columns, &edges);
            assert_eq!(plan.conflicts, [] as [u32; 0]);
            check(&columns, &edges, &plan);
        }
    }

    #[test]
    fn odd_rings_conflict_and_one_change_repairs_them() {
        for count in [3, 5, 7, 9] {
            let (mut columns, edges) = ring(&vec![8.0 * W; count]);
            let plan = solve(&columns, &edges);
            assert_eq!(plan.conflicts.len(), 1);
            check(&columns, &edges, &plan);
            let (changes, plan) = repair(&mut columns, &edges);
            assert_eq!((changes.len(), plan.conflicts.len()), (1, 0));
            check(&columns, &edges, &plan);
            let totals: usize = columns.iter().map(Columns::total).sum();
            assert!(totals.abs_diff(8 * count) == 1);
        }
    }

    #[test]
    fn fractional_walls_are_repaired_where_it_stretches_least() {
        let lengths = [8.5, 8.5, 8.5, 20.45, 8.5].map(|n| n * W);
        let (mut columns, edges) = ring(&lengths);
        assert_eq!(columns[0].counts, [9]);
        let (changes, plan) = repair(&mut columns, &edges);
        assert!(plan.conflicts.is_empty());
        for change in &changes {
            let wall = &columns[change.wall as usize];
            let ratio = wall.widths[0] / (wall.counts[0] as f64 * W);
            assert!((0.95..1.07).contains(&ratio), "{ratio}");
        }
        // Walls of one column cannot be changed; the edge then stays a conflict.
        let (mut single, mut edges) = ring(&[2.0 * W; 3]);
        single.fill(Columns::new(&[W, W], W, false));
        edges.iter_mut().for_each(|edge| edge.lines[0] = 2);
        let (changes, plan) = repair(&mut single, &edges);
        assert_eq!((changes, plan.conflicts), (vec![], vec![2]));
    }

    #[test]
    fn jambs_hang_on_one_edge_and_cylinders_are_even() {
        let (mut columns, mut edges) = ring(&[16.0 * W, 8.0 * W, 16.0 * W, 8.0 * W]);
        columns[0] = Columns::new(&[5.0 * W, 4.0 * W, 7.0 * W], W, false);
        edges[0].lines[0] = 3;
        for (k, line) in [(4, 1), (5, 2)] {
            columns.push(Columns::new(&[3.0 * W], W, false));
            edges.push(PhaseEdge {
                edge: k,
                walls: [0, k],
                lines: [line, 0],
            });
        }
        let plan = solve(&columns, &edges);
        assert!(plan.conflicts.is_empty());
        check(&columns, &edges, &plan);
        let tower = Columns::new(&[20.4 * W, 8.7 * W], W, true);
        assert_eq!(tower.total() % 2, 0);
        assert_eq!(tower.counts, [21, 9]);
    }

    #[test]
    fn the_order_of_edges_does_not_change_phases() {
        let lengths = [5.0, 9.0, 5.0, 9.0].map(|n| n * W);
        let (columns, mut edges) = ring(&lengths);
        let first = solve(&columns, &edges);
        edges.reverse();
        assert_eq!(first.phases, solve(&columns, &edges).phases);
        edges.rotate_left(2);
        edges.iter_mut().for_each(|edge| {
            edge.walls.reverse();
            edge.lines.reverse();
        });
        assert_eq!(first.phases, solve(&columns, &edges).phases);
    }
}
