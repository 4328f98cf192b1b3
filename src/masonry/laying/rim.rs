//! The pieces of an opening's edge along which stones lie: their curves on the wall, how deep stones reach into the
//! reveal, and how far lintels lie on the wall.

use super::run::{NEAR, Run};
use super::site::Site;
use crate::building::{Bend, CircularArc, Edge, EdgeId, FaceId, Piece};
use crate::masonry::footprint::Footprint;
use crate::masonry::plan::{is_wall, pieces};
use glam::{DVec2, DVec3};

/// A line or an arc of an opening's edge on a wall, with the side on which the wall lies.
#[derive(Clone, Copy, Debug)]
pub(super) enum Curve {
    /// From a place along the unit vector `along`; the wall lies towards `inwards`.
    Line {
        from: DVec2,
        along: DVec2,
        inwards: DVec2,
    },
    /// About a centre; `turn` is the angle for each metre along the curve (radians). The wall lies outside if `out` is
    /// 1, inside if it is -1.
    Arc {
        centre: DVec2,
        start: DVec2,
        turn: f64,
        out: f64,
    },
}

impl Curve {
    fn line(run: &Run) -> Self {
        let wall = &run.sides[0];
        Self::Line {
            from: wall.place,
            along: wall.along,
            inwards: wall.inwards,
        }
    }

    /// The place at `along` metres along the curve, and `off` metres from it into the wall.
    pub fn at(&self, along: f64, off: f64) -> DVec2 {
        match *self {
            Self::Line {
                from,
                along: way,
                inwards,
            } => from + way * along + inwards * off,
            Self::Arc {
                centre,
                start,
                turn,
                out,
            } => {
                let (sin, cos) = libm::sincos(turn * along);
                let radius = start - centre;
                let radius = radius * cos + radius.perp() * sin;
                centre + radius * (1.0 + out * off / radius.length())
            }
        }
    }

    /// The length of the curve at a distance into the wall, over its own length.
    pub fn stretch(&self, off: f64) -> f64 {
        match *self {
            Self::Line { .. } => 1.0,
            Self::Arc {
                centre, start, out, ..
            } => 1.0 + out * off / start.distance(centre),
        }
    }
}

/// How much deeper or shallower than wanted a line of a reveal's grid may be for stones to end at it (share of the depth).
const NEAR_LINE: f64 = 0.2;

/// How long the bearing of a lintel is at least, in half bricks.
const LEAST_BEARING: f64 = 0.6;
/// The share of a bearing that lies on the wall's face at least.
const WALL_SHARE: f64 = 0.99;

/// A piece of an edge between a wall and a reveal.
pub(super) struct RimPiece {
    pub wall: FaceId,
    pub curve: Curve,
    /// The ends of its stones along the curve (metres): those of the piece, but a lintel's lie on the wall beside the
    /// opening.
    pub ends: [f64; 2],
    /// How deep stones reach into the reveal (metres): about as deep as wanted, at most half of it if another convex
    /// edge lies at its far end.
    pub depth: f64,
}

impl Site {
    /// Lets a lintel or a sill of this height (metres) lie on the wall at both ends, by a column of the grid where the
    /// wall is free.
    pub(super) fn bear(&self, ring: &mut RimPiece, height: f64) {
        let Curve::Line { from, along, .. } = ring.curve else {
            return;
        };
        let columns = self.lines(ring.wall, true).into_iter();
        let places: Vec<f64> = columns
            .map(|s| (s - from.x) * along.x)
            .filter(|_| along.y.abs() < 1e-6)
            .collect();
        let half = self.plan.module.half;
        let near = |end: f64, way: f64| {
            let reaches = places.iter().map(|place| (place - end) * way);
            let reach = reaches.filter(|reach| *reach > LEAST_BEARING * half);
            let reach = reach.reduce(f64::min).filter(|reach| *reach < 2.0 * half)?;
            let corners = [(0.0, 0.0), (reach, 0.0), (reach, height), (0.0, height)];
            let corners = corners.map(|(by, off)| ring.curve.at(end + way * by, off));
            let place = Footprint::hull(&corners)?;
            let is_wall = self.faces[ring.wall.index()].has_inside(&place, WALL_SHARE);
            (is_wall && self.is_free(ring.wall, &place)).then_some(way * reach)
        };
        let [start, end] = ring.ends;
        let by = [near(start, -1.0), near(end, 1.0)].map(|by| by.unwrap_or(0.0));
        ring.ends = [start + by[0], end + by[1]];
    }

    /// The parts of an edge that are not upright, between a wall and a reveal. `depth` is how deep their stones should
    /// reach (metres).
    pub(super) fn rings(&self, id: EdgeId, depth: f64) -> Vec<RimPiece> {
        let edge = self.edge(id);
        let [Some(a), Some(b)] = edge.faces else {
            return Vec::new();
        };
        let Some(wall) = [a, b].into_iter().find(|&face| is_wall(self.face(face))) else {
            return Vec::new();
        };
        if edge.bend != Bend::Convex {
            return Vec::new();
        }
        let reveal = if wall == a { b } else { a };
        let level = self
            .runs(id)
            .into_iter()
            .filter(|run| !run.is_upright && run.sides[0].face == wall);
        let lines = level.map(|run| RimPiece {
            wall,
            curve: Curve::line(&run),
            ends: [0.0, run.ends[1] - run.ends[0]],
            depth: run.sides[1]
                .reach(pieces(depth, self.plan.module.half))
                .min(self.reveal(edge, reveal, 0.5 * (run.ends[0] + run.ends[1]))),
        });
        let arcs = edge
            .path
            .joints()
            .windows(2)
            .zip(edge.path.pieces())
            .filter_map(|(ends, piece)| match piece {
                Piece::Arc(arc) => Some(RimPiece {
                    wall,
                    curve: self.arc(wall, arc, edge, ends[0])?,
                    ends: [0.0, ends[1] - ends[0]],
                    depth: self.arc_depth(edge, reveal, 0.5 * (ends[0] + ends[1]), depth),
                }),
                Piece::Line { .. } => None,
            });
        lines.chain(arcs).collect()
    }

    /// An arc of an edge in the (s, t) of a flat wall; none if it does not lie in the wall.
    fn arc(&self, wall: FaceId, arc: &CircularArc, edge: &Edge, start: f64) -> Option<Curve> {
        let surface = &self.face(wall).surface;
        if !surface.is_flat() {
            return None;
        }
        let of = |p: DVec3| surface.project(p);
        let (centre, first) = (of(arc.centre), of(edge.path.point(start)).truncate());
        let next = of(edge.path.point(start + 0.01 * arc.radius)).truncate();
        let centre = (centre.z.abs() < 0.01).then(|| centre.truncate())?;
        let turn = (first - centre).perp_dot(next - centre).signum() / arc.radius;
        let curve = |out: f64| Curve::Arc {
            centre,
            start: first,
            turn,
            out,
        };
        // The middle of the arc is clear of corners.
        let probe = curve(1.0).at(0.5 * arc.length(), 0.01);
        let is_outside = self.regions[wall.index()].contains(probe);
        Some(curve(if is_outside { 1.0 } else { -1.0 }))
    }

    /// How deep stones may reach into a reveal from a place of its edge (metres): half of it if another convex edge
    /// lies at its far end.
    fn reveal(&self, edge: &Edge, face: FaceId, along: f64) -> f64 {
        let Some((place, way)) = self.reveal_axis(edge, face, along) else {
            return f64::MAX;
        };
        let region = &self.regions[face.index()];
        let width = region.ray(place, way, NEAR).unwrap_or(f64::MAX);
        let is_through = self.is_convex_at(face, place + way * width);
        if is_through { 0.5 * width } else { width }
    }

    /// The (s, t) of a place of an edge on a reveal, and the axis that leads into the reveal from there.
    fn reveal_axis(&self, edge: &Edge, face: FaceId, along: f64) -> Option<(DVec2, DVec2)> {
        let of = &self.face(face).surface;
        let place = of.project(edge.path.point(along)).truncate();
        let frame = of.frame(place.x, place.y);
        let inward = edge_inward(self, edge, edge.side(face)?, along);
        let way = DVec2::new(inward.dot(frame.s), inward.dot(frame.t));
        let axis = match way.x.abs() > way.y.abs() {
            true => DVec2::X * way.x.signum(),
            false => DVec2::Y * way.y.signum(),
        };
        Some((place, axis))
    }

    /// The depth of the stones of an arc below a reveal (metres): as wanted, or up to the line of the reveal's grid that
    /// is nearly as deep, so that no strip of a unit is left beside them.
    fn arc_depth(&self, edge: &Edge, face: FaceId, along: f64, wanted: f64) -> f64 {
        let most = self.reveal(edge, face, along);
        let lines = self.reveal_axis(edge, face, along).map(|(place, way)| {
            let lines = self.lines(face, way.x != 0.0).into_iter();
            let depths = lines.map(move |line| way.dot(DVec2::splat(line) - place));
            depths.filter(|depth| (depth - wanted).abs() < NEAR_LINE * wanted)
        });
        let nearest = |a: f64, b: f64| {
            let is_nearer = (b - wanted).abs() < (a - wanted).abs();
            if is_nearer { b } else { a }
        };
        let line = lines.into_iter().flatten().reduce(nearest);
        line.unwrap_or(wanted).min(most)
    }

    /// Whether a convex edge of a face passes a place.
    fn is_convex_at(&self, face: FaceId, place: DVec2) -> bool {
        let p = self.at(face, place, 0.0);
        let mut edges = self
            .face(face)
            .loops
            .iter()
            .flatten()
            .map(|walk| self.edge(walk.edge));
        edges.any(|edge| {
            let at = edge.path.project(p).clamp(0.0, edge.length());
            edge.bend == Bend::Convex && edge.path.point(at).distance(p) < NEAR
        })
    }
}

/// The unit vector from an edge into one of its faces.
fn edge_inward(site: &Site, edge: &Edge, side: usize, along: f64) -> DVec3 {
    let tangent = edge.path.tangent(along);
    let face = edge.faces[side].expect("a side of the edge");
    let surface = &site.face(face).surface;
    let place = surface.project(edge.path.point(along));
    let normal = surface.frame(place.x, place.y).normal;
    if side == 0 {
        normal.cross(tangent)
    } else {
        tangent.cross(normal)
    }
}
