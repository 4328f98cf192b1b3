//! What a boundary segment contributes to the direction at a point.
//!
//! Miyata, Itoh, Shimada (2000), eq. (1) adds s_i / d_i^2 over the segments. Two things are read
//! differently: the sum is of representation vectors (see the module above), and a segment's
//! weight is the integral of 1 / distance^p along it, so that cutting a side into pieces changes
//! nothing.

use crate::domain::closest_on_segment;
use glam::DVec2;

/// Distances below this many picture units count as this many: the field is not asked closer.
const NEAREST: f64 = 0.5;

/// From this many segment lengths away two Gauss points give the integral to 1e-5.
const FAR: f64 = 2.0;

/// Segments farther than this many times the nearest one's distance are left out at power 3 and 4:
/// all of them together count for less than a hundredth.
const NEGLIGIBLE: f64 = 8.0;

/// A boundary segment with what every point needs of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source {
    start: DVec2,
    middle: DVec2,
    along: DVec2,
    length: f64,
    fourfold: DVec2,
}

impl Source {
    pub fn new([a, b]: [DVec2; 2]) -> Self {
        let length = a.distance(b);
        let along = (b - a) / length;
        Self {
            start: a,
            middle: a.midpoint(b),
            along,
            length,
            fourfold: super::fourfold(along),
        }
    }

    /// The integral of 1 / |p - x|^power over the segment, power 2, 3 or 4.
    fn weight(&self, p: DVec2, power: u32) -> f64 {
        let middle = self.middle - p;
        if middle.length_squared() > (FAR * self.length) * (FAR * self.length) {
            let offset = self.along * (0.288_675_134_594_812_9 * self.length);
            return 0.5
                * self.length
                * (inverse_power((middle - offset).length_squared(), power)
                    + inverse_power((middle + offset).length_squared(), power));
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

/// The unit representation vector at a point whose nearest boundary point is `nearest` away.
pub(super) fn direction(sources: &[Source], p: DVec2, nearest: f64, power: u32) -> DVec2 {
    let reach = if power > 2 {
        NEGLIGIBLE * nearest.max(1.0)
    } else {
        f64::INFINITY
    };
    let mut sum = DVec2::ZERO;
    for source in sources {
        let limit = reach + 0.5 * source.length;
        if source.middle.distance_squared(p) < limit * limit {
            sum += source.weight(p, power) * source.fourfold;
        }
    }
    sum.normalize_or_zero()
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

/// Equation (1) as printed: the mean of s_i / d_i^2, d_i the distance to the segment.
pub(super) fn printed_vector(segments: &[[DVec2; 2]], p: DVec2) -> DVec2 {
    let mut sum = DVec2::ZERO;
    for &[a, b] in segments {
        let square = closest_on_segment(p, a, b).distance_squared(p);
        sum += (b - a) / square.max(NEAREST * NEAREST);
    }
    sum / segments.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

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
                let weight = Source::new([a, b]).weight(p, power);
                assert!((weight / expected - 1.0).abs() < 1e-4, "{p} {power}");
            }
        }
    }
}
