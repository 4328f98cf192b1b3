//! Random ashlar: rectangles of random size on a fine grid (Legakis, Dorsey, Gortler 2001, section 5.2, Random
//! Ashlar).

use super::bond;
use super::cell::{CellDraft, CellSort, Feature};
use super::faces::wrapped;
use super::rectangles::{Most, Rectangle, Unit, Units};
use super::run::{Run, unit};
use super::site::Site;
use super::work::SiteWork;
use crate::building::{CornerId, EdgeId, FaceId};
use crate::masonry::footprint::Footprint;
use crate::masonry::grid_place::GridPlace;
use crate::masonry::occupancy::Coverage;
use crate::masonry::tree::GeneratorNode;
use crate::random::{Purpose, Random};
use glam::DVec2;

/// Units that the stones of corners reach into the two walls.
const CORNER: [usize; 2] = [3, 2];
/// The most units that edge stones reach into the face along which they lie.
const LONGEST: usize = 4;
/// A unit that is at least this share of the stones' depth is as deep.
const NEARLY: f64 = 0.8;
/// A course that is at least this share of the room between two edges fills it.
const SINGLE: f64 = 0.75;
/// The most rows of an edge stone.
const HIGHEST: usize = 3;

/// The number of a feature's stream of random numbers.
fn item(feature: Feature) -> u64 {
    match feature {
        Feature::Corner(id) => 1 << 32 | u64::from(id.0),
        Feature::Edge(id) => 2 << 32 | u64::from(id.0),
        Feature::Face(id) => 3 << 32 | u64::from(id.0),
    }
}

fn random(seed: u64, feature: Feature) -> Random {
    Random::new(seed, Purpose::Placement, item(feature))
}

impl Site {
    /// A single stone at a corner, three units by two. At the corner of an opening, the largest stone that fits into
    /// the wall diagonally off it.
    pub fn ashlar_corner(&mut self, id: CornerId, node: &GeneratorNode) {
        let quadrants = self.quadrants(id);
        let rim = quadrants
            .iter()
            .find_map(|found| Some((found.face, found.place, found.opposite_the_gap()?)));
        if let Some(rim) = rim {
            self.rim_stone(id, node, rim);
        } else if let Some((run, at_end)) = self.corner_run(id, &quadrants) {
            let feature = Feature::Corner(id);
            let intervals = self.intervals(&run);
            let count = 2.min(intervals.len());
            let part = if at_end {
                &intervals[intervals.len() - count..]
            } else {
                &intervals[..count]
            };
            if let (Some((row, [from, _])), Some((_, [_, to]))) = (part.first(), part.last()) {
                let long = self.turned(feature, self.long_side(&run, *row, false));
                if let Some(span) = self.free_part(&run, [*from, *to]) {
                    let draft = self.edge_stone(&run, (long, CORNER), span);
                    self.place(feature, node, draft);
                }
            }
        }
    }

    fn rim_stone(
        &mut self,
        id: CornerId,
        node: &GeneratorNode,
        (face, place, way): (FaceId, DVec2, DVec2),
    ) {
        let (columns, rows) = (self.lines(face, true), self.lines(face, false));
        let (Some(column), Some(row)) =
            (unit(&columns, place.x, way.x), unit(&rows, place.y, way.y))
        else {
            return;
        };
        for [w, h] in [[3, 2], [2, 2], [2, 1], [1, 1]] {
            let span = |at: usize, way: f64, count: usize| match way > 0.0 {
                true => Some([at, at + count]),
                false => Some([(at + 1).checked_sub(count)?, at + 1]),
            };
            let (Some(c), Some(r)) = (span(column, way.x, w), span(row, way.y, h)) else {
                continue;
            };
            if c[1] >= columns.len() || r[1] >= rows.len() {
                continue;
            }
            let low = DVec2::new(columns[c[0]], rows[r[0]]);
            let high = DVec2::new(columns[c[1]], rows[r[1]]);
            if let Some(block) =
                Footprint::rectangle(low, high).filter(|block| self.is_free(face, block))
            {
                let draft = self.face_draft(face, &block, self.depth(face), CellSort::Stone);
                self.place(Feature::Corner(id), node, draft);
                return;
            }
        }
    }

    /// A stone along an upright run. It reaches `units[0]` columns into side `long`, and `units[1]` into the other
    /// side.
    pub fn edge_stone(
        &self,
        run: &Run,
        (long, units): (usize, [usize; 2]),
        span: [f64; 2],
    ) -> CellDraft {
        let middle = 0.5 * (span[0] + span[1]);
        let reaches = [0, 1].map(|side| {
            let count = units[usize::from(side != long)];
            let [low, high] =
                span.map(|at| self.stone_reach(run, side, count, 0.9 * at + 0.1 * middle));
            low.min(high)
        });
        let reaches = self.fitted(run, span, reaches);
        let body = self.edge_body(run, span, reaches);
        CellDraft::new(CellSort::Stone, body, self.edge_outwards(run, middle))
    }

    /// The reach of an edge stone: between two convex edges each has half of the columns.
    fn stone_reach(&self, run: &Run, side: usize, count: usize, along: f64) -> f64 {
        let side = &run.sides[side];
        let room = self.room(side, along);
        if !room.is_shared {
            return side.reach(count).min(room.width);
        }
        let columns = (1..=count).rev().map(|count| side.reach(count));
        let half = 0.5 * room.width;
        columns
            .into_iter()
            .find(|&reach| reach <= half + 1e-6)
            .unwrap_or(half)
    }

    /// Stones along an edge: those of upright edges point to both sides in turn and have random heights; those of
    /// level edges have random lengths.
    pub fn ashlar_edge(&mut self, id: EdgeId, node: &GeneratorNode, seed: u64) {
        let feature = Feature::Edge(id);
        let mut random = random(seed, feature);
        for run in self.runs(id) {
            let most = if run.is_upright {
                HIGHEST
            } else {
                node.count("most_width")
            };
            let mut long = (random.below(2) + usize::from(self.edge(id).flip)) % 2;
            for span in self.stone_spans(&run, most, &mut random) {
                if run.is_upright {
                    let reach = 3 + random.below(LONGEST - 2);
                    let draft = self.edge_stone(&run, (long, [reach, 2]), span);
                    self.place(feature, node, draft);
                    long = 1 - long;
                } else {
                    self.level_stone(feature, node, &run, span);
                }
            }
        }
    }

    /// Cuts the free parts of a run at the grid's lines into pieces of 1 to `most` units.
    fn stone_spans(&self, run: &Run, most: usize, random: &mut Random) -> Vec<[f64; 2]> {
        let mut spans = Vec::new();
        let intervals = self.intervals(run);
        for [from, to] in self.free(run) {
            let units = intervals.iter().filter_map(|&(_, [a, b])| {
                let (a, b) = (a.max(from), b.min(to));
                (b - a > 0.01).then_some([a, b])
            });
            let units: Vec<[f64; 2]> = units.collect();
            let mut rest = &units[..];
            while let Some(first) = rest.first() {
                let count = (1 + random.below(most)).min(rest.len());
                // The stone takes one unit more if a single unit would be left behind.
                let count = if rest.len() - count == 1 && count < most {
                    count + 1
                } else {
                    count
                };
                spans.push([first[0], rest[count - 1][1]]);
                rest = &rest[count..];
            }
        }
        spans
    }

    fn level_stone(&mut self, feature: Feature, node: &GeneratorNode, run: &Run, span: [f64; 2]) {
        let middle = 0.5 * (span[0] + span[1]);
        let height = match self.single_course(run, middle) {
            Some(_) if run.sides[0].inwards.y > 0.0 => return,
            Some(course) => course,
            None => self.stone_reach(run, 0, 1, middle),
        };
        let depth = self
            .stone_reach(run, 1, 2, middle)
            .min(self.level_depth(run));
        let body = self.edge_body(run, span, [height, depth]);
        let outwards = self.edge_outwards(run, middle);
        self.place(
            feature,
            node,
            CellDraft::new(CellSort::Stone, body, outwards),
        );
    }

    /// The height of a single course between two level edges of a wall, as under a door (metres): the stones of the
    /// upper edge take all of it. None where there is more than a course.
    fn single_course(&self, run: &Run, along: f64) -> Option<f64> {
        let side = &run.sides[0];
        let room = self.room(side, along);
        let is_single = side.reach(1) > SINGLE * room.width;
        (room.is_shared && side.inwards.y.abs() > 0.5 && is_single).then_some(room.width)
    }

    /// How deep the stones of a level edge reach into its other face (metres): about as deep as the stones of its first
    /// face, but one unit where that is nearly as deep, so that no strip of it is left.
    fn level_depth(&self, run: &Run) -> f64 {
        let depth = self.depth(run.sides[0].face);
        let unit = run.sides[1].reach(1);
        if (NEARLY * depth..depth).contains(&unit) {
            unit
        } else {
            depth
        }
    }

    /// The states of a row of units of a face.
    fn unit_row(&self, id: FaceId, row: usize) -> Vec<Unit> {
        let grid = self.plan.grid(id);
        let state = |column: usize| {
            let [low, high] = grid.block([column, column + 1], [row, row + 1]);
            let Some(place) = GridPlace::new(low, high) else {
                return Unit::Taken;
            };
            let place = self.home_place(id, place);
            match self.faces[id.index()].coverage_of(&place) {
                Coverage::Occupied => Unit::Taken,
                Coverage::Free if self.is_free(id, &place.footprint()) => Unit::Free,
                _ if self.is_sliver(id, &place) => Unit::Sliver,
                _ => Unit::Partly,
            }
        };
        (0..grid.column_lines().len() - 1).map(state).collect()
    }
}

/// Fills a face. Free units are visited in nearly the order of rows. At each a rectangle of random size, shrunk until
/// it fits, becomes a stone. Then stones of one unit are merged with neighbours at random while the union is a
/// rectangle and not too large.
pub(super) struct AshlarWork {
    id: FaceId,
    node: GeneratorNode,
    random: Random,
    units: Units,
    /// How many rows of units there are.
    rows: usize,
    /// The stones to be laid, the next one last; none before they are found.
    stones: Option<Vec<Rectangle>>,
}

impl AshlarWork {
    pub fn new(site: &Site, id: FaceId, node: &GeneratorNode, seed: u64) -> Self {
        let grid = site.plan.grid(id);
        Self {
            id,
            node: node.clone(),
            random: random(seed, Feature::Face(id)),
            units: Units {
                columns: grid.column_lines().len() - 1,
                is_round: site.grid_period(id).is_some(),
                states: Vec::new(),
            },
            rows: grid.row_lines().len() - 1,
            stones: None,
        }
    }

    fn find_stones(&mut self) -> Vec<Rectangle> {
        let most = Most {
            width: self.node.count("most_width"),
            height: self.node.count("most_height"),
        };
        let mut stones = bond::stones(&mut self.units, most, &mut self.random);
        stones.reverse();
        stones
    }
}

impl SiteWork for AshlarWork {
    fn advance(&mut self, site: &mut Site) -> bool {
        let row = self.units.states.len() / self.units.columns;
        if row < self.rows {
            let states = site.unit_row(self.id, row);
            self.units.states.extend(states);
            return false;
        }
        let Some(stones) = &mut self.stones else {
            self.stones = Some(self.find_stones());
            return false;
        };
        for _ in 0..self.units.columns {
            let Some(stone) = stones.pop() else {
                return true;
            };
            let grid = site.plan.grid(self.id);
            let place = wrapped(grid, stone.columns, stone.rows, site.grid_period(self.id));
            if let Some(place) = place {
                let whole = (&place, place.area());
                site.face_brick(self.id, &self.node, whole, CellSort::Stone);
            }
        }
        stones.is_empty()
    }
}
