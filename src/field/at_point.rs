//! The direction at a point, source by source, and its turns along a walk.

use super::follow::{base, sources};
use super::singular::TORN;
use super::sources::{Sum, line_weight, printed_term, printed_vector};
use super::symmetry::{direction_of, representation};
use super::{Direction, FieldParams, Fields};
use crate::domain::Domain;
use glam::DVec2;
use std::f64::consts::TAU;

/// The most samples between two points of a walk.
const MOST_SAMPLES: f64 = 4096.0;

/// A term of equation (1) as printed (Miyata, Itoh, Shimada 2000).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrintedTerm {
    /// The segment of the boundary.
    pub segment: [DVec2; 2],
    /// Its share of the sum.
    pub vector: DVec2,
}

/// The terms of equation (1) as printed at a point, in the order of the boundary. [`printed_sum`] is their sum.
pub fn printed_terms(domain: &Domain, p: DVec2) -> Vec<PrintedTerm> {
    let segments = domain.segments();
    let count = segments.len().max(1) as f64;
    let term = |&segment: &[DVec2; 2]| PrintedTerm {
        segment,
        vector: printed_term(segment, p) / count,
    };
    segments.iter().map(term).collect()
}

/// Equation (1) as printed at a point: the mean of s_i / d_i^2.
pub fn printed_sum(domain: &Domain, p: DVec2) -> DVec2 {
    printed_vector(domain.segments(), p)
}

/// The sum of all sources of the direction at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionSum {
    /// Unit vector along one side of a cell, or zero without sources.
    pub direction: DVec2,
    /// How much the sources agree: 1 if all have one direction, 0 if they cancel.
    pub certainty: f64,
}

impl Fields {
    /// Sums the sources at a point one by one, with the symmetry of the cells there. [`Fields::direction`] is sampled
    /// from such sums. Where the direction is that of [`Direction::Printed`], the boundary is summed by
    /// [`Direction::Boundary`].
    pub fn direction_sum(&self, domain: &Domain, p: DVec2) -> DirectionSum {
        let mut params = self.params.clone();
        if params.direction == Direction::Printed {
            params.direction = Direction::Boundary;
        }
        let FieldParams { reach, power, .. } = params;
        let (space, symmetry) = (domain.space(), self.kind(p).symmetry());
        let mut sum = Sum::default();
        if let Some((base, _)) = base(space, &params, self.along, p) {
            sum.add(line_weight(reach, power), representation(base, symmetry));
        }
        for source in sources(domain, &params, symmetry) {
            for image in space.images(p, f64::INFINITY) {
                source.contribute(image, power, &mut sum);
            }
        }
        if sum.weight == 0.0 {
            return DirectionSum {
                direction: self.along,
                certainty: 1.0,
            };
        }
        sum.break_tie();
        DirectionSum {
            direction: direction_of(sum.vector.normalize_or_zero(), symmetry),
            certainty: sum.coherence(),
        }
    }

    /// How far the direction has turned at each point of a closed walk, in whole turns, clockwise on screen: 0 at the
    /// first point, and at last back there the index of the walk, a multiple of 1/N. Empty if the direction vanishes
    /// or tears on the way. The walk should keep to cells of one symmetry.
    pub fn turns(&self, walk: &[DVec2]) -> Vec<f64> {
        let mut turns = vec![0.0; walk.len() + 1];
        let first = walk.first().copied().unwrap_or_default();
        let Some(layer) = self.layer(first) else {
            return turns;
        };
        let at = |p: DVec2| self.grid.interpolated(&layer.nodes, p);
        let symmetry = f64::from(layer.symmetry);
        let (mut from, mut last, mut angle) = (first, at(first), 0.0);
        for k in 1..=walk.len() {
            let to = walk.get(k).copied().unwrap_or(first);
            let samples = (4.0 * from.distance(to) / self.grid.step).clamp(1.0, MOST_SAMPLES);
            let samples = samples as u32;
            for sample in 1..=samples {
                let next = at(from.lerp(to, f64::from(sample) / f64::from(samples)));
                let (cos, sin) = (last.dot(next), last.perp_dot(next));
                if cos <= TORN * last.length() * next.length() {
                    return Vec::new();
                }
                angle += libm::atan2(sin, cos);
                last = next;
            }
            turns[k] = angle / (TAU * symmetry);
            from = to;
        }
        turns[walk.len()] = (turns[walk.len()] * symmetry).round() / symmetry;
        turns
    }
}
