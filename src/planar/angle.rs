//! Angles and unit vectors, with the same bits on every machine.

use glam::DVec2;

/// The unit vector at an angle from the x axis.
pub(crate) fn unit_vector(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// The signed angle from one vector to another, -π..π.
pub(crate) fn signed_angle(from: DVec2, to: DVec2) -> f64 {
    libm::atan2(from.perp_dot(to), from.dot(to))
}
