//! Raking bricks: a row on edge along the slope in which a wall ends.

use super::cell::{CellSort, Feature};
use super::site::Site;
use crate::building::{EdgeId, FaceId, Piece, labels};
use crate::masonry::footprint::{Footprint, HalfPlane};
use crate::masonry::free_space::{LEAST_SHARE, clip};
use crate::masonry::plan::{is_wall, pieces};
use crate::masonry::tree::GeneratorNode;
use glam::DVec2;

/// Ends of slopes nearer than this meet (metres).
const NEAR: f64 = 2e-3;

/// A sloping side of a wall in its (s, t).
#[derive(Clone, Copy, Debug)]
struct Slope {
    ends: [DVec2; 2],
    /// Unit vector into the wall.
    inwards: DVec2,
}

impl Site {
    /// Lays a row of bricks on edge on a wall, along an edge that slopes. The end faces of a roof are not walls. Each
    /// brick is a course wide and half a brick long. Where two slopes meet, the rows end half-way between them.
    pub fn raking_bricks(&mut self, id: EdgeId, node: &GeneratorNode) {
        let walls = self.edge(id).faces.into_iter().flatten();
        let is_own = |face: &FaceId| {
            let face = self.face(*face);
            is_wall(face) && !face.has_label(labels::ROOF)
        };
        let Some(wall) = walls.into_iter().find(is_own) else {
            return;
        };
        let Some(slope) = self.slope(wall, id) else {
            return;
        };
        let ends = self.half_ways(wall, id, &slope);
        let module = self.plan.module;
        let [from, to] = slope.ends;
        let count = pieces(from.distance(to), module.course);
        let off = slope.inwards * module.half;
        for k in 0..count {
            let [a, b] = [k, k + 1].map(|k| from.lerp(to, k as f64 / count as f64));
            let brick = Footprint::hull(&[a, b, b + off, a + off]);
            let inset = 0.5 * module.joint;
            let cut = |brick: Footprint, half: &HalfPlane| brick.clip(*half, inset);
            let brick = brick.and_then(|brick| ends.iter().try_fold(brick, cut));
            if let Some(brick) = brick {
                self.raking_brick(id, node, (wall, &brick));
            }
        }
    }

    fn raking_brick(
        &mut self,
        id: EdgeId,
        node: &GeneratorNode,
        (wall, brick): (FaceId, &Footprint),
    ) {
        let module = self.plan.module;
        let clipped = {
            let obstacles = self.faces[wall.index()].obstacles(brick);
            clip(brick, &obstacles, 0.5 * module.joint, LEAST_SHARE)
        };
        let Some(part) = clipped else { return };
        let is_whole = part.area() > 0.9 * module.half * module.course;
        let sort = if is_whole {
            CellSort::Whole
        } else {
            CellSort::Raked
        };
        let mut draft = self.face_draft(wall, &part, self.depth(wall), sort);
        draft.extrude = node.number("extrude");
        self.place(Feature::Edge(id), node, draft);
    }

    /// A straight edge of a wall that is neither level nor upright.
    fn slope(&self, wall: FaceId, id: EdgeId) -> Option<Slope> {
        let edge = self.edge(id);
        let [Piece::Line { from, to }] = *edge.path.pieces() else {
            return None;
        };
        let surface = &self.face(wall).surface;
        let ends = [from, to].map(|p| surface.project(p).truncate());
        let way = (ends[1] - ends[0]).try_normalize()?;
        let inwards = if edge.side(wall)? == 0 {
            way.perp()
        } else {
            -way.perp()
        };
        let is_sloping = way.abs().min_element() > 0.05;
        is_sloping.then_some(Slope { ends, inwards })
    }

    /// The half-planes in which bricks of a slope lie: they end half-way to the other slopes of the wall.
    fn half_ways(&self, wall: FaceId, id: EdgeId, slope: &Slope) -> Vec<HalfPlane> {
        let others = self.face(wall).loops.iter().flatten().map(|walk| walk.edge);
        let others: Vec<Slope> = others
            .filter(|&other| other != id)
            .filter_map(|other| self.slope(wall, other))
            .collect();
        let middle = slope.ends[0].midpoint(slope.ends[1]);
        let meets = |end: DVec2| {
            let meeting = |other: &&Slope| other.ends.iter().any(|p| p.distance(end) < NEAR);
            let other = others.iter().find(meeting)?;
            let border = [end, end + slope.inwards + other.inwards];
            Some(HalfPlane::with(middle, border))
        };
        slope.ends.into_iter().filter_map(meets).collect()
    }
}
