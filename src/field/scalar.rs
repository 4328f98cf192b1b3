//! Size and aspect ratio as functions of the point.

use super::FieldParams;
use crate::domain::Domain;
use glam::DVec2;

/// How a value changes towards the boundary and the constraint lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim {
    /// Factor of the value on the boundary.
    pub factor: f64,
    /// Distance, in picture units, from which on the value is its own again.
    pub reach: f64,
}

impl Default for Rim {
    fn default() -> Self {
        Self {
            factor: 1.0,
            reach: 1.0,
        }
    }
}

impl Rim {
    /// Logarithm of the factor at a distance.
    pub(super) fn log_factor(&self, distance: f64) -> f64 {
        let t = 1.0 - (distance / self.reach).clamp(0.0, 1.0);
        libm::log(self.factor) * (t * t * (3.0 - 2.0 * t))
    }

    pub(super) fn is_flat(&self) -> bool {
        self.factor == 1.0
    }
}

/// A soft spot: its value in the middle, falling off smoothly to nothing at the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The middle, picture units.
    pub centre: DVec2,
    /// Where it ends, picture units.
    pub radius: f64,
    /// A factor of the size, or an aspect ratio.
    pub value: f64,
}

impl Spot {
    /// Its share at a point that lies `from` its middle: 1 there, 0 from the radius on.
    pub(super) fn share(&self, from: DVec2) -> f64 {
        let rest = 1.0 - from.length_squared() / (self.radius * self.radius);
        if rest > 0.0 { rest * rest } else { 0.0 }
    }
}

/// A gradient across the picture's middle, from -1 to 1 in each direction: linear and radial, or as
/// waves that repeat with the picture.
pub(super) fn gradient(linear: DVec2, radial: f64, from_middle: DVec2, periodic: bool) -> f64 {
    let (across, outwards) = if periodic {
        let turn = std::f64::consts::PI * from_middle;
        (
            DVec2::new(libm::sin(turn.x), libm::sin(turn.y)),
            -0.5 * (libm::cos(turn.x) + libm::cos(turn.y)),
        )
    } else {
        (from_middle, 2.0 * from_middle.length().min(1.0) - 1.0)
    };
    1.0 + linear.dot(across) + radial * outwards
}

/// The factor of the size at a point: rim and spots, and the waves of a torus.
pub(super) fn growth(params: &FieldParams, domain: &Domain, p: DVec2) -> f64 {
    let mut log = rim(&params.size_rim, domain, p);
    shares(&params.size_spots, domain, p, |share, value| {
        log += share * libm::log(value);
    });
    let factor = libm::exp(log);
    if domain.period().is_none() {
        return factor;
    }
    let from_middle = 2.0 * p / params.side - DVec2::ONE;
    factor * gradient(params.linear, params.radial, from_middle, true)
}

/// The aspect ratio of stretched cells at a point.
pub(super) fn stretch(params: &FieldParams, domain: &Domain, p: DVec2) -> f64 {
    let mut log = libm::log(params.aspect) + rim(&params.aspect_rim, domain, p);
    shares(&params.aspect_spots, domain, p, |share, value| {
        log += share * (libm::log(value) - log);
    });
    libm::exp(log)
}

/// The spots that count at a point: their share and value.
fn shares(spots: &[Spot], domain: &Domain, p: DVec2, mut each: impl FnMut(f64, f64)) {
    for spot in spots {
        let share = spot.share(domain.shortest(p - spot.centre));
        if share > 0.0 {
            each(share, spot.value);
        }
    }
}

fn rim(rim: &Rim, domain: &Domain, p: DVec2) -> f64 {
    if rim.is_flat() {
        0.0
    } else {
        rim.log_factor(depth(domain, p))
    }
}

/// Distance to the boundary and the constraint lines; 0 outside.
fn depth(domain: &Domain, p: DVec2) -> f64 {
    let boundary = domain.nearest(p).distance.max(0.0);
    domain
        .nearest_line(p)
        .map_or(boundary, |near| boundary.min(near.distance))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rims_and_spots_fall_off_smoothly() {
        let rim = Rim {
            factor: 0.25,
            reach: 80.0,
        };
        assert!((libm::exp(rim.log_factor(0.0)) - 0.25).abs() < 1e-12);
        assert_eq!(rim.log_factor(80.0), 0.0);
        assert!((libm::exp(rim.log_factor(40.0)) - 0.5).abs() < 1e-12);
        let spot = Spot {
            centre: DVec2::ZERO,
            radius: 10.0,
            value: 2.0,
        };
        assert_eq!(spot.share(DVec2::ZERO), 1.0);
        assert_eq!(spot.share(DVec2::new(6.0, 8.0)), 0.0);
        assert_eq!(spot.share(DVec2::new(60.0, 8.0)), 0.0);
        assert!((spot.share(DVec2::X * 5.0) - 0.5625).abs() < 1e-12);
    }

    #[test]
    fn waves_repeat_with_the_picture() {
        let (linear, radial) = (DVec2::new(0.3, -0.2), 0.25);
        let at = |x: f64, y: f64| gradient(linear, radial, DVec2::new(x, y), true);
        for k in 0..20 {
            let t = f64::from(k) * 0.1 - 1.0;
            assert!((at(-1.0, t) - at(1.0, t)).abs() < 1e-12);
            assert!((at(t, -1.0) - at(t, 1.0)).abs() < 1e-12);
        }
        assert_eq!(at(0.0, 0.0), 1.0 - radial);
    }
}
