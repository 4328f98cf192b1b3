//! The run of a packing on any domain: motion, population control, and the end.

use super::body::MovingParticle;
use super::cell_fields::CellFields;
use super::integrate::Motion;
use super::packing_domain::{HashOf, MetricSpace, PackingDomain};
use super::population::{Change, PopulationScan};
use super::step_rule::StepRule;
use super::{
    BoundaryCondition, PackingParams, Particle, Population, PopulationChange, Sample, StepReport,
};
use crate::order;
use crate::random::{Purpose, Random};
use glam::DVec2;

/// A run flies apart if a cell moves farther than this in a step, in sizes: neighbours attract each other up to half a
/// size beyond their stable distance.
const FLIGHT: f64 = 0.5;

/// A packing in progress, without its domain.
#[derive(Clone, Debug)]
pub(crate) struct Run<P> {
    pub params: PackingParams,
    pub bodies: Vec<MovingParticle<P>>,
    pub(super) motion: Motion<P>,
    pub next_id: u32,
    pub report: StepReport,
    /// The step of the last population control.
    pub controlled: u32,
    /// The record of the run.
    pub samples: Vec<Sample>,
    /// The cells that came and went.
    pub changes: Vec<PopulationChange<P>>,
}

impl<P: Copy> Run<P> {
    /// Starts a run with cells at these centres. The second of each pair tells whether the cell is fixed.
    pub fn of<A: CellFields<Place = P>>(
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
            changes: Vec::new(),
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

    pub fn add<A: CellFields<Place = P>>(&mut self, asked: A, centre: P, fixed: bool) {
        let particle = Particle::new(self.next_id, centre, fixed, asked);
        self.next_id += 1;
        self.bodies.push(MovingParticle {
            particle,
            velocity: DVec2::ZERO,
            factor: 1.0,
            has_moved: true,
        });
    }

    /// Gives each cell its own size, by the variance Vs. Cells are placed with equal sizes first, because
    /// drawn sizes would make the filling leave out large cells.
    pub fn assign_sizes<A: CellFields<Place = P>>(&mut self, asked: A) {
        let variance = self.params.variance;
        if variance == 0.0 {
            return;
        }
        for body in &mut self.bodies {
            let mut random = Random::new(self.params.seed, Purpose::Size, body.particle.id.into());
            // Uniform, with the standard deviation Vs.
            body.factor = 1.0 + variance * 3.0_f64.sqrt() * random.signed();
            body.particle.size = body.factor * asked.size(body.particle.centre);
        }
    }

    /// Displaces each free cell at random, by at most `jolt` times its size. A cell stays if the walls leave no room at
    /// the new place.
    pub fn jolt<G: PackingDomain<Place = P>>(&mut self, ground: G) {
        let PackingParams { jolt, seed, .. } = self.params;
        let is_open = ground.boundary() == BoundaryCondition::Open;
        for body in self.bodies.iter_mut().filter(|_| jolt > 0.0) {
            let Particle {
                id, centre, size, ..
            } = body.particle;
            let mut random = Random::new(seed, Purpose::Jolt, id.into());
            let by = DVec2::new(random.signed(), random.signed()).clamp_length_max(1.0);
            let (there, _) = ground.metric().exp(centre, jolt * size * by);
            let there = ground.metric().wrap(there);
            if !body.particle.fixed && (is_open || ground.has_room(there)) {
                body.place(there, ground.fields());
            }
        }
    }

    /// The cells in the order of their ids.
    pub fn particles(&self) -> Vec<Particle<P>> {
        let mut particles: Vec<Particle<P>> = self.bodies.iter().map(|b| b.particle).collect();
        order::sort(&mut particles, |p| (p.id.into(), 0));
        particles
    }

    /// The result of the last step.
    pub fn report(&self) -> StepReport {
        self.report
    }

    /// Makes one step of the equation of motion, with population control when it is due.
    pub fn step<G: PackingDomain<Place = P>>(&mut self, ground: G) -> StepReport {
        while !self.advance(ground, &mut None, usize::MAX) {}
        self.report
    }

    /// Continues a step with about this many bodies; true when it is complete. `survey` keeps the population
    /// scan between calls. The result does not depend on the portions.
    pub fn advance<G: PackingDomain<Place = P>>(
        &mut self,
        ground: G,
        survey: &mut Option<PopulationScan<P, HashOf<G>>>,
        portion: usize,
    ) -> bool {
        if self.report.done {
            return true;
        }
        if survey.is_none() {
            let rule = self.rule::<G>();
            let moved = self
                .motion
                .advance(&mut self.bodies, ground, &rule, portion);
            let Some((largest_move, largest_force)) = moved else {
                return false;
            };
            self.report.step += 1;
            self.report.largest_move = largest_move;
            self.report.largest_force = largest_force;
            if self.is_survey_due::<G>() {
                self.controlled = self.report.step;
                *survey = Some(PopulationScan::new(ground, &self.bodies));
                if self.bodies.len() > portion {
                    return false;
                }
            }
        }
        let mut changed = false;
        if let Some(under_way) = survey {
            let change = under_way.advance(ground, &self.bodies, &self.params, portion);
            let Some(change) = change else {
                return false;
            };
            *survey = None;
            changed = self.change(ground, change);
        }
        self.report.cells = self.bodies.len();
        self.note_flight();
        self.report.converged = self.is_small::<G>() && !changed;
        let most = self.params.physics.most_steps;
        self.report.done = self.report.converged || self.report.step >= most;
        self.sample(ground);
        true
    }

    /// The number of cooling steps up to and including `step`.
    fn late<G: PackingDomain<Place = P>>(step: u32) -> u32 {
        step.saturating_sub(G::TUNING.cooling_from)
    }

    /// The rule for the next step.
    fn rule<G: PackingDomain<Place = P>>(&self) -> StepRule {
        let rule = StepRule::new(&self.params);
        let (late, cooling) = (Self::late::<G>(self.report.step + 1), rule.cooling());
        let pace = (0..late).fold(1.0, |pace, _| pace * cooling);
        StepRule { pace, ..rule }
    }

    /// Whether the moves and forces of the last step are small enough to end the run.
    fn is_small<G: PackingDomain<Place = P>>(&self) -> bool {
        let (last, physics) = (&self.report, &self.params.physics);
        let cools = || StepRule::new(&self.params).cooling() < 1.0;
        last.step >= G::TUNING.least_steps
            && last.largest_move < physics.move_end
            && (last.largest_force < physics.force_end
                || (Self::late::<G>(last.step) > 0 && cools()))
    }

    /// Notes the first step in which a cell moved farther than [`FLIGHT`]. Aided steps limit moves, so they never
    /// count.
    fn note_flight(&mut self) {
        let flies = self.report.largest_move > FLIGHT && !StepRule::new(&self.params).is_aided;
        if flies && self.report.flown_at == 0 {
            self.report.flown_at = self.report.step;
        }
    }

    /// Whether population control is due.
    fn is_survey_due<G: PackingDomain<Place = P>>(&self) -> bool {
        let step = self.report.step;
        let due = step - self.controlled >= G::TUNING.population_every;
        self.params.population != Population::Off
            && step <= G::TUNING.population_until
            && (due || self.is_small::<G>())
    }

    /// Adds and removes cells; true if there were any.
    fn change<G: PackingDomain<Place = P>>(&mut self, ground: G, change: Change<P>) -> bool {
        let step = self.report.step;
        let noted = |id, centre, came| PopulationChange {
            step,
            id,
            centre,
            came,
        };
        let gone = self.bodies.iter().zip(&change.remove);
        let gone = gone.filter_map(|(body, &gone)| gone.then_some(body.particle));
        self.changes
            .extend(gone.map(|cell| noted(cell.id, cell.centre, false)));
        let mut index = 0;
        self.bodies.retain(|_| {
            index += 1;
            !change.remove[index - 1]
        });
        let removed = change.remove.iter().filter(|&&gone| gone).count() as u32;
        for &centre in &change.add {
            self.changes.push(noted(self.next_id, centre, true));
            self.add(ground.fields(), centre, false);
        }
        self.report.removed += removed;
        self.report.added += change.add.len() as u32;
        let changed = removed > 0 || !change.add.is_empty();
        if changed {
            self.motion.forget();
        }
        if removed > 0 {
            // Neighbours of removed cells must not stay at rest.
            self.bodies
                .iter_mut()
                .for_each(|body| body.has_moved = true);
        }
        changed
    }
}
