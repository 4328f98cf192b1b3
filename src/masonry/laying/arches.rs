//! Stones and bricks around openings: arches, lintels and jambs (Legakis, Dorsey, Gortler 2001, section 5.2, Arch
//! Stones and Arch Bricks).

use super::bricks::BrickBond;
use super::cell::{CellSort, Feature};
use super::quoins::stacks;
use super::rim::{Curve, RimPiece};
use super::run::Run;
use super::site::Site;
use crate::building::{EdgeId, FaceId};
use crate::masonry::footprint::Footprint;
use crate::masonry::free_space::{LEAST_SHARE, clip};
use crate::masonry::plan::pieces;
use crate::masonry::tree::{GeneratorNode, StoneRow};

/// The width of an arch's bricks, in courses.
const BRICK_WIDTH: f64 = 0.75;
/// Columns that jamb stones reach into the wall and into the reveal, the other way round at every other stone.
const JAMB: [usize; 2] = [3, 2];

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
        for mut ring in self.rings(id, rows.depth) {
            let height = rows.rows.iter().map(|row| row.length).sum();
            self.bear(&mut ring, height);
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
        let [start, end] = ring.ends;
        let length = (end - start) * ring.curve.stretch(off + 0.5 * row.length);
        let is_arc = matches!(ring.curve, Curve::Arc { .. });
        let count = match is_arc {
            true => pieces(length, row.width) | 1,
            false => odd_pieces(length, row.width),
        };
        let depth = ring.depth.min(self.plan.grid(ring.wall).depth);
        for k in 0..count {
            let ends = [k, k + 1].map(|k| start + (end - start) * k as f64 / count as f64);
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
