//! Copings: flat stones on the top of a free-standing wall, a little proud of both its sides.

use super::cell::{CellDraft, CellSort, Feature};
use super::run::NEAR;
use super::site::Site;
use crate::building::{Bend, EdgeId, FaceId, Piece};
use crate::masonry::block::Polyhedron;
use crate::masonry::footprint::{Footprint, HalfPlane};
use crate::masonry::plan::{is_wall, pieces};
use crate::masonry::tree::GeneratorNode;
use glam::DVec2;

/// Walls thicker than this have no coping, in modules.
const THICKEST: f64 = 8.0;
/// The top of a wall has a coping only if an edge beside it is longer than this many of its widths.
const LONGER: f64 = 1.5;
/// Faces that look up have at least this vertical part in their normals.
const UP: f64 = 0.999;
/// Edges this near to a place pass it (metres).
const ON: f64 = 2.0 * NEAR;
/// The end of a coping at a turn goes this far beyond the wall before it is cut, in widths of the wall.
const BEYOND: f64 = 4.0;

/// A straight or circular part of an edge beside the top of a wall.
#[derive(Clone, Debug)]
struct Ledge {
    edge: EdgeId,
    /// The top of the wall.
    face: FaceId,
    length: f64,
    /// The place of its start on the top, and (`along`) the displacement on the top for each metre.
    start: DVec2,
    along: DVec2,
    /// Unit vector across the top.
    inwards: DVec2,
}

impl Ledge {
    fn at(&self, along: f64, off: f64) -> DVec2 {
        self.start + self.along * along + self.inwards * off
    }
}

/// How a coping ends.
#[derive(Clone, Copy, Debug)]
enum Turn {
    /// The edge is closed, so the coping has no ends.
    Closed,
    /// The coping stands over the end of its wall.
    Free,
    /// The coping ends half-way to that of the next wall, at the border of this half-plane.
    Cut(HalfPlane),
}

impl Site {
    /// Lays stones across the top of a wall, along the longer one of the two edges beside it. Stones stand on the top
    /// and claim nothing in it. Where the wall turns, the copings of both parts meet half-way.
    pub fn coping_edge(&mut self, id: EdgeId, node: &GeneratorNode) {
        for ledge in self.ledges(id) {
            let Some(width) = self.coped_width(&ledge) else {
                continue;
            };
            let turns = self.turns(&ledge);
            let over = node.number("over");
            let count = pieces(ledge.length, node.number("length"));
            for k in 0..count {
                let ends = [k == 0, k + 1 == count];
                let beyond = [0, 1].map(|end| match (ends[end], turns[end]) {
                    (false, _) | (true, Turn::Closed) => 0.0,
                    (true, Turn::Free) => over,
                    (true, Turn::Cut(_)) => BEYOND * (width + over),
                });
                let at = |k: usize| ledge.length * k as f64 / count as f64;
                let span = [at(k) - beyond[0], at(k + 1) + beyond[1]];
                self.coping_stone(node, &ledge, (span, width), turns);
            }
        }
    }

    fn coping_stone(
        &mut self,
        node: &GeneratorNode,
        ledge: &Ledge,
        ([from, to], width): ([f64; 2], f64),
        turns: [Turn; 2],
    ) {
        let over = node.number("over");
        let corners = [
            (from, -over),
            (to, -over),
            (to, width + over),
            (from, width + over),
        ];
        let mut base = Footprint::hull(&corners.map(|(along, off)| ledge.at(along, off)));
        for turn in turns {
            if let Turn::Cut(half) = turn {
                base = base.and_then(|base| base.clip(half, 0.0));
            }
        }
        let Some(base) = base else { return };
        let face = ledge.face;
        let tall = node.number("thickness");
        let body = Polyhedron::prism(&base, [0.0, tall], [0.0; 2], |p, z| self.at(face, p, z));
        // Joints are between stones. The bed joint is below, in the wall's own cells.
        let [first, last] = [from, to].map(|along| self.at(face, ledge.at(along, 0.0), 0.0));
        let way = (last - first).normalize_or_zero();
        let half = 0.5 * self.plan.module.joint;
        let body = body.with_insets(|plane, _| {
            if plane.normal.dot(way).abs() > 0.5 {
                half
            } else {
                0.0
            }
        });
        let draft = CellDraft::new(CellSort::Stone, body, self.normal(face, base.centre()));
        self.settle(Feature::Edge(ledge.edge), node, draft, Vec::new());
    }

    /// The parts of a convex edge between a wall and a level face that looks up.
    fn ledges(&self, id: EdgeId) -> Vec<Ledge> {
        let edge = self.edge(id);
        let [Some(a), Some(b)] = edge.faces else {
            return Vec::new();
        };
        let is_top = |face: FaceId| {
            let place = self.face(face).bounds()[0];
            self.normal(face, place).y > UP
        };
        let found = [(a, b), (b, a)].into_iter();
        let mut found = found.filter(|&(wall, top)| is_wall(self.face(wall)) && is_top(top));
        let Some((_, face)) = found.next().filter(|_| edge.bend == Bend::Convex) else {
            return Vec::new();
        };
        let surface = &self.face(face).surface;
        if let ([Piece::Line { from, to }], true) = (edge.path.pieces(), surface.is_flat()) {
            let [start, end] = [*from, *to].map(|p| surface.project(p).truncate());
            let along = (end - start).normalize_or_zero();
            let side = if edge.side(face) == Some(0) {
                1.0
            } else {
                -1.0
            };
            return vec![Ledge {
                edge: id,
                face,
                length: start.distance(end),
                start,
                along,
                inwards: along.perp() * side,
            }];
        }
        let runs = self
            .runs(id)
            .into_iter()
            .filter(|run| run.sides[1].face == face);
        let ledge = |run: super::run::Run| Ledge {
            edge: id,
            face,
            length: run.ends[1] - run.ends[0],
            start: run.sides[1].place,
            along: run.sides[1].along,
            inwards: run.sides[1].inwards,
        };
        runs.map(ledge).collect()
    }

    /// The width of the top of a wall beside a ledge, if the coping belongs to this one of its two edges.
    fn coped_width(&self, ledge: &Ledge) -> Option<f64> {
        let (width, is_own) = self.coped(ledge)?;
        is_own.then_some(width)
    }

    /// The width of the top of a wall beside a ledge, if there is a coping, and whether it belongs to this edge.
    fn coped(&self, ledge: &Ledge) -> Option<(f64, bool)> {
        let from = ledge.at(0.5 * ledge.length, 0.0);
        let width = self.regions[ledge.face.index()].ray(from, ledge.inwards, NEAR)?;
        let other = self.edge_at(ledge.face, from + ledge.inwards * width)?;
        let [own, length] = [ledge.edge, other].map(|id| self.edge(id).length());
        let is_narrow =
            width <= THICKEST * self.plan.module.half && width * LONGER < own.max(length);
        let is_longer = own > length + NEAR || (own > length - NEAR && ledge.edge < other);
        (is_narrow && self.edge(other).bend == Bend::Convex).then_some((width, is_longer))
    }

    /// The edge of a face at a place of its border.
    fn edge_at(&self, face: FaceId, place: DVec2) -> Option<EdgeId> {
        let p = self.at(face, place, 0.0);
        let mut edges = self.face(face).loops.iter().flatten().map(|walk| walk.edge);
        edges.find(|&id| self.passes(id, p, ON))
    }

    /// How the coping of a ledge ends.
    fn turns(&self, ledge: &Ledge) -> [Turn; 2] {
        if self.edge(ledge.edge).is_closed() {
            return [Turn::Closed; 2];
        }
        let middle = ledge.at(0.5 * ledge.length, 1e-3);
        [0.0, ledge.length].map(|along| {
            let end = ledge.at(along, 0.0);
            let p = self.at(ledge.face, end, 0.0);
            let walks = self.face(ledge.face).loops.iter().flatten();
            let others = walks.map(|walk| walk.edge).filter(|&id| id != ledge.edge);
            let beside = others.filter(|&id| self.passes(id, p, ON));
            let mut next = beside.flat_map(|id| self.ledges(id));
            // It does not matter which of the two edges beside the next wall's top the next coping belongs to.
            let Some(next) = next.find(|other| self.coped(other).is_some()) else {
                return Turn::Free;
            };
            let border = [end, end + ledge.inwards + next.inwards];
            Turn::Cut(HalfPlane::with(middle, border))
        })
    }
}
