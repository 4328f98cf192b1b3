//! Size and aspect ratio as functions of the point.

use super::smoothstep;
use glam::DVec2;

/// Change of a value towards the boundary and the constraint lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grading {
    /// Factor of the value on the boundary.
    pub factor: f64,
    /// Distance, in picture units, beyond which the value is unchanged.
    pub reach: f64,
}

impl Grading {
    /// Logarithm of the factor at a distance.
    pub(super) fn log_factor(&self, distance: f64) -> f64 {
        libm::log(self.factor) * smoothstep(1.0 - distance / self.reach)
    }

    pub(super) fn is_flat(&self) -> bool {
        self.factor == 1.0
    }
}

/// A soft spot: full strength at the centre, falling smoothly to zero at the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftSpot {
    /// The middle, picture units.
    pub centre: DVec2,
    /// Where the influence ends, picture units.
    pub radius: f64,
    /// A factor of the size, or an aspect ratio.
    pub value: f64,
}

impl SoftSpot {
    /// Weight at an offset `from` the centre: 1 there, 0 from the radius on.
    pub(super) fn share(&self, from: DVec2) -> f64 {
        let rest = 1.0 - from.length_squared() / (self.radius * self.radius);
        if rest > 0.0 { rest * rest } else { 0.0 }
    }
}

/// A factor that changes from the picture's centre to its edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gradient {
    linear: DVec2,
    radial: f64,
    side: f64,
}

impl Gradient {
    /// For a picture with this side; `None` if the factor is 1 everywhere.
    pub fn new(linear: DVec2, radial: f64, side: f64) -> Option<Self> {
        let gradient = Self {
            linear,
            radial,
            side,
        };
        (linear != DVec2::ZERO || radial != 0.0).then_some(gradient)
    }

    /// The factor at a point, linear and radial.
    pub fn at(&self, p: DVec2) -> f64 {
        let off = self.off_middle(p);
        self.mixed(off, 2.0 * off.length().min(1.0) - 1.0)
    }

    /// Waves that repeat with the picture: symmetric, and as steep at the centre as the gradient.
    pub fn waves_at(&self, p: DVec2) -> f64 {
        let turn = std::f64::consts::PI * self.off_middle(p);
        let across = DVec2::new(libm::sin(turn.x), libm::sin(turn.y));
        self.mixed(across, -0.5 * (libm::cos(turn.x) + libm::cos(turn.y)))
    }

    /// The offset from the centre, -1 to 1 along each axis.
    fn off_middle(&self, p: DVec2) -> DVec2 {
        2.0 * p / self.side - DVec2::ONE
    }

    fn mixed(&self, across: DVec2, outwards: f64) -> f64 {
        1.0 + self.linear.dot(across) + self.radial * outwards
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradings_and_spots_fall_off_smoothly() {
        let grading = Grading {
            factor: 0.25,
            reach: 80.0,
        };
        assert!((libm::exp(grading.log_factor(0.0)) - 0.25).abs() < 1e-12);
        assert_eq!(grading.log_factor(80.0), 0.0);
        assert!((libm::exp(grading.log_factor(40.0)) - 0.5).abs() < 1e-12);
        let spot = SoftSpot {
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
        let gradient = Gradient {
            linear: DVec2::new(0.3, -0.2),
            radial: 0.25,
            side: 2.0,
        };
        let at = |x: f64, y: f64| gradient.waves_at(DVec2::new(x, y));
        for k in 0..20 {
            let t = f64::from(k) * 0.1;
            assert!((at(0.0, t) - at(2.0, t)).abs() < 1e-12);
            assert!((at(t, 0.0) - at(t, 2.0)).abs() < 1e-12);
        }
        assert_eq!(at(1.0, 1.0), 1.0 - gradient.radial);
    }
}
