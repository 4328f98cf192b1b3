//! Adds cells where there is room and removes them where they are crowded.
//!
//! Miyata, Itoh, Shimada (2000), section 4.3; the rule by the smallest w is that of Itoh, Miyata, Shimada
//! (2003), section 5.1. Attraction keeps the smallest w near 1 even beside the largest gaps. So by default
//! the places around a cell, four for squares and six for round cells, are tested for an empty one instead.
//! Rows and columns hold a whole number of cells. The remaining length may be spread over several gaps, none
//! as wide as a cell, so rows are also measured over several cells.

use super::body::MovingParticle;
use super::front::{is_taken, slots};
use super::packing_domain::{
    Boundary, ClosestPoint, ClosestPointOf, HashOf, MetricSpace, PackingDomain, SpatialHash,
    TransportOf,
};
use super::shape::CellShape;
use super::transport::ParallelTransport;
use super::{BoundaryCondition, PackingParams, Population};
use crate::field::CellKind;
use crate::order;
use glam::DVec2;

/// Two limits in stable distances: a cell is removed if its nearest neighbour is nearer than the first, and
/// one is added if the nearest is at least as far as the second. Round cells have six neighbours that share a
/// gap: they accept a smaller gap, because all six make room.
const fn limits(kind: CellKind) -> (f64, f64) {
    if kind.has_corners() {
        (0.66, 0.72)
    } else {
        (0.74, 0.63)
    }
}
/// The papers' rule adds a cell beside one whose nearest neighbour is farther than this.
const LONELY: f64 = 1.02;
/// Rows and columns: a cell is added in the widest gap of a row whose summed slack exceeds this, in stable
/// distances, ...
const LOOSE: f64 = 0.6;
/// ... over this many gaps on each side ...
const WINDOW: usize = 3;
/// ... if that gap is at least this wide ...
const GAP: f64 = 1.2;
/// ... and its midpoint at least this far from all cells.
const SQUEEZED: f64 = 0.58;
/// Bodies at most this far apart touch and leave no gap.
const TOUCHING: f64 = 1.15;
/// The next cell of a row is at most this far from where it would touch.
const ROW: f64 = 0.55;
/// The largest share of the cells that is removed, or added, at once.
const MOST_CHANGED: f64 = 0.1;

/// Planned changes: `remove[i]` for body i, and the centres of new cells.
#[derive(Clone, Debug)]
pub(crate) struct Change<P> {
    pub remove: Vec<bool>,
    pub add: Vec<P>,
}

/// A candidate place for a new cell.
struct CandidatePlace<P> {
    place: P,
    /// The shape of a cell at that place.
    shape: CellShape,
    /// The least distance to all cells, in stable distances.
    room: f64,
}

impl<P> CandidatePlace<P> {
    fn new(place: P, shape: CellShape) -> Self {
        let room = limits(shape.kind()).1;
        Self { place, shape, room }
    }
}

/// A population scan in progress.
#[derive(Clone, Debug)]
pub(crate) struct PopulationScan<P, B> {
    shapes: Vec<CellShape>,
    grid: B,
    longest: f64,
    nearest: Vec<f64>,
    /// Bodies in the order of ids: the order in memory depends on all moves.
    order: Vec<usize>,
    /// How many of these have been scanned.
    seen: usize,
    most: usize,
    change: Change<P>,
}

struct ScanInputs<'a, G: PackingDomain> {
    ground: G,
    bodies: &'a [MovingParticle<G::Place>],
    shapes: &'a [CellShape],
    grid: &'a HashOf<G>,
    longest: f64,
}

impl<P: Copy, B: SpatialHash<P>> PopulationScan<P, B> {
    /// Starts a scan.
    pub fn new<G>(ground: G, bodies: &[MovingParticle<P>]) -> Self
    where
        G: PackingDomain<Place = P>,
        G::Metric: MetricSpace<Place = P, Hash = B>,
    {
        let shapes: Vec<CellShape> = bodies.iter().map(|b| CellShape::of(&b.particle)).collect();
        let longest = shapes.iter().fold(0.0_f64, |m, s| m.max(s.length()));
        let mut grid = ground.metric().grid(longest);
        for body in bodies {
            grid.push(body.particle.centre);
        }
        let mut order: Vec<usize> = (0..bodies.len()).collect();
        order::sort(&mut order, |&i| (bodies[i].particle.id.into(), 0));
        Self {
            shapes,
            grid,
            longest,
            nearest: Vec::with_capacity(bodies.len()),
            order,
            seen: 0,
            most: (MOST_CHANGED * bodies.len() as f64).ceil() as usize,
            change: Change {
                remove: Vec::new(),
                add: Vec::new(),
            },
        }
    }

    /// Scans a number of bodies, which must not change during the scan; gives the change when all have been
    /// scanned.
    pub fn advance<G>(
        &mut self,
        ground: G,
        bodies: &[MovingParticle<P>],
        params: &PackingParams,
        portion: usize,
    ) -> Option<Change<P>>
    where
        G: PackingDomain<Place = P>,
        G::Metric: MetricSpace<Place = P, Hash = B>,
    {
        let census = ScanInputs {
            ground,
            bodies,
            shapes: &self.shapes,
            grid: &self.grid,
            longest: self.longest,
        };
        let mut left = portion;
        if self.nearest.len() < bodies.len() {
            let from = self.nearest.len();
            let end = from.saturating_add(left).min(bodies.len());
            left -= end - from;
            self.nearest.extend((from..end).map(|i| census.nearest(i)));
            if end < bodies.len() {
                return None;
            }
            self.change.remove = census.crowded(&self.nearest, self.most);
        }
        let Change { remove, add } = &mut self.change;
        let end = self.seen.saturating_add(left).min(bodies.len());
        for &i in &self.order[self.seen..end] {
            if add.len() >= self.most || remove[i] {
                continue;
            }
            if params.population == Population::Smallest && self.nearest[i] < LONELY {
                continue;
            }
            for site in census.sites(i) {
                add.extend(census.fitting(site, add));
            }
        }
        self.seen = end;
        let is_done = end == bodies.len();
        is_done.then(|| Change {
            remove: std::mem::take(&mut self.change.remove),
            add: std::mem::take(&mut self.change.add),
        })
    }
}

/// Whether a new cell has room between the walls: false between two walls that are closer than the size of a cell.
fn clear_of_walls<G: PackingDomain>(place: G::Place, shape: &CellShape, ground: G) -> bool {
    let mut near = Vec::new();
    ground
        .walls()
        .closest_points(place, shape.length(), &mut near);
    let least = match ground.boundary() {
        BoundaryCondition::Wall => 0.4,
        BoundaryCondition::On => 0.7,
    };
    let is_clear =
        |wall: &ClosestPointOf<G>| wall.distance() >= least * shape.extent(wall.inward());
    near.iter().all(is_clear)
}

/// The next body of a row.
struct NextInRow {
    body: usize,
    /// The offset to it, and the same offset continued from it.
    way: DVec2,
    onwards: DVec2,
    /// The distance to it, in stable distances.
    far: f64,
}

impl<G: PackingDomain> ScanInputs<'_, G> {
    /// The candidate places beside a body.
    fn sites(&self, i: usize) -> Vec<CandidatePlace<G::Place>> {
        let centre = self.bodies[i].particle.centre;
        let at = |p: G::Place| {
            let place = self.ground.metric().wrap(p);
            CandidatePlace::new(place, CellShape::metric_at(self.ground.fields(), place))
        };
        let beside = match G::Metric::WALKS {
            true => self.beside(i),
            false => Vec::new(),
        };
        let is_open = |to: DVec2| !is_taken(&self.shapes[i], to, &beside);
        let mut sites = Vec::with_capacity(8);
        for place in slots(centre, self.shapes[i], self.ground, is_open) {
            let site = at(place);
            let has_corners = site.shape.kind().has_corners();
            sites.push(site);
            if has_corners && let Some(middle) = self.in_loose_row(i, place) {
                sites.push(CandidatePlace {
                    room: SQUEEZED,
                    ..at(middle)
                });
            }
        }
        sites
    }

    /// The bodies that touch one, as seen from it.
    fn beside(&self, i: usize) -> Vec<(DVec2, CellShape)> {
        let mut beside = Vec::with_capacity(8);
        let (at, shape) = (self.bodies[i].particle.centre, &self.shapes[i]);
        self.any_near(at, shape, TOUCHING, |k, r, turn| {
            let other = self.shapes[k].seen(turn);
            if k != i && shape.is_closer(&other, r, TOUCHING) {
                beside.push((r, other));
            }
            false
        });
        beside
    }

    /// The place of a candidate that has room for a cell; where the outline is narrow, moved onto its centre
    /// line.
    fn fitting(
        &self,
        CandidatePlace { place, shape, room }: CandidatePlace<G::Place>,
        add: &[G::Place],
    ) -> Option<G::Place> {
        let ground = self.ground;
        let is_free = |place: G::Place, shape: &CellShape| {
            let is_near = |&other: &G::Place| {
                let way = ground.metric().log(place, other);
                way.is_some_and(|(r, _)| shape.is_closer(shape, r, room))
            };
            self.is_free(place, shape, room) && !add.iter().any(is_near)
        };
        if !is_free(place, &shape) {
            return None;
        }
        if ground.has_room(place) && clear_of_walls(place, &shape, ground) {
            return Some(place);
        }
        ground
            .middle_of_narrow(place)
            .filter(|&middle| is_free(middle, &CellShape::metric_at(ground.fields(), middle)))
    }

    /// The midpoint of the gap between a body and the next one of its row at `to`, if the row is loose there
    /// and has no wider gap.
    fn in_loose_row(&self, i: usize, to: G::Place) -> Option<G::Place> {
        if !self.shapes[i].kind().has_corners() {
            return None;
        }
        let NextInRow {
            body: next,
            way,
            onwards,
            far: gap,
        } = self.next(i, to)?;
        if gap < GAP {
            return None;
        }
        let mut slack = gap - 1.0;
        for (mut at, mut along) in [(next, onwards), (i, -way)] {
            for _ in 0..WINDOW {
                let touching = along / self.shapes[at].cells_along(along);
                let (to, _) = self
                    .ground
                    .metric()
                    .exp(self.bodies[at].particle.centre, touching);
                let Some(next) = self.next(at, to) else {
                    break;
                };
                if next.far > gap {
                    return None;
                }
                slack += next.far - 1.0;
                (at, along) = (next.body, next.onwards);
            }
        }
        let middle = || {
            self.ground
                .metric()
                .exp(self.bodies[i].particle.centre, 0.5 * way)
        };
        (slack > LOOSE).then(|| middle().0)
    }

    /// The next body of a row: the one at the place where it would touch this one.
    fn next(&self, i: usize, to: G::Place) -> Option<NextInRow> {
        let (centre, shape) = (self.bodies[i].particle.centre, &self.shapes[i]);
        let mut best = None;
        let mut least = ROW;
        self.any_near(to, shape, ROW, |k, r, turn| {
            let far = shape.normalised_distance(&self.shapes[k].seen(turn), r);
            if k != i && far < least && !self.ground.metric().is_parted(to, r) {
                (least, best) = (far, Some(k));
            }
            false
        });
        let body = best?;
        let (way, turn) = self
            .ground
            .metric()
            .log(centre, self.bodies[body].particle.centre)?;
        Some(NextInRow {
            body,
            way,
            onwards: turn.undo(way),
            far: shape.normalised_distance(&self.shapes[body].seen(turn), way),
        })
    }

    /// The smallest w between a body and the others (2 if none is near).
    fn nearest(&self, i: usize) -> f64 {
        let (at, shape) = (self.bodies[i].particle.centre, &self.shapes[i]);
        let mut least = 2.0_f64;
        self.any_near(at, shape, 1.0, |k, r, turn| {
            let far = shape.normalised_distance(&self.shapes[k].seen(turn), r);
            if k != i && far < least && !self.ground.metric().is_parted(at, r) {
                least = far;
            }
            false
        });
        least
    }

    /// Whether every body is at least `room` stable distances away from this place.
    fn is_free(&self, at: G::Place, shape: &CellShape, room: f64) -> bool {
        !self.any_near(at, shape, room, |k, r, turn| {
            shape.is_closer(&self.shapes[k].seen(turn), r, room)
                && !self.ground.metric().is_parted(at, r)
        })
    }

    /// Whether a test holds for any body that may be nearer than `w` stable distances. The test gets the
    /// body's number, the offset to it, which may cross walls, and the parallel transport from there.
    fn any_near(
        &self,
        at: G::Place,
        shape: &CellShape,
        w: f64,
        mut test: impl FnMut(usize, DVec2, TransportOf<G>) -> bool,
    ) -> bool {
        let reach = w * 0.5 * (shape.length() + self.longest);
        self.ground.metric().any_near(self.grid, at, reach, |k| {
            let other = self.bodies[k].particle.centre;
            let way = self.ground.metric().log_within(at, other, reach);
            way.is_some_and(|(r, turn)| test(k, r, turn))
        })
    }

    /// The bodies to remove: the most crowded first, and never two neighbours at once.
    fn crowded(&self, nearest: &[f64], most: usize) -> Vec<bool> {
        let mut tight: Vec<usize> = (0..nearest.len())
            .filter(|&i| nearest[i] < limits(self.shapes[i].kind()).0)
            .filter(|&i| !self.bodies[i].particle.fixed)
            .collect();
        order::sort(&mut tight, |&i| {
            let id = u64::from(self.bodies[i].particle.id);
            (order::rank(nearest[i]), !id)
        });
        let mut remove = vec![false; nearest.len()];
        let mut count = 0;
        for i in tight {
            let (centre, shape) = (self.bodies[i].particle.centre, &self.shapes[i]);
            let reach = 1.5 * self.longest;
            let beside = self
                .ground
                .metric()
                .any_near(self.grid, centre, reach, |k| {
                    let way = || {
                        self.ground
                            .metric()
                            .log(centre, self.bodies[k].particle.centre)
                    };
                    remove[k] && way().is_some_and(|(r, _)| shape.is_closer(shape, r, 1.5))
                });
            if !beside && count < most {
                remove[i] = true;
                count += 1;
            }
        }
        remove
    }
}
