//! Surfaces about the y axis.

use super::edges;
use crate::trimesh::{ROW, Soup};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The first step around, as a share of the longest edges: diagonals between unlike rings are longer.
const STEP: f64 = 0.88;
/// Samples of a profile, by which its length is measured.
const SAMPLES: usize = 1024;

/// A disc of even triangles that face up. `profile` runs from the axis outwards as its argument goes from 0 to 1: the
/// distance from the axis, and the height. `edge` is the length of the longest edges.
pub(super) fn disc(profile: impl Fn(f64) -> DVec2, edge: f64) -> Soup {
    edges::within(edge, STEP, |step| stepped(&profile, step))
}

fn stepped(profile: &impl Fn(f64) -> DVec2, step: f64) -> Soup {
    let mut soup = Soup::default();
    let mut last = soup.ring(profile(0.0), 1, None);
    for at in even(profile, ROW * step) {
        let count = ((TAU * at.x / step).round() as usize).max(6);
        let ring = soup.ring(at, count, Some(&last));
        soup.sew(&last, &ring);
        last = ring;
    }
    // Rings that were sewn outwards instead of upwards face down.
    for triangle in &mut soup.triangles {
        triangle.swap(1, 2);
    }
    soup
}

fn place(at: DVec2, angle: f64) -> DVec3 {
    DVec3::new(at.x * libm::cos(angle), at.y, at.x * libm::sin(angle))
}

/// Points of a profile in even steps of about this length, without its first one.
fn even(profile: &impl Fn(f64) -> DVec2, step: f64) -> Vec<DVec2> {
    let part = |k: usize| k as f64 / SAMPLES as f64;
    let mut along = vec![0.0];
    for k in 0..SAMPLES {
        along.push(along[k] + (profile(part(k + 1)) - profile(part(k))).length());
    }
    let count = (along[SAMPLES] / step).ceil().max(2.0);
    let mut k = 0;
    let point = |row: usize| {
        let wanted = along[SAMPLES] * row as f64 / count;
        while k + 1 < SAMPLES && along[k + 1] < wanted {
            k += 1;
        }
        let share = ((wanted - along[k]) / (along[k + 1] - along[k])).clamp(0.0, 1.0);
        profile((k as f64 + share) / SAMPLES as f64)
    };
    (1..=count as usize).map(point).collect()
}

/// The cosine of the angle beyond which a profile has a crease.
const CREASE: f64 = 0.766;

/// The surface that a profile sweeps as it turns: vertices, which are double along creases, their normals, and
/// triangles.
/// The outside lies to the left of the profile, seen with the axis on the left.
pub(super) fn turned(profile: &[DVec2], around: usize) -> (Soup, Vec<DVec3>) {
    let (mut soup, mut normals) = (Soup::default(), Vec::new());
    let mut before: Option<usize> = None;
    for (k, &p) in profile.iter().enumerate() {
        let [ahead, behind] = sides(profile, k);
        let is_crease = ahead.dot(behind) < CREASE;
        let smooth = (ahead + behind).normalize();
        let first = ring(
            &mut soup,
            &mut normals,
            around,
            p,
            if is_crease { behind } else { smooth },
        );
        if let Some(before) = before {
            band(&mut soup, around, before, first);
        }
        before = Some(match is_crease {
            true => ring(&mut soup, &mut normals, around, p, ahead),
            false => first,
        });
    }
    (soup, normals)
}

/// The normals of the pieces after and before a point of a profile. The profile is mirrored at the axis.
fn sides(profile: &[DVec2], k: usize) -> [DVec2; 2] {
    let p = profile[k];
    let mirrored = |q: DVec2| DVec2::new(2.0 * p.x - q.x, q.y);
    let last = profile.len() - 1;
    let before = if k > 0 {
        profile[k - 1]
    } else {
        mirrored(profile[1])
    };
    let after = if k < last {
        profile[k + 1]
    } else {
        mirrored(profile[last - 1])
    };
    [after - p, p - before].map(|d| d.perp().normalize())
}

/// Adds a ring of vertices and returns the number of its first one.
fn ring(soup: &mut Soup, normals: &mut Vec<DVec3>, around: usize, p: DVec2, n: DVec2) -> usize {
    let first = soup.positions.len();
    for k in 0..around {
        let angle = TAU * k as f64 / around as f64;
        soup.positions.push(place(p, angle));
        normals.push(place(n, angle));
    }
    first
}

/// Joins two rings of the same number of vertices. One of them may be a pole on the axis.
fn band(soup: &mut Soup, around: usize, before: usize, after: usize) {
    let is_pole = |first: usize| soup.positions[first].x.abs() < 1e-9;
    let poles = [is_pole(before), is_pole(after)];
    for k in 0..around {
        let next = (k + 1) % around;
        let [a, b, c, d] = [before + k, before + next, after + next, after + k].map(|v| v as u32);
        if !poles[0] {
            soup.triangles.push([a, b, c]);
        }
        if !poles[1] {
            soup.triangles.push([a, c, d]);
        }
    }
}
