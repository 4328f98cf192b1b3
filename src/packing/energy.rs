//! The potential energy of all pairs, kept from step to step: late in a run most cells are at rest.

use super::body::MovingParticle;
use super::force::{farthest, potential_between};
use super::packing_domain::{Location, MetricSpace, SiteOf};
use super::shape::CellShape;
use super::square_pairs::{SeenSquare, SquarePairs};
use super::transport::ParallelTransport;
use crate::csr::Csr;
use crate::field::CellKind;
use glam::DVec2;

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

    /// A body has moved.
    pub fn has_moved(&mut self, body: usize) {
        if let Some(is_outdated) = self.is_outdated.get_mut(body) {
            *is_outdated = true;
        }
    }

    /// The sum over all pairs. It computes only pairs of which one body has moved, but adds all of them in the
    /// order of the list: the sum does not depend on when the last one was asked for.
    pub fn sum<S: MetricSpace>(
        &mut self,
        near: &Csr<u32>,
        bodies: &[MovingParticle<S::Place>],
        metric: S,
    ) -> f64 {
        if self.pairs.len() != near.len() {
            self.pairs.resize(near.len(), 0.0);
            self.is_outdated.clear();
            self.is_outdated.resize(bodies.len(), true);
        }
        let sites = bodies.iter().map(|b| b.particle.centre.site());
        let sites: Vec<SiteOf<S>> = sites.collect();
        let mut waiting = None;
        let mut k = 0;
        for (i, body) in bodies.iter().enumerate() {
            for &j in near.row(i) {
                let (j, pair) = (j as usize, k);
                k += 1;
                if !(self.is_outdated[i] || self.is_outdated[j]) {
                    continue;
                }
                let (a, b) = (&body.particle, &bodies[j].particle);
                self.pairs[pair] = 0.0;
                let Some((r, turn)) = metric.log_between(&sites[i], &sites[j], farthest(a, b))
                else {
                    continue;
                };
                if !(a.kind == CellKind::Square && b.kind == CellKind::Square) {
                    self.pairs[pair] = potential_between(a, b, (r, turn));
                } else if CellShape::of(a).may_touch(&CellShape::of(b), r, 0.0) {
                    let other = SeenSquare {
                        axis: turn.apply(b.axis),
                        size: b.size,
                        way: r,
                    };
                    let next = (pair, (a.axis, a.size), other);
                    waiting = self.two_squares(waiting, next);
                }
            }
        }
        if let Some((pair, own, other)) = waiting {
            [self.pairs[pair], _] = SquarePairs::new([own; 2], [other; 2]).potentials();
        }
        let sum = self.pairs.iter().fold(0.0, |sum, energy| sum + energy);
        self.is_outdated.fill(false);
        sum
    }

    /// Computes two pairs of squares, or lets the first one wait.
    fn two_squares(
        &mut self,
        waiting: Option<WaitingPair>,
        next: WaitingPair,
    ) -> Option<WaitingPair> {
        let Some(first) = waiting else {
            return Some(next);
        };
        let pairs = SquarePairs::new([first.1, next.1], [first.2, next.2]);
        [self.pairs[first.0], self.pairs[next.0]] = pairs.potentials();
        None
    }
}

/// The number of a pair of squares, the axis and the size of the first one, and the other one.
type WaitingPair = (usize, (DVec2, f64), SeenSquare);
