//! Grains and kernels: rice, beans, cashews and almonds. Each is a tube along an arc.

use super::shell::{Shell, Spot, bell, step, turned};
use super::{Mark, Part};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// The place of a ring along a tube, -1 to 1; rings are denser towards the ends.
fn along(ring: usize, rings: usize) -> f64 {
    -libm::cos(PI * ring as f64 / (rings - 1) as f64)
}

/// The radius of a rounded tube at `t`, -1 to 1, relative to its middle: 0 at the ends. A high `full` keeps the tube
/// thick for longer, and a low `blunt` makes its ends blunter.
fn rounded(t: f64, full: f64, blunt: f64) -> f64 {
    let left = 1.0 - libm::pow(t.abs(), full);
    if left <= 0.0 {
        0.0
    } else {
        libm::pow(left, blunt)
    }
}

/// A grain of rice: flattened, with two grooves on each side, and with the notch where the germ was.
pub(super) fn rice() -> Shell {
    const RINGS: usize = 34;
    Shell::tube(RINGS, 32, |ring, angle| {
        let t = along(ring, RINGS);
        let (c, s) = turned(angle);
        let r = 0.42 * rounded(t, 2.4, 0.5);
        // The grooves lie on the flat sides, above and below the middle; another one is on the back.
        let flat = bell((c.abs() - 0.42) / 0.18);
        let back = 0.7 * bell(s / 0.22) * step(0.0, 0.5, c);
        let groove = (flat + back) * step(0.97, 0.6, t.abs());
        let r = r * (1.0 - 0.05 * groove);
        let mut p = DVec3::new(t, 1.05 * r * c - 0.06 * t * t, 0.88 * r * s);
        // The germ has left an oblique notch below the tip.
        let off = DVec3::new(0.80, -0.32, 0.0);
        let near = bell((p - off).length() / 0.25);
        p += DVec3::new(-0.17, 0.26, 0.0) * near;
        let mark = Mark::of(Part::Tip).shared(0.9 * near);
        (
            p,
            mark.shaded(0.3 - 0.5 * groove - 0.2 * step(0.75, 1.0, t.abs())),
        )
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
        half: 0.94,
        length: 0.99,
    };
    Shell::tube(RINGS, 30, |ring, turn| {
        // Rings and columns are denser at the scar.
        let t = along(ring, RINGS);
        let t = t - 0.24 * libm::sin(PI * t);
        let angle = turn - 0.72 * libm::sin(turn);
        let (t, angle, far) = rounded_about_scar(t, angle);
        let (middle, out) = arc.at(t);
        let r = 0.43 * rounded(t, 2.8, 0.52) * (1.0 + 0.07 * t);
        let (c, s) = turned(angle);
        let place = middle - out * (r * c) + DVec3::Z * (0.76 * r * s);
        let p = place + out * (0.020 * step(1.25, 0.7, far) - 0.014 * bell((far - 1.4) / 0.35));
        (p, scar(far).shaded(0.25 * libm::sin(5.0 * t + 2.0 * c)))
    })
}

/// Half the length of a bean's scar in `t`, and half its width as the sine of half the angle. A ring and a column of
/// vertices lie on its border.
const SCAR: [f64; 2] = [0.243, 0.1024];

/// Moves a place on a bean so that the rings and columns around its scar become ellipses. Also gives the distance from
/// the middle of the scar, 1 on its border.
fn rounded_about_scar(t: f64, angle: f64) -> (f64, f64, f64) {
    // The scar is at the angle 0.
    let angle = if angle > PI { angle - TAU } else { angle };
    let (x, y) = (t / SCAR[0], libm::sin(0.5 * angle) / SCAR[1]);
    let far = x.abs().max(y.abs());
    if far <= 0.0 {
        return (t, angle, 0.0);
    }
    let circle = far / (x * x + y * y).sqrt();
    let near = step(3.0, 1.2, far);
    let scale = 1.0 + (circle - 1.0) * near;
    let turned = match near > 0.0 {
        true => 2.0 * libm::asin(scale * y * SCAR[1]),
        false => angle,
    };
    (scale * t, turned, far)
}

/// The mark of a scar at a distance from its middle, 1 on its border.
fn scar(far: f64) -> Mark {
    match far {
        ..0.9 => Mark::of(Part::Vein),
        ..1.7 => Mark::of(Part::Edge).shared(step(1.7, 1.0, far)),
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

/// An almond: a flat drop with uneven furrows from its blunt end to its tip.
pub(super) fn almond() -> Shell {
    const RINGS: usize = 30;
    const AROUND: usize = 48;
    Shell::tube(RINGS, AROUND, |ring, angle| -> Spot {
        let t = along(ring, RINGS);
        let r = 0.57 * rounded(t, 2.1, 0.64) * (1.0 - 0.42 * t);
        let (c, s) = turned(angle);
        // Furrows are uneven: they wind a little, and fade and begin anew.
        let wind = 0.9 * libm::sin(3.0 * angle + 1.3 * t) + 0.5 * libm::sin(2.0 * t + 2.0 * angle);
        let first = libm::cos(11.0 * angle + wind);
        let second = libm::cos(17.0 * angle - 1.5 * wind + 1.0);
        let fade = 0.6 + 0.4 * libm::sin(3.5 * t + 4.0 * angle);
        let furrow = (fade * first + 0.6 * (1.0 - fade) * second) * step(1.0, 0.75, t.abs());
        let r = r * (1.0 + 0.022 * furrow);
        let p = DVec3::new(t, 0.56 * r * c, r * s);
        let mark = Mark::of(Part::Tip).shared(0.9 * step(0.84, 1.0, t) + 0.5 * step(-0.9, -1.0, t));
        (p, mark.shaded(0.7 * first * fade + 0.35 * second))
    })
}
