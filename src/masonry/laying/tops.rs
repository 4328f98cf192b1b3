//! Top corners: two walls meet at right angles below a level face. Their cells are one course high.

use super::bricks::BrickBond;
use super::cell::{CellDraft, CellSort, Feature};
use super::run::{NEAR, RunSide};
use super::site::Site;
use crate::building::{Bend, CornerId, EdgeEnd, FaceId, Piece};
use crate::masonry::block::Polyhedron;
use crate::masonry::footprint::Footprint;
use crate::masonry::tree::GeneratorNode;
use glam::{DVec2, DVec3};

/// Directions whose cosine is less than this are at right angles.
const RIGHT: f64 = 1e-3;
/// The least length of diagonal bricks, in modules.
const LEAST: f64 = 1.4;
/// Diagonal bricks with more room than this, in modules, are as deep as the bricks beside them.
const WIDE: f64 = 1.9;

/// A top corner.
#[derive(Clone, Debug)]
pub(super) struct TopCorner {
    place: DVec3,
    /// Unit vectors along the walls, from the corner.
    ways: [DVec3; 2],
    /// How far cells may reach along each wall (metres): to the end of the level face, or half as far if there is
    /// another top corner.
    rooms: [f64; 2],
    /// The two walls, as the sides of their common edge.
    sides: [RunSide; 2],
    /// The ends of the highest course along the upright edge between the walls (metres).
    span: [f64; 2],
    /// The index in `sides` of the wall that shows a stretcher in this course.
    long: usize,
    top: FaceId,
}

impl TopCorner {
    /// How far a number of columns reaches along each wall, or less if there is less room.
    pub fn reaches(&self, columns: usize) -> [f64; 2] {
        [0, 1].map(|k| self.sides[k].reach(columns).min(self.rooms[k]))
    }

    /// The prism, a course high, below a convex polygon. The polygon's corners are given as distances along both walls
    /// (metres).
    pub fn body(&self, corners: &[DVec2]) -> Polyhedron {
        let place = |p: &DVec2| self.place + self.ways[0] * p.x + self.ways[1] * p.y;
        let mut high: Vec<DVec3> = corners.iter().map(place).collect();
        if self.ways[0].cross(self.ways[1]).y < 0.0 {
            high.reverse();
        }
        let height = self.span[1] - self.span[0];
        let low = high.iter().map(|&p| p - DVec3::Y * height).collect();
        Polyhedron::between(&[low, high])
    }

    /// The outward normals of both walls.
    pub fn fronts(&self) -> [DVec3; 2] {
        [-self.ways[1], -self.ways[0]]
    }
}

impl Site {
    /// The top corner between two flat walls at a corner of the building; none if the corner is of another sort.
    pub fn top_corner(&self, id: CornerId, is_by_hand: bool) -> Option<TopCorner> {
        let corner = self.building.corner(id);
        if (corner.class.valence, corner.class.convex) != (3, 3) {
            return None;
        }
        let (run, at_end) = self.corner_run(id, &self.quadrants(id))?;
        let intervals = self.intervals(&run);
        let course = if at_end {
            intervals.last()
        } else {
            intervals.first()
        };
        let (row, span) = *course?;
        let place = self.building.place(id);
        let lower = self
            .edge(run.edge)
            .path
            .point(run.ends[usize::from(!at_end)]);
        let walls = run.sides.each_ref().map(|side| side.face);
        let mut faces = corner.faces.iter().flatten().copied();
        let top = faces.find(|face| !walls.contains(face))?;
        let [a, b] = walls.map(|wall| self.level_end(id, [wall, top]));
        let ((a, room), (b, other)) = (a?, b?);
        let is_right = a.dot(b).abs() < RIGHT && a.y.abs().max(b.y.abs()) < RIGHT;
        (is_right && lower.y < place.y).then_some(TopCorner {
            place,
            ways: [a, b],
            rooms: [room, other],
            long: self.long_side(&run, row, is_by_hand),
            sides: run.sides,
            span,
            top,
        })
    }

    /// The direction of a corner's straight edge between two faces, and how far the corner's cells may reach along it.
    fn level_end(&self, id: CornerId, faces: [FaceId; 2]) -> Option<(DVec3, f64)> {
        let is_own = |end: &&EdgeEnd| {
            let edge = self.edge(end.edge);
            faces.iter().all(|&face| edge.side(face).is_some())
        };
        let end = self.building.corner(id).edges.iter().find(is_own)?;
        let edge = self.edge(end.edge);
        let [Piece::Line { .. }] = edge.path.pieces() else {
            return None;
        };
        let other = self.building.corner(edge.corners[1 - end.end]?);
        let is_shared = edge.bend == Bend::Convex && other.class.convex == 3;
        let room = if is_shared { 0.5 } else { 1.0 } * edge.length();
        Some((self.building.leaving(*end), room))
    }

    /// Whether nothing lies where cells of these reaches come, neither on the walls nor on the level face.
    pub fn is_top_free(&self, top: &TopCorner, reaches: [f64; 2]) -> bool {
        let on_walls = top.sides.iter().zip(reaches).all(|(side, reach)| {
            let [from, to] = top.span.map(|along| side.at(along));
            let off = side.inwards * reach;
            let place = Footprint::hull(&[from, to, from + off, to + off]);
            place.is_some_and(|place| self.is_free(side.face, &place))
        });
        let surface = &self.face(top.top).surface;
        let [a, b] = [top.ways[0] * reaches[0], top.ways[1] * reaches[1]];
        let corners = [DVec3::ZERO, a, b, a + b].map(|by| surface.project(top.place + by));
        let is_flat = corners.iter().all(|place| place.z.abs() < NEAR);
        let place = Footprint::hull(&corners.map(|place| place.truncate()));
        on_walls && is_flat && place.is_some_and(|place| self.is_free(top.top, &place))
    }

    /// Lays three bricks at the top corner of a step: two meet on the diagonal, and one lies in the angle behind them
    /// (section 5.5, fig. 8c). They are cells of one corner, so that edges need not know of each other. Other corners
    /// get a single brick, as do those of narrow landings.
    pub fn step_corner(&mut self, id: CornerId, node: &GeneratorNode, bond: &BrickBond) {
        let cells = self
            .top_corner(id, bond.is_by_hand)
            .and_then(|top| self.diagonals(&top));
        let Some(cells) = cells else {
            return self.brick_corner(id, node, bond);
        };
        for (body, outwards) in cells {
            let draft = CellDraft::new(CellSort::Special, body, outwards);
            self.place(Feature::Corner(id), node, draft);
        }
    }

    /// The bodies of the three bricks, and where they look; none if there is no room.
    fn diagonals(&self, top: &TopCorner) -> Option<[(Polyhedron, DVec3); 3]> {
        let module = self.plan.module.half;
        let [a, b] = top.reaches(2);
        if a.min(b) < LEAST * module || !self.is_top_free(top, [a, b]) {
            return None;
        }
        let is_wide = a.min(b) > WIDE * module;
        let deep = if is_wide { module } else { 0.5 * a.min(b) };
        // Along the wall with more room the third brick ends where no joint of the wall's own bricks does.
        let along = usize::from(top.rooms[1] > top.rooms[0]);
        let mut ends = [a, b];
        let longer = top.reaches(3);
        if is_wide && top.long == along && self.is_top_free(top, with(ends, along, longer)) {
            ends = with(ends, along, longer);
        }
        let at = DVec2::new;
        let inner = at(deep, deep);
        let [front, side] = top.fronts();
        let cells = [
            ([DVec2::ZERO, at(a, 0.0), at(a, deep), inner], front),
            ([DVec2::ZERO, inner, at(deep, b), at(0.0, b)], side),
            (
                [inner, at(ends[0], deep), ends.into(), at(deep, ends[1])],
                DVec3::Y,
            ),
        ];
        Some(cells.map(|(corners, outwards)| (top.body(&corners), outwards)))
    }
}

/// A pair with its number `k` taken from another pair.
fn with(mut pair: [f64; 2], k: usize, other: [f64; 2]) -> [f64; 2] {
    pair[k] = other[k];
    pair
}
