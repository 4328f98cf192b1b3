//! The places at which the population scan may add cells.

use super::BoundaryCondition;
use super::front::{is_taken, slots};
use super::packing_domain::{Boundary, ClosestPoint, ClosestPointOf, MetricSpace, PackingDomain};
use super::population::ScanInputs;
use super::shape::CellShape;
use super::transport::ParallelTransport;
use glam::DVec2;

/// A row or column is loose if its summed slack exceeds this, in stable distances. A cell is added in its widest gap.
const LOOSE: f64 = 0.6;
/// The slack is summed over this many gaps on each side of the widest gap.
const WINDOW: usize = 3;
/// The widest gap of a loose row takes a cell only if its ends are at least this far apart, in stable distances.
const GAP: f64 = 1.2;
/// The midpoint of that gap must be at least this far from all cells, in stable distances.
const SQUEEZED: f64 = 0.58;
/// Bodies at most this far apart, in stable distances, touch and leave no gap.
const TOUCHING: f64 = 1.15;
/// The next cell of a row is at most this far from the place where it would touch, in stable distances.
const ROW: f64 = 0.55;

/// A candidate place for a new cell.
pub(super) struct CandidatePlace<P> {
    place: P,
    /// The shape of a cell at that place.
    shape: CellShape,
    /// The least distance to all cells that the place needs, in stable distances.
    room: f64,
}

/// Whether a new cell has room between the walls: false between two walls that are closer than the size of a cell.
fn clear_of_walls<G: PackingDomain>(place: G::Place, shape: &CellShape, ground: G) -> bool {
    let mut near = Vec::new();
    ground
        .walls()
        .closest_points(place, shape.length(), &mut near);
    let least = match ground.boundary() {
        BoundaryCondition::Wall | BoundaryCondition::Open => 0.4,
        BoundaryCondition::On => 0.7,
    };
    let is_clear =
        |wall: &ClosestPointOf<G>| wall.distance() >= least * shape.extent(wall.inward());
    near.iter().all(is_clear)
}

/// The next body of a row.
struct NextInRow {
    body: usize,
    /// The offset to it from the body before; `onwards` is that offset in the frame of `body`, to continue the row.
    way: DVec2,
    onwards: DVec2,
    /// The length of `way`, in stable distances.
    far: f64,
}

impl<G: PackingDomain> ScanInputs<'_, G> {
    /// The place opposite a body's nearest neighbour, at the stable distance. `None` where there is no room, and beside
    /// another new cell, because two cells in one place would never part.
    pub(super) fn opposite(&self, i: usize, add: &[G::Place]) -> Option<G::Place> {
        let (centre, shape) = (self.bodies[i].particle.centre, &self.shapes[i]);
        let metric = self.ground.metric();
        let mut nearest = (2.0_f64, -shape.size * shape.places().next()?);
        self.any_near(centre, shape, 1.0, |k, r, turn| {
            let far = shape.normalised_distance(&self.shapes[k].seen(turn), r);
            if k != i && far > 0.0 && far < nearest.0 && !metric.is_parted(centre, r) {
                nearest = (far, r / far);
            }
            false
        });
        let place = metric.wrap(metric.exp(centre, -nearest.1).0);
        let is_beside = |&other: &G::Place| {
            let way = metric.log(place, other);
            way.is_some_and(|(r, _)| shape.is_closer(shape, r, self.crowding(shape.kind())))
        };
        (self.ground.has_room(place) && !add.iter().any(is_beside)).then_some(place)
    }

    /// The candidate places beside a body.
    pub(super) fn sites(&self, i: usize) -> Vec<CandidatePlace<G::Place>> {
        let centre = self.bodies[i].particle.centre;
        let at = |p: G::Place| {
            let place = self.ground.metric().wrap(p);
            let shape = CellShape::metric_at(self.ground.fields(), place);
            let room = self.room(shape.kind());
            CandidatePlace { place, shape, room }
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

    /// The bodies that touch body `i`, by offset and shape in its frame.
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
    pub(super) fn fitting(
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

    /// The body after `i` in a row: the body nearest to `to`, the place where a neighbour would touch.
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

    /// Whether every body is at least `room` stable distances away from this place.
    fn is_free(&self, at: G::Place, shape: &CellShape, room: f64) -> bool {
        !self.any_near(at, shape, room, |k, r, turn| {
            shape.is_closer(&self.shapes[k].seen(turn), r, room)
                && !self.ground.metric().is_parted(at, r)
        })
    }
}
