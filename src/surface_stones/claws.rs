//! Claws and horny tips: bare bodies that grow out of the scales at the ends of a leg or a tail.

use crate::material::{FINISHES, Palette};
use crate::order::lesser;
use crate::solid::{Surface, normals};
use glam::{DVec3, Vec3};
use std::f64::consts::TAU;

/// A claw: the hull of balls along a curve, from its root to its point.
#[derive(Clone, Debug, PartialEq)]
pub struct Claw {
    /// The middles of the balls, in the model's units; at least two.
    pub points: Vec<DVec3>,
    /// Their radii, in the model's units.
    pub radii: Vec<f64>,
}

/// The row of the smoothest finish of a palette, which claws have.
pub(super) const HORN_ROW: u8 = FINISHES as u8;
/// Corners around a claw.
const AROUND: u32 = 14;
/// The ratio of a claw's width to its height.
const NARROW: f64 = 0.8;
/// The share of the belly's colour at the root of a claw; it falls to 0 at the point.
const PALE: f32 = 0.3;

impl Claw {
    /// The claw's surface, in the model's axes and units; triangles run counter-clockwise seen from outside.
    pub(super) fn surface(&self, palette: &Palette) -> Surface {
        let mut surface = Surface::default();
        let last = self.points.len().saturating_sub(1);
        for (k, (&p, &radius)) in self.points.iter().zip(&self.radii).enumerate() {
            let along = self.points[(k + 1).min(last)] - self.points[k.saturating_sub(1)];
            let side = along.cross(DVec3::Y).try_normalize().unwrap_or(DVec3::X);
            let up = side.cross(along).normalize_or(DVec3::Y);
            let share = PALE * (1.0 - k as f32 / last.max(1) as f32);
            let colour = mixed(palette, share);
            for corner in 0..AROUND {
                let angle = TAU * f64::from(corner) / f64::from(AROUND);
                let out = side * (NARROW * libm::cos(angle)) + up * libm::sin(angle);
                surface.positions.push((p + out * radius).as_vec3());
                surface.colours.push(colour);
            }
            if k > 0 {
                let first = AROUND * (k as u32 - 1);
                surface.triangles.extend(belt(first));
            }
        }
        // The root is inside the body, so only the point is closed.
        let (Some(&point), Some(&radius)) = (self.points.last(), self.radii.last()) else {
            return surface;
        };
        let way = point - self.points[last.saturating_sub(1)];
        let point = point + way.normalize_or_zero() * radius;
        let end = surface.positions.len() as u32;
        surface.positions.push(point.as_vec3());
        surface.colours.push(mixed(palette, 0.0));
        let rim = end - AROUND;
        let lid = (0..AROUND).map(|k| [rim + k, rim + (k + 1) % AROUND, end]);
        surface.triangles.extend(lid);
        surface.normals = normals(&surface.positions, &surface.triangles);
        surface
    }

    /// The claw's surface with its vertices moved by `place`, for a scene.
    pub(super) fn placed(&self, palette: &Palette, place: impl Fn(DVec3) -> Vec3) -> Surface {
        let mut surface = self.surface(palette);
        for p in &mut surface.positions {
            *p = place(p.as_dvec3());
        }
        surface
    }
}

/// The triangles between the ring of corners that begins at `first` and the next one.
fn belt(first: u32) -> impl Iterator<Item = [u32; 3]> {
    (0..AROUND).flat_map(move |k| {
        let [a, b] = [first + k, first + (k + 1) % AROUND];
        [[a, b, a + AROUND], [b, b + AROUND, a + AROUND]]
    })
}

/// The palette's colour of marks, mixed with a share of its colour of bellies.
fn mixed(palette: &Palette, share: f32) -> [u8; 3] {
    std::array::from_fn(|k| {
        let [mark, belly] = [palette.mark[k], palette.belly[k]].map(f32::from);
        lesser(mark + (belly - mark) * share, 255.0) as u8
    })
}
