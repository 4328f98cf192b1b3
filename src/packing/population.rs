//! Adds cells where there is room and removes them where they are crowded.
//!
//! Miyata, Itoh, Shimada (2000), section 4.3; the rule by the smallest w, the distance to the nearest cell in stable
//! distances, is that of Itoh, Miyata, Shimada (2003), section 5.1. Attraction keeps the smallest w near 1 even beside
//! the largest gaps. So by default the places around a cell, four for squares and six for round cells, are tested for
//! an empty one instead. Rows and columns hold a whole number of cells. The remaining length may be spread over several
//! gaps, none as wide as a cell, so rows are also measured over several cells.

use super::body::MovingParticle;
use super::packing_domain::{HashOf, MetricSpace, PackingDomain, SpatialHash, TransportOf};
use super::shape::CellShape;
use super::{PackingParams, Population};
use crate::field::CellKind;
use crate::order;
use glam::DVec2;

/// Two limits in stable distances. A cell is removed if its nearest neighbour is nearer than the first. A cell is added
/// at a place whose nearest cell is at least as far as the second. Round cells are added in smaller gaps, because all
/// six cells around a gap make room.
const fn limits(kind: CellKind) -> (f64, f64) {
    if kind.has_corners() {
        (0.66, 0.72)
    } else {
        (0.74, 0.63)
    }
}
/// The papers' rule adds a cell beside one whose nearest neighbour is at least this far, in stable distances.
const LONELY: f64 = 1.02;
/// The largest share of the cells that is removed, or added, at once.
const MOST_CHANGED: f64 = 0.1;

/// Planned changes: `remove[i]` for body i, and the centres of new cells.
#[derive(Clone, Debug)]
pub(crate) struct Change<P> {
    pub remove: Vec<bool>,
    pub add: Vec<P>,
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
    /// The number of bodies of `order` that have been scanned.
    seen: usize,
    most: usize,
    change: Change<P>,
}

/// The data that a scan reads: the bodies, their shapes, and the spatial hash that finds them.
pub(super) struct ScanInputs<'a, G: PackingDomain> {
    pub(super) ground: G,
    pub(super) bodies: &'a [MovingParticle<G::Place>],
    pub(super) shapes: &'a [CellShape],
    pub(super) grid: &'a HashOf<G>,
    pub(super) longest: f64,
    pub(super) params: &'a PackingParams,
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

    /// Scans the next `portion` bodies; gives the change when all have been scanned. The bodies must not change during
    /// the scan.
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
            params,
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
            if params.population != Population::Slots && self.nearest[i] < census.lonely() {
                continue;
            }
            if params.population == Population::Opposite {
                add.extend(census.opposite(i, add));
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

impl<G: PackingDomain> ScanInputs<'_, G> {
    /// A cell of this kind is crowded if its smallest w is below this.
    pub(super) fn crowding(&self, kind: CellKind) -> f64 {
        self.params.physics.crowded.unwrap_or(limits(kind).0)
    }

    /// The least distance of an empty place to all cells, in stable distances.
    pub(super) fn room(&self, kind: CellKind) -> f64 {
        let asked = self.params.physics.roomy;
        let asked = asked.filter(|_| self.params.population == Population::Slots);
        asked.unwrap_or(limits(kind).1)
    }

    /// The papers' rule adds a cell beside one whose smallest w is at least this.
    fn lonely(&self) -> f64 {
        self.params.physics.roomy.unwrap_or(LONELY)
    }

    /// The smallest w between a body and all other bodies (2 if none is near).
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

    /// Whether a test holds for any body that may be nearer than `w` stable distances. The test gets the
    /// body's number, the offset to it, which may cross walls, and the parallel transport from there.
    pub(super) fn any_near(
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
            .filter(|&i| nearest[i] < self.crowding(self.shapes[i].kind()))
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
