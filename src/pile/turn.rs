//! Orientations of bodies.

use crate::random::Random;
use glam::{DMat3, DVec3};
use std::f64::consts::{PI, TAU};

/// How the bodies of a type are turned (section 4.1.3).
///
/// A body's v axis is its y axis, the upright one. It lies along the surface's normal, and u is horizontal. In the
/// global frame (fig. 13) v is the y axis of space. Then a body turns about v, u and w, in this order. The axes turn
/// with it. Each angle is uniform in a range about 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// θu, θv, θw: the widths of the ranges, in radians. If all are full turns, orientations are uniform over all
    /// rotations.
    pub ranges: DVec3,
    /// Whether angles count from the axes of space, not from those of the surface.
    pub is_global: bool,
}

impl Turn {
    /// The orientation of one body: a rotation from its own frame to space.
    pub fn draw(&self, normal: DVec3, random: &mut Random) -> DMat3 {
        if self.ranges.min_element() >= TAU - 1e-9 {
            return uniform(random);
        }
        let [u, v, w] = [self.ranges.x, self.ranges.y, self.ranges.z]
            .map(|range| 0.5 * range * random.signed());
        let frame = if self.is_global {
            DMat3::IDENTITY
        } else {
            frame(normal)
        };
        frame * about_y(v) * about_x(u) * about_z(w)
    }
}

/// The frame with columns u, v, w: v is the normal, and u is horizontal.
fn frame(normal: DVec3) -> DMat3 {
    let v = normal;
    let u = DVec3::Y.cross(v).try_normalize().unwrap_or(DVec3::X);
    DMat3::from_cols(u, v, u.cross(v))
}

fn about_x(angle: f64) -> DMat3 {
    let (sin, cos) = libm::sincos(angle);
    DMat3::from_cols(
        DVec3::X,
        DVec3::new(0.0, cos, sin),
        DVec3::new(0.0, -sin, cos),
    )
}

fn about_y(angle: f64) -> DMat3 {
    let (sin, cos) = libm::sincos(angle);
    DMat3::from_cols(
        DVec3::new(cos, 0.0, -sin),
        DVec3::Y,
        DVec3::new(sin, 0.0, cos),
    )
}

fn about_z(angle: f64) -> DMat3 {
    let (sin, cos) = libm::sincos(angle);
    DMat3::from_cols(
        DVec3::new(cos, sin, 0.0),
        DVec3::new(-sin, cos, 0.0),
        DVec3::Z,
    )
}

/// A rotation, uniform over all rotations (Shoemake 1992, Uniform Random Rotations).
fn uniform(random: &mut Random) -> DMat3 {
    let share = random.unit();
    let [a, b] = [random.signed(), random.signed()].map(|turns| libm::sincos(PI * turns));
    let [r, s] = [(1.0 - share).sqrt(), share.sqrt()];
    let [x, y, z, w] = [r * a.0, r * a.1, s * b.0, s * b.1];
    DMat3::from_cols(
        DVec3::new(
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y + w * z),
            2.0 * (x * z - w * y),
        ),
        DVec3::new(
            2.0 * (x * y - w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z + w * x),
        ),
        DVec3::new(
            2.0 * (x * z + w * y),
            2.0 * (y * z - w * x),
            1.0 - 2.0 * (x * x + y * y),
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Purpose;

    const FULL: Turn = Turn {
        ranges: DVec3::splat(TAU),
        is_global: false,
    };

    fn draws(turn: Turn, normal: DVec3) -> impl Iterator<Item = DMat3> {
        (0..4000).map(move |k| turn.draw(normal, &mut Random::new(3, Purpose::Turn, k)))
    }

    #[test]
    fn orientations_are_rotations() {
        let some = Turn {
            ranges: DVec3::new(1.0, 6.0, 0.5),
            is_global: false,
        };
        for m in draws(FULL, DVec3::Y).chain(draws(some, DVec3::new(0.6, 0.0, 0.8))) {
            assert!((m * m.transpose()).abs_diff_eq(DMat3::IDENTITY, 1e-12));
            assert!((m.determinant() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn full_ranges_are_uniform_over_all_rotations() {
        // Each axis is uniform on the sphere: its height is uniform in -1..1, so its square has the mean 1/3 and its
        // fourth power 1/5. The trace has the mean 0 and its square the mean 1.
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let squared = |values: &[f64]| values.iter().map(|v| v * v).collect::<Vec<_>>();
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            let heights: Vec<f64> = draws(FULL, DVec3::Y).map(|m| (m * axis).y).collect();
            let squares = squared(&heights);
            assert!(mean(&heights).abs() < 0.04 && (mean(&squares) - 1.0 / 3.0).abs() < 0.02);
            assert!((mean(&squared(&squares)) - 0.2).abs() < 0.02);
        }
        let trace = |m: DMat3| m.x_axis.x + m.y_axis.y + m.z_axis.z;
        let traces: Vec<f64> = draws(FULL, DVec3::Y).map(trace).collect();
        assert!(mean(&traces).abs() < 0.06 && (mean(&squared(&traces)) - 1.0).abs() < 0.08);
    }

    #[test]
    fn ranges_count_from_the_normal_or_from_space() {
        let normal = DVec3::new(0.6, 0.0, 0.8);
        let none = Turn {
            ranges: DVec3::new(0.0, TAU, 0.0),
            is_global: false,
        };
        for m in draws(none, normal) {
            assert!((m.y_axis - normal).length() < 1e-12);
        }
        let global = Turn {
            ranges: DVec3::splat(0.2),
            is_global: true,
        };
        for m in draws(global, normal) {
            assert!(m.y_axis.y > libm::cos(0.2));
        }
    }
}
