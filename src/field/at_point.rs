//! The direction at a point, source by source, and its turns along a walk. All sums are plain: neither the tree of
//! sources nor the background grid takes part.

use super::follow::{base, sources};
use super::singular::TORN;
use super::sources::{SourceSegment, Sum, line_weight, printed_term, printed_vector};
use super::symmetry::{direction_of, representation};
use super::{Direction, FieldParams, Fields, ends};
use crate::domain::Domain;
use crate::planar::closest_on_segment;
use glam::DVec2;
use std::f64::consts::TAU;

/// Samples of a walk on the length of the picture's side; at most [`MOST_SAMPLES`] between two of its places.
const SAMPLES: f64 = 256.0;
const MOST_SAMPLES: f64 = 4096.0;

/// A segment of the boundary and its terms in the direction at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentTerm {
    /// Its ends.
    pub segment: [DVec2; 2],
    /// Its distance d_i.
    pub distance: f64,
    /// Its share of [`printed_sum`].
    pub printed: DVec2,
    /// Its share of our sum: its representation vector times its weight, over the weight of the whole boundary.
    pub turned: DVec2,
}

/// Equation (1) of Miyata, Itoh, Shimada (2000) as printed, at a point: the mean of s_i / d_i^2 over the boundary.
pub fn printed_sum(domain: &Domain, p: DVec2) -> DVec2 {
    printed_vector(domain.segments(), p)
}

/// The sum of all sources of the direction at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionSum {
    /// Unit vector along one side of a cell, or zero where the sources cancel.
    pub direction: DVec2,
    /// How much the sources agree: 1 if all have one direction, 0 if they cancel.
    pub certainty: f64,
}

/// A place on a walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WalkPlace {
    /// The direction there.
    pub sum: DirectionSum,
    /// How far the direction has turned on the way, in whole turns, clockwise on screen.
    pub turns: f64,
}

/// The sources of the direction, with one symmetry.
struct PlainSources<'a> {
    fields: &'a Fields,
    domain: &'a Domain,
    params: FieldParams,
    symmetry: u32,
    list: Vec<SourceSegment>,
}

impl<'a> PlainSources<'a> {
    /// The sources with the symmetry of the cells at a point.
    fn new(fields: &'a Fields, domain: &'a Domain, p: DVec2) -> Self {
        let mut params = fields.params.clone();
        if params.direction == Direction::Printed {
            params.direction = Direction::Boundary;
        }
        let symmetry = fields.kind(p).symmetry();
        Self {
            fields,
            domain,
            symmetry,
            list: sources(domain, &params, symmetry),
            params,
        }
    }

    /// The weighted mean of the sources' representation vectors at a point, and the direction and certainty by it.
    fn at(&self, p: DVec2) -> (DVec2, DirectionSum) {
        let (params, along, symmetry) = (&self.params, self.fields.along, self.symmetry);
        let space = self.domain.space();
        let mut sum = Sum::default();
        if let Some((base, _)) = base(space, params, along, p) {
            let weight = line_weight(params.reach, params.power);
            sum.add(weight, representation(base, symmetry));
        }
        for source in &self.list {
            for image in space.images(p, f64::INFINITY) {
                source.contribute(image, params.power, &mut sum);
            }
        }
        if sum.weight == 0.0 {
            sum.add(1.0, representation(along, symmetry));
        }
        let mean = sum.vector / sum.weight;
        let direction = direction_of(mean.normalize_or_zero(), symmetry);
        let certainty = mean.length();
        (
            mean,
            DirectionSum {
                direction,
                certainty,
            },
        )
    }
}

impl Fields {
    /// The terms of the boundary's segments at a point, in their order, with the symmetry of the cells there.
    pub fn segment_terms(&self, domain: &Domain, p: DVec2) -> Vec<SegmentTerm> {
        let symmetry = self.kind(p).symmetry();
        let (segments, power) = (domain.segments(), self.params.power);
        let strengths = ends::strengths(domain, if symmetry == 4 { 1.0 } else { self.params.ends });
        let count = segments.len() as f64;
        let (mut terms, mut whole) = (Vec::with_capacity(segments.len()), 0.0);
        for (&segment, strength) in segments.iter().zip(strengths) {
            let mut sum = Sum::default();
            if let Some(source) = SourceSegment::new(segment, strength, symmetry) {
                source.contribute(p, power, &mut sum);
            }
            whole += sum.weight;
            let [a, b] = segment;
            terms.push(SegmentTerm {
                segment,
                distance: closest_on_segment(p, a, b).distance(p),
                printed: printed_term(segment, p) / count,
                turned: sum.vector,
            });
        }
        for term in &mut terms {
            term.turned /= whole;
        }
        terms
    }

    /// Sums the sources at a point one by one, with the symmetry of the cells there. [`Fields::direction`] is sampled
    /// from such sums. Where the direction is that of [`Direction::Printed`], the boundary is summed by
    /// [`Direction::Boundary`].
    pub fn direction_sum(&self, domain: &Domain, p: DVec2) -> DirectionSum {
        PlainSources::new(self, domain, p).at(p).1
    }

    /// The direction along a closed walk within the outline: at each of its places, and back at the first one. There
    /// the direction has turned by the index of the walk, a multiple of 1/N (N: the symmetry). Empty if the walk leaves
    /// the outline, or the direction vanishes or tears on the way. The symmetry is that of the cells at the first
    /// place.
    pub fn along_walk(&self, domain: &Domain, walk: &[DVec2]) -> Vec<WalkPlace> {
        let Some(&first) = walk.first() else {
            return Vec::new();
        };
        let sources = PlainSources::new(self, domain, first);
        let full = TAU * f64::from(sources.symmetry);
        let (mut from, (mut last, sum)) = (first, sources.at(first));
        let mut angle = 0.0;
        let mut places = vec![WalkPlace { sum, turns: 0.0 }];
        for &to in walk[1..].iter().chain([&first]) {
            let samples = (from.distance(to) / self.params.side * SAMPLES).clamp(1.0, MOST_SAMPLES);
            let samples = samples.ceil() as u32;
            let mut sum = sum;
            for sample in 1..=samples {
                let p = from.lerp(to, f64::from(sample) / f64::from(samples));
                let (next, here) = sources.at(p);
                let (cos, sin) = (last.dot(next), last.perp_dot(next));
                if cos <= TORN * last.length() * next.length() || !domain.contains(p) {
                    return Vec::new();
                }
                angle += libm::atan2(sin, cos);
                (last, sum) = (next, here);
            }
            places.push(WalkPlace {
                sum,
                turns: angle / full,
            });
            from = to;
        }
        if let Some(end) = places.last_mut() {
            end.turns = (angle / TAU).round() / f64::from(sources.symmetry);
        }
        places
    }
}
