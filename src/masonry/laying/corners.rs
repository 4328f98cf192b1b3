//! Cells at corners: bricks that show three faces, and bricks off the corners of openings.

use super::bricks::BrickBond;
use super::cell::{CellSort, Feature};
use super::run::{NEAR, Run, unit};
use super::site::Site;
use crate::building::{Bend, CornerId, FaceId};
use crate::masonry::footprint::Footprint;
use crate::masonry::plan::is_wall;
use crate::masonry::tree::GeneratorNode;
use glam::DVec2;

/// How far from a corner its quadrants are probed (metres).
const PROBE: f64 = 0.02;

/// A corner's place on a wall, and which of its four quadrants lie in the wall.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadrants {
    pub face: FaceId,
    pub place: DVec2,
    inside: [bool; 4],
}

const QUADRANTS: [DVec2; 4] = [
    DVec2::new(1.0, 1.0),
    DVec2::new(-1.0, 1.0),
    DVec2::new(-1.0, -1.0),
    DVec2::new(1.0, -1.0),
];

impl Quadrants {
    pub fn count(&self) -> usize {
        self.inside.iter().filter(|&&inside| inside).count()
    }

    /// The quadrant opposite the only one that is outside.
    pub fn opposite_the_gap(&self) -> Option<DVec2> {
        let gap = self.inside.iter().position(|&inside| !inside)?;
        (self.count() == 3).then(|| -QUADRANTS[gap])
    }

    /// The only quadrant inside.
    pub fn single(&self) -> Option<DVec2> {
        let only = self.inside.iter().position(|&inside| inside)?;
        (self.count() == 1).then(|| QUADRANTS[only])
    }
}

impl Site {
    /// The quadrants of a corner on each wall around it.
    pub fn quadrants(&self, id: CornerId) -> Vec<Quadrants> {
        let p = self.building.place(id);
        let mut faces: Vec<FaceId> = self
            .building
            .corner(id)
            .faces
            .iter()
            .flatten()
            .copied()
            .collect();
        faces.sort_unstable();
        faces.dedup();
        let walls = faces.into_iter().filter(|&face| is_wall(self.face(face)));
        walls
            .map(|face| {
                let place = self.face(face).surface.project(p).truncate();
                let region = &self.regions[face.index()];
                let period = self.face(face).surface.period();
                let inside = QUADRANTS.map(|way| {
                    let q = place + PROBE * way;
                    let images =
                        [0.0, -1.0, 1.0].map(|turn| q + DVec2::X * turn * period.unwrap_or(0.0));
                    images.iter().any(|&q| region.contains(q))
                });
                Quadrants {
                    face,
                    place,
                    inside,
                }
            })
            .collect()
    }

    /// Lays the cell of a corner.
    pub fn brick_corner(&mut self, id: CornerId, node: &GeneratorNode, bond: &BrickBond) {
        let quadrants = self.quadrants(id);
        let rim = quadrants
            .iter()
            .find_map(|found| Some((found.face, found.place, found.opposite_the_gap()?)));
        if let Some((face, place, way)) = rim {
            self.rim_brick(id, node, bond, (face, place, way));
        } else {
            self.corner_brick(id, node, bond, &quadrants);
        }
    }

    /// A block in the wall, diagonally off the corner of an opening; paired along its row if the partner's place is
    /// free. The corner's bit pairs it with the block on its other side.
    fn rim_brick(
        &mut self,
        id: CornerId,
        node: &GeneratorNode,
        bond: &BrickBond,
        (face, place, way): (FaceId, DVec2, DVec2),
    ) {
        let (columns, rows) = (self.lines(face, true), self.lines(face, false));
        let column = unit(&columns, place.x, way.x);
        let row = unit(&rows, place.y, way.y);
        let (Some(column), Some(row)) = (column, row) else {
            return;
        };
        let grid = self.plan.grid(face);
        let turns = if self.face(face).surface.period().is_some() {
            grid.s.len() - 1
        } else {
            0
        };
        let shift = usize::from(self.building.corner(id).flip);
        let first = if grid.starts(column as isize - turns as isize, row + shift) {
            column as isize
        } else {
            column as isize - 1
        };
        let rectangle = |from: usize, to: usize| {
            Footprint::rectangle(
                DVec2::new(columns[from], rows[row]),
                DVec2::new(columns[to], rows[row + 1]),
            )
        };
        let pair = (bond.are_paired()
            && bond.extrude == 0.0
            && first >= 0
            && first as usize + 2 < columns.len())
        .then(|| rectangle(first as usize, first as usize + 2))
        .flatten()
        .filter(|pair| self.is_free(face, pair));
        let single = rectangle(column, column + 1).filter(|block| self.is_free(face, block));
        let is_whole = pair.is_some();
        let Some(block) = pair.or(single) else { return };
        let depth = self.depth(face);
        let sort = match (is_whole, bond.are_paired()) {
            _ if bond.extrude > 0.0 => CellSort::Sill,
            (true, _) | (_, false) => bond.sort,
            (false, true) => CellSort::Half,
        };
        let mut draft = self.face_draft(face, &block, depth, sort);
        draft.extrude = bond.extrude;
        self.place(Feature::Corner(id), node, draft);
    }

    /// The end of the edge between two walls: a brick that shows three faces.
    fn corner_brick(
        &mut self,
        id: CornerId,
        node: &GeneratorNode,
        bond: &BrickBond,
        quadrants: &[Quadrants],
    ) {
        let Some((run, at_end)) = self.corner_run(id, quadrants) else {
            return;
        };
        let intervals = self.intervals(&run);
        let interval = if at_end {
            intervals.last()
        } else {
            intervals.first()
        };
        let free = interval.and_then(|&(row, span)| Some((row, self.free_part(&run, span)?)));
        if let Some((row, span)) = free {
            self.edge_brick(Feature::Corner(id), node, bond, (&run, row, span));
        }
    }

    /// The upright run between two walls that ends at a corner, and whether the corner is at its end.
    pub fn corner_run(&self, id: CornerId, quadrants: &[Quadrants]) -> Option<(Run, bool)> {
        let walls: Vec<FaceId> = quadrants
            .iter()
            .filter(|found| found.single().is_some())
            .map(|found| found.face)
            .collect();
        let p = self.building.place(id);
        let edges = self.building.corner(id).edges.iter().map(|end| end.edge);
        let runs = edges.filter(|&edge| {
            let edge = self.edge(edge);
            edge.bend == Bend::Convex
                && edge.faces.iter().flatten().all(|face| walls.contains(face))
        });
        runs.flat_map(|edge| self.runs(edge))
            .filter(|run| run.is_upright)
            .find_map(|run| {
                let path = &self.edge(run.edge).path;
                let end = run
                    .ends
                    .iter()
                    .position(|&at| path.point(at).distance(p) < NEAR)?;
                Some((run, end == 1))
            })
    }
}
