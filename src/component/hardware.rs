//! Hexagonal nuts and bolts with threads, and gears. Each turns about y.

use super::shell::{Shell, turned};
use super::{Mark, Part};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_3, FRAC_PI_6, TAU};

/// The slope of the chamfer of hexagons: the tangent of 30 degrees.
const CHAMFER: f64 = 0.577_350_269_189_625_8;

/// A point of a profile: the distance from the axis, the height, and the mark.
type Ring = (f64, f64, Mark);

fn about((r, y, mark): Ring, angle: f64) -> (DVec3, Mark) {
    let (c, s) = turned(angle);
    (DVec3::new(r * c, y, r * s), mark)
}

/// The distance from the axis to the side of a hexagon with this radius.
fn hexagon(radius: f64, angle: f64) -> f64 {
    let off = (angle + FRAC_PI_6).rem_euclid(FRAC_PI_3) - FRAC_PI_6;
    // A corner is at 0; the middle of a side is 30 degrees from it.
    radius * libm::cos(FRAC_PI_6) / libm::cos(FRAC_PI_6 - off.abs())
}

/// The upper end of a hexagonal prism whose corners a cone has cut off. The cone meets the end in a circle; `k` is 0
/// for that circle, and 1 for the curve where the cone meets the sides.
fn hex_end(k: usize, [radius, top]: [f64; 2], angle: f64) -> Ring {
    let circle = 0.955 * radius * libm::cos(FRAC_PI_6);
    let side = hexagon(radius, angle);
    match k {
        0 => (circle, top, Mark::of(Part::Edge)),
        _ => (
            side,
            top - (side - circle) * CHAMFER,
            Mark::of(Part::Edge).shared(0.5),
        ),
    }
}

/// A right-handed thread at a height and an angle: 1 on the crest, 0 in the groove.
fn thread(height: f64, pitch: f64, angle: f64) -> f64 {
    0.5 + 0.5 * libm::cos(TAU * height / pitch + angle)
}

/// A hexagonal nut: chamfered at both ends, with a threaded bore.
pub(super) fn nut(is_fine: bool) -> Shell {
    const HEX: [f64; 2] = [1.0, 0.42];
    const BORE: f64 = 0.5;
    // The rings run up the outside, over the top, and down the bore.
    let inner = if is_fine { 19 } else { 2 };
    let around = if is_fine { 48 } else { 24 };
    let rings = 4 + 2 + inner + 2;
    Shell::ring(rings, around, |ring, angle| {
        let top = HEX[1];
        let place = match ring {
            0 | 1 => {
                let (r, y, mark) = hex_end(ring, HEX, angle);
                (r, -y, mark)
            }
            2 | 3 => hex_end(3 - ring, HEX, angle),
            4 => (BORE + 0.075, top, Mark::of(Part::Edge)),
            5 => (BORE + 0.01, top - 0.06, Mark::of(Part::Edge)),
            k if k < 6 + inner => {
                let share = (k - 6) as f64 / (inner - 1) as f64;
                let y = (top - 0.085) * (1.0 - 2.0 * share);
                let crest = if is_fine { thread(y, 0.19, angle) } else { 0.5 };
                let mark = Mark::of(Part::Thread).shaded(1.4 * crest - 0.9);
                (BORE - 0.055 * crest, y, mark)
            }
            k if k == 6 + inner => (BORE + 0.01, 0.06 - top, Mark::of(Part::Edge)),
            _ => (BORE + 0.075, -top, Mark::of(Part::Edge)),
        };
        about(place, angle)
    })
}

/// A bolt with a hexagonal head: a washer face below it, a shank, a thread, and a chamfered end.
pub(super) fn bolt(is_fine: bool) -> Shell {
    const HEX: [f64; 2] = [0.60, 1.0];
    const FOOT: f64 = 0.60;
    const SHANK: f64 = 0.285;
    const DEEP: f64 = 0.05;
    const END: f64 = -1.0;
    /// The upper end of the thread.
    const TOP: f64 = 0.16;
    let turns = if is_fine { 36 } else { 4 };
    let around = if is_fine { 30 } else { 12 };
    let rings = 8 + turns + 4;
    Shell::tube(rings, around, |ring, angle| {
        let [radius, top] = HEX;
        let edge = Mark::of(Part::Edge);
        let place = match ring {
            0 => (0.0, top + 0.02, Mark::BODY),
            1 => (0.30, top + 0.02, Mark::BODY),
            2 | 3 => hex_end(ring - 2, HEX, angle),
            4 => (hexagon(radius, angle), FOOT + 0.03, Mark::BODY),
            5 => (0.475, FOOT + 0.03, edge),
            6 => (0.47, FOOT, edge),
            7 => (SHANK + 0.02, FOOT, Mark::BODY.shaded(-0.5)),
            8 => (SHANK, FOOT - 0.03, Mark::BODY),
            k if k < 8 + turns && is_fine => {
                let y = TOP + (k - 9) as f64 / (turns - 2) as f64 * (END + 0.10 - TOP);
                let fade = (0.5 * (k - 9) as f64).min(1.0);
                let crest = thread(y, 0.172, angle);
                let mark = Mark::of(Part::Thread)
                    .shared(fade)
                    .shaded((1.4 * crest - 0.9) * fade);
                (SHANK - DEEP * fade * (1.0 - crest), y, mark)
            }
            9 => (SHANK, TOP, Mark::BODY),
            // From afar a thread is only darker.
            k if k < 8 + turns => {
                let y = if k == 10 { TOP - 0.04 } else { END + 0.10 };
                (SHANK - 0.5 * DEEP, y, Mark::of(Part::Thread).shaded(-0.35))
            }
            k if k == 8 + turns => (SHANK - DEEP, END + 0.07, edge),
            k if k == 9 + turns => (SHANK - DEEP - 0.06, END, edge),
            k if k == 10 + turns => (0.10, END, Mark::BODY),
            _ => (0.0, END, Mark::BODY),
        };
        about(place, angle)
    })
}

/// A gear with twelve teeth, a hub and a bore.
pub(super) fn gear() -> Shell {
    const TEETH: f64 = 12.0;
    const RINGS: usize = 14;
    const AROUND: usize = 96;
    let edge = Mark::of(Part::Edge);
    Shell::ring(RINGS, AROUND, |ring, angle| {
        // A tooth has eight columns of vertices: two on the crest, two in the groove, and two on each flank.
        let at = (angle * TEETH / TAU).rem_euclid(1.0) * 8.0;
        let high = ((at - 4.0).abs() - 1.0).clamp(0.0, 2.0) / 2.0;
        let rim = 0.80 + 0.2 * (1.0 - high);
        let half = [0.20, 0.30];
        let upper = |k: usize| match k {
            0 => (rim, half[0] - 0.035, edge),
            1 => (rim - 0.035, half[0], edge),
            2 => (0.66, half[0], Mark::BODY),
            3 => (0.60, half[0] - 0.06, Mark::BODY.shaded(-0.3)),
            4 => (0.40, half[0] - 0.06, Mark::BODY.shaded(-0.3)),
            5 => (0.36, half[1], edge),
            // The bore joins both hubs.
            _ => (0.20, half[1], edge),
        };
        let place = match ring {
            0..=6 => upper(ring),
            k => {
                let (r, y, mark) = upper(13 - k);
                (r, -y, mark)
            }
        };
        about(place, angle)
    })
}
