//! The equation of motion m x'' + c x' = f (Miyata, Itoh, Shimada 2000, eq. 5), m = 1.
//!
//! Time is in units of sqrt(m d^2 / k0), so that one set of constants serves all sizes.

use super::force::{Pair, SQUARE_REACH};
use super::grid::{Grid, images};
use super::shape::Shape;
use super::wall::{keep_inside, wall_force};
use super::{Body, Integrator};
use crate::domain::{Domain, Facing, Foot};
use crate::field::{Fields, Kind};
use crate::order;
use glam::DVec2;

/// Viscous damping c. A honeycomb of circles has more faults to heal than rows and columns: circles
/// keep swinging for longer.
const fn damping(kind: Kind) -> f64 {
    if matches!(kind, Kind::Circle) { 0.2 } else { 2.0 }
}
/// Time step of the semi-implicit method.
const SEMI_IMPLICIT_STEP: f64 = 0.5;
/// Time step of the Runge-Kutta method; stable while damping times step stays below 2.
const RUNGE_KUTTA_STEP: f64 = 0.6;
/// No cell moves farther than this share of its size in one step.
const LONGEST_MOVE: f64 = 0.25;
/// Neighbours are looked for this much farther than forces reach (in the largest size), and again
/// when a cell has moved half as far.
const SKIN: f64 = 0.25;

/// The neighbour list and the forces.
#[derive(Clone, Debug, Default)]
pub(super) struct Motion {
    /// For body i the later neighbours are `list[start[i]..start[i + 1]]`.
    start: Vec<u32>,
    list: Vec<u32>,
    forces: Vec<DVec2>,
    /// Where the bodies were when the list was made.
    made_at: Vec<DVec2>,
    slack: f64,
    feet: Vec<Foot>,
    gauges: Vec<Gauge>,
}

#[derive(Clone, Copy, Debug)]
struct Gauge {
    centre: DVec2,
    axis: DVec2,
    size: f64,
}

/// What one step needs to know of its surroundings.
#[derive(Clone, Copy)]
pub(super) struct Surroundings<'a> {
    pub domain: &'a Domain,
    pub fields: &'a Fields,
    pub facing: &'a Facing,
}

impl Motion {
    /// The bodies have changed: make the list again.
    pub fn forget(&mut self) {
        self.made_at.clear();
    }

    /// Makes the neighbour list again where it may have become wrong. The bodies are put in the
    /// order of the grid's buckets first, so that neighbours lie near in memory too.
    pub fn refresh(&mut self, bodies: &mut [Body], domain: &Domain) {
        let limit = 0.25 * self.slack * self.slack;
        let fresh = self.made_at.len() == bodies.len()
            && bodies
                .iter()
                .zip(&self.made_at)
                .all(|(body, &at)| body.particle.centre.distance_squared(at) < limit);
        if fresh || bodies.is_empty() {
            return;
        }
        let first = bodies[0].particle.centre;
        let (mut lo, mut hi) = (first, first);
        let (mut largest, mut longest, mut root) = (0.0_f64, 0.0_f64, 1.0_f64);
        for body in bodies.iter() {
            lo = lo.min(body.particle.centre);
            hi = hi.max(body.particle.centre);
            let shape = Shape::of(&body.particle);
            largest = largest.max(shape.size);
            longest = longest.max(shape.length());
            root = root.max(shape.root);
        }
        let slack = SKIN * largest;
        // A move counts for more across a stretched cell than along it.
        self.slack = slack / root;
        let reach = SQUARE_REACH * longest + slack;
        let grid = Grid::new(lo, hi, reach / 2.0);
        let place = |b: &Body| (grid.bucket(b.particle.centre) as u64, b.particle.id.into());
        order::sort(bodies, place);
        self.made_at = bodies.iter().map(|b| b.particle.centre).collect();
        self.forces.resize(bodies.len(), DVec2::ZERO);
        self.collect_pairs(bodies, domain, &grid, (reach, slack));
    }

    /// The bodies are in the order of the grid's buckets, so those of a run of buckets are a run of
    /// bodies, and only the ones after the body itself are looked at.
    fn collect_pairs(
        &mut self,
        bodies: &[Body],
        domain: &Domain,
        grid: &Grid,
        (reach, slack): (f64, f64),
    ) {
        let mut firsts = vec![0; grid.buckets() + 1];
        for body in bodies {
            firsts[grid.bucket(body.particle.centre) + 1] += 1;
        }
        for k in 1..firsts.len() {
            firsts[k] += firsts[k - 1];
        }
        self.list.clear();
        self.start.clear();
        self.start.push(0);
        let period = domain.period();
        let plain = period.is_none() && domain.lines().is_empty();
        for (i, body) in bodies.iter().enumerate() {
            let centre = body.particle.centre;
            let shape = Shape::of(&body.particle);
            for image in images(period, centre, reach) {
                for run in grid.runs_near(image, reach) {
                    let end = firsts[run.end];
                    let first = firsts[run.start].max(i + 1).min(end);
                    for (other, j) in bodies[first..end].iter().zip(first as u32..) {
                        let r = other.particle.centre - image;
                        let meets = shape.may_touch(&Shape::of(&other.particle), r, slack);
                        if meets && (plain || self.meets(body, other, r, domain)) {
                            self.list.push(j);
                        }
                    }
                }
            }
            self.start.push(self.list.len() as u32);
        }
    }

    /// Is there no wall between two cells, and is `r` the shortest way between them on the torus?
    fn meets(&self, body: &Body, other: &Body, r: DVec2, domain: &Domain) -> bool {
        let (a, b) = (&body.particle, &other.particle);
        let half = domain.period().map_or(f64::INFINITY, |side| 0.5 * side);
        r.abs().max_element() <= half
            && (a.fixed || b.fixed || !domain.crosses_line(a.centre, b.centre))
    }

    /// The pairs that may touch, each once.
    fn pairs<'a>(&'a self, bodies: &'a [Body]) -> impl Iterator<Item = (usize, usize)> + 'a {
        (0..bodies.len()).flat_map(|i| {
            self.list[self.start[i] as usize..self.start[i + 1] as usize]
                .iter()
                .map(move |&j| (i, j as usize))
        })
    }

    /// See [`super::Packing::energy`].
    pub fn energy(&self, bodies: &[Body], domain: &Domain) -> f64 {
        let mut sum = 0.0;
        let mut stiffness = 0.0;
        for (i, j) in self.pairs(bodies) {
            let (a, b) = (&bodies[i].particle, &bodies[j].particle);
            sum += Pair::new(a, b).potential(domain.shortest(b.centre - a.centre));
        }
        for body in bodies {
            stiffness += body.particle.size * body.particle.size / bodies.len() as f64;
        }
        if bodies.is_empty() {
            0.0
        } else {
            sum / stiffness
        }
    }

    fn evaluate(&mut self, bodies: &[Body], around: Surroundings) {
        self.forces.fill(DVec2::ZERO);
        self.gauges.clear();
        self.gauges.extend(bodies.iter().map(|body| Gauge {
            centre: body.particle.centre,
            axis: body.particle.axis,
            size: body.particle.size,
        }));
        for i in 0..bodies.len() {
            let a = bodies[i].particle;
            let mut total = DVec2::ZERO;
            for k in self.start[i] as usize..self.start[i + 1] as usize {
                let j = self.list[k] as usize;
                let b = &self.gauges[j];
                let r = around.domain.shortest(b.centre - a.centre);
                let reach = SQUARE_REACH * 0.5 * (a.size + b.size);
                if r.length_squared() >= reach * reach {
                    continue;
                }
                let force = Pair::squares((a.axis, b.axis), (a.size, b.size)).force(r);
                self.forces[j] += force;
                total -= force;
            }
            self.forces[i] += total + wall_force(&bodies[i], around.facing, &mut self.feet);
        }
    }

    /// One step; answers the largest move and the largest force on a free cell, in its size.
    pub fn step(
        &mut self,
        bodies: &mut [Body],
        around: Surroundings,
        integrator: Integrator,
        pace: f64,
    ) -> (f64, f64) {
        self.evaluate(bodies, around);
        let mut largest_force = 0.0_f64;
        for (body, force) in bodies.iter().zip(&self.forces) {
            if !body.particle.fixed {
                largest_force = largest_force.max(force.length() / body.particle.size);
            }
        }
        let moves = match integrator {
            Integrator::SemiImplicit => self.semi_implicit(bodies, pace),
            Integrator::RungeKutta => self.runge_kutta(bodies, around, pace),
        };
        let mut largest_move = 0.0_f64;
        for (body, by) in bodies.iter_mut().zip(moves) {
            if body.particle.fixed {
                continue;
            }
            let before = body.particle.centre;
            let shape = Shape::of(&body.particle);
            let by = by.clamp_length_max(LONGEST_MOVE * body.particle.size);
            let centre = keep_inside(before, before + by, shape, around);
            body.place(centre, around.fields);
            largest_move =
                largest_move.max(around.domain.shortest(centre - before).length() / shape.size);
        }
        (largest_move, largest_force)
    }

    fn semi_implicit(&self, bodies: &mut [Body], pace: f64) -> Vec<DVec2> {
        let h = SEMI_IMPLICIT_STEP;
        let each = bodies.iter_mut().zip(&self.forces);
        each.map(|(body, &force)| {
            body.velocity = (body.velocity + h * force) / (1.0 + h * damping(body.particle.kind));
            pace * h * body.velocity
        })
        .collect()
    }

    /// The classical scheme on (x, v); the first evaluation has been made.
    fn runge_kutta(&mut self, bodies: &mut [Body], around: Surroundings, pace: f64) -> Vec<DVec2> {
        let h = pace * RUNGE_KUTTA_STEP;
        let start: Vec<(DVec2, DVec2)> = bodies
            .iter()
            .map(|b| (b.particle.centre, b.velocity))
            .collect();
        let mut velocity: Vec<DVec2> = start.iter().map(|&(_, v)| v).collect();
        let mut sums = vec![(DVec2::ZERO, DVec2::ZERO); bodies.len()];
        for (stage, weight) in [1.0, 2.0, 2.0, 1.0].into_iter().enumerate() {
            if stage > 0 {
                self.evaluate(bodies, around);
            }
            let ahead = if stage == 2 { h } else { 0.5 * h };
            for (i, body) in bodies.iter_mut().enumerate() {
                if body.particle.fixed {
                    continue;
                }
                let (slope, pull) = (
                    velocity[i],
                    self.forces[i] - damping(body.particle.kind) * velocity[i],
                );
                sums[i].0 += weight / 6.0 * slope;
                sums[i].1 += weight / 6.0 * pull;
                if stage < 3 {
                    body.place(start[i].0 + ahead * slope, around.fields);
                    velocity[i] = start[i].1 + ahead * pull;
                }
            }
        }
        let each = bodies.iter_mut().zip(start).zip(sums);
        each.map(|((body, (centre, v)), (slope, pull))| {
            body.particle.centre = centre;
            body.velocity = v + h * pull;
            h * slope
        })
        .collect()
    }
}
