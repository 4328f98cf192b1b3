//! Bricks on faces, clipped to the free space.

use super::bricks::BrickBond;
use super::cell::{CellDraft, CellSort, Feature};
use super::site::Site;
use crate::building::{Bend, FaceId, Stance};
use crate::masonry::block::Polyhedron;
use crate::masonry::footprint::Footprint;
use crate::masonry::free_space::{LEAST_SHARE, MOST_DEPTH, clip, clip_multi};
use crate::masonry::occupancy::Coverage;
use crate::masonry::plan::{FaceGrid, is_wall};
use crate::masonry::tree::GeneratorNode;
use glam::DVec2;

/// Sides of a face longer than this are no chords of an arc (metres).
const OBLIQUE: f64 = 0.2;

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

    /// Whether a place of a face is free, exactly.
    pub fn is_free(&self, face: FaceId, place: &Footprint) -> bool {
        let map = &self.faces[face.index()];
        let obstacles = map.obstacles(place);
        let covered: f64 = obstacles
            .iter()
            .map(|obstacle| obstacle.shared_area(place))
            .sum();
        covered < 0.01 * place.area()
    }

    /// The cell on a footprint of a face.
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

    /// Fills a face with bricks.
    pub fn brick_face(&mut self, id: FaceId, node: &GeneratorNode, bond: &BrickBond) {
        let has_phase = is_wall(self.face(id))
            && self.face(id).loops.iter().flatten().any(|walk| {
                let edge = self.edge(walk.edge);
                edge.is_vertical() && edge.bend == Bend::Convex
            });
        let shift = if has_phase {
            0
        } else {
            self.better_shift(id, bond)
        };
        for (place, is_pair) in self.face_bricks(id, bond, shift) {
            let sort = if is_pair || !bond.are_paired() {
                bond.sort
            } else {
                CellSort::Half
            };
            self.face_brick(id, node, &place, sort);
        }
    }

    /// Lays a brick on a face, clipped to the free space.
    pub fn face_brick(
        &mut self,
        id: FaceId,
        node: &GeneratorNode,
        place: &Footprint,
        sort: CellSort,
    ) {
        let place = &self.home(id, place.clone());
        let map = &self.faces[id.index()];
        if map.coverage(place) == Coverage::Occupied {
            return;
        }
        let obstacles = map.obstacles(place);
        let inset = 0.5 * self.plan.module.joint;
        let parts = match self.is_oblique(id) {
            true => clip_multi(place, &obstacles, inset, (LEAST_SHARE, MOST_DEPTH)),
            false => clip(place, &obstacles, inset, LEAST_SHARE)
                .into_iter()
                .collect(),
        };
        for part in parts {
            self.face_part(id, node, &part, (part.area() / place.area(), sort));
        }
    }

    /// Whether long sides of a face run across its grid. There the single cuts of a brick leave gaps, and it is cut
    /// into several parts.
    fn is_oblique(&self, id: FaceId) -> bool {
        self.slopes(id).next().is_some()
    }

    /// The directions of the long sides of a face that run across its grid.
    fn slopes(&self, id: FaceId) -> impl Iterator<Item = DVec2> + '_ {
        let ways = self.regions[id.index()].sides().map(|[a, b]| b - a);
        let is_oblique = |way: &DVec2| {
            let size = way.abs();
            size.min_element() > 0.1 * size.max_element() && way.length() > OBLIQUE
        };
        ways.filter(is_oblique).map(DVec2::normalize)
    }

    /// Whether a part of a brick has a side along a slope of its face.
    fn is_raked(&self, id: FaceId, part: &Footprint) -> bool {
        let is_along = |k: usize, slope: DVec2| {
            let [a, b] = part.side(k);
            (b - a).normalize_or_zero().perp_dot(slope).abs() < 1e-3
        };
        let mut slopes = self.slopes(id);
        slopes.any(|slope| (0..part.corners().len()).any(|k| is_along(k, slope)))
    }

    /// Lays a part of a brick, which has this share of the whole.
    fn face_part(
        &mut self,
        id: FaceId,
        node: &GeneratorNode,
        part: &Footprint,
        (share, sort): (f64, CellSort),
    ) {
        let is_half = (share - 0.5).abs() < 0.03 && part.corners().len() == 4;
        let sort = match sort {
            _ if share < 0.97 && self.is_raked(id, part) => CellSort::Raked,
            CellSort::Whole if is_half => CellSort::Half,
            _ if share < 0.97 => CellSort::Cut,
            sort => sort,
        };
        let depth = self.depth(id);
        let mut draft = self.face_draft(id, part, depth, sort);
        if let Some(body) = self.mitred(id, draft.claimed, depth) {
            draft.claimed = body;
            self.place(Feature::Face(id), node, draft);
        }
    }

    /// The phase of a face that no edge decides: the one that makes fewer bricks (section 5.2).
    fn better_shift(&self, id: FaceId, bond: &BrickBond) -> usize {
        let map = &self.faces[id.index()];
        let count = |shift: usize| {
            let bricks = self.face_bricks(id, bond, shift).into_iter();
            bricks
                .filter(|(place, _)| {
                    map.coverage(&self.home(id, place.clone())) != Coverage::Occupied
                })
                .count()
        };
        usize::from(count(1) < count(0))
    }

    /// The places of all bricks of a face's grid, and whether each is a pair of cells of the grid.
    fn face_bricks(&self, id: FaceId, bond: &BrickBond, shift: usize) -> Vec<(Footprint, bool)> {
        let grid = self.plan.grid(id);
        let period = self
            .face(id)
            .surface
            .period()
            .filter(|_| !grid.are_rows_along_s());
        let columns = grid.column_lines().len() as isize - 1;
        let mut found = Vec::new();
        for row in 0..grid.row_lines().len() - 1 {
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
                let place = wrapped(grid, [start as usize, end as usize], row, period);
                found.extend(place.map(|place| (place, end - start == 2)));
            }
        }
        found
    }
}

/// The rectangle of some columns in a row; on a whole cylinder the last column may be one of the next turn.
fn wrapped(
    grid: &FaceGrid,
    [from, to]: [usize; 2],
    row: usize,
    period: Option<f64>,
) -> Option<Footprint> {
    let last = grid.column_lines().len() - 1;
    let [low, mut high] = grid.block([from, to.min(last)], [row, row + 1]);
    if let (Some(period), true) = (period, to > last) {
        high.x = grid.s[to - last] + period;
    }
    Footprint::rectangle(low, high)
}
