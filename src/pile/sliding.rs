//! The exact search for a body's place on its line.

use super::Body;
use super::blocked::Blocked;
use super::sliding_line::{Extent, Met, NOWHERE, SlidingLine, SlidingSphere};
use crate::component::{FourSpheres, Sphere, fourfold};
use crate::order::{greater, set_bits};
use wide::f32x4;

/// A body in one orientation on its line.
pub(super) struct Sliding<'a> {
    line: &'a SlidingLine,
    own: Vec<SlidingSphere>,
    /// The body's spheres, four by four, in units of the body's bound.
    fours: Vec<FourSpheres>,
    extent: Extent,
    /// The pairs of spheres that have blocked a place: numbers among `own` and among the line's `met`.
    pairs: Vec<(usize, usize)>,
}

impl<'a> Sliding<'a> {
    /// A body of these spheres.
    pub fn new(line: &'a SlidingLine, body: &Body, spheres: &[Sphere]) -> Self {
        let own: Vec<SlidingSphere> = spheres
            .iter()
            .map(|s| line.along(body.turn * (body.scale * s.centre), body.scale * s.radius))
            .collect();
        let most =
            |far: fn(&SlidingSphere) -> f64| own.iter().map(far).fold(f64::NEG_INFINITY, greater);
        let coarse = |length: f64| fourfold(length / line.bound);
        let extent = Extent {
            beside: coarse(most(|s| s.off().sqrt() + s.radius)),
            low: coarse(-most(|s| s.radius - s.t)),
            high: coarse(most(|s| s.t + s.radius)),
        };
        let fours = own.chunks(4).map(|four| {
            let sphere = |k: usize| four.get(k).unwrap_or(&NOWHERE);
            let centre = |s: &SlidingSphere| [s.u, s.w, s.t].map(|v| v / line.bound);
            FourSpheres::new(|k| centre(sphere(k)), |k| sphere(k).radius / line.bound)
        });
        Self {
            fours: fours.collect(),
            own,
            extent,
            line,
            pairs: Vec::new(),
        }
    }

    /// The place nearest to the dart at which no spheres overlap by more than `tau`, in R of the smaller body.
    /// `blocked` is the part of the range that is known to be blocked.
    ///
    /// Each pair of spheres blocks an interval. An interval is added only if it contains the nearest place that still
    /// seems free, until none does. Other intervals would not change that place, not even in its last bit.
    pub fn free_place(&mut self, tau: f64, mut blocked: Blocked) -> Option<f64> {
        self.block_again(tau, &mut blocked);
        let mut best = blocked.nearest_to_zero()?;
        let all = self.line.fours.len();
        let coarse_tau = fourfold(tau);
        let (mut k, mut agree) = (0, 0);
        while agree < all {
            let before = best;
            let at = fourfold(best / self.line.bound);
            for lane in set_bits(self.line.fours[k].near(&self.extent, coarse_tau, at)) {
                best = self.meet(4 * k + lane, tau, best, &mut blocked)?;
            }
            agree = if best == before { agree + 1 } else { 0 };
            k = if k + 1 == all { 0 } else { k + 1 };
        }
        Some(best)
    }

    /// Blocks the intervals of all pairs that have blocked a place before.
    fn block_again(&self, tau: f64, blocked: &mut Blocked) {
        for &(own, other) in &self.pairs {
            let other = &self.line.met[other];
            if let Some((from, to)) = self.own[own].interval(other, tau * other.unit) {
                blocked.add(from, to);
            }
        }
    }

    /// Blocks `best` if a settled sphere meets the body there. Returns the next place that seems free, or `None` if all
    /// is blocked.
    fn meet(&mut self, k: usize, tau: f64, mut best: f64, blocked: &mut Blocked) -> Option<f64> {
        let other = &self.line.met[k];
        let allowed = tau * other.unit;
        let (mut centre, radius) = self.there(other, allowed, best);
        for four in 0..self.fours.len() {
            for lane in set_bits(self.fours[four].near(centre, radius)) {
                let own = 4 * four + lane;
                let overlap = self.own[own].overlap(other, allowed, best);
                let Some((from, to)) = overlap else {
                    continue;
                };
                blocked.add(from, to);
                self.pairs.push((own, k));
                best = blocked.nearest_to_zero()?;
                (centre, _) = self.there(other, allowed, best);
            }
        }
        Some(best)
    }

    /// A sphere relative to the body at t, in single precision. The allowed overlap is taken off its radius.
    fn there(&self, other: &Met, allowed: f64, t: f64) -> ([f32x4; 3], f32x4) {
        let SlidingSphere {
            u,
            w,
            t: along,
            radius,
        } = other.sphere;
        let coarse = |length: f64| fourfold(length / self.line.bound);
        ([u, w, along - t].map(coarse), coarse(radius - allowed))
    }
}
