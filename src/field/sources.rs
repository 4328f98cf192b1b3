//! Contributions of segments to the direction at a point.
//!
//! Miyata, Itoh, Shimada (2000), eq. (1) adds s_i / d_i^2 over the boundary's segments. Two things differ
//! here: the sum is of representation vectors, and a segment's weight is the integral of 1 / distance^p along
//! it, so that cutting a side into pieces changes nothing.
//!
//! The segments stand in a tree with moments of each branch, so that far ones are summed together.

use super::symmetry::representation;
use crate::planar::closest_on_segment;
use glam::DVec2;
use wide::f64x2;

/// Smaller distances count as this one (picture units), so that the field stays finite.
const NEAREST: f64 = 0.5;

/// At distances of at least this many segment lengths, two Gauss points give the integral over a segment to 1e-5.
const FAR: f64 = 2.0;

/// At power 3 and 4, segments farther than this many times the nearest distance are left out: together they
/// weigh less than a hundredth.
const NEGLIGIBLE: f64 = 8.0;

/// A branch farther from the point than this many of its radii is summed as one source, by its moments.
const OPENING: f64 = 3.0;

/// Most sources of a branch without children.
const LEAF: usize = 3;

/// A segment with its precomputed values.
#[derive(Clone, Copy, Debug)]
pub(super) struct SourceSegment {
    start: DVec2,
    end: DVec2,
    middle: DVec2,
    along: DVec2,
    length: f64,
    /// From the middle to a Gauss point.
    offset: DVec2,
    /// Factor of the weight.
    strength: f64,
    representation: DVec2,
}

impl SourceSegment {
    /// `None` for a segment of zero length.
    pub fn new([a, b]: [DVec2; 2], strength: f64, symmetry: u32) -> Option<Self> {
        let length = a.distance(b);
        let along = (b - a) / length;
        (length > 0.0).then(|| Self {
            start: a,
            end: a + length * along,
            middle: a.midpoint(b),
            along,
            length,
            offset: along * (0.288_675_134_594_812_9 * length),
            strength,
            representation: representation(along, symmetry),
        })
    }

    /// Adds its contribution to the direction at a point.
    pub fn contribute(&self, p: DVec2, power: u32, sum: &mut Sum) {
        sum.add(self.strength * self.weight(p, power), self.representation);
    }

    /// The integral of 1 / |p - x|^power over the segment, power 2, 3 or 4.
    fn weight(&self, p: DVec2, power: u32) -> f64 {
        let middle = self.middle - p;
        if middle.length_squared() > (FAR * self.length) * (FAR * self.length) {
            let (a, b) = (middle - self.offset, middle + self.offset);
            let (x, y) = (f64x2::new([a.x, b.x]), f64x2::new([a.y, b.y]));
            let [a, b] = inverse_powers(x * x + y * y, power).to_array();
            return 0.5 * self.length * (a + b);
        }
        let h = self.along.perp_dot(p - self.start).abs().max(NEAREST);
        let from = self.along.dot(self.start - p);
        let to = from + self.length;
        match power {
            2 => angle_between(from, to, h) / h,
            3 => {
                let part = |t: f64| t / (h * h * (h * h + t * t).sqrt());
                part(to) - part(from)
            }
            _ => {
                let part = |t: f64| t / (2.0 * h * h * (h * h + t * t));
                part(to) - part(from) + angle_between(from, to, h) / (2.0 * h * h * h)
            }
        }
    }
}

/// The weight of an infinite straight line at a distance.
pub(super) fn line_weight(distance: f64, power: u32) -> f64 {
    let h = distance.max(NEAREST);
    match power {
        2 => std::f64::consts::PI / h,
        3 => 2.0 / (h * h),
        _ => std::f64::consts::FRAC_PI_2 / (h * h * h),
    }
}

/// Sums of representation vectors and of their weights.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sum {
    pub vector: DVec2,
    pub weight: f64,
}

impl Sum {
    pub fn add(&mut self, weight: f64, representation: DVec2) {
        self.vector += weight * representation;
        self.weight += weight;
    }
}

/// Sources in a tree, so that far ones are summed together up to second moments (Barnes, Hut 1986).
#[derive(Clone, Debug, Default)]
pub(super) struct Sources {
    list: Vec<SourceSegment>,
    /// Depth-first: each branch stands before its two halves.
    branches: Vec<Branch>,
}

#[derive(Clone, Copy, Debug)]
struct Branch {
    first: usize,
    end: usize,
    /// Index of the first branch after this branch and its descendants.
    next: usize,
    middle: DVec2,
    radius: f64,
    weight: f64,
    /// Moments of the representation over the segments: its integrals times 1, x, y, x², xy and y², relative
    /// to the centre.
    moments: [DVec2; 6],
}

impl Sources {
    /// The tree of these sources. Consecutive sources should be neighbours in space, so that branches are small.
    pub fn new(list: Vec<SourceSegment>) -> Self {
        let mut sources = Self {
            list,
            branches: Vec::new(),
        };
        if !sources.list.is_empty() {
            sources.grow(0, sources.list.len());
        }
        sources
    }

    fn grow(&mut self, first: usize, end: usize) {
        let list = &self.list[first..end];
        let ends = |s: &SourceSegment| [s.start, s.end];
        let mut corners = (list[0].start, list[0].start);
        for p in list.iter().flat_map(ends) {
            corners = (corners.0.min(p), corners.1.max(p));
        }
        let middle = corners.0.midpoint(corners.1);
        let mut branch = Branch {
            first,
            end,
            next: 0,
            middle,
            radius: 0.0,
            weight: 0.0,
            moments: [DVec2::ZERO; 6],
        };
        for source in list {
            for p in ends(source) {
                branch.radius = branch.radius.max(p.distance(middle));
            }
            let weight = source.strength * source.length;
            let (from, half) = (source.middle - middle, 0.5 * source.length * source.along);
            let mean = |x: f64, y: f64, u: f64, v: f64| x * y + u * v / 3.0;
            let factors = [
                1.0,
                from.x,
                from.y,
                mean(from.x, from.x, half.x, half.x),
                mean(from.x, from.y, half.x, half.y),
                mean(from.y, from.y, half.y, half.y),
            ];
            branch.weight += weight;
            for (moment, factor) in branch.moments.iter_mut().zip(factors) {
                *moment += factor * weight * source.representation;
            }
        }
        let at = self.branches.len();
        self.branches.push(branch);
        if end - first > LEAF {
            let half = first.midpoint(end);
            self.grow(first, half);
            self.grow(half, end);
        }
        self.branches[at].next = self.branches.len();
    }

    /// Distance to the nearest source, or `most` if none is that near.
    pub fn distance(&self, p: DVec2, most: f64) -> f64 {
        let mut least = most;
        let mut at = 0;
        while let Some(branch) = self.branches.get(at) {
            let reach = least + branch.radius;
            at += 1;
            if branch.middle.distance_squared(p) >= reach * reach {
                at = branch.next;
            } else if at == branch.next {
                for source in &self.list[branch.first..branch.end] {
                    let place = closest_on_segment(p, source.start, source.end);
                    least = least.min(place.distance(p));
                }
            }
        }
        least
    }

    /// Adds the contributions of all sources at a point whose nearest source is `nearest` away.
    pub fn sum(&self, p: DVec2, nearest: f64, power: u32, sum: &mut Sum) {
        let cut = if power > 2 {
            NEGLIGIBLE * nearest.max(1.0)
        } else {
            f64::INFINITY
        };
        let mut at = 0;
        while let Some(branch) = self.branches.get(at) {
            let to = branch.middle - p;
            let square = to.length_squared();
            let (reach, opening) = (cut + branch.radius, OPENING * branch.radius);
            at += 1;
            if square > reach * reach {
                at = branch.next;
            } else if square > opening * opening {
                at = branch.next;
                // Taylor series of the inverse power around the branch's centre.
                let weight = inverse_power(square, power);
                let p = f64::from(power);
                let first = -p * weight / square;
                let (second, [m, x, y, xx, xy, yy]) =
                    (-0.5 * (p + 2.0) * first / square, branch.moments);
                sum.vector += weight * m
                    + first * (to.x * x + to.y * y + 0.5 * (xx + yy))
                    + second * (to.x * to.x * xx + 2.0 * to.x * to.y * xy + to.y * to.y * yy);
                sum.weight += weight * branch.weight;
            } else if at == branch.next {
                for source in &self.list[branch.first..branch.end] {
                    source.contribute(p, power, sum);
                }
            }
        }
    }
}

/// atan(to / h) - atan(from / h) with one call.
fn angle_between(from: f64, to: f64, h: f64) -> f64 {
    libm::atan2(h * (to - from), h * h + from * to)
}

fn inverse_power(square: f64, power: u32) -> f64 {
    match power {
        2 => 1.0 / square,
        3 => 1.0 / (square * square.sqrt()),
        _ => 1.0 / (square * square),
    }
}

/// [`inverse_power`] of two squared distances.
fn inverse_powers(squares: f64x2, power: u32) -> f64x2 {
    let one = f64x2::splat(1.0);
    match power {
        2 => one / squares,
        3 => one / (squares * squares.sqrt()),
        _ => one / (squares * squares),
    }
}

/// Equation (1) as printed: the mean of s_i / d_i^2, d_i the distance to the segment.
pub(super) fn printed_vector(segments: &[[DVec2; 2]], p: DVec2) -> DVec2 {
    let mut sum = DVec2::ZERO;
    for &segment in segments {
        sum += printed_term(segment, p);
    }
    sum / segments.len().max(1) as f64
}

/// The term s_i / d_i^2 of a segment.
pub(super) fn printed_term([a, b]: [DVec2; 2], p: DVec2) -> DVec2 {
    let square = closest_on_segment(p, a, b).distance_squared(p);
    (b - a) / square.max(NEAREST * NEAREST)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::{signed_angle, unit_vector};

    #[test]
    fn weights_equal_numerical_integrals() {
        let (a, b) = (DVec2::new(3.0, 4.0), DVec2::new(23.0, 11.0));
        for p in [
            DVec2::new(0.0, 9.0),
            DVec2::new(13.0, 2.0),
            DVec2::new(-90.0, 70.0),
        ] {
            for power in [2, 3, 4] {
                let n = 20_000;
                let sum: f64 = (0..n)
                    .map(|k| {
                        a.lerp(b, (f64::from(k) + 0.5) / f64::from(n))
                            .distance_squared(p)
                    })
                    .map(|square| inverse_power(square, power))
                    .sum();
                let expected = sum * a.distance(b) / f64::from(n);
                let source = SourceSegment::new([a, b], 1.0, 4).unwrap();
                let weight = source.weight(p, power);
                assert!((weight / expected - 1.0).abs() < 1e-4, "{p} {power}");
            }
        }
    }

    /// A wavy coast of 400 segments: the tree against the plain sum.
    #[test]
    fn the_tree_gives_the_plain_sum() {
        let at = |k: usize| {
            let t = k as f64 / 400.0 * std::f64::consts::TAU;
            let r = 180.0 + 30.0 * libm::sin(5.0 * t) + 6.0 * libm::sin(31.0 * t);
            DVec2::splat(256.0) + r * unit_vector(t)
        };
        let segments = (0..400).map(|k| [at(k), at((k + 1) % 400)]);
        for symmetry in [2, 4] {
            let list: Vec<SourceSegment> = segments
                .clone()
                .filter_map(|s| SourceSegment::new(s, 1.0, symmetry))
                .collect();
            let tree = Sources::new(list.clone());
            let (mut error, mut points) = (0.0, 0.0);
            for k in 0..400 {
                let p = DVec2::new(f64::from(k * 37 % 512), f64::from(k * 91 % 512));
                let mut plain = Sum::default();
                let mut nearest = f64::INFINITY;
                for source in &list {
                    plain.add(source.weight(p, 4), source.representation);
                    let end = source.start + source.length * source.along;
                    nearest = nearest.min(closest_on_segment(p, source.start, end).distance(p));
                }
                assert!((tree.distance(p, 1e9) - nearest).abs() < 1e-9, "{p}");
                if plain.vector.length() < 0.5 * plain.weight {
                    continue;
                }
                let mut sum = Sum::default();
                tree.sum(p, nearest, 4, &mut sum);
                let (a, b) = (sum.vector, plain.vector);
                error += signed_angle(a, b).abs() / f64::from(symmetry);
                points += 1.0;
            }
            let mean = (error / points).to_degrees();
            assert!(mean < 0.2, "{mean} degrees off");
        }
    }
}
