//! The equation of motion m x'' + c x' = f (Miyata, Itoh, Shimada 2000, eq. 5), with the constants of `physics`.

use super::Integrator;
use super::body::MovingParticle;
use super::energy::PairEnergies;
use super::neighbour_list::NeighbourList;
use super::packing_domain::{MetricSpace, PackingDomain};
use super::pair_forces::{PairData, Touching, forces_on};
use super::physics::CornerBubbles;
use super::runge_kutta::RungeKutta;
use super::shape::CellShape;
use super::step_rule::StepRule;
use super::transport::ParallelTransport;
use super::wall::{stays_clear, wall_force};
use crate::field::CellKind;
use crate::order::greater;
use glam::DVec2;
use std::ops::Range;

/// No cell moves farther than this share of its size in one step, if [`StepRule::is_aided`].
const LONGEST_MOVE: f64 = 0.25;
/// If steps are not aided, no cell is faster than this, in sizes per unit of time. The limit only keeps numbers finite
/// in a run that explodes.
const FASTEST: f64 = 1e3;
/// A cell counts as moved if its last move was longer than this share of its size. It rests while neither it nor any of
/// its neighbours has moved; the remaining force is far below the limit at which a run ends.
const fn least_move(kind: CellKind) -> f64 {
    if matches!(kind, CellKind::Circle) {
        0.0
    } else {
        REST
    }
}
/// The value of [`least_move`] for all kinds except circles.
const REST: f64 = 0.002;

/// The progress of a step.
#[derive(Clone, Debug, Default)]
enum Doing<P> {
    /// Next: the neighbour list.
    #[default]
    Neighbours,
    /// Next: which bodies are awake.
    Waking,
    /// Next: the forces on this body and those after it. No Runge-Kutta scheme during the first evaluation of a step.
    Forces(usize, Option<RungeKutta<P>>),
    /// Next: the moves of this body and those after it.
    Moves(usize, Vec<DVec2>),
}

/// The motion of all bodies: the step in progress, the neighbour list and the forces.
#[derive(Clone, Debug)]
pub(super) struct Motion<P> {
    doing: Doing<P>,
    /// The largest move and the largest force of the step so far, in sizes of the cell.
    largest: (f64, f64),
    list: NeighbourList<P>,
    /// Bodies that are not at rest.
    awake: Vec<bool>,
    forces: Vec<DVec2>,
    /// A lower bound of each body's distance to the walls at the start of the step.
    clear: Vec<f64>,
    pair_data: Vec<PairData<P>>,
    energies: PairEnergies,
}

impl<P> Default for Motion<P> {
    fn default() -> Self {
        Self {
            doing: Doing::default(),
            largest: (0.0, 0.0),
            list: NeighbourList::default(),
            awake: Vec::new(),
            forces: Vec::new(),
            clear: Vec::new(),
            pair_data: Vec::new(),
            energies: PairEnergies::default(),
        }
    }
}

impl<P: Copy> Motion<P> {
    /// Invalidates the list after a change of the bodies.
    pub fn forget(&mut self) {
        self.list.forget();
    }

    /// Frees data that the next step makes anew. Only to be called between steps.
    pub fn compact(&mut self) {
        self.pair_data = Vec::new();
        self.energies = PairEnergies::default();
    }

    /// Whether a step is in progress. The bodies must then keep their order.
    pub fn is_in_a_step(&self) -> bool {
        !matches!(self.doing, Doing::Neighbours)
    }

    /// Renews the neighbour list if it may be outdated; true if it was renewed. The bodies are then in another order.
    pub fn refresh<S: MetricSpace<Place = P>>(
        &mut self,
        bodies: &mut [MovingParticle<P>],
        metric: S,
        corners: CornerBubbles,
    ) -> bool {
        let renewed = self.list.refresh(bodies, metric, corners.square_reach());
        if renewed {
            self.energies.forget();
            self.forces.resize(bodies.len(), DVec2::ZERO);
            self.clear.resize(bodies.len(), 0.0);
        }
        renewed
    }

    /// The pairs that may touch, each once.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.list.pairs()
    }

    /// The sum of the potentials of all pairs.
    pub fn sum_energy<S: MetricSpace<Place = P>>(
        &mut self,
        bodies: &[MovingParticle<P>],
        metric: S,
        corners: CornerBubbles,
    ) -> f64 {
        self.energies.sum(&self.list.near, bodies, metric, corners)
    }

    /// Marks as awake the bodies that have moved, and their neighbours; all bodies if none may sleep. Fixed bodies are
    /// never awake.
    fn wake(&mut self, bodies: &[MovingParticle<P>], may_sleep: bool) {
        self.awake.clear();
        self.awake
            .extend(bodies.iter().map(|b| b.has_moved || !may_sleep));
        for (i, body) in bodies.iter().enumerate() {
            for &j in self.list.near.row(i) {
                self.awake[i] |= bodies[j as usize].has_moved;
                self.awake[j as usize] |= body.has_moved;
            }
        }
        for (awake, body) in self.awake.iter_mut().zip(bodies) {
            *awake &= !body.particle.fixed;
        }
    }

    /// Prepares an evaluation: zero forces, and the pair data of all bodies.
    fn begin_forces(&mut self, bodies: &[MovingParticle<P>], corners: CornerBubbles) {
        let reach = corners.square_reach();
        self.forces.fill(DVec2::ZERO);
        self.pair_data.clear();
        self.pair_data
            .extend(bodies.iter().map(|b| PairData::of(&b.particle, reach)));
    }

    /// Multiplies all forces by the stiffness, at the end of an evaluation.
    fn stiffen(&mut self, stiffness: f64) {
        if stiffness != 1.0 {
            self.forces.iter_mut().for_each(|force| *force *= stiffness);
        }
    }

    /// Adds the forces between the bodies of a range and later bodies, and the walls' forces on the range. Pairs and
    /// bodies at rest are left out. In the first evaluation of a step it also notes the distances to the walls.
    fn evaluate<G: PackingDomain<Place = P>>(
        &mut self,
        bodies: &[MovingParticle<P>],
        these: Range<usize>,
        ground: G,
        (corners, first): (CornerBubbles, bool),
    ) {
        let (mut near_walls, mut touching) = (Vec::new(), Vec::new());
        for (i, body) in these.clone().zip(&bodies[these]) {
            self.find_touching(i, ground.metric(), &mut touching);
            let mut total = DVec2::ZERO;
            for pairs in touching.chunks(2) {
                let forces = forces_on((i, bodies), pairs, &self.pair_data, corners);
                for (&(j, _, turn), force) in pairs.iter().zip(forces) {
                    self.forces[j] += turn.undo(force);
                    total -= force;
                }
            }
            if self.awake[i] {
                let (force, distance) = wall_force(body, ground.walls(), &mut near_walls);
                total += force;
                if first {
                    self.clear[i] = distance;
                }
            }
            self.forces[i] += total;
        }
    }

    /// Finds the bodies after body `i` that are within its reach, with their offsets. Pairs with neither body awake are
    /// left out.
    #[inline(always)]
    fn find_touching<S: MetricSpace<Place = P>>(
        &self,
        i: usize,
        metric: S,
        touching: &mut Vec<Touching<S::Transport>>,
    ) {
        touching.clear();
        let (a, a_awake) = (&self.pair_data[i], self.awake[i]);
        for &j in self.list.near.row(i) {
            let j = j as usize;
            if !(a_awake || self.awake[j]) {
                continue;
            }
            let b = &self.pair_data[j];
            let reach = a.reach + b.reach;
            if let Some((r, turn)) = metric.log_within(a.centre, b.centre, reach)
                && r.length_squared() < reach * reach
            {
                touching.push((j, r, turn));
            }
        }
    }

    /// Continues a step with at most `portion` bodies. When the step is complete, gives the largest move and the
    /// largest force of a free cell, in its size.
    pub fn advance<G: PackingDomain<Place = P>>(
        &mut self,
        bodies: &mut [MovingParticle<P>],
        ground: G,
        rule: &StepRule,
        portion: usize,
    ) -> Option<(f64, f64)> {
        let corners = rule.physics.corners;
        let (mut left, count) = (portion, bodies.len());
        let mut these = |from: usize| {
            let end = from.saturating_add(left).min(count);
            left -= end - from;
            from..end
        };
        loop {
            match std::mem::take(&mut self.doing) {
                Doing::Neighbours => {
                    let renewed = self.refresh(bodies, ground.metric(), corners);
                    self.doing = Doing::Waking;
                    if renewed && bodies.len() > portion {
                        return None;
                    }
                }
                Doing::Waking => {
                    self.wake(bodies, rule.is_aided);
                    self.begin_forces(bodies, corners);
                    self.doing = Doing::Forces(0, None);
                }
                Doing::Forces(from, scheme) => {
                    let these = these(from);
                    let end = these.end;
                    self.evaluate(bodies, these, ground, (corners, scheme.is_none()));
                    if end < bodies.len() {
                        self.doing = Doing::Forces(end, scheme);
                        return None;
                    }
                    self.stiffen(rule.physics.stiffness);
                    self.doing = self.after_forces(bodies, ground, rule, scheme);
                }
                Doing::Moves(from, moves) => {
                    let these = these(from);
                    let end = these.end;
                    self.make_moves(bodies, these, ground, (&moves, rule.is_aided));
                    if end == bodies.len() {
                        return Some(self.largest);
                    }
                    self.doing = Doing::Moves(end, moves);
                    return None;
                }
            }
        }
    }

    /// The next part of a step, once all forces are known. A Runge-Kutta scheme evaluates the forces four times.
    fn after_forces<G: PackingDomain<Place = P>>(
        &mut self,
        bodies: &mut [MovingParticle<P>],
        ground: G,
        rule: &StepRule,
        scheme: Option<RungeKutta<P>>,
    ) -> Doing<P> {
        if scheme.is_none() {
            self.largest = (0.0, self.largest_force(bodies));
        }
        match rule.integrator {
            Integrator::SemiImplicit => Doing::Moves(0, self.semi_implicit(bodies, rule)),
            Integrator::Euler => Doing::Moves(0, self.explicit(bodies, rule)),
            Integrator::RungeKutta => {
                let scheme = scheme.unwrap_or_else(|| RungeKutta::new(bodies));
                self.runge_kutta(bodies, ground, rule, scheme)
            }
        }
    }

    fn largest_force(&self, bodies: &[MovingParticle<P>]) -> f64 {
        let mut largest = 0.0_f64;
        for (i, body) in bodies.iter().enumerate() {
            if self.awake[i] {
                largest = greater(largest, self.forces[i].length() / body.particle.size);
            }
        }
        largest
    }

    /// Makes the moves of a range of bodies, and updates the largest move.
    fn make_moves<G: PackingDomain<Place = P>>(
        &mut self,
        bodies: &mut [MovingParticle<P>],
        these: Range<usize>,
        ground: G,
        (moves, is_aided): (&[DVec2], bool),
    ) {
        let longest = if is_aided { LONGEST_MOVE } else { FASTEST };
        for i in these {
            let body = &mut bodies[i];
            if !self.awake[i] {
                body.velocity = DVec2::ZERO;
                body.has_moved = false;
                continue;
            }
            let before = body.particle.centre;
            let shape = CellShape::of(&body.particle);
            let by = moves[i].clamp_length_max(longest * body.particle.size);
            let is_clear = stays_clear(self.clear[i], by.length(), shape.length());
            let (centre, turn) = ground.moved(before, by, shape, is_clear);
            body.place(centre, ground.fields());
            body.velocity = turn.apply(body.velocity);
            if !is_aided {
                let fastest = FASTEST * body.particle.size;
                body.velocity = body.velocity.clamp_length_max(fastest);
            }
            self.energies.has_moved(i);
            let moved = ground.metric().distance(before, centre) / shape.size;
            body.has_moved = moved > least_move(body.particle.kind);
            self.largest.0 = greater(self.largest.0, moved);
        }
    }

    fn semi_implicit(&self, bodies: &mut [MovingParticle<P>], rule: &StepRule) -> Vec<DVec2> {
        let (h, mass) = (rule.time_step, rule.physics.mass);
        let each = bodies.iter_mut().zip(&self.forces);
        each.map(|(body, &force)| {
            let damping = rule.damping(body.particle.kind);
            body.velocity = (body.velocity + h * force / mass) / (1.0 + h * damping / mass);
            rule.pace * h * body.velocity
        })
        .collect()
    }

    /// Explicit Euler: place and velocity change by the values before the step.
    fn explicit(&self, bodies: &mut [MovingParticle<P>], rule: &StepRule) -> Vec<DVec2> {
        let h = rule.pace * rule.time_step;
        let each = bodies.iter_mut().zip(&self.forces);
        each.map(|(body, &force)| {
            let by = h * body.velocity;
            let pull = force - rule.damping(body.particle.kind) * body.velocity;
            body.velocity += h * pull / rule.physics.mass;
            by
        })
        .collect()
    }

    /// Goes on to the next evaluation, or to the moves after the last one.
    fn runge_kutta<G: PackingDomain<Place = P>>(
        &mut self,
        bodies: &mut [MovingParticle<P>],
        ground: G,
        rule: &StepRule,
        mut scheme: RungeKutta<P>,
    ) -> Doing<P> {
        if scheme.advance(bodies, (&self.forces, &self.awake), ground, rule) {
            return Doing::Moves(0, scheme.finish(bodies, rule));
        }
        self.begin_forces(bodies, rule.physics.corners);
        Doing::Forces(0, Some(scheme))
    }
}
