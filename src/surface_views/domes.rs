//! Bodies that lie on a surface: bubbles and bars.
//!
//! Their x runs along the body, and their y out of the surface. They reach a little below the surface, because it is
//! curved and the bodies are flat.

use crate::planar::unit_vector;
use crate::scene::Body;
use crate::solid::{Surface, normals};
use glam::{DVec2, Vec3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// The shape of a dome.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dome {
    /// Half the length and half the width.
    pub half: DVec2,
    /// The radius of the corners; `None` for an ellipse.
    pub round: Option<f64>,
    pub high: f64,
    /// The depth below the surface.
    pub deep: f64,
    /// The angle between the rim and the surface, in radians.
    pub rim: f64,
    /// The brightness of the rim, relative to the top.
    pub dark: f64,
}

/// At each level of detail: points around an ellipse; points of a corner and of a side; rings from the rim to the
/// top.
const DEGREES: [(u32, [u32; 2], u32); 4] = [
    (28, [5, 2], 6),
    (20, [3, 2], 4),
    (12, [2, 1], 3),
    (8, [1, 1], 2),
];

impl Dome {
    pub fn body(&self, material: u8) -> Body {
        Body::new(self.levels(), material)
    }

    pub fn levels(&self) -> Vec<Surface> {
        DEGREES.map(|degree| self.surface(degree)).to_vec()
    }

    fn surface(&self, (around, [corner, side], rings): (u32, [u32; 2], u32)) -> Surface {
        let outline = match self.round {
            None => ellipse(self.half, around),
            Some(round) => rounded(self.half, round, corner, side),
        };
        let count = outline.len() as u32;
        // Facets lie as far outside of the true shape as inside, so no level of detail shadows another.
        let halfway = |angle: f64| 0.5 + 0.5 / libm::cos(angle);
        let wider = halfway(FRAC_PI_2 * 2.0 / f64::from(count));
        let higher = halfway(0.5 * self.rim / f64::from(rings));
        let mut surface = Surface::default();
        let mut ring = |part: f64, high: f64, light: f64| {
            for &p in &outline {
                // Rings change from the outline at the rim to an ellipse at the top.
                let inner = (p / self.half).normalize_or_zero() * self.half;
                let p = (inner * wider).lerp(p, part * part) * part;
                let at = Vec3::new(p.x as f32, high as f32, -p.y as f32);
                surface.positions.push(at);
                surface.colours.push([(255.0 * light + 0.5) as u8; 3]);
            }
        };
        ring(0.97, -self.deep, self.dark);
        let lifted = |k: u32| {
            let angle = self.rim * (1.0 - f64::from(k) / f64::from(rings));
            let part = libm::sin(angle) / libm::sin(self.rim);
            let high = (libm::cos(angle) - libm::cos(self.rim)) / (1.0 - libm::cos(self.rim));
            (part, self.high * high * if k == 0 { 1.0 } else { higher })
        };
        for k in 0..rings {
            let (part, high) = lifted(k);
            let light = if k == 0 && rings > 2 { self.dark } else { 1.0 };
            ring(part, high, light);
        }
        let top = self.high * higher;
        surface.positions.push(Vec3::new(0.0, top as f32, 0.0));
        surface.colours.push([255; 3]);
        for ring in 0..rings {
            for k in 0..count {
                let [a, b] = [k, (k + 1) % count].map(|k| ring * count + k);
                surface
                    .triangles
                    .extend([[a, b, b + count], [a, b + count, a + count]]);
            }
        }
        let top = (rings + 1) * count;
        let last = rings * count;
        let fan = (0..count).map(|k| [last + k, last + (k + 1) % count, top]);
        surface.triangles.extend(fan);
        surface.normals = normals(&surface.positions, &surface.triangles);
        surface
    }
}

fn ellipse(half: DVec2, count: u32) -> Vec<DVec2> {
    let at = |k: u32| {
        let turn = TAU * f64::from(k) / f64::from(count);
        half * unit_vector(turn)
    };
    (0..count).map(at).collect()
}

/// A rectangle with round corners. `corner` and `side` are the numbers of points of each corner and side.
fn rounded(half: DVec2, round: f64, corner: u32, side: u32) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = Vec::new();
    let arc = |quarter: u32, k: u32| {
        let signs = [
            DVec2::ONE,
            DVec2::new(-1.0, 1.0),
            -DVec2::ONE,
            DVec2::new(1.0, -1.0),
        ];
        let part = match corner {
            1 => 0.5,
            _ => f64::from(k) / f64::from(corner - 1),
        };
        let turn = FRAC_PI_2 * (f64::from(quarter) + part);
        let middle = signs[quarter as usize % 4] * (half - round);
        middle + round * unit_vector(turn)
    };
    for quarter in 0..4 {
        points.extend((0..corner).map(|k| arc(quarter, k)));
        let (from, to) = (arc(quarter, corner - 1), arc((quarter + 1) % 4, 0));
        let part = |k: u32| f64::from(k + 1) / f64::from(side + 1);
        points.extend((0..side).map(|k| from.lerp(to, part(k))));
    }
    points
}

/// A ball about the origin.
pub(super) fn ball(radius: f64, material: u8) -> Body {
    let level = |[around, rows]: [u32; 2]| {
        let mut surface = Surface::default();
        surface.positions.push(Vec3::Y);
        for row in 1..rows {
            let down = FRAC_PI_2 * 2.0 * f64::from(row) / f64::from(rows);
            for k in 0..around {
                let turn = TAU * f64::from(k) / f64::from(around);
                let (flat, high) = (libm::sin(down), libm::cos(down));
                let (x, z) = (libm::cos(turn) * flat, -libm::sin(turn) * flat);
                surface
                    .positions
                    .push(Vec3::new(x as f32, high as f32, z as f32));
            }
        }
        surface.positions.push(Vec3::NEG_Y);
        let last = surface.positions.len() as u32 - 1;
        let at = |row: u32, k: u32| match row {
            0 => 0,
            row if row == rows => last,
            row => 1 + (row - 1) * around + k % around,
        };
        for row in 0..rows {
            for k in 0..around {
                let [a, b] = [k, k + 1].map(|k| at(row, k));
                let [c, d] = [k + 1, k].map(|k| at(row + 1, k));
                surface.triangles.extend([[a, d, c], [a, c, b]]);
            }
        }
        surface
            .triangles
            .retain(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
        surface.normals = surface.positions.clone();
        surface
            .positions
            .iter_mut()
            .for_each(|p| *p *= radius as f32);
        surface.colours = vec![[255; 3]; surface.positions.len()];
        surface
    };
    Body::new([[26, 14], [16, 9], [10, 6]].map(level).to_vec(), material)
}
