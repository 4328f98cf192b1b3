//! Grains and kernels: rice, beans, cashews and almonds. Each is a tube along an arc.

use super::shell::{Shell, Spot, bell, step, turned};
use super::{Mark, Part};
use glam::DVec3;
use std::f64::consts::PI;

/// The place of a ring along a tube, -1 to 1; rings are denser towards the ends.
fn along(ring: usize, rings: usize) -> f64 {
    -libm::cos(PI * ring as f64 / (rings - 1) as f64)
}

/// The radius of a rounded tube at `t`, -1 to 1, relative to its middle: 0 at the ends.
fn rounded(t: f64, full: f64, blunt: f64) -> f64 {
    let left = 1.0 - libm::pow(t.abs(), full);
    if left <= 0.0 {
        0.0
    } else {
        libm::pow(left, blunt)
    }
}

/// A grain of rice: flattened, with two slight grooves on each side, and with the notch where the germ was.
pub(super) fn rice() -> Shell {
    const RINGS: usize = 34;
    Shell::tube(RINGS, 24, |ring, angle| {
        let t = along(ring, RINGS);
        let (c, s) = turned(angle);
        let r = 0.405 * rounded(t, 2.5, 0.55);
        // The grooves lie on the flat sides, above and below the middle.
        let side = bell((c.abs() - 0.40) / 0.15) * step(0.97, 0.6, t.abs());
        let r = r * (1.0 - 0.085 * side);
        let mut p = DVec3::new(t, 1.08 * r * c - 0.05 * t * t, 0.86 * r * s);
        // The germ has left an oblique notch below the tip.
        let off = DVec3::new(0.80, -0.34, 0.0);
        let near = bell((p - off).length() / 0.24);
        p += DVec3::new(-0.15, 0.25, 0.0) * near;
        let mark = Mark::of(Part::Tip).shared(1.4 * near);
        (p, mark.shaded(0.35 * step(0.6, 1.0, t.abs()) - 0.6 * side))
    })
}

/// A tube along an arc in the plane of x and y: at `t` from -1 to 1 the arc has turned by `t * half`.
struct Arc {
    half: f64,
    length: f64,
}

impl Arc {
    /// The place and the outward direction of the arc.
    fn at(&self, t: f64) -> (DVec3, DVec3) {
        let radius = self.length / self.half;
        let (c, s) = turned(t * self.half);
        let out = DVec3::new(s, c, 0.0);
        (radius * (out - DVec3::Y), out)
    }
}

/// A kidney bean: its inner side has a pale scar with a dark rim.
pub(super) fn bean() -> Shell {
    const RINGS: usize = 42;
    let arc = Arc {
        half: 0.72,
        length: 0.98,
    };
    Shell::tube(RINGS, 30, |ring, turn| {
        // Rings and columns are denser at the scar.
        let t = along(ring, RINGS);
        let t = t - 0.24 * libm::sin(PI * t);
        let angle = turn - 0.72 * libm::sin(turn);
        let (middle, out) = arc.at(t);
        let r = 0.43 * rounded(t, 2.8, 0.52) * (1.0 + 0.06 * t);
        let (c, s) = turned(angle);
        let place = middle - out * (r * c) + DVec3::Z * (0.84 * r * s);
        let (x, y) = (t / 0.17, libm::sin(0.5 * angle) / 0.15);
        let far = (x * x + y * y).sqrt();
        let p = place + out * (0.022 * step(1.25, 0.8, far) - 0.014 * bell((far - 1.35) / 0.3));
        (p, scar(far).shaded(0.25 * libm::sin(5.0 * t + 2.0 * c)))
    })
}

/// The mark of a scar at a distance from its middle, in half widths.
fn scar(far: f64) -> Mark {
    match far {
        ..1.0 => Mark::of(Part::Vein),
        ..1.7 => Mark::of(Part::Edge).shared(step(1.7, 1.2, far)),
        _ => Mark::BODY,
    }
}

/// A cashew: curled, thick at one end, with a seam along its back.
pub(super) fn cashew() -> Shell {
    const RINGS: usize = 36;
    let arc = Arc {
        half: 1.34,
        length: 1.16,
    };
    Shell::tube(RINGS, 28, |ring, angle| {
        let t = along(ring, RINGS);
        let (middle, out) = arc.at(t);
        let r = 0.385 * rounded(t, 2.7, 0.5) * (1.0 - 0.24 * t);
        let (c, s) = turned(angle);
        let seam = bell(s / 0.2) * step(0.95, 0.7, t.abs());
        // The seam runs along the back; the inner side is a little flat.
        let inner = if c < 0.0 { 0.90 } else { 1.0 };
        let r = r * (1.0 - if c > 0.0 { 0.075 * seam } else { 0.03 * seam });
        let p = middle + out * (inner * r * c) + DVec3::Z * (0.86 * r * s);
        let tips = step(0.72, 0.97, t.abs());
        let shade = 0.2 * libm::sin(4.0 * t + 1.0) * c - if c > 0.0 { 0.5 * seam } else { 0.0 };
        (p, Mark::of(Part::Tip).shared(tips).shaded(shade))
    })
}

/// An almond: a flat drop with fine furrows from its blunt end to its tip.
pub(super) fn almond() -> Shell {
    const RINGS: usize = 30;
    const AROUND: usize = 40;
    Shell::tube(RINGS, AROUND, |ring, angle| -> Spot {
        let t = along(ring, RINGS);
        let r = 0.56 * rounded(t, 2.1, 0.62) * (1.0 - 0.42 * t);
        let (c, s) = turned(angle);
        let furrow = libm::cos(10.0 * angle + libm::sin(3.0 * angle));
        let r = r * (1.0 + 0.022 * furrow * step(1.0, 0.75, t.abs()));
        let p = DVec3::new(t, 0.60 * r * c, r * s);
        let mark = Mark::of(Part::Tip).shared(step(0.86, 1.0, t));
        (p, mark.shaded(0.55 * furrow))
    })
}
