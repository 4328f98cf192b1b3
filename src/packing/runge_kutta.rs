//! The classical Runge-Kutta scheme on (x, v).

use super::body::MovingParticle;
use super::packing_domain::{MetricSpace, PackingDomain};
use super::step_rule::StepRule;
use super::transport::ParallelTransport;
use glam::DVec2;

/// Weights of the evaluations.
const WEIGHTS: [f64; 4] = [1.0, 2.0, 2.0, 1.0];

/// A step in progress. Velocities and their slopes stay in the frames of the starting places.
#[derive(Clone, Debug)]
pub(super) struct RungeKutta<P> {
    /// The number of the evaluation, from 0.
    stage: usize,
    start: Vec<(P, DVec2)>,
    velocity: Vec<DVec2>,
    /// Offsets from the start at which forces are evaluated.
    ahead: Vec<DVec2>,
    sums: Vec<(DVec2, DVec2)>,
}

impl<P: Copy> RungeKutta<P> {
    /// Starts from bodies whose first evaluation is done.
    pub fn new(bodies: &[MovingParticle<P>]) -> Self {
        let start = bodies.iter().map(|b| (b.particle.centre, b.velocity));
        Self {
            stage: 0,
            start: start.collect(),
            velocity: bodies.iter().map(|b| b.velocity).collect(),
            ahead: vec![DVec2::ZERO; bodies.len()],
            sums: vec![(DVec2::ZERO, DVec2::ZERO); bodies.len()],
        }
    }

    /// Takes the forces of an evaluation, and moves the awake bodies to their places for the next evaluation. True
    /// after the last evaluation.
    pub fn advance<G: PackingDomain<Place = P>>(
        &mut self,
        bodies: &mut [MovingParticle<P>],
        (forces, awake): (&[DVec2], &[bool]),
        ground: G,
        rule: &StepRule,
    ) -> bool {
        let h = rule.pace * rule.time_step;
        let (stage, weight) = (self.stage, WEIGHTS[self.stage]);
        let further = if stage == 2 { h } else { 0.5 * h };
        for (i, body) in bodies.iter_mut().enumerate() {
            if !awake[i] {
                continue;
            }
            let (start, velocity) = self.start[i];
            let mut force = forces[i];
            if stage > 0 {
                force = ground.metric().exp(start, self.ahead[i]).1.undo(force);
            }
            let slope = self.velocity[i];
            let drag = rule.damping(body.particle.kind) * slope;
            let pull = (force - drag) / rule.physics.mass;
            self.sums[i].0 += weight / 6.0 * slope;
            self.sums[i].1 += weight / 6.0 * pull;
            if stage < 3 {
                self.ahead[i] = further * slope;
                let (there, _) = ground.metric().exp(start, self.ahead[i]);
                body.place(there, ground.fields());
                self.velocity[i] = velocity + further * pull;
            }
        }
        self.stage += 1;
        self.stage == WEIGHTS.len()
    }

    /// Puts the bodies back to their starts with their new velocities; gives their moves.
    pub fn finish(self, bodies: &mut [MovingParticle<P>], rule: &StepRule) -> Vec<DVec2> {
        let h = rule.pace * rule.time_step;
        let each = bodies.iter_mut().zip(self.start).zip(self.sums);
        each.map(|((body, (centre, v)), (slope, pull))| {
            body.particle.centre = centre;
            body.velocity = v + h * pull;
            h * slope
        })
        .collect()
    }
}
