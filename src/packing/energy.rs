//! The potential energy of all pairs. The potentials of pairs at rest are kept from step to step: late in a run, most
//! cells do not move.

use super::body::MovingParticle;
use super::force::potential_between;
use super::packing_domain::MetricSpace;
use super::physics::CornerBubbles;
use crate::csr::Csr;

/// The potentials (eq. 4) of the pairs of a neighbour list.
#[derive(Clone, Debug, Default)]
pub(super) struct PairEnergies {
    /// The potential of each pair, in the order of the list; empty after a change of the list.
    pairs: Vec<f64>,
    /// Whether each body has moved since the potentials of its pairs were computed.
    is_outdated: Vec<bool>,
}

impl PairEnergies {
    /// Forgets all potentials, because the neighbour list has changed.
    pub fn forget(&mut self) {
        self.pairs.clear();
    }

    /// Marks the potentials of a body's pairs as outdated, because the body has moved.
    pub fn has_moved(&mut self, body: usize) {
        if let Some(is_outdated) = self.is_outdated.get_mut(body) {
            *is_outdated = true;
        }
    }

    /// The sum over all pairs. Only pairs with a moved body are computed anew, but all are added in the order of the
    /// list. So the sum does not depend on earlier calls.
    pub fn sum<S: MetricSpace>(
        &mut self,
        near: &Csr<u32>,
        bodies: &[MovingParticle<S::Place>],
        metric: S,
        corners: CornerBubbles,
    ) -> f64 {
        if self.pairs.len() != near.len() {
            self.pairs.resize(near.len(), 0.0);
            self.is_outdated.clear();
            self.is_outdated.resize(bodies.len(), true);
        }
        let mut pairs = self.pairs.iter_mut();
        let mut sum = 0.0;
        for (i, body) in bodies.iter().enumerate() {
            for (&j, energy) in near.row(i).iter().zip(&mut pairs) {
                let j = j as usize;
                if self.is_outdated[i] || self.is_outdated[j] {
                    let (a, b) = (&body.particle, &bodies[j].particle);
                    let way = metric.log(a.centre, b.centre);
                    *energy = way.map_or(0.0, |way| potential_between(a, b, way, corners));
                }
                sum += *energy;
            }
        }
        self.is_outdated.fill(false);
        sum
    }
}
