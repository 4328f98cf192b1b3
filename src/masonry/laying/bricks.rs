//! Bricks at edges: running bond that turns corners (Legakis, Dorsey, Gortler 2001, section 5.2, Bricks). RGB Blocks
//! and the rows of window bottoms are laid by the same rules.

use super::cell::{CellDraft, CellSort, Feature};
use super::run::{NEAR, Run, unit};
use super::site::Site;
use crate::building::{EdgeId, FaceId};
use crate::masonry::tree::GeneratorNode;

/// The deepest sill that one header covers, in modules.
const DEEPEST: f64 = 16.0;

/// The bond: how many columns cells take.
#[derive(Clone, Copy, Debug)]
pub(super) struct BrickBond {
    /// Columns that an edge's cell reaches into the face along which it lies.
    pub long: usize,
    /// Columns that this cell reaches into the other face.
    pub short: usize,
    /// The sort of a cell that is not cut.
    pub sort: CellSort,
    /// How far cells of window bottoms stand out (metres).
    pub extrude: f64,
    /// Whether the edges' bits alone decide which way bricks point.
    pub is_by_hand: bool,
}

impl BrickBond {
    pub const BRICKS: Self = Self {
        long: 2,
        short: 1,
        sort: CellSort::Whole,
        extrude: 0.0,
        is_by_hand: false,
    };
    pub const BLOCKS: Self = Self {
        long: 1,
        sort: CellSort::Stone,
        ..Self::BRICKS
    };

    pub fn are_paired(&self) -> bool {
        self.long == 2
    }
}

impl Site {
    /// Lays the cells of an edge.
    pub fn brick_edge(&mut self, id: EdgeId, node: &GeneratorNode, bond: &BrickBond) {
        self.upright_bricks(id, node, bond);
        for run in self.runs(id).into_iter().filter(|run| !run.is_upright) {
            self.level_bricks(id, node, bond, &run);
        }
    }

    /// Lays the cells of an edge's upright parts, one in each course.
    pub fn upright_bricks(&mut self, id: EdgeId, node: &GeneratorNode, bond: &BrickBond) {
        for run in self.runs(id).into_iter().filter(|run| run.is_upright) {
            for (row, span) in self.intervals(&run) {
                if let Some(span) = self.free_part(&run, span) {
                    self.edge_brick(Feature::Edge(id), node, bond, (&run, row, span));
                }
            }
        }
    }

    /// The free part of an interval of a run around its middle; none if it is a quarter of the interval or less.
    pub fn free_part(&self, run: &Run, [from, to]: [f64; 2]) -> Option<[f64; 2]> {
        let middle = 0.5 * (from + to);
        let mut free = self.free(run).into_iter();
        let part = free.find(|[a, b]| *a < middle && middle < *b)?;
        let part = [part[0].max(from), part[1].min(to)];
        (part[1] - part[0] > 0.25 * (to - from)).then_some(part)
    }

    /// A brick of an upright edge: it lies along one of the two faces, which alternate by rows.
    pub fn edge_brick(
        &mut self,
        feature: Feature,
        node: &GeneratorNode,
        bond: &BrickBond,
        (run, row, span): (&Run, usize, [f64; 2]),
    ) {
        let long = self.turned(feature, self.long_side(run, row, bond.is_by_hand));
        let counts = [0, 1].map(|side| if side == long { bond.long } else { bond.short });
        let middle = 0.5 * (span[0] + span[1]);
        let reaches = [0, 1].map(|side| self.limited_reach(run, side, counts[side], middle));
        let reaches = self.fitted(run, span, reaches);
        let body = self.edge_body(run, span, reaches);
        let is_short = reaches[0].max(reaches[1]) < 1.5 * self.plan.module.half;
        let sort = if bond.are_paired() && is_short {
            CellSort::Half
        } else {
            bond.sort
        };
        let outwards = self.edge_outwards(run, middle);
        self.place(feature, node, CellDraft::new(sort, body, outwards));
    }

    /// The side of a run whose face shows the stretcher in a row of the first side's wall.
    pub fn long_side(&self, run: &Run, row: usize, is_by_hand: bool) -> usize {
        let flip = usize::from(self.edge(run.edge).flip);
        if is_by_hand {
            return (row + flip + usize::from(run.is_swapped)) % 2;
        }
        let wall = &run.sides[0];
        let grid = self.plan.grid(wall.face);
        let shown = if self.plan.conflicts.contains(&run.edge) {
            (row + grid.first_course) % 2
        } else {
            usize::from(!grid.starts(wall.line() as isize - self.turn(wall.face), row))
        };
        (shown + flip) % 2
    }

    /// The long side of a feature's cell: the bit stored with a corner turns the corner's own cell.
    pub fn turned(&self, feature: Feature, long: usize) -> usize {
        match feature {
            Feature::Corner(id) => (long + usize::from(self.building.corner(id).flip)) % 2,
            _ => long,
        }
    }

    /// The number of columns in the period of a whole cylinder, on which [`Self::lines`] begin a period early; 0 on
    /// other faces.
    pub fn turn(&self, face: FaceId) -> isize {
        let is_closed = self.face(face).surface.period().is_some();
        if is_closed {
            self.plan.grid(face).s.len() as isize - 1
        } else {
            0
        }
    }

    /// Bricks along a level edge, in the wall's own bond, one course high. The edge's bit moves them by half a brick.
    fn level_bricks(&mut self, id: EdgeId, node: &GeneratorNode, bond: &BrickBond, run: &Run) {
        let wall = &run.sides[0];
        let Some(row) = unit(&wall.lines, wall.start, wall.way) else {
            return;
        };
        let row = row + usize::from(self.edge(id).flip);
        let intervals = self.intervals(run);
        for [from, to] in self.free(run) {
            let inner = intervals.iter().filter_map(|&(column, [a, b])| {
                let (a, b) = (a.max(from), b.min(to));
                (b - a > NEAR).then_some((column, [a, b]))
            });
            let inner: Vec<(usize, [f64; 2])> = inner.collect();
            for span in self.paired(wall.face, row, &inner, bond) {
                self.level_brick(id, node, bond, (run, span));
            }
        }
    }

    /// Joins pairs of neighbouring intervals that make a brick of a row. Each is returned with whether it is a pair.
    fn paired(
        &self,
        face: FaceId,
        row: usize,
        intervals: &[(usize, [f64; 2])],
        bond: &BrickBond,
    ) -> Vec<([f64; 2], bool)> {
        let grid = self.plan.grid(face);
        let mut found: Vec<([f64; 2], bool)> = Vec::new();
        let mut last: Option<usize> = None;
        for &(column, [from, to]) in intervals {
            // The brick that this column belongs to is numbered by its first column.
            let number = column as isize - self.turn(face);
            let first = if grid.starts(number, row) {
                number
            } else {
                number - 1
            };
            let brick = (first + 2 * self.turn(face) + 2) as usize;
            match found.last_mut() {
                Some((span, is_pair)) if bond.are_paired() && last == Some(brick) => {
                    (span[1], *is_pair) = (to, true);
                }
                _ => found.push(([from, to], false)),
            }
            last = Some(brick);
        }
        found
    }

    fn level_brick(
        &mut self,
        id: EdgeId,
        node: &GeneratorNode,
        bond: &BrickBond,
        (run, (span, is_pair)): (&Run, ([f64; 2], bool)),
    ) {
        let middle = 0.5 * (span[0] + span[1]);
        let height = self.limited_reach(run, 0, 1, middle);
        let depth = self
            .limited_depth(run, run.sides[1].reach(1), middle)
            .min(self.depth(run.sides[0].face));
        let reaches = [height, depth];
        let body = self.edge_body(run, span, self.fitted(run, span, reaches));
        let sort = if bond.are_paired() && !is_pair {
            CellSort::Half
        } else {
            bond.sort
        };
        let outwards = self.edge_outwards(run, middle);
        self.place(
            Feature::Edge(id),
            node,
            CellDraft::new(sort, body, outwards),
        );
    }

    /// A row of headers along the bottom of a window, as deep as its sill (section 5.2, Window Bottom Bricks).
    pub fn sill_edge(&mut self, id: EdgeId, node: &GeneratorNode) {
        let module = self.plan.module.half;
        for run in self.runs(id).into_iter().filter(|run| !run.is_upright) {
            for span in self.level_spans(&run, module) {
                let (body, outwards) = self.level_body(&run, span, DEEPEST * module);
                let mut draft = CellDraft::new(CellSort::Sill, body, outwards);
                draft.extrude = node.number("extrude");
                self.place(Feature::Edge(id), node, draft);
            }
        }
    }
}
