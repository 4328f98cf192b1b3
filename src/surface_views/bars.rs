//! Bars, crosses and stars for directions, and tubes along lines.

use super::SATIN;
use super::domes::Dome;
use crate::scene::Body;
use crate::solid::{Surface, normals};
use crate::surface_stones::Fit;
use crate::trimesh::SurfacePoint;
use glam::{DVec2, DVec3, Vec3};
use std::f64::consts::{PI, TAU};

/// Half the length and half the width of a bar, in distances between bars.
const BAR: DVec2 = DVec2::new(0.40, 0.058);
/// Half the length and half the width of an arm of a cross or star, in distances between bars.
const ARM: DVec2 = DVec2::new(0.36, 0.046);
/// The sides of a tube's cross-section.
const AROUND: u32 = 10;

/// Bars through one point, for all directions that mean the same in this symmetry.
pub(super) fn star(symmetry: u32) -> Body {
    let arms = (symmetry / 2).max(1);
    let half = if arms == 1 { BAR } else { ARM };
    let bar = Dome {
        half,
        round: Some(0.98 * half.y),
        high: 0.9 * half.y,
        deep: 1.6 * half.y,
        rim: 1.4,
        dark: 0.86,
    };
    let turned = |surface: &Surface| {
        let mut all = Surface::default();
        for arm in 0..arms {
            let turn = PI * f64::from(arm) / f64::from(arms);
            let (cos, sin) = (libm::cos(turn) as f32, libm::sin(turn) as f32);
            let around = |v: &Vec3| Vec3::new(cos * v.x + sin * v.z, v.y, cos * v.z - sin * v.x);
            let first = all.positions.len() as u32;
            all.positions.extend(surface.positions.iter().map(around));
            all.normals.extend(surface.normals.iter().map(around));
            all.colours.extend(&surface.colours);
            all.triangles
                .extend(surface.triangles.iter().map(|t| t.map(|v| v + first)));
        }
        all
    };
    // Stars are small, so they do not need the finest level.
    let levels = bar.levels().iter().skip(1).map(turned).collect();
    Body::new(levels, SATIN)
}

/// The places and normals of a line's points in the scene, without points nearer than `apart` to the last one that is
/// kept.
fn thinned(line: &[SurfacePoint], apart: f64, fit: &Fit) -> Vec<(DVec3, DVec3)> {
    let mut places: Vec<(DVec3, DVec3)> = Vec::new();
    for p in line {
        let at = fit.place(p.at).as_dvec3();
        let is_far = |&(last, _): &(DVec3, DVec3)| at.distance(last) > apart;
        if places.last().is_none_or(is_far) {
            places.push((at, p.normal));
        }
    }
    places
}

/// The triangles between rings of [`AROUND`] vertices, which follow each other.
fn joined(rings: u32) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    for ring in 1..rings {
        for k in 0..AROUND {
            let [a, b] = [k, (k + 1) % AROUND].map(|k| (ring - 1) * AROUND + k);
            let [c, d] = [b, a].map(|v| v + AROUND);
            triangles.extend([[a, c, b], [a, d, c]]);
        }
    }
    triangles
}

/// A tube with round ends along a line on a surface; `radius` in scene units. Nothing if the line has no length.
pub(super) fn tube(line: &[SurfacePoint], radius: f64, fit: &Fit) -> Option<Body> {
    let places = thinned(line, 0.4 * radius, fit);
    let last = places.len().checked_sub(1).filter(|&last| last > 0)?;
    let along = |k: usize| {
        let (from, to) = (places[k.saturating_sub(1)].0, places[(k + 1).min(last)].0);
        (to - from).normalize_or_zero()
    };
    let mut surface = Surface::default();
    let mut ring = |at: DVec3, along: DVec3, out: DVec3, radius: f64| {
        let across = along.cross(out).normalize_or_zero();
        let up = across.cross(along);
        for k in 0..AROUND {
            let turn = TAU * f64::from(k) / f64::from(AROUND);
            let p = at + (across * libm::cos(turn) + up * libm::sin(turn)) * radius;
            surface.positions.push(p.as_vec3());
        }
    };
    const END: [(f64, f64); 3] = [(0.98, 0.2), (0.8, 0.6), (0.4, 0.92)];
    let (start, end) = (places[0], places[last]);
    for (back, part) in END {
        ring(
            start.0 - along(0) * (back * radius),
            along(0),
            start.1,
            part * radius,
        );
    }
    for (k, &(at, out)) in places.iter().enumerate() {
        ring(at, along(k), out, radius);
    }
    for &(back, part) in END.iter().rev() {
        ring(
            end.0 + along(last) * (back * radius),
            along(last),
            end.1,
            part * radius,
        );
    }
    let rings = surface.positions.len() as u32 / AROUND;
    surface.triangles = joined(rings);
    surface.normals = normals(&surface.positions, &surface.triangles);
    surface.colours = vec![[255; 3]; surface.positions.len()];
    Some(Body::new(vec![surface], SATIN))
}
