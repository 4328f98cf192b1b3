//! The equation of motion m x'' + c x' = f (Miyata, Itoh, Shimada 2000, eq. 5), m = 1.
//!
//! Time is in units of sqrt(m d^2 / k0), so that one set of constants serves all sizes.

use super::force::{Pair, force_between};
use super::grid::Grid;
use super::shape::{SQUARE_REACH, Shape};
use super::wall::{keep_inside, stays_clear, wall_force};
use super::{Body, Integrator, Particle, Surroundings};
use crate::domain::{Domain, Projection};
use crate::field::Kind;
use crate::order::greater;
use glam::DVec2;

/// Viscous damping c. A honeycomb of circles has more faults to heal than rows and columns: circles
/// keep swinging for longer.
const fn damping(kind: Kind) -> f64 {
    if matches!(kind, Kind::Circle) {
        0.2
    } else {
        2.0
    }
}
/// Time step of the semi-implicit method.
const SEMI_IMPLICIT_STEP: f64 = 0.5;
/// Time step of the Runge-Kutta method; stable while damping times step stays below 2.
const RUNGE_KUTTA_STEP: f64 = 0.6;
/// No cell moves farther than this share of its size in one step.
const LONGEST_MOVE: f64 = 0.25;
/// Neighbours are looked for this much farther than forces reach (in the largest size), and again
/// when a cell has moved half as far (Verlet 1967).
const VERLET_MARGIN: f64 = 0.25;

/// A move of less than this share of its size is none: a cell rests while neither it nor any of its
/// neighbours moves. The force it is left with is far below the one at which a run ends.
const fn least_move(kind: Kind) -> f64 {
    if matches!(kind, Kind::Circle) {
        0.0
    } else {
        REST
    }
}
/// See [`least_move`].
const REST: f64 = 0.002;

/// The neighbour list and the forces.
#[derive(Clone, Debug, Default)]
pub(super) struct Motion {
    /// For body i the later neighbours are `list[start[i]..start[i + 1]]`.
    start: Vec<u32>,
    list: Vec<u32>,
    /// Which bodies do not rest.
    awake: Vec<bool>,
    forces: Vec<DVec2>,
    /// How far from the walls they were, at least, when the step began.
    clear: Vec<f64>,
    /// Where the bodies were when the list was made.
    made_at: Vec<DVec2>,
    margin: f64,
    near_walls: Vec<Projection>,
    pair_data: Vec<PairData>,
}

/// What the forces of most pairs depend on, close together in memory.
#[derive(Clone, Copy, Debug)]
struct PairData {
    centre: DVec2,
    axis: DVec2,
    size: f64,
    /// Two cells farther apart than the sum of this do not touch.
    reach: f64,
    is_square: bool,
}

impl PairData {
    fn of(particle: &Particle) -> Self {
        let stretched = particle.kind.is_stretched();
        Self {
            centre: particle.centre,
            axis: particle.axis,
            size: particle.size,
            reach: if stretched {
                f64::INFINITY
            } else {
                SQUARE_REACH * 0.5 * particle.size
            },
            is_square: particle.kind == Kind::Square,
        }
    }
}

impl Motion {
    /// The bodies have changed: make the list again.
    pub fn forget(&mut self) {
        self.made_at.clear();
    }

    /// Makes the neighbour list again where it may have become wrong. The bodies are put in the
    /// order of the grid's buckets first, so that neighbours lie near in memory too.
    pub fn refresh(&mut self, bodies: &mut [Body], domain: &Domain) {
        let limit = 0.25 * self.margin * self.margin;
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
        let margin = VERLET_MARGIN * largest;
        // A move counts for more across a stretched cell than along it.
        self.margin = margin / root;
        let reach = SQUARE_REACH * longest + margin;
        let grid = Grid::new(lo, hi, reach / 2.0);
        let firsts = sort_by_bucket(bodies, &grid);
        self.made_at = bodies.iter().map(|b| b.particle.centre).collect();
        self.forces.resize(bodies.len(), DVec2::ZERO);
        self.clear.resize(bodies.len(), 0.0);
        self.collect_pairs(bodies, domain, (&grid, &firsts), (reach, margin));
    }

    /// The bodies are in the order of the grid's buckets, so those of a run of buckets are a run of
    /// bodies, and only the ones after the body itself are looked at.
    fn collect_pairs(
        &mut self,
        bodies: &[Body],
        domain: &Domain,
        (grid, firsts): (&Grid, &[usize]),
        (reach, margin): (f64, f64),
    ) {
        self.list.clear();
        self.start.clear();
        self.start.push(0);
        let space = domain.space();
        for (i, body) in bodies.iter().enumerate() {
            let centre = body.particle.centre;
            let shape = Shape::of(&body.particle);
            for image in space.images(centre, reach) {
                for run in grid.runs_near(image, reach) {
                    let end = firsts[run.end];
                    let first = firsts[run.start].max(i + 1).min(end);
                    for (other, j) in bodies[first..end].iter().zip(first as u32..) {
                        let r = other.particle.centre - image;
                        if shape.may_touch(&Shape::of(&other.particle), r, margin)
                            && space.is_shortest(r)
                            && !is_walled_off(body, other, r, domain)
                        {
                            self.list.push(j);
                        }
                    }
                }
            }
            self.start.push(self.list.len() as u32);
        }
    }

    /// The pairs that may touch, each once.
    pub fn pairs<'a>(&'a self, bodies: &'a [Body]) -> impl Iterator<Item = (usize, usize)> + 'a {
        (0..bodies.len()).flat_map(|i| {
            self.list[self.start[i] as usize..self.start[i + 1] as usize]
                .iter()
                .map(move |&j| (i, j as usize))
        })
    }

    /// Wakes the bodies that have moved, and their neighbours.
    fn wake(&mut self, bodies: &[Body]) {
        self.awake.clear();
        self.awake.extend(bodies.iter().map(|b| b.has_moved));
        for (i, body) in bodies.iter().enumerate() {
            for &j in &self.list[self.start[i] as usize..self.start[i + 1] as usize] {
                self.awake[i] |= bodies[j as usize].has_moved;
                self.awake[j as usize] |= body.has_moved;
            }
        }
        for (awake, body) in self.awake.iter_mut().zip(bodies) {
            *awake &= !body.particle.fixed;
        }
    }

    /// The forces on those that are awake.
    fn evaluate(&mut self, bodies: &[Body], around: Surroundings, first: bool) {
        self.forces.fill(DVec2::ZERO);
        self.pair_data.clear();
        self.pair_data
            .extend(bodies.iter().map(|b| PairData::of(&b.particle)));
        for (i, body) in bodies.iter().enumerate() {
            let (a, a_awake) = (self.pair_data[i], self.awake[i]);
            let mut total = DVec2::ZERO;
            for &j in &self.list[self.start[i] as usize..self.start[i + 1] as usize] {
                let j = j as usize;
                let b = &self.pair_data[j];
                if !(a_awake || self.awake[j]) {
                    continue;
                }
                let r = around.domain.space().shortest(b.centre - a.centre);
                let reach = a.reach + b.reach;
                if r.length_squared() >= reach * reach {
                    continue;
                }
                let force = if a.is_square && b.is_square {
                    Pair::squares((a.axis, b.axis), (a.size, b.size)).force(r)
                } else {
                    force_between(&body.particle, &bodies[j].particle, r)
                };
                self.forces[j] += force;
                total -= force;
            }
            if a_awake {
                let (force, distance) = wall_force(body, around.walls, &mut self.near_walls);
                total += force;
                if first {
                    self.clear[i] = distance;
                }
            }
            self.forces[i] += total;
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
        self.wake(bodies);
        self.evaluate(bodies, around, true);
        let mut largest_force = 0.0_f64;
        for (i, body) in bodies.iter().enumerate() {
            if self.awake[i] {
                let force = self.forces[i].length() / body.particle.size;
                largest_force = greater(largest_force, force);
            }
        }
        let moves = match integrator {
            Integrator::SemiImplicit => self.semi_implicit(bodies, pace),
            Integrator::RungeKutta => self.runge_kutta(bodies, around, pace),
        };
        let (domain, space) = (around.domain, around.domain.space());
        let has_lines = !domain.lines().is_empty();
        let mut largest_move = 0.0_f64;
        for (i, (body, by)) in bodies.iter_mut().zip(moves).enumerate() {
            if !self.awake[i] {
                body.velocity = DVec2::ZERO;
                body.has_moved = false;
                continue;
            }
            let before = body.particle.centre;
            let shape = Shape::of(&body.particle);
            let by = by.clamp_length_max(LONGEST_MOVE * body.particle.size);
            let is_clear = stays_clear(self.clear[i], by.length(), shape.length());
            let centre = match is_clear && !has_lines {
                true => space.wrap(before + by),
                false => keep_inside(before, before + by, shape, around),
            };
            body.place(centre, around.fields);
            let moved = space.shortest(centre - before).length() / shape.size;
            body.has_moved = moved > least_move(body.particle.kind);
            largest_move = greater(largest_move, moved);
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
                self.evaluate(bodies, around, false);
            }
            let ahead = if stage == 2 { h } else { 0.5 * h };
            for (i, body) in bodies.iter_mut().enumerate() {
                if !self.awake[i] {
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

/// Is there a wall between two cells, `r` apart? Those fixed on a constraint line see both its sides.
fn is_walled_off(body: &Body, other: &Body, r: DVec2, domain: &Domain) -> bool {
    let (a, b) = (&body.particle, &other.particle);
    let sees_over = a.fixed || b.fixed;
    domain.is_gap_between(a.centre, b.centre)
        || (!sees_over && domain.crosses_line(a.centre, a.centre + r))
}

/// Puts bodies in the order of the buckets they lie in, in a bucket by their ids. Answers where the
/// bodies of each bucket begin.
fn sort_by_bucket(bodies: &mut [Body], grid: &Grid) -> Vec<usize> {
    let buckets: Vec<usize> = bodies
        .iter()
        .map(|b| grid.bucket(b.particle.centre))
        .collect();
    let mut firsts = vec![0; grid.buckets() + 1];
    for &bucket in &buckets {
        firsts[bucket + 1] += 1;
    }
    for k in 1..firsts.len() {
        firsts[k] += firsts[k - 1];
    }
    let mut free = firsts.clone();
    let old = bodies.to_vec();
    for (body, bucket) in old.into_iter().zip(buckets) {
        let mut k = free[bucket];
        free[bucket] += 1;
        while k > firsts[bucket] && bodies[k - 1].particle.id > body.particle.id {
            bodies[k] = bodies[k - 1];
            k -= 1;
        }
        bodies[k] = body;
    }
    firsts
}
