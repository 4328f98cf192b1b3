//! The greedy choice of inner spheres among medial balls.

use super::four_spheres::{FourSpheres, fourfold};
use super::pool::Sphere;
use crate::order::{greater, rank, set_bits};
use glam::DVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::collections::binary_heap::PeekMut;

/// A place that fills up a group of four, in units of the body: no ball is near it.
const FAR: DVec3 = DVec3::splat(1e3);

/// The rank of an upper bound of a ball's gain, the ball's number, and the number of chosen spheres for which the bound
/// was computed. Among equally promising balls the least number comes first.
type BallGain = (u64, Reverse<(u32, u32)>);

/// The greedy choice of balls, by the squares of gaps, so that the greatest gaps shrink first. A ball's gain can only
/// shrink as others are chosen, so most gains need not be computed again (Minoux 1978, Accelerated
/// Greedy Algorithms for Maximizing Submodular Set Functions).
#[derive(Default)]
pub(super) struct Choice {
    gaps: GapPlaces,
    spheres: Vec<Sphere>,
    /// The balls that are left, the most promising first: see [`BallGain`].
    gains: BinaryHeap<BallGain>,
}

/// Places with the gap at each: its distance from the nearest sphere.
#[derive(Default)]
struct GapPlaces {
    places: Vec<DVec3>,
    gaps: Vec<f64>,
    greatest: f64,
    /// The places four by four, as spheres whose radii are the gaps: a ball that overlaps such a sphere may reduce the
    /// gap. They are relative to `origin`, a corner of the body, in units of its longest side (`unit`).
    fours: Vec<FourSpheres>,
    origin: DVec3,
    unit: f64,
}

impl GapPlaces {
    fn new(places: Vec<DVec3>) -> Self {
        let wider = |(lo, hi): (DVec3, DVec3), &p: &DVec3| (lo.min(p), hi.max(p));
        let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (origin, high) = places.iter().fold(none, wider);
        let unit = (high - origin).max_element().max(f64::MIN_POSITIVE);
        let near: Vec<DVec3> = places.iter().map(|&p| (p - origin) / unit).collect();
        let bare = |four: &[DVec3]| {
            let place = |k: usize| four.get(k).copied().unwrap_or(FAR).to_array();
            FourSpheres::new(place, |_| 0.0)
        };
        Self {
            gaps: vec![f64::INFINITY; places.len()],
            greatest: f64::INFINITY,
            fours: near.chunks(4).map(bare).collect(),
            origin,
            unit,
            places,
        }
    }

    fn take(&mut self, ball: Sphere) {
        self.greatest = 0.0;
        for (gap, place) in self.gaps.iter_mut().zip(&self.places) {
            let own = place.distance(ball.centre) - ball.radius;
            *gap = gap.min(own.max(0.0));
            self.greatest = greater(self.greatest, *gap);
        }
        for (four, gaps) in self.fours.iter_mut().zip(self.gaps.chunks(4)) {
            four.set_radii(|k| gaps.get(k).map_or(0.0, |gap| gap / self.unit));
        }
    }

    /// By how much a ball would reduce the sum of the squares of the gaps.
    fn gain(&self, ball: &Sphere) -> f64 {
        let coarse = |v: f64| fourfold(v / self.unit);
        let centre = (ball.centre - self.origin).to_array().map(coarse);
        let radius = coarse(ball.radius);
        let mut gain = 0.0;
        for (first, four) in (0..).step_by(4).zip(&self.fours) {
            for k in set_bits(four.near(centre, radius)).map(|lane| first + lane) {
                let gap = self.gaps[k];
                let own = (self.places[k].distance(ball.centre) - ball.radius).max(0.0);
                if own < gap {
                    gain += gap * gap - own * own;
                }
            }
        }
        gain
    }
}

impl Choice {
    /// Begins to choose among a number of balls, by the gaps at places.
    pub fn new(places: Vec<DVec3>, balls: usize) -> Self {
        let unknown = |ball| (rank(f64::INFINITY), Reverse((ball, 0)));
        Self {
            gaps: GapPlaces::new(places),
            gains: (0..balls as u32).map(unknown).collect(),
            spheres: Vec::new(),
        }
    }

    /// The spheres in the order of choice.
    pub fn spheres(&self) -> &[Sphere] {
        &self.spheres
    }

    /// The greatest gap.
    pub fn greatest(&self) -> f64 {
        self.gaps.greatest
    }

    /// The mean gap.
    pub fn mean(&self) -> f64 {
        let gaps = &self.gaps.gaps;
        gaps.iter().sum::<f64>() / gaps.len() as f64
    }

    /// For each sphere the greatest gap at places to which it is the nearest one.
    pub fn beyond(&self) -> Vec<f64> {
        let mut beyond = vec![0.0_f64; self.spheres.len()];
        for (place, &gap) in self.gaps.places.iter().zip(&self.gaps.gaps) {
            let away = |sphere: &Sphere| place.distance(sphere.centre) - sphere.radius;
            let all = self.spheres.iter().map(away).enumerate();
            let nearest = all.min_by(|a, b| a.1.total_cmp(&b.1));
            if let Some((k, _)) = nearest {
                beyond[k] = beyond[k].max(gap);
            }
        }
        beyond
    }

    /// Takes a ball.
    pub fn take(&mut self, ball: Sphere) {
        self.gaps.take(ball);
        self.spheres.push(ball);
    }

    /// Takes the most promising ball if its gain is up to date, else computes this gain. False if no ball gains
    /// anything.
    pub fn advance(&mut self, pool: &[Sphere]) -> bool {
        let known = self.spheres.len() as u32;
        let Some(mut best) = self.gains.peek_mut().filter(|best| best.0 > rank(0.0)) else {
            return false;
        };
        let (ball, known_at) = best.1.0;
        if known_at == known {
            PeekMut::pop(best);
            self.take(pool[ball as usize]);
        } else {
            let gain = self.gaps.gain(&pool[ball as usize]);
            *best = (rank(gain), Reverse((ball, known)));
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    #[test]
    fn a_gain_is_the_sum_over_all_places() {
        let mut random = Random::new(1, Purpose::Scatter, 0);
        let mut draw = || DVec3::new(random.unit(), random.unit(), random.unit());
        // Far from the origin, as places of a file may be.
        let home = DVec3::splat(5_000.0);
        let places: Vec<DVec3> = (0..203).map(|_| home + 3.0 * draw()).collect();
        let mut gaps = GapPlaces::new(places);
        for _ in 0..20 {
            let [centre, size] = [draw(), draw()];
            let ball = Sphere {
                centre: home + 3.0 * centre,
                radius: size.x,
            };
            let reduced = |(place, gap): (&DVec3, &f64)| {
                let own = (place.distance(ball.centre) - ball.radius).max(0.0);
                if own < *gap {
                    gap * gap - own * own
                } else {
                    0.0
                }
            };
            if gaps.greatest < f64::INFINITY {
                let all: f64 = gaps.places.iter().zip(&gaps.gaps).map(reduced).sum();
                assert_eq!(gaps.gain(&ball), all);
            }
            gaps.take(ball);
            let greatest = gaps.gaps.iter().copied().fold(0.0, f64::max);
            assert_eq!(gaps.greatest, greatest);
        }
    }
}
