//! Heap and dome: open surfaces on the ground.

use super::piled::PiledShape;
use super::rings;
use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_2;

/// The heap for the numbers `[height, round, depth]`. Its profile blends a smooth fall (the share `round`) with a
/// straight one: with a roundness of 0.86 it is .495 (1 - r)² (1 + 2 r) + .08 (1 - r) times a constant.
pub(super) fn heap(n: &[f64], edge: f64) -> PiledShape {
    let profile = |r: f64| {
        let fall = 1.0 - r;
        let smooth = fall * fall * (1.0 + 2.0 * r);
        DVec2::new(0.5 * r, n[0] * (n[1] * smooth + (1.0 - n[1]) * fall))
    };
    oval(profile, n[2], edge)
}

/// The dome for the numbers `[height, depth]`.
pub(super) fn dome(n: &[f64], edge: f64) -> PiledShape {
    let profile = |t: f64| {
        let angle = FRAC_PI_2 * t;
        // The rim lies on the ground exactly, without rounding errors.
        let up = if t < 1.0 { libm::cos(angle) } else { 0.0 };
        DVec2::new(0.5 * libm::sin(angle), n[0] * up)
    };
    oval(profile, n[1], edge)
}

fn oval(profile: impl Fn(f64) -> DVec2, depth: f64, edge: f64) -> PiledShape {
    let mut surface = rings::disc(profile, edge);
    let squeeze = DVec3::new(1.0, 1.0, depth);
    surface.positions.iter_mut().for_each(|p| *p *= squeeze);
    PiledShape::grounded(surface)
}
