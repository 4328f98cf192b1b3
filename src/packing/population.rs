//! Adds cells where there is room and removes them where it is too tight.
//!
//! Miyata, Itoh, Shimada (2000), section 4.3; the rule with the smallest w is that of Itoh, Miyata,
//! Shimada (2003), section 5.1. Attraction keeps the smallest w near 1 beside the largest gaps, so
//! by default the places around a cell, four of squares and six of round cells, are tested for an empty
//! one instead.

use super::front::slots;
use super::grid::Grid;
use super::integrate::Surroundings;
use super::placement::has_room;
use super::shape::Shape;
use super::{Body, Edge, PackingParams, Population};
use crate::domain::{Domain, Facing};
use crate::field::Kind;
use crate::order::{self, lesser};
use glam::DVec2;

/// A cell goes where its nearest neighbour is nearer than the first, in stable distances; one comes
/// where the nearest is at least as far as the second. Round cells have six neighbours that share a
/// gap: one comes into a smaller gap, and the six make room.
const fn limits(kind: Kind) -> (f64, f64) {
    if kind.has_corners() {
        (0.66, 0.72)
    } else {
        (0.74, 0.63)
    }
}
/// The papers' rule adds beside a cell whose nearest neighbour is farther than this.
const LONELY: f64 = 1.02;
/// The largest share of the cells changed in one look.
const MOST_CHANGED: f64 = 0.1;

/// What to change: `remove[i]` for the body i, and the centres of new cells.
pub(super) struct Change {
    pub remove: Vec<bool>,
    pub add: Vec<DVec2>,
}

struct Census<'a> {
    domain: &'a Domain,
    bodies: &'a [Body],
    shapes: Vec<Shape>,
    grid: Grid,
    longest: f64,
}

pub(super) fn change(around: Surroundings, bodies: &[Body], params: &PackingParams) -> Change {
    let Surroundings {
        domain,
        fields,
        facing,
    } = around;
    let shapes: Vec<Shape> = bodies.iter().map(|b| Shape::of(&b.particle)).collect();
    let longest = shapes.iter().fold(0.0_f64, |m, s| m.max(s.length()));
    let (lo, hi) = domain.bounds();
    let mut census = Census {
        domain,
        bodies,
        shapes,
        grid: Grid::new(lo, hi, longest),
        longest,
    };
    for body in bodies {
        census.grid.push(body.particle.centre);
    }
    let nearest: Vec<f64> = (0..bodies.len()).map(|i| census.nearest(i)).collect();
    let most = (MOST_CHANGED * bodies.len() as f64).ceil() as usize;
    let remove = census.crowded(&nearest, most);
    let mut add: Vec<DVec2> = Vec::new();
    // In the order of ids, not of memory: the order in memory follows the moves of all.
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    order::sort(&mut order, |&i| (bodies[i].particle.id.into(), 0));
    for i in order {
        if add.len() >= most || remove[i] {
            continue;
        }
        if params.population == Population::Smallest && nearest[i] < LONELY {
            continue;
        }
        for place in slots(bodies[i].particle.centre, census.shapes[i], fields) {
            let place = domain.wrap(place);
            let shape = Shape::gauge(fields, place);
            let (_, room) = limits(shape.kind());
            let free = census.is_free(place, &shape, room)
                && add
                    .iter()
                    .all(|&other| !shape.is_closer(&shape, domain.shortest(other - place), room));
            if free
                && has_room(place, around, params.edge)
                && clear_of_walls(place, &shape, facing, params.edge)
            {
                add.push(place);
            }
        }
    }
    Change { remove, add }
}

/// A new cell may not stand between two walls that are nearer to each other than a cell.
fn clear_of_walls(place: DVec2, shape: &Shape, facing: &Facing, edge: Edge) -> bool {
    let mut feet = Vec::new();
    facing.feet(place, shape.length(), &mut feet);
    let least = if edge == Edge::Wall { 0.4 } else { 0.7 };
    feet.iter()
        .all(|foot| foot.distance >= least * shape.extent(foot.inward))
}

impl Census<'_> {
    /// The smallest w between a body and the others (2 where none is near).
    fn nearest(&self, i: usize) -> f64 {
        let (at, shape) = (self.bodies[i].particle.centre, &self.shapes[i]);
        let mut least = 2.0_f64;
        self.any_near(at, shape, 1.0, |k, r| {
            if k != i {
                least = lesser(least, shape.closeness(&self.shapes[k], r));
            }
            false
        });
        least
    }

    /// Is every body at least `room` stable distances away from this place?
    fn is_free(&self, at: DVec2, shape: &Shape, room: f64) -> bool {
        !self.any_near(at, shape, room, |k, r| {
            shape.is_closer(&self.shapes[k], r, room)
        })
    }

    /// Does it hold for any body that may be nearer than `w` stable distances, with no wall between?
    fn any_near(
        &self,
        at: DVec2,
        shape: &Shape,
        w: f64,
        mut test: impl FnMut(usize, DVec2) -> bool,
    ) -> bool {
        let (domain, period) = (self.domain, self.domain.period());
        let reach = w * 0.5 * (shape.length() + self.longest);
        self.grid.any_near(period, at, reach, |k| {
            let way = domain.shortest(self.bodies[k].particle.centre - at);
            !domain.is_parted(at, at + way) && test(k, way)
        })
    }

    /// The tightest first, and no two neighbours in one look.
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
            let (period, reach) = (self.domain.period(), 1.5 * self.longest);
            let beside = self.grid.any_near(period, centre, reach, |k| {
                let r = self.bodies[k].particle.centre - centre;
                remove[k] && shape.is_closer(shape, self.domain.shortest(r), 1.5)
            });
            if !beside && count < most {
                remove[i] = true;
                count += 1;
            }
        }
        remove
    }
}
