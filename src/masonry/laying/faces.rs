//! Bricks on faces, clipped to the free space.

use super::bricks::BrickBond;
use super::cell::{CellDraft, CellSort, Feature};
use super::site::Site;
use super::work::SiteWork;
use crate::building::{Bend, FaceId, Piece, Stance};
use crate::masonry::block::Polyhedron;
use crate::masonry::footprint::Footprint;
use crate::masonry::free_space::{LEAST_SHARE, TOUCH, remainder};
use crate::masonry::grid_place::GridPlace;
use crate::masonry::occupancy::Coverage;
use crate::masonry::plan::{FaceGrid, is_wall};
use crate::masonry::tree::GeneratorNode;
use glam::DVec2;

/// A brick is a sliver if its free area is less than this share of half a brick.
const SLIVER: f64 = 0.35;
/// Smaller gaps stay mortar (square metres).
const LEAST_GAP: f64 = 5e-4;
/// A brick is whole if its area over that of its place in the grid lies in this range.
const WHOLE: std::ops::RangeInclusive<f64> = 0.97..=1.15;

/// A brick of a face's grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct GridBrick {
    /// The space that it may fill.
    pub place: GridPlace,
    /// The area of its own place in the grid (square metres).
    pub area: f64,
    /// Whether it takes two columns.
    pub is_pair: bool,
}

impl GridBrick {
    /// The area of a brick of two columns (square metres).
    pub fn pair_area(&self) -> f64 {
        self.area * if self.is_pair { 1.0 } else { 2.0 }
    }
}

/// Fills a face with bricks, row by row.
pub(super) struct BrickWork {
    id: FaceId,
    node: GeneratorNode,
    bond: BrickBond,
    /// The numbers of bricks in each of the two phases, while they are counted; none once bricks are laid.
    counts: Option<[usize; 2]>,
    shift: usize,
    /// The next row.
    row: usize,
}

impl BrickWork {
    pub fn new(site: &Site, id: FaceId, node: &GeneratorNode, bond: BrickBond) -> Self {
        let face = site.face(id);
        let has_phase = is_wall(face)
            && face.loops.iter().flatten().any(|walk| {
                let edge = site.edge(walk.edge);
                edge.is_vertical() && edge.bend == Bend::Convex
            });
        Self {
            id,
            node: node.clone(),
            bond,
            counts: (!has_phase).then_some([0; 2]),
            shift: 0,
            row: 0,
        }
    }
}

impl SiteWork for BrickWork {
    /// Counts or lays a row. A face that gets no phase from an edge takes the phase with fewer bricks (section 5.2).
    fn advance(&mut self, site: &mut Site) -> bool {
        let row = self.row;
        match &mut self.counts {
            Some(counts) => {
                for (shift, count) in counts.iter_mut().enumerate() {
                    *count += site.free_bricks(self.id, &self.bond, (row, shift));
                }
            }
            None => site.brick_row(self.id, &self.node, &self.bond, (row, self.shift)),
        }
        self.row += 1;
        if self.row < site.plan.grid(self.id).row_lines().len() - 1 {
            return false;
        }
        match self.counts.take() {
            Some([plain, shifted]) => {
                (self.shift, self.row) = (usize::from(shifted < plain), 0);
                false
            }
            None => true,
        }
    }
}

impl Site {
    /// How deep cells of a face reach into the wall: a module at a wall, a course below a level face, and no more than
    /// half of the wall.
    pub fn depth(&self, face: FaceId) -> f64 {
        let module = self.plan.module;
        let grid = self.plan.grid(face);
        let depth = if grid.stance == Stance::Level {
            module.course
        } else {
            module.half
        };
        depth.min(grid.depth)
    }

    /// Whether a place of a face is free by exact areas: obstacles cover less than a hundredth of it.
    pub fn is_free(&self, face: FaceId, place: &Footprint) -> bool {
        let map = &self.faces[face.index()];
        let obstacles = map.obstacles(place);
        let covered: f64 = obstacles
            .iter()
            .map(|obstacle| obstacle.shared_area(place))
            .sum();
        covered < 0.01 * place.area()
    }

    /// The cell below a footprint of a face, `depth` deep (metres).
    pub fn face_draft(
        &self,
        face: FaceId,
        footprint: &Footprint,
        depth: f64,
        sort: CellSort,
    ) -> CellDraft {
        let body = Polyhedron::prism(footprint, [-depth, 0.0], [0.0; 2], |place, z| {
            self.at(face, place, z)
        });
        CellDraft::new(sort, body, self.normal(face, footprint.centre()))
    }

    /// Lays a row of bricks on a face.
    fn brick_row(
        &mut self,
        id: FaceId,
        node: &GeneratorNode,
        bond: &BrickBond,
        at: (usize, usize),
    ) {
        let mut bricks = self.without_slivers(id, self.row_bricks(id, bond, at));
        if bond.are_paired() {
            bricks = self.evened(id, bricks);
        }
        for brick in bricks {
            let sort = if brick.is_pair || !bond.are_paired() {
                bond.sort
            } else {
                CellSort::Half
            };
            self.face_brick(id, node, (&brick.place, brick.area), sort);
        }
        let is_level = self.plan.grid(id).stance == Stance::Level;
        if is_level && (self.is_oblique(id) || self.is_round(id)) {
            self.fill_gaps(id, node, at.0);
        }
    }

    /// Whether a flat face has an arc for a border, as the lid of a tower.
    fn is_round(&self, id: FaceId) -> bool {
        let face = self.face(id);
        let mut edges = face.loops.iter().flatten();
        face.surface.is_flat()
            && edges.any(|walk| {
                let mut pieces = self.edge(walk.edge).path.pieces().iter();
                pieces.any(|piece| matches!(piece, Piece::Arc(_)))
            })
    }

    /// Lays pieces in the gaps that cut bricks leave in a row of a level face: beside the oblique sides of blocks on
    /// its corners and edges, and along arcs.
    fn fill_gaps(&mut self, id: FaceId, node: &GeneratorNode, row: usize) {
        let grid = self.plan.grid(id);
        let last = grid.column_lines().len() - 1;
        let [low, high] = grid.block([0, last], [row, row + 1]);
        let Some(strip) = Footprint::rectangle(low, high) else {
            return;
        };
        for gap in self.faces[id.index()].gaps_in(&strip) {
            let area = gap.area();
            if area > LEAST_GAP {
                self.face_part(id, node, &gap, (&gap, area, CellSort::Raked));
            }
        }
    }

    /// The bricks of a row without slivers: the neighbour with more free area takes the place of a sliver as well.
    fn without_slivers(&self, id: FaceId, mut bricks: Vec<GridBrick>) -> Vec<GridBrick> {
        let least = SLIVER * self.plan.module.half * self.plan.module.course;
        let free: Vec<f64> = bricks
            .iter()
            .map(|brick| self.free_area(id, &brick.place))
            .collect();
        let is_sliver = |k: usize| (TOUCH..least).contains(&free[k]);
        let mut taken = Vec::new();
        for k in (0..bricks.len()).filter(|&k| is_sliver(k)) {
            let beside = [k.checked_sub(1), Some(k + 1)].into_iter().flatten();
            let beside = beside.filter(|&j| j < bricks.len());
            let wider = beside.reduce(|a, b| if free[b] > free[a] { b } else { a });
            if let Some(j) = wider.filter(|&j| free[j] >= least)
                && let Some(place) = bricks[j].place.with(&bricks[k].place)
            {
                bricks[j].place = place;
                taken.push(k);
            }
        }
        for k in taken.into_iter().rev() {
            bricks.remove(k);
        }
        bricks
    }

    /// Whether so little of a place on a wall is free that no stone should be cut to it alone.
    pub fn is_sliver(&self, id: FaceId, place: &GridPlace) -> bool {
        let least = SLIVER * self.plan.module.half * self.plan.module.course;
        is_wall(self.face(id)) && (TOUCH..least).contains(&self.free_area(id, place))
    }

    /// The area of a place on a face that is free, exactly (square metres).
    fn free_area(&self, id: FaceId, place: &GridPlace) -> f64 {
        let place = self.home_place(id, *place);
        let map = &self.faces[id.index()];
        match map.coverage_of(&place) {
            Coverage::Occupied => 0.0,
            Coverage::Free => place.area(),
            Coverage::Partly => {
                let whole = place.footprint();
                let parts = remainder(&whole, &map.obstacles(&whole));
                parts.iter().map(Footprint::area).sum()
            }
        }
    }

    /// Lays a brick on a face, clipped to the free space. `area` is that of a brick that is not cut (square metres).
    pub fn face_brick(
        &mut self,
        id: FaceId,
        node: &GeneratorNode,
        (place, area): (&GridPlace, f64),
        sort: CellSort,
    ) {
        let place = self.home_place(id, *place);
        if self.faces[id.index()].coverage_of(&place) == Coverage::Occupied {
            return;
        }
        let whole = place.footprint();
        for part in self.laid_parts(id, &whole) {
            self.face_part(id, node, &part, (&whole, area, sort));
        }
    }

    /// Whether long sides of a face run across its grid. There the single cuts of a brick leave gaps, and it is cut
    /// into several parts.
    pub(super) fn is_oblique(&self, id: FaceId) -> bool {
        !self.slopes[id.index()].is_empty()
    }

    /// Whether a part of a brick has a side along a slope of its face.
    fn is_raked(&self, id: FaceId, part: &Footprint) -> bool {
        let is_along = |k: usize, slope: DVec2| {
            let [a, b] = part.side(k);
            (b - a).normalize_or_zero().perp_dot(slope).abs() < 1e-3
        };
        let mut slopes = self.slopes[id.index()].iter();
        slopes.any(|&slope| (0..part.corners().len()).any(|k| is_along(k, slope)))
    }

    /// Lays the part of a brick that is left of its whole place.
    fn face_part(
        &mut self,
        id: FaceId,
        node: &GeneratorNode,
        part: &Footprint,
        (whole, area, sort): (&Footprint, f64, CellSort),
    ) {
        let share = part.area() / area;
        let is_half = (share - 0.5).abs() < 0.03 && part.corners().len() == 4;
        let sort = match sort {
            _ if share < 0.97 && self.is_raked(id, part) => CellSort::Raked,
            CellSort::Whole if is_half => CellSort::Half,
            _ if !WHOLE.contains(&share) => CellSort::Cut,
            sort => sort,
        };
        let depth = self.depth(id);
        let mut draft = self.face_draft(id, part, depth, sort);
        draft.unclipped = (share < *WHOLE.start()).then(|| Box::new(whole.clone()));
        if let Some(body) = self.mitred(id, draft.claimed, depth) {
            draft.claimed = body;
            self.place(Feature::Face(id), node, draft);
        }
    }

    /// The number of bricks in a row of a face's grid, without those of edges, and the number of these that are cut.
    pub fn row_pieces(&self, id: FaceId, row: usize, shift: usize) -> [usize; 2] {
        let bricks = self.row_bricks(id, &BrickBond::BRICKS, (row, shift));
        if self.is_clear(id, row) {
            return [bricks.len(), 0];
        }
        let shares = bricks
            .iter()
            .map(|brick| self.free_area(id, &brick.place) / brick.area);
        let there = shares.filter(|&share| share > LEAST_SHARE);
        let is_cut = |share: f64| share < 0.97 && (share - 0.5).abs() > 0.03;
        there.fold([0, 0], |[all, cut], share| {
            [all + 1, cut + usize::from(is_cut(share))]
        })
    }

    /// Whether a row is free along its whole length. False for rows of a whole cylinder, which are not looked at.
    fn is_clear(&self, id: FaceId, row: usize) -> bool {
        let grid = self.plan.grid(id);
        let last = grid.column_lines().len() - 1;
        let [low, high] = grid.block([0, last], [row, row + 1]);
        let strip = GridPlace::new(low, high);
        let strip = strip.filter(|_| self.face(id).surface.period().is_none());
        let bitmap = self.faces[id.index()].bitmap();
        strip.is_some_and(|strip| bitmap.is_empty_under(&strip))
    }

    /// The number of bricks in a row of a face's grid whose places are free at least in part.
    fn free_bricks(&self, id: FaceId, bond: &BrickBond, at: (usize, usize)) -> usize {
        let map = &self.faces[id.index()];
        let bricks = self.row_bricks(id, bond, at).into_iter();
        let is_free = |brick: &GridBrick| {
            map.coverage_of(&self.home_place(id, brick.place)) != Coverage::Occupied
        };
        bricks.filter(is_free).count()
    }

    /// The length after which the columns of a face's rows come back, on a whole cylinder (metres).
    pub fn grid_period(&self, id: FaceId) -> Option<f64> {
        let period = self.face(id).surface.period();
        period.filter(|_| !self.plan.grid(id).are_rows_along_s())
    }

    /// The bricks of a row of a face's grid, with the bond shifted by `shift` columns.
    fn row_bricks(
        &self,
        id: FaceId,
        bond: &BrickBond,
        (row, shift): (usize, usize),
    ) -> Vec<GridBrick> {
        let grid = self.plan.grid(id);
        let period = self.grid_period(id);
        let columns = grid.column_lines().len() as isize - 1;
        let mut found = Vec::new();
        for column in -1..columns {
            let is_first = !bond.are_paired() || grid.starts(column, row + shift);
            if !is_first || (period.is_some() || !bond.are_paired()) && column < 0 {
                continue;
            }
            let last = column + if bond.are_paired() { 2 } else { 1 };
            let end = if period.is_some() {
                last
            } else {
                last.min(columns)
            };
            let start = column.max(0);
            let place = wrapped(grid, [start as usize, end as usize], [row, row + 1], period);
            found.extend(place.map(|place| GridBrick {
                area: place.area(),
                place,
                is_pair: end - start == 2,
            }));
        }
        found
    }
}

/// The rectangle of some columns and rows; on a whole cylinder the last column may be one of the next turn.
pub(super) fn wrapped(
    grid: &FaceGrid,
    [from, to]: [usize; 2],
    rows: [usize; 2],
    period: Option<f64>,
) -> Option<GridPlace> {
    let last = grid.column_lines().len() - 1;
    let [low, mut high] = grid.block([from, to.min(last)], rows);
    if let (Some(period), true) = (period, to > last) {
        high.x = grid.s[to - last] + period;
    }
    GridPlace::new(low, high)
}
