//! Stones and bricks around openings: arches, lintels and jambs (Legakis, Dorsey, Gortler 2001, section 5.2, Arch
//! Stones and Arch Bricks).

use super::bricks::BrickBond;
use super::cell::{CellSort, Feature};
use super::quoins::stacks;
use super::run::Run;
use super::site::Site;
use crate::building::{Arc, Bend, Edge, EdgeId, FaceId, Piece};
use crate::masonry::footprint::Footprint;
use crate::masonry::free_space::{LEAST_SHARE, clip};
use crate::masonry::plan::{is_wall, pieces};
use crate::masonry::tree::{GeneratorNode, StoneRow};
use glam::{DVec2, DVec3};

/// The width of an arch's bricks, in courses.
const BRICK_WIDTH: f64 = 0.75;
/// Columns that jamb stones reach into the wall and into the reveal, the other way round at every other stone.
const JAMB: [usize; 2] = [3, 2];

/// A line or an arc of an opening's edge on a wall, with the side on which the wall lies.
#[derive(Clone, Copy, Debug)]
enum Curve {
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
    fn at(&self, along: f64, off: f64) -> DVec2 {
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
    fn stretch(&self, off: f64) -> f64 {
        match *self {
            Self::Line { .. } => 1.0,
            Self::Arc {
                centre, start, out, ..
            } => 1.0 + out * off / start.distance(centre),
        }
    }
}

/// A piece of an edge between a wall and a reveal.
struct RimPiece {
    wall: FaceId,
    curve: Curve,
    length: f64,
    /// How deep stones reach into the reveal (metres): about as deep as wanted, at most half of it if another convex
    /// edge lies at its far end.
    depth: f64,
}

/// Rows of stones around an opening.
struct Rows<'a> {
    rows: &'a [StoneRow],
    keystone: f64,
    depth: f64,
    sort: CellSort,
}

impl Site {
    /// Rows of stones around an edge: voussoirs on arcs, a lintel on level parts, quoins on upright parts.
    pub fn arch_stones(&mut self, id: EdgeId, node: &GeneratorNode) {
        let module = self.plan.module;
        let depth = match node.number("depth") {
            0.0 => module.half,
            depth => depth,
        };
        let rows = Rows {
            rows: &node.rows,
            keystone: if node.rows.len() == 1 {
                node.number("keystone")
            } else {
                0.0
            },
            depth,
            sort: CellSort::Stone,
        };
        self.arch_rows(id, node, &rows);
        for run in self.runs(id).into_iter().filter(|run| run.is_upright) {
            self.jamb_stones(id, node, &run);
        }
    }

    /// Rings of bricks on the wall along the parts of an edge that are not upright. Upright parts are laid as by
    /// Bricks.
    pub fn arch_bricks(&mut self, id: EdgeId, node: &GeneratorNode, bond: &BrickBond) {
        let module = self.plan.module;
        let row = StoneRow {
            length: module.half,
            width: BRICK_WIDTH * module.course,
            extrude: 0.0,
        };
        let rows = vec![row; node.count("rings")];
        let rows = Rows {
            rows: &rows,
            keystone: 0.0,
            depth: module.half,
            sort: CellSort::Whole,
        };
        self.arch_rows(id, node, &rows);
        self.upright_bricks(id, node, bond);
    }

    fn arch_rows(&mut self, id: EdgeId, node: &GeneratorNode, rows: &Rows) {
        for ring in self.rings(id, rows.depth) {
            let mut off = 0.0;
            for (k, row) in rows.rows.iter().enumerate() {
                let is_last = k + 1 == rows.rows.len();
                let length = if is_last {
                    self.snapped(&ring, off, row.length)
                } else {
                    row.length
                };
                self.arch_row(id, node, (&ring, rows), (off, &StoneRow { length, ..*row }));
                off += length;
            }
        }
    }

    /// The length of a lintel's last row, changed by half a course at most so that it ends at a course line. Rows on
    /// arcs keep their length.
    fn snapped(&self, ring: &RimPiece, off: f64, length: f64) -> f64 {
        let Curve::Line { from, inwards, .. } = ring.curve else {
            return length;
        };
        let lines = &self.plan.grid(ring.wall).t;
        let reaches = lines.iter().map(|t| (t - from.y) * inwards.y - off);
        let half = 0.5 * self.plan.module.course;
        let near = reaches.filter(|reach| reach - length > -half);
        near.fold(f64::MAX, f64::min).min(length + half)
    }

    /// One row: an odd number of stones, so that one is in the middle and no joint.
    fn arch_row(
        &mut self,
        id: EdgeId,
        node: &GeneratorNode,
        (ring, rows): (&RimPiece, &Rows),
        (off, row): (f64, &StoneRow),
    ) {
        let length = ring.length * ring.curve.stretch(off + 0.5 * row.length);
        let is_arc = matches!(ring.curve, Curve::Arc { .. });
        let count = match is_arc {
            true => pieces(length, row.width) | 1,
            false => odd_pieces(length, row.width),
        };
        let depth = ring.depth.min(self.plan.grid(ring.wall).depth);
        for k in 0..count {
            let ends = [k, k + 1].map(|k| ring.length * k as f64 / count as f64);
            let is_key = is_arc && 2 * k + 1 == count;
            let mut top = off + row.length;
            if is_key && rows.keystone > 0.0 {
                top = self.keystone_top(ring, ends, top + rows.keystone);
            }
            let corners = [
                (ends[0], off),
                (ends[1], off),
                (ends[1], top),
                (ends[0], top),
            ];
            let corners = corners.map(|(along, off)| ring.curve.at(along, off));
            let Some(whole) = Footprint::hull(&corners) else {
                continue;
            };
            let Some(part) = self.beside_obstacles(ring.wall, &whole, off == 0.0) else {
                continue;
            };
            let sort = if part.area() < 0.97 * whole.area() {
                CellSort::Cut
            } else {
                rows.sort
            };
            let mut draft = self.face_draft(ring.wall, &part, depth, sort);
            draft.extrude = row.extrude;
            self.place(Feature::Edge(id), node, draft);
        }
    }

    /// How far from the edge a keystone ends: at the course line nearest to `top`, if it stands upright.
    fn keystone_top(&self, ring: &RimPiece, ends: [f64; 2], top: f64) -> f64 {
        let middle = 0.5 * (ends[0] + ends[1]);
        let up = ring.curve.at(middle, 1.0).y - ring.curve.at(middle, 0.0).y;
        if up < 0.999 {
            return top;
        }
        let [low, high] = [top, top + 1.0].map(|off| ring.curve.at(ends[0], off).y);
        let lines = self.plan.grid(ring.wall).t.iter();
        let steps = lines.map(|line| (line - low) / (high - low));
        let nearest = |a: f64, b: f64| if b.abs() < a.abs() { b } else { a };
        top + steps.reduce(nearest).unwrap_or(0.0)
    }

    /// The part of a stone of an arch that overlaps nothing. The chord of its inner side lies in the opening, so the
    /// opening itself does not count at the innermost row.
    fn beside_obstacles(
        &self,
        wall: FaceId,
        place: &Footprint,
        is_inner: bool,
    ) -> Option<Footprint> {
        let map = &self.faces[wall.index()];
        let obstacles = if is_inner {
            map.claimed_near(place)
        } else {
            map.obstacles(place)
        };
        let inset = 0.5 * self.plan.module.joint;
        clip(place, &obstacles, inset, LEAST_SHARE)
    }

    /// The parts of an edge that are not upright, between a wall and a reveal. `depth` is how deep their stones should
    /// reach (metres).
    fn rings(&self, id: EdgeId, depth: f64) -> Vec<RimPiece> {
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
            length: run.ends[1] - run.ends[0],
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
                    length: ends[1] - ends[0],
                    depth: depth.min(self.reveal(edge, reveal, 0.5 * (ends[0] + ends[1]))),
                }),
                Piece::Line { .. } => None,
            });
        lines.chain(arcs).collect()
    }

    /// An arc of an edge in the (s, t) of a flat wall; none if it does not lie in the wall.
    fn arc(&self, wall: FaceId, arc: &Arc, edge: &Edge, start: f64) -> Option<Curve> {
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
        let of = &self.face(face).surface;
        let place = of.project(edge.path.point(along)).truncate();
        let Some(side) = edge.side(face) else {
            return f64::MAX;
        };
        let frame = of.frame(place.x, place.y);
        let inward = edge_inward(self, edge, side, along);
        let way = DVec2::new(inward.dot(frame.s), inward.dot(frame.t));
        let region = &self.regions[face.index()];
        let way = if way.x.abs() > way.y.abs() {
            DVec2::X * way.x.signum()
        } else {
            DVec2::Y * way.y.signum()
        };
        let width = region.ray(place, way, super::run::NEAR).unwrap_or(f64::MAX);
        let is_through = self.is_convex_at(face, place + way * width);
        if is_through { 0.5 * width } else { width }
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
            edge.bend == Bend::Convex && edge.path.point(at).distance(p) < super::run::NEAR
        })
    }

    /// Stones of some courses along an upright edge. In turn they reach farther into the wall and farther into the
    /// reveal.
    fn jamb_stones(&mut self, id: EdgeId, node: &GeneratorNode, run: &Run) {
        let courses = node.count("quoin");
        let spans = self.intervals(run);
        let free: Vec<[f64; 2]> = spans
            .into_iter()
            .filter_map(|(_, span)| self.free_part(run, span))
            .collect();
        for (number, span) in stacks(&free, courses).into_iter().enumerate() {
            let draft = self.edge_stone(run, (number % 2, JAMB), span);
            self.place(Feature::Edge(id), node, draft);
        }
    }
}

/// The odd number of pieces of a length whose width differs from the wanted one by the least factor.
fn odd_pieces(length: f64, width: f64) -> usize {
    let count = pieces(length, width);
    if !count.is_multiple_of(2) {
        return count;
    }
    // The geometric mean of the two odd numbers beside an even one.
    let mean = ((count * count - 1) as f64).sqrt();
    if length < mean * width {
        count - 1
    } else {
        count + 1
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
