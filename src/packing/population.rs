//! Adds cells where there is room and removes them where it is too tight.
//!
//! Miyata, Itoh, Shimada (2000), section 4.3; the rule with the smallest w is that of Itoh, Miyata,
//! Shimada (2003), section 5.1. Attraction keeps the smallest w near 1 beside the largest gaps, so
//! by default a cell's four edges are tested for an empty place instead.

use super::grid::Grid;
use super::placement::{has_room, slots};
use super::{Body, Edge, PackingParams, Population};
use crate::domain::{Domain, Facing};
use crate::field::Fields;
use crate::order;
use glam::DVec2;

/// A cell goes where its nearest neighbour is nearer than this, in stable distances.
const TOO_TIGHT: f64 = 0.66;
/// A cell comes where the nearest is at least this far.
const ROOM: f64 = 0.72;
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
    bodies: &'a [Body],
    grid: Grid,
    largest: f64,
}

pub(super) fn change(
    domain: &Domain,
    fields: &Fields,
    facing: &Facing,
    bodies: &[Body],
    params: &PackingParams,
) -> Change {
    let largest = bodies.iter().fold(0.0_f64, |m, b| m.max(b.particle.size));
    let (lo, hi) = domain.bounds();
    let mut census = Census {
        bodies,
        grid: Grid::new(lo, hi, largest),
        largest,
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
        let p = &bodies[i].particle;
        for place in slots(p.centre, p.size, fields) {
            let free = census.gap(place, fields.size(place), usize::MAX) >= ROOM
                && add
                    .iter()
                    .all(|other| other.distance(place) >= ROOM * fields.size(place));
            if free
                && has_room(place, fields, domain, facing, params.edge)
                && clear_of_walls(place, fields, facing, params.edge)
            {
                add.push(place);
            }
        }
    }
    Change { remove, add }
}

/// A new cell may not stand between two walls that are nearer to each other than a cell.
fn clear_of_walls(place: DVec2, fields: &Fields, facing: &Facing, edge: Edge) -> bool {
    let mut feet = Vec::new();
    let size = fields.size(place);
    facing.feet(place, size, &mut feet);
    let least = if edge == Edge::Wall { 0.4 } else { 0.7 };
    feet.iter().all(|foot| foot.distance >= least * size)
}

impl Census<'_> {
    /// The smallest w between a body and the others (2 where none is near).
    fn nearest(&self, i: usize) -> f64 {
        let p = &self.bodies[i].particle;
        self.gap(p.centre, p.size, i)
    }

    fn gap(&self, at: DVec2, size: f64, but: usize) -> f64 {
        let mut least = 2.0_f64;
        self.grid.near(at, 0.5 * (size + self.largest), |k| {
            if k != but {
                let other = &self.bodies[k].particle;
                least = least.min(other.centre.distance(at) / (0.5 * (size + other.size)));
            }
        });
        least
    }

    /// The tightest first, and no two neighbours in one look.
    fn crowded(&self, nearest: &[f64], most: usize) -> Vec<bool> {
        let mut tight: Vec<usize> = (0..nearest.len())
            .filter(|&i| nearest[i] < TOO_TIGHT && !self.bodies[i].particle.fixed)
            .collect();
        order::sort(&mut tight, |&i| {
            let id = u64::from(self.bodies[i].particle.id);
            (order::rank(nearest[i]), !id)
        });
        let mut remove = vec![false; nearest.len()];
        let mut count = 0;
        for i in tight {
            let p = &self.bodies[i].particle;
            let mut beside = false;
            self.grid.near(p.centre, 1.5 * self.largest, |k| {
                let near = self.bodies[k].particle.centre.distance(p.centre) < 1.5 * p.size;
                beside |= remove[k] && near;
            });
            if !beside && count < most {
                remove[i] = true;
                count += 1;
            }
        }
        remove
    }
}
