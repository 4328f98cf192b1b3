//! A leaf: a thin sheet with a serrated outline, a midrib, side veins and a stalk, slightly curled.

use super::shell::{Shell, Spot, bell, step, turned};
use super::{Mark, Part};
use crate::order::greater;
use glam::DVec3;

/// Side veins on each half of the blade.
const VEINS: usize = 8;
/// Places of vertices across half of the blade, by level of detail: 0 is the midrib, 1 the rim.
const ACROSS: [f64; 8] = [0.0, 0.045, 0.10, 0.26, 0.44, 0.62, 0.81, 1.0];
const COARSE: [f64; 3] = [0.0, 0.45, 1.0];
const COARSEST: [f64; 2] = [0.0, 1.0];
/// The blade begins at this x; its tip is at 1.
const BASE: f64 = -0.72;
/// The end of the stalk.
const END: f64 = -1.12;
/// How far side veins run forward on their way to the rim.
const FORWARD: f64 = 0.30;
/// The share of a vein's colour in coarse leaves.
const PALER: f64 = 0.35;

/// How far the teeth stand out at a place between two side veins, 0 at one and 1 at the next. There is a large tooth at
/// each vein, and a small one between two.
fn tooth(off: f64) -> f64 {
    match off {
        ..0.05 => 1.0,
        ..0.5 => (off - 0.13) * 1.2,
        ..0.56 => 0.6,
        _ => (off - 0.62) * 2.4,
    }
}

/// The rows of a leaf at a level of detail: where each meets the midrib, as a share of the blade, how close it is to a
/// side vein, 0 to 1, and how far its tooth stands out.
fn rows(level: usize) -> Vec<[f64; 3]> {
    let mut rows = vec![[-0.24, 0.0, 0.0], [-0.12, 0.0, 0.0]];
    let steps: &[(f64, f64)] = match level {
        0 => &[
            (0.0, 1.0),
            (0.13, 0.0),
            (0.5, 0.0),
            (0.62, 0.0),
            (0.89, 0.0),
        ],
        _ => &[(0.0, 0.0)],
    };
    let skip = [1, 1, 2][level];
    for vein in (0..=VEINS).step_by(skip) {
        for &(off, near) in steps {
            let at = (vein as f64 + off) / (VEINS as f64 + 1.0);
            let near = if vein == 0 { 0.0 } else { near };
            rows.push([at, near, if level == 0 { tooth(off) } else { 0.0 }]);
        }
    }
    rows.push([1.0, 0.0, 0.0]);
    rows
}

/// Half the width of the blade at a share of its length.
fn width(u: f64) -> f64 {
    let u = u.clamp(0.0, 1.0);
    let round = libm::pow(u, 0.64) * (1.0 - u);
    1.36 * round * (1.0 - 0.10 * u)
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
        let (at, mark) = spot(rows[r], hand * across[k], if is_rim { 0.0 } else { side });
        // Veins of a coarse leaf would be too broad.
        let is_pale = level > 0 && mark.part == Part::Vein;
        let share = f64::from(mark.share) * if is_pale { PALER } else { 1.0 };
        (at, mark.shared(share))
    })
}

/// A vertex: `u` along the midrib, `v` across from -1 to 1, on the upper side (1), the lower one (-1) or the rim (0).
fn spot([u, near, tooth]: [f64; 3], v: f64, side: f64) -> Spot {
    let far = v.abs();
    let is_stalk = u < 0.0;
    // Rows are bent forward; all of them end within the blade.
    let along = u + FORWARD * far * u * (1.0 - u) * 1.6;
    let tooth = tooth * step(0.75, 1.0, far) * step(0.0, 0.1, u) * step(1.0, 0.93, u);
    let stalk = 0.027 + 0.014 * step(-0.15, -0.24, u);
    let half = if is_stalk {
        stalk
    } else {
        width(along).max(stalk * (1.0 - u)).max(0.012)
    };
    let x = match is_stalk {
        true => BASE + (u / 0.24) * (BASE - END),
        false => BASE + (along + 0.016 * tooth) * (1.0 - BASE),
    };
    let z = v * half + 0.05 * tooth * v.signum();
    // The midrib is a ridge below and a furrow above. The side veins are alike, but flatter.
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
        Mark::of(Part::Vein).shared(greater(rib * rib, 0.75 * vein * step(1.2, 0.2, far)))
    } else {
        Mark::BODY
    };
    let cell = 0.35 * (1.0 - near) * step(0.0, 0.3, far);
    let shade = cell - 0.9 * step(0.7, 1.0, far) - 0.4 * step(0.85, 1.0, u);
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
