//! Measures of a packing: its energy, the net force on each cell, the alignment of cells with their
//! neighbours, and the record of the run.
//!
//! The record has the energy and the largest move of every step, or of every fourth step with more than 2,000 cells. It
//! is kept even if nothing displays it.

use super::body::MovingParticle;
use super::force::{force_between, potential_between};
use super::packing_domain::{Boundary, MetricSpace, PackingDomain};
use super::run::Run;
use super::shape::CellShape;
use super::transport::ParallelTransport;
use super::wall::wall_force;
use super::{Packing, Particle, Physics, Sample};
use crate::domain::Domain;
use glam::DVec2;

/// The net force on a cell, and the cell's share of the energy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NetForce {
    /// The sum of all forces on the cell, in its size. It is given for fixed cells, too.
    pub force: DVec2,
    /// Half the sum of the potentials (eq. 4) of the cell's pairs, in its k0: below 0 if its neighbours hold it, above
    /// 0 if they press it.
    pub energy: f64,
}

/// The alignment of a cell with its neighbours.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Alignment {
    /// The mean distance of its nearest neighbours over the stable distance; 1 without neighbours.
    pub spacing: f64,
    /// The angle between the cell's axis and its neighbours, in degrees. Cells with corners: the angle to the rows and
    /// columns, 0..45. Ellipses: the angle to the long axis of the neighbours' offsets, 0..90. `None` for circles, and
    /// without a neighbour or an axis.
    pub angle: Option<f64>,
}

/// With more cells than this, the energy is not recorded at every step.
const MANY: usize = 2000;
/// Steps between two records of the energy, with more than [`MANY`] cells.
const STRIDE: u32 = 4;

/// Cells nearer than this, in stable distances, count as neighbours: next in a row or column, or one of the six around
/// a round cell.
const NEAR: f64 = 1.25;

impl<P: Copy> Run<P> {
    /// The potential energy of the cells among each other (eq. 4 summed over pairs), in units of the mean cell's k0. It
    /// is taken from the last row of the record, or computed if the record is empty.
    pub fn energy<S: MetricSpace<Place = P>>(&mut self, metric: S) -> f64 {
        match self.samples.last() {
            Some(last) => last.energy.pairs,
            None => self.sum_energy(metric),
        }
    }

    /// Adds a row to the record if it is due. The record depends on nothing but the run.
    pub(super) fn sample<G: PackingDomain<Place = P>>(&mut self, ground: G) {
        let report = self.report;
        if report.cells <= MANY || report.step.is_multiple_of(STRIDE) || report.done {
            let energy = self.energy_parts(ground.metric(), ground.walls());
            self.samples.push(Sample {
                step: report.step,
                energy,
                largest_move: report.largest_move,
            });
        }
    }

    pub(super) fn sum_energy<S: MetricSpace<Place = P>>(&mut self, metric: S) -> f64 {
        self.refresh_pairs(metric);
        let physics = self.params.physics;
        let sum = self
            .motion
            .sum_energy(&self.bodies, metric, physics.corners);
        physics.stiffness * sum / self.mean_stiffness()
    }

    /// Renews the list of pairs. Does nothing during a step, because the bodies must then keep their order.
    fn refresh_pairs<S: MetricSpace<Place = P>>(&mut self, metric: S) {
        if !self.motion.is_in_a_step() {
            let corners = self.params.physics.corners;
            self.motion.refresh(&mut self.bodies, metric, corners);
        }
    }

    /// Calls `visit` with both bodies of each pair that may touch, the offset from the first to the second with the
    /// parallel transport, and the bodies' indices in `bodies`.
    pub(super) fn each_pair<S: MetricSpace<Place = P>>(
        &mut self,
        metric: S,
        mut visit: impl FnMut(
            &MovingParticle<P>,
            &MovingParticle<P>,
            (DVec2, S::Transport),
            (usize, usize),
        ),
    ) {
        self.refresh_pairs(metric);
        for (i, j) in self.motion.pairs() {
            let (a, b) = (&self.bodies[i], &self.bodies[j]);
            if let Some(way) = metric.log(a.particle.centre, b.particle.centre) {
                visit(a, b, way, (i, j));
            }
        }
    }

    /// The cells, in no special order, with the net force on each at its present place.
    pub fn net_forces<S: MetricSpace<Place = P>, W: Boundary<Place = P>>(
        &mut self,
        metric: S,
        walls: W,
    ) -> Vec<(Particle<P>, NetForce)> {
        let Physics {
            corners, stiffness, ..
        } = self.params.physics;
        let mut all = vec![NetForce::default(); self.bodies.len()];
        self.each_pair(metric, |a, b, (r, turn), (i, j)| {
            let force = force_between(&a.particle, &b.particle, (r, turn), corners);
            let energy = 0.5 * potential_between(&a.particle, &b.particle, (r, turn), corners);
            all[i].force -= force;
            all[j].force += turn.undo(force);
            all[i].energy += energy;
            all[j].energy += energy;
        });
        let mut near = Vec::new();
        for (own, body) in all.iter_mut().zip(&self.bodies) {
            let size = body.particle.size;
            own.force += wall_force(body, walls, &mut near).0;
            own.force = stiffness * own.force / size;
            own.energy = stiffness * own.energy / (size * size);
        }
        self.bodies.iter().map(|b| b.particle).zip(all).collect()
    }

    /// The cells, in no special order, each with its alignment.
    pub fn alignments<S: MetricSpace<Place = P>>(
        &mut self,
        metric: S,
    ) -> Vec<(Particle<P>, Alignment)> {
        let mut around = vec![Around::default(); self.bodies.len()];
        self.each_pair(metric, |a, b, (r, turn), (i, j)| {
            let other = CellShape::of(&b.particle).seen(turn);
            let far = CellShape::of(&a.particle).normalised_distance(&other, r);
            if far < NEAR {
                around[i].add(&a.particle, r, far);
                around[j].add(&b.particle, -turn.undo(r), far);
            }
        });
        let bodies = self.bodies.iter().zip(around);
        let aligned = |(body, around): (&MovingParticle<P>, Around)| {
            (body.particle, around.aligned(&body.particle))
        };
        bodies.map(aligned).collect()
    }
}

impl Packing {
    /// The potential energy of the cells among each other (eq. 4 summed over pairs), in units of the mean cell's k0. It
    /// is taken from the last row of the record, or computed if the record is empty.
    pub fn energy(&mut self, domain: &Domain) -> f64 {
        self.run.energy(domain)
    }

    /// The record of the run, by rising steps.
    pub fn samples(&self) -> &[Sample] {
        &self.run.samples
    }

    /// The cells, in no special order, with the net force on each at its present place.
    pub fn net_forces(&mut self, domain: &Domain) -> Vec<(Particle, NetForce)> {
        self.run.net_forces(domain, &self.walls)
    }

    /// The cells, in no special order, each with its alignment.
    pub fn alignments(&mut self, domain: &Domain) -> Vec<(Particle, Alignment)> {
        self.run.alignments(domain)
    }

    /// The cell that contains this place, after its index among all cells in the order of ids. If several contain the
    /// place, the cell whose centre is nearest in its own metric.
    pub fn at(&self, domain: &Domain, p: DVec2) -> Option<(usize, Particle)> {
        let bodies = &self.run.bodies;
        let mut best: Option<(f64, &Particle)> = None;
        for body in bodies {
            let particle = &body.particle;
            let far = particle.relative_radius(domain.space().shortest(p - particle.centre));
            if best.map_or(far <= 1.0, |(least, _)| far < least) {
                best = Some((far, particle));
            }
        }
        let particle = best?.1;
        let before = bodies.iter().filter(|b| b.particle.id < particle.id);
        Some((before.count(), *particle))
    }
}

/// Sums over the neighbours of a cell.
#[derive(Clone, Copy, Debug, Default)]
struct Around {
    count: f64,
    far: f64,
    /// For cells with corners, the sum of the fourth powers (as complex numbers) of the unit vectors to neighbours, in
    /// the frame in which the cell is a square. For other cells, the sum of the squared offsets.
    turn: DVec2,
}

impl Around {
    fn add<P>(&mut self, particle: &Particle<P>, r: DVec2, far: f64) {
        self.count += 1.0;
        self.far += far;
        let axis = particle.axis;
        let local = DVec2::new(axis.dot(r), axis.perp_dot(r));
        let squared = |v: DVec2| v.rotate(v);
        self.turn += if particle.kind.has_corners() {
            let root = CellShape::of(particle).root;
            let framed = local * DVec2::new(1.0, root * root);
            squared(squared(framed.normalize_or_zero()))
        } else {
            squared(local)
        };
    }

    fn aligned<P>(&self, particle: &Particle<P>) -> Alignment {
        if self.count == 0.0 {
            return Alignment {
                spacing: 1.0,
                angle: None,
            };
        }
        let fold = if particle.kind.has_corners() {
            4.0
        } else {
            2.0
        };
        let has_axis =
            particle.kind != crate::field::CellKind::Circle && particle.axis != DVec2::ZERO;
        let turn = libm::atan2(self.turn.y, self.turn.x).to_degrees().abs() / fold;
        Alignment {
            spacing: self.far / self.count,
            angle: has_axis.then_some(turn),
        }
    }
}
