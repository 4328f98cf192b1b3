//! A leaf: a thin sheet with a serrated outline, a midrib, side veins and a stalk, slightly curled.

use super::shell::{Shell, Spot, bell, step, turned};
use super::{Mark, Part};
use glam::DVec3;

/// Side veins on each half of the blade.
const VEINS: usize = 9;
/// Places across half of the blade, from the midrib to the rim.
const ACROSS: [f64; 8] = [0.0, 0.045, 0.10, 0.26, 0.44, 0.62, 0.81, 1.0];
const COARSE: [f64; 3] = [0.0, 0.45, 1.0];
const COARSEST: [f64; 2] = [0.0, 1.0];
/// The blade begins at this x; its tip is at 1.
const BASE: f64 = -0.72;
/// The end of the stalk.
const END: f64 = -1.12;
/// How far side veins run forward on their way to the rim.
const FORWARD: f64 = 0.30;

/// The rows of a leaf at a level of detail: where each meets the midrib, as a share of the blade, and how close it is to
/// a side vein, 0 to 1.
fn rows(level: usize) -> Vec<(f64, f64)> {
    let mut rows = vec![(-0.24, 0.0), (-0.12, 0.0)];
    let steps: &[(f64, f64)] = match level {
        0 => &[(0.0, 1.0), (0.16, 0.0), (0.5, 0.0), (0.9, 0.0)],
        _ => &[(0.0, 0.0)],
    };
    let skip = [1, 1, 2][level];
    for vein in (0..=VEINS).step_by(skip) {
        for &(off, near) in steps {
            let at = (vein as f64 + off) / (VEINS as f64 + 1.0);
            rows.push((at, if vein == 0 { 0.0 } else { near }));
        }
    }
    rows.push((1.0, 0.0));
    rows
}

/// Half the width of the blade at a share of its length.
fn width(u: f64) -> f64 {
    let u = u.clamp(0.0, 1.0);
    let round = libm::pow(u, 0.62) * libm::pow(1.0 - u, 0.85);
    1.22 * round * (1.0 - 0.16 * u)
}

/// The leaf at a level of detail: 0 is the finest, 2 the coarsest.
pub(super) fn leaf(level: usize) -> Shell {
    let across: &[f64] = [&ACROSS[..], &COARSE, &COARSEST][level];
    let rows = rows(level);
    let half = across.len() - 1;
    Shell::sheet(rows.len(), 2 * half + 1, |side, r, c| {
        let (hand, k) = match c < half {
            true => (-1.0, half - c),
            false => (1.0, c - half),
        };
        let is_rim = r == 0 || r == rows.len() - 1 || k == half;
        spot(
            rows[r],
            hand * across[k],
            if is_rim { 0.0 } else { side },
            level,
        )
    })
}

/// A vertex: `u` along the midrib, `v` across from -1 to 1, on the upper side (1), the lower one (-1) or the rim (0).
fn spot((u, near): (f64, f64), v: f64, side: f64, level: usize) -> Spot {
    let far = v.abs();
    let is_stalk = u < 0.0;
    // Rows are bent forward; all of them end within the blade.
    let along = u + FORWARD * far * u * (1.0 - u) * 1.6;
    let tooth = match level {
        0 => step(0.7, 1.0, far) * (near - 0.35) * step(0.0, 0.1, u) * step(1.0, 0.93, u),
        _ => 0.0,
    };
    let stalk = 0.034 + 0.012 * step(-0.12, -0.24, u);
    let half = if is_stalk {
        stalk
    } else {
        width(along).max(stalk * (1.0 - u)).max(0.012)
    };
    let x = match is_stalk {
        true => BASE + (u / 0.24) * (BASE - END),
        false => BASE + (along + 0.012 * tooth) * (1.0 - BASE),
    };
    let z = v * half + 0.045 * tooth * v.signum();
    // The midrib is a ridge below and a furrow above; so are the side veins, less.
    let rib = bell(z / 0.045) * step(1.0, 0.75, u);
    let vein = if is_stalk {
        0.0
    } else {
        near * step(1.0, 0.88, far)
    };
    let thick = 0.036 + 0.032 * rib + 0.006 * vein;
    let puff = 0.018
        * (1.0 - near)
        * libm::sin(3.0 * far.min(1.0))
        * step(0.0, 0.1, u)
        * step(1.0, 0.9, u);
    let furrow = 0.012 * rib + 0.010 * vein;
    let y = if side > 0.0 { thick - furrow } else { -thick } * side.abs() + puff;
    let mark = if is_stalk {
        Mark::of(Part::Stalk)
    } else if rib > 0.3 || vein > 0.5 {
        Mark::of(Part::Vein).shared(rib.max(0.8 * vein))
    } else {
        Mark::BODY
    };
    let shade = 0.6 * step(0.75, 1.0, far) + 0.3 * step(0.85, 1.0, u) - 0.2 * rib;
    (curled(DVec3::new(x, y, z)), mark.shaded(shade))
}

/// Curls a flat leaf: it sags along its length, and its halves rise from the midrib.
fn curled(p: DVec3) -> DVec3 {
    let (c, s) = turned(0.42 * p.x);
    let lift = 0.24 * p.z.abs() + 0.05 * libm::sin(5.5 * p.x + 1.3 * p.z.signum()) * p.z.abs();
    let radius = 1.0 / 0.42;
    let y = p.y + lift;
    DVec3::new(
        (radius + y) * s,
        (radius + y) * c - radius,
        p.z * (1.0 - 0.10 * p.z.abs()),
    )
}
