//! The run of a packing on any ground: bodies in motion, population control, and the end.

use super::ground::{Asks, Ground};
use super::integrate::Motion;
use super::population;
use super::{PackingParams, Particle, Population, Sample, StepReport};
use crate::order;
use crate::random::{Purpose, Random};
use glam::DVec2;

/// A cell in motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Body<P> {
    pub particle: Particle<P>,
    /// In the frame of its place.
    pub velocity: DVec2,
    /// This cell's size over what the size field asks for.
    pub factor: f64,
    /// It has moved in the last step, or is new.
    pub has_moved: bool,
}

impl<P: Copy> Body<P> {
    /// Moves it; its direction and size follow the fields.
    pub fn place<A: Asks<Place = P>>(&mut self, centre: P, asked: A) {
        self.particle.centre = centre;
        self.particle.axis = asked.direction(centre);
        self.particle.size = self.factor * asked.size(centre);
        self.particle.aspect = asked.aspect(centre);
    }
}

/// A packing on its way, without its ground.
#[derive(Clone, Debug)]
pub(crate) struct Run<P> {
    pub params: PackingParams,
    pub bodies: Vec<Body<P>>,
    pub(super) motion: Motion<P>,
    pub next_id: u32,
    pub report: StepReport,
    /// The step of the last population control.
    pub controlled: u32,
    /// The record of the run.
    pub samples: Vec<Sample>,
}

impl<P: Copy> Run<P> {
    /// Of these centres; true where one is fixed.
    pub fn of<A: Asks<Place = P>>(
        cells: impl Iterator<Item = (P, bool)>,
        asked: A,
        params: PackingParams,
    ) -> Self {
        let mut run = Self {
            params,
            bodies: Vec::new(),
            motion: Motion::default(),
            next_id: 0,
            report: StepReport::default(),
            controlled: 0,
            samples: Vec::new(),
        };
        for (centre, fixed) in cells {
            run.add(asked, centre, fixed);
        }
        run.assign_sizes(asked);
        run.report.cells = run.bodies.len();
        run.report.done = run.bodies.is_empty();
        run.report.converged = run.report.done;
        run
    }

    pub fn add<A: Asks<Place = P>>(&mut self, asked: A, centre: P, fixed: bool) {
        let particle = Particle::new(self.next_id, centre, fixed, asked);
        self.next_id += 1;
        self.bodies.push(Body {
            particle,
            velocity: DVec2::ZERO,
            factor: 1.0,
            has_moved: true,
        });
    }

    /// Vs: cells are placed at equal sizes, then each gets its own. Drawing sizes while places are
    /// filled would leave the large ones out.
    pub fn assign_sizes<A: Asks<Place = P>>(&mut self, asked: A) {
        let variance = self.params.variance;
        if variance == 0.0 {
            return;
        }
        for body in &mut self.bodies {
            let mut random = Random::new(self.params.seed, Purpose::Size, body.particle.id.into());
            // Uniform with the standard deviation Vs.
            body.factor = 1.0 + variance * 3.0_f64.sqrt() * random.signed();
            body.particle.size = body.factor * asked.size(body.particle.centre);
        }
    }

    /// The cells in the order of their ids.
    pub fn particles(&self) -> Vec<Particle<P>> {
        let mut particles: Vec<Particle<P>> = self.bodies.iter().map(|b| b.particle).collect();
        order::sort(&mut particles, |p| (p.id.into(), 0));
        particles
    }

    /// What the last step did.
    pub fn report(&self) -> StepReport {
        self.report
    }

    /// One step of the equation of motion and, now and then, population control.
    pub fn step<G: Ground<Place = P>>(&mut self, ground: G) -> StepReport {
        if self.report.done {
            return self.report;
        }
        let step = self.report.step + 1;
        let late = step.saturating_sub(G::TUNING.cooling_from);
        let pace = (0..late).fold(1.0, |pace, _| pace * G::TUNING.cooling);
        self.motion.refresh(&mut self.bodies, ground.sight());
        let (largest_move, largest_force) =
            self.motion
                .step(&mut self.bodies, ground, self.params.integrator, pace);
        self.report.step = step;
        self.report.largest_move = largest_move;
        self.report.largest_force = largest_force;
        let small = step >= G::TUNING.least_steps
            && largest_move < G::TUNING.move_end
            && (largest_force < G::TUNING.force_end || late > 0);
        let changed = self.control_population(ground, small);
        self.report.cells = self.bodies.len();
        self.report.converged = small && !changed;
        self.report.done = self.report.converged || step >= G::TUNING.most_steps;
        self.sample(ground.sight());
        self.report
    }

    /// Adds and removes cells where it is time to; true where any were.
    fn control_population<G: Ground<Place = P>>(&mut self, ground: G, small: bool) -> bool {
        let step = self.report.step;
        let due = step - self.controlled >= G::TUNING.population_every;
        if self.params.population == Population::Off
            || step > G::TUNING.population_until
            || !(due || small)
        {
            return false;
        }
        self.controlled = step;
        let change = population::change(ground, &self.bodies, &self.params);
        let mut index = 0;
        self.bodies.retain(|_| {
            index += 1;
            !change.remove[index - 1]
        });
        let removed = change.remove.iter().filter(|&&gone| gone).count() as u32;
        for &centre in &change.add {
            self.add(ground.fields(), centre, false);
        }
        self.report.removed += removed;
        self.report.added += change.add.len() as u32;
        let changed = removed > 0 || !change.add.is_empty();
        if changed {
            self.motion.forget();
        }
        if removed > 0 {
            // Their neighbours are not known any more.
            self.bodies
                .iter_mut()
                .for_each(|body| body.has_moved = true);
        }
        changed
    }
}
