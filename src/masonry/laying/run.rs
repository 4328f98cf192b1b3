//! Runs: upright or level pieces of convex edges, along which cells are laid. Level pieces may be arcs.

use super::site::{Site, meet};
use crate::building::{Bend, EdgeId, FaceId, FaceSurface, Piece, Stance};
use crate::masonry::block::Polyhedron;
use crate::masonry::footprint::Footprint;
use crate::masonry::plan::{FaceGrid, divided, is_wall, pieces};
use glam::{DVec2, DVec3};

/// The step along an edge by which its direction on a face is measured (metres).
const STEP: f64 = 1e-4;
/// A unit vector is along an axis if its part along that is greater. Cells of other directions would be skewed.
const ALONG: f64 = 0.999_999;
/// The most by which an arc may leave the straight line that stands for it on a flat face, in modules.
const BENT: f64 = 0.25;
/// Places nearer than this count as one (metres).
pub(super) const NEAR: f64 = 2e-3;

/// One side of a run: a place of the edge on a face, and the way into the face.
#[derive(Clone, Debug)]
pub(super) struct RunSide {
    pub face: FaceId,
    /// The place of the run's start on the face.
    pub place: DVec2,
    /// Unit vector into the face: along +s, -s, +t or -t on a wall.
    pub inwards: DVec2,
    /// The displacement on the face for each metre along the run.
    pub along: DVec2,
    /// The grid lines across `inwards`.
    pub lines: Vec<f64>,
    /// The coordinate of the edge among `lines` (metres).
    pub start: f64,
    /// 1 if `lines` rise on the way into the face, else -1.
    pub way: f64,
    /// How far the ends of an arc lie inside of the straight line that stands for it on a flat face (metres).
    pub bent: f64,
}

impl RunSide {
    /// The number of the line at the edge.
    pub fn line(&self) -> usize {
        FaceGrid::line_at(&self.lines, self.start)
    }

    /// How many columns lie within a distance from the edge.
    pub fn columns_within(&self, width: f64) -> usize {
        let border = self.start + self.way * width.min(1e4);
        FaceGrid::line_at(&self.lines, border).abs_diff(self.line())
    }

    /// How far `count` columns reach into the face (metres).
    pub fn reach(&self, count: usize) -> f64 {
        FaceGrid::reach(&self.lines, self.start, self.way, count)
    }

    /// The place of the edge at a distance along the run.
    pub fn at(&self, along: f64) -> DVec2 {
        self.place + self.along * along
    }
}

/// An upright or level piece of an edge between two faces.
#[derive(Clone, Debug)]
pub(super) struct Run {
    pub edge: EdgeId,
    /// Its ends by arc length of the edge (metres).
    pub ends: [f64; 2],
    pub is_upright: bool,
    /// Its sides; the first one is a wall.
    pub sides: [RunSide; 2],
    /// Whether `sides` are in the opposite order of the edge's faces.
    pub is_swapped: bool,
}

/// The room for a cell on a face, from a run to the next border of the face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    /// The distance to the border (metres); `f64::MAX` if there is none.
    pub width: f64,
    /// Whether a convex edge runs along that border, whose cells need room, too.
    pub is_shared: bool,
}

impl Site {
    /// The runs of an edge: its upright and its level pieces. Empty if the edge is not convex or has no wall.
    pub fn runs(&self, id: EdgeId) -> Vec<Run> {
        let edge = self.edge(id);
        if edge.bend != Bend::Convex {
            return Vec::new();
        }
        let shift = if edge.is_closed() {
            self.to_line(id)
        } else {
            0.0
        };
        let spans = edge.path.joints().windows(2).zip(edge.path.pieces());
        spans
            .filter_map(|(ends, piece)| self.run(id, [ends[0] + shift, ends[1] + shift], piece))
            .collect()
    }

    fn run(&self, id: EdgeId, ends: [f64; 2], piece: &Piece) -> Option<Run> {
        let edge = self.edge(id);
        let faces = [edge.faces[0]?, edge.faces[1]?];
        let middle = 0.5 * (ends[0] + ends[1]);
        let tangent = edge.path.tangent(middle);
        let is_upright = tangent.y.abs() > 0.999;
        let is_level = match piece {
            Piece::Line { .. } => tangent.y.abs() < 1e-3,
            Piece::Arc(arc) => arc.x.cross(arc.y).y.abs() > 0.999,
        };
        let first = faces.iter().position(|&face| is_wall(self.face(face)))?;
        if !(is_upright || is_level) {
            return None;
        }
        let frame = self.building.edge_frame(id, middle);
        let side = |k: usize| self.side(faces[k], id, ends, frame.inward[k]?);
        Some(Run {
            edge: id,
            ends,
            is_upright,
            sides: [side(first)?, side(1 - first)?],
            is_swapped: first == 1,
        })
    }

    fn side(&self, face: FaceId, edge: EdgeId, ends: [f64; 2], inward: DVec3) -> Option<RunSide> {
        let path = &self.edge(edge).path;
        let surface = &self.face(face).surface;
        let middle = surface
            .project(path.point(0.5 * (ends[0] + ends[1])))
            .truncate();
        let frame = surface.frame(middle.x, middle.y);
        let inwards = DVec2::new(inward.dot(frame.s), inward.dot(frame.t)).try_normalize()?;
        // On a disk, s is the arc length at one radius only, so the displacement is measured.
        let beside = surface
            .project(path.point(0.5 * (ends[0] + ends[1]) + STEP))
            .truncate();
        let way = (beside - middle) / STEP;
        let end = middle + way * (0.5 * (ends[1] - ends[0]));
        let bent = (surface.project(path.point(ends[1])).truncate()).distance(end);
        // Cells along the tangent of a flat face's round outline would lie outside of it: faces meet at a mitre there.
        let is_plane = matches!(surface, FaceSurface::Sweep(_)) && surface.is_flat();
        if is_plane && bent > BENT * self.plan.module.half {
            return None;
        }
        let side = |inwards: DVec2, along: DVec2, (lines, start, way): (Vec<f64>, f64, f64)| {
            let along = along * (beside.distance(middle) / STEP);
            let place = middle - along * (0.5 * (ends[1] - ends[0]));
            RunSide {
                bent: if is_plane { bent } else { 0.0 },
                face,
                place,
                inwards,
                along,
                lines,
                start,
                way,
            }
        };
        let straight = axis(inwards).zip(axis(way.try_normalize()?));
        if let Some((inwards, along)) = straight {
            let lines = self.lines(face, inwards.x != 0.0);
            let start = middle.dot(inwards.abs());
            return Some(side(inwards, along, (lines, start, inwards.x + inwards.y)));
        }
        // The grid of a level face does not follow an oblique edge, so the edge gets lines parallel to itself.
        let is_level = self.face(face).stance() == Stance::Level && surface.is_flat();
        let width = self.regions[face.index()].ray(middle, inwards, NEAR)?;
        let lines = divided(&[0.0, width], &[pieces(width, self.plan.module.half)]);
        is_level.then(|| side(inwards, way.normalize(), (lines, 0.0, 1.0)))
    }

    /// The lines of s or of t. On a whole cylinder, those of s go on for one period to either side.
    pub fn lines(&self, face: FaceId, of_s: bool) -> Vec<f64> {
        let grid = self.plan.grid(face);
        let lines = if of_s { &grid.s } else { &grid.t };
        let Some(period) = self.face(face).surface.period().filter(|_| of_s) else {
            return lines.clone();
        };
        let once = &lines[..lines.len() - 1];
        let turns = [-1.0, 0.0, 1.0].into_iter();
        turns
            .flat_map(|turn| once.iter().map(move |line| line + turn * period))
            .collect()
    }

    /// The room that a side of a run has at a distance along it.
    pub fn room(&self, side: &RunSide, along: f64) -> Room {
        let from = side.at(along);
        let region = &self.regions[side.face.index()];
        // The ends of the straight line that stands for an arc lie outside of it.
        let skip = NEAR + side.bent;
        let width = region.ray(from, side.inwards, skip).unwrap_or(f64::MAX);
        // The seam of a cylinder is no border.
        if width == f64::MAX
            || self.face(side.face).surface.period().is_some()
                && self.is_seam(side.face, from + width * side.inwards)
        {
            return Room {
                width: f64::MAX,
                is_shared: false,
            };
        }
        let border = self.at(side.face, from + width * side.inwards, 0.0);
        let edges = self.face(side.face).loops.iter().flatten();
        let is_near = |id: &EdgeId| meet(&self.edge_boxes[id.index()], &[border; 2]);
        let mut near = edges.map(|walk| walk.edge).filter(is_near);
        let is_shared =
            near.any(|id| self.edge(id).bend == Bend::Convex && self.passes(id, border, NEAR));
        Room { width, is_shared }
    }

    /// The reach of a cell into one face (metres): `count` columns, or as many as there is room for. Between two convex
    /// edges one column is left for the cells of the other edge, and a single column is halved.
    pub fn limited_reach(&self, run: &Run, side: usize, count: usize, along: f64) -> f64 {
        let side = &run.sides[side];
        let room = self.room(side, along);
        let columns = side.columns_within(room.width);
        match (room.is_shared, columns) {
            (false, _) => side.reach(count).min(room.width),
            (true, 0 | 1) => 0.5 * room.width,
            (true, columns) => side.reach(count.min(columns - 1)),
        }
    }

    /// The depth of a cell below a level edge's other face: `wanted` metres, or as much as there is room for. If
    /// another convex edge shares the room, the cell takes half of it at most.
    pub fn limited_depth(&self, run: &Run, wanted: f64, along: f64) -> f64 {
        let room = self.room(&run.sides[1], along);
        wanted.min(if room.is_shared {
            0.5 * room.width
        } else {
            room.width
        })
    }

    fn is_seam(&self, face: FaceId, place: DVec2) -> bool {
        let [low, high] = self.face(face).bounds();
        (place.x - low.x).abs() < NEAR || (place.x - high.x).abs() < NEAR
    }

    /// The body of a cell along a run, from `from` to `to` (metres from the run's start), reaching into both faces.
    /// Its back is parallel to the face with the longer reach.
    pub fn edge_body(&self, run: &Run, [from, to]: [f64; 2], reaches: [f64; 2]) -> Polyhedron {
        let long = usize::from(reaches[1] > reaches[0]);
        let ring = |along: f64| {
            let at = |k: usize, reach: f64, z: f64| {
                let side = &run.sides[k];
                self.at(side.face, side.at(along) + side.inwards * reach, z)
            };
            let ends = [0, 1].map(|k| at(k, reaches[k], 0.0));
            let other = ends[1 - long];
            let depth = self.face(run.sides[long].face).surface.project(other).z;
            let inner = at(long, reaches[long], depth);
            vec![at(0, 0.0, 0.0), ends[0], inner, ends[1]]
        };
        let rings = [ring(from), ring(to)];
        let body = Polyhedron::between(&rings);
        if body.volume() > 0.0 {
            return body;
        }
        let [low, high] = rings;
        Polyhedron::between(&[high, low])
    }

    /// The reaches of a cell, the shorter one reduced so that the cell goes no deeper behind the other face than half
    /// of the wall.
    fn within_wall(&self, run: &Run, along: f64, mut reaches: [f64; 2]) -> [f64; 2] {
        let long = usize::from(reaches[1] > reaches[0]);
        let [far, near] = [&run.sides[long], &run.sides[1 - long]];
        let end = self.at(
            near.face,
            near.at(along) + near.inwards * reaches[1 - long],
            0.0,
        );
        let depth = -self.face(far.face).surface.project(end).z;
        let most = self.plan.grid(far.face).depth;
        if depth > most {
            reaches[1 - long] *= most / depth;
        }
        reaches
    }

    /// The reaches of a cell along a run. Each is shrunk by a quarter, up to four times, until earlier claims cover at
    /// most a fiftieth of the cell on that face.
    pub fn fitted(&self, run: &Run, span: [f64; 2], reaches: [f64; 2]) -> [f64; 2] {
        let mut reaches = self.within_wall(run, span[0], reaches);
        for _ in 0..4 {
            let before = reaches;
            for (side, reach) in run.sides.iter().zip(&mut reaches) {
                let ends = span.map(|along| side.at(along));
                let off = side.inwards * *reach;
                let place = Footprint::hull(&[ends[0], ends[1], ends[1] + off, ends[0] + off]);
                let map = &self.faces[side.face.index()];
                if place.is_some_and(|place| map.claimed_share(&place) > 0.02) {
                    *reach *= 0.75;
                }
            }
            if reaches == before {
                break;
            }
        }
        reaches
    }

    /// The unit vector in which an edge's cells look.
    pub fn edge_outwards(&self, run: &Run, along: f64) -> DVec3 {
        let sum: DVec3 = run
            .sides
            .iter()
            .map(|side| self.normal(side.face, side.at(along)))
            .sum();
        sum.normalize_or(DVec3::Y)
    }

    /// The free parts of a run, from its start (metres).
    pub fn free(&self, run: &Run) -> Vec<[f64; 2]> {
        let [start, end] = run.ends;
        let length = self.edges[run.edge.index()].length();
        let turns = if self.edge(run.edge).is_closed() {
            2
        } else {
            1
        };
        let mut parts: Vec<[f64; 2]> = Vec::new();
        for turn in 0..turns {
            for [from, to] in self.edges[run.edge.index()].free() {
                let by = f64::from(turn) * length - start;
                let part = [(from + by).max(0.0), (to + by).min(end - start)];
                match parts.last_mut() {
                    Some(last) if (part[0] - last[1]).abs() < 1e-9 => {
                        last[1] = part[1].max(last[1])
                    }
                    _ => parts.push(part),
                }
            }
        }
        parts.retain(|[from, to]| to - from > NEAR);
        parts
    }

    /// The distance from the start of a closed edge to the next column line of its wall (metres).
    fn to_line(&self, id: EdgeId) -> f64 {
        let edge = self.edge(id);
        let wall = edge
            .faces
            .into_iter()
            .flatten()
            .find(|&face| is_wall(self.face(face)));
        let Some(wall) = wall else { return 0.0 };
        let surface = &self.face(wall).surface;
        let [s, next] = [0.0, STEP].map(|at| surface.project(edge.path.point(at)).x);
        let period = surface.period().unwrap_or(edge.length());
        let ahead = |line: f64| ((line - s) * (next - s).signum()).rem_euclid(period);
        self.plan
            .grid(wall)
            .s
            .iter()
            .map(|&line| ahead(line))
            .fold(f64::MAX, f64::min)
    }

    /// The intervals into which the grid lines of the first side divide a run, each with the index of its column.
    pub fn intervals(&self, run: &Run) -> Vec<(usize, [f64; 2])> {
        let side = &run.sides[0];
        let lines = self.lines(side.face, side.along.x != 0.0);
        let (start, way) = (
            side.place.dot(side.along.abs()),
            side.along.x + side.along.y,
        );
        let length = run.ends[1] - run.ends[0];
        let intervals = lines.windows(2).enumerate().filter_map(|(k, w)| {
            let [a, b] = [w[0], w[1]].map(|line| (line - start) / way);
            let (from, to) = (a.min(b).max(0.0), a.max(b).min(length));
            (to - from > NEAR).then_some((k, [from, to]))
        });
        let mut intervals: Vec<(usize, [f64; 2])> = intervals.collect();
        intervals.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
        intervals
    }
}

/// The unit vector of the axis along which a vector in (s, t) lies; none if it lies between two axes.
fn axis(v: DVec2) -> Option<DVec2> {
    let along_s = v.x.abs() > v.y.abs();
    let (length, axis) = if along_s {
        (v.x, DVec2::X)
    } else {
        (v.y, DVec2::Y)
    };
    (length.abs() > ALONG).then_some(axis * length.signum())
}

/// The number of the interval that begins (`way` above 0) or ends at the line nearest to `at`; none beyond the ends.
pub(super) fn unit(lines: &[f64], at: f64, way: f64) -> Option<usize> {
    let line = FaceGrid::line_at(lines, at);
    let unit = if way > 0.0 {
        Some(line)
    } else {
        line.checked_sub(1)
    };
    unit.filter(|&unit| unit + 1 < lines.len())
}
