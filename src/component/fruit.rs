//! Round fruit and nuts: orange, apple, chestnut and walnut. Each turns about y.

use super::shell::{Shell, bell, curve, step, turned};
use super::{Mark, Part};
use glam::DVec3;

/// A knot of a profile: distance from the axis, height.
type Knot = [f64; 2];

/// The place on a profile at an angle.
fn about([r, y]: Knot, angle: f64) -> DVec3 {
    let (c, s) = turned(angle);
    DVec3::new(r.max(0.0) * c, y, r.max(0.0) * s)
}

/// The profile of a chestnut's base.
const CHESTNUT_CAP: [Knot; 4] = [[0.0, -0.60], [0.26, -0.612], [0.47, -0.60], [0.64, -0.545]];
/// The profiles of a chestnut's body and of its tip.
const CHESTNUT: [Knot; 9] = [
    [0.655, -0.525],
    [0.84, -0.42],
    [0.985, -0.16],
    [0.985, 0.12],
    [0.84, 0.40],
    [0.56, 0.60],
    [0.28, 0.71],
    [0.13, 0.775],
    [0.085, 0.83],
];
const CHESTNUT_TIP: [Knot; 4] = [[0.075, 0.86], [0.07, 0.94], [0.10, 1.02], [0.0, 1.05]];

/// A chestnut: flat on one side, with a dull base, and with a tuft at its tip.
pub(super) fn chestnut() -> Shell {
    const CAP: usize = 6;
    const BODY: usize = 18;
    let rings = CAP + BODY + CHESTNUT_TIP.len();
    Shell::tube(rings, 36, |ring, angle| {
        let wave = 1.0 + 0.05 * libm::sin(3.0 * angle + 0.6) + 0.022 * libm::sin(8.0 * angle);
        let (knot, mark) = if ring < CAP {
            let at = ring as f64 / (CAP - 1) as f64;
            let [r, y] = curve(&CHESTNUT_CAP, 3.0 * at);
            let grain = libm::sin(9.0 * angle + 5.0 * at) * libm::sin(7.0 * at + 2.0 * angle);
            let rough = 0.003 * grain * at * (1.0 - at);
            let mark = Mark::of(Part::Cap).shaded(0.22 * grain - 0.25 * at * at);
            ([r * (1.0 + at * (wave - 1.0)), y - 4.0 * rough], mark)
        } else if ring < CAP + BODY {
            let at = (ring - CAP) as f64 / (BODY - 1) as f64;
            let [r, y] = curve(&CHESTNUT, 8.0 * at);
            let streak = libm::sin(17.0 * angle + 2.0 * libm::sin(3.0 * angle));
            let fade = bell((at - 0.5) / 0.42);
            let pale = step(0.80, 0.97, at);
            let mark = Mark::of(Part::Tip).shared(0.8 * pale);
            let shade = 0.35 * streak * fade - 0.45 * step(0.25, 0.0, at);
            let blend = 1.0 + (wave - 1.0) * step(0.35, 0.0, at);
            ([r * blend, y], mark.shaded(shade))
        } else {
            let k = ring - CAP - BODY;
            let tuft = 1.0
                + if k == 2 {
                    0.3 * libm::sin(6.0 * angle)
                } else {
                    0.0
                };
            let [r, y] = CHESTNUT_TIP[k];
            ([r * tuft, y], Mark::of(Part::Tip))
        };
        let mut p = about(knot, angle);
        // Neighbours in the burr have pressed one side flat.
        p.z *= if p.z > 0.0 { 0.84 } else { 0.60 };
        p.y -= 0.05 * p.x * p.x * step(-0.4, 0.3, p.y);
        (p, mark)
    })
}

const ORANGE: [Knot; 15] = [
    [0.0, -0.915],
    [0.06, -0.925],
    [0.14, -0.93],
    [0.42, -0.86],
    [0.74, -0.63],
    [0.94, -0.27],
    [0.985, 0.08],
    [0.92, 0.42],
    [0.70, 0.71],
    [0.42, 0.865],
    [0.24, 0.90],
    [0.165, 0.872],
    [0.125, 0.858],
    [0.095, 0.885],
    [0.0, 0.905],
];

/// An orange: its stalk end is dimpled, and has a green button.
pub(super) fn orange() -> Shell {
    const AROUND: usize = 40;
    const RINGS: usize = 29;
    Shell::tube(RINGS, AROUND, |ring, angle| {
        let at = 0.5 * ring as f64;
        let [r, y] = curve(&ORANGE, at);
        let top = step(7.5, 10.0, at) * step(12.0, 10.5, at);
        let ribs = 1.0 + 0.03 * top * libm::cos(10.0 * angle);
        let star = 1.0 + step(11.6, 12.2, at) * 0.12 * libm::cos(5.0 * angle);
        let part = if at > 11.6 { Part::Stalk } else { Part::Tip };
        let share = if at > 11.6 {
            1.0
        } else {
            step(9.0, 11.5, at).max(step(1.6, 0.2, at))
        };
        let pores = libm::sin(13.0 * angle + 7.0 * at) * libm::sin(9.0 * at - 5.0 * angle);
        (
            about([r * ribs * star, y], angle),
            Mark::of(part).shared(share).shaded(0.25 * pores),
        )
    })
}

const APPLE: [Knot; 18] = [
    [0.0, -0.70],
    [0.05, -0.72],
    [0.12, -0.76],
    [0.27, -0.865],
    [0.46, -0.84],
    [0.72, -0.60],
    [0.92, -0.20],
    [0.985, 0.18],
    [0.90, 0.54],
    [0.66, 0.775],
    [0.42, 0.80],
    [0.22, 0.685],
    [0.09, 0.53],
    [0.05, 0.53],
    [0.045, 0.70],
    [0.045, 0.88],
    [0.07, 1.02],
    [0.0, 1.04],
];

/// An apple: five soft lobes below, and a stalk in its hollow.
pub(super) fn apple() -> Shell {
    const RINGS: usize = 35;
    Shell::tube(RINGS, 36, |ring, angle| {
        let at = 0.5 * ring as f64;
        let [r, y] = curve(&APPLE, at);
        let low = step(6.5, 3.0, at) * step(0.4, 1.5, at);
        let lobes = libm::cos(5.0 * angle);
        let p = about(
            [r * (1.0 + 0.035 * low * lobes), y - 0.05 * low * lobes],
            angle,
        );
        // The stalk leans.
        let lean = 0.16 * step(13.0, 17.0, at);
        let mark = match at {
            12.6.. => Mark::of(Part::Stalk),
            9.0.. => Mark::of(Part::Tip).shared(step(9.5, 12.0, at)),
            ..1.3 => Mark::of(Part::Stalk).shared(0.8),
            _ => Mark::of(Part::Tip).shared(0.55 * step(5.0, 2.5, at)),
        };
        let streak = libm::sin(11.0 * angle + 3.0 * libm::sin(2.0 * angle)) * step(0.0, 4.0, at);
        (p + lean * DVec3::X, mark.shaded(0.4 * streak))
    })
}

/// A walnut in its shell: wrinkled, with a seam all around and a small point.
pub(super) fn walnut() -> Shell {
    Shell::ball(12, |n| {
        let wave = |a: DVec3, b: f64| libm::sin(n.dot(a) + b);
        // Furrows with sharp bottoms run from the tip to the base and branch.
        let bent = wave(DVec3::new(2.0, 3.0, 5.0), 0.4);
        let first = wave(DVec3::new(8.0, 1.5, 2.0), 1.6 * bent).abs();
        let second = wave(DVec3::new(-3.0, 4.5, 7.0), 1.4 * bent + 1.0).abs();
        let seam = bell(n.z / 0.10);
        let wrinkle = (first + 0.7 * second - 1.0) * step(0.08, 0.3, n.z.abs());
        let tip = bell((1.0 - n.y) / 0.05);
        let base = bell((1.0 + n.y) / 0.06);
        let r = 0.88 + 0.045 * wrinkle + 0.085 * seam + 0.13 * tip - 0.06 * base;
        let p = n * r * DVec3::new(0.92, 1.06, 0.92);
        let mark = Mark::of(Part::Edge).shared(seam);
        (p, mark.shaded(wrinkle))
    })
}
