//! Measures of a pile.

use super::{Body, Fate, Kind};
use crate::component::Sphere;
use crate::trimesh::spatial_hash::SurfaceHash;
use glam::DVec3;

/// A gap that counts as touching, in R of the smaller body.
const TOUCHING: f64 = 0.02;

/// For each body, the numbers of the bodies that it touches: their inner spheres overlap by about `offset` or more, in
/// R of the smaller body. Bodies that are not kept touch nothing.
pub fn contacts(bodies: &[Body], kinds: &[Kind], offset: f64) -> Vec<Vec<u32>> {
    let mut touched = vec![Vec::new(); bodies.len()];
    for_pairs(bodies, kinds, |a, b, overlap| {
        if overlap >= offset - TOUCHING {
            touched[a].push(b as u32);
            touched[b].push(a as u32);
        }
    });
    for list in &mut touched {
        list.sort_unstable();
    }
    touched
}

/// The deepest overlap of two inner spheres of different bodies, in R of the smaller body; less than 0 if none overlap.
pub fn deepest_overlap(bodies: &[Body], kinds: &[Kind]) -> f64 {
    let mut deepest = f64::NEG_INFINITY;
    for_pairs(bodies, kinds, |_, _, overlap| {
        deepest = overlap.max(deepest)
    });
    deepest
}

/// For each body the deepest overlap of one of its inner spheres with one of another body, in R of the smaller body;
/// below 0 if none overlap, and minus infinity if no body is near.
pub fn deepest_overlaps(bodies: &[Body], kinds: &[Kind]) -> Vec<f64> {
    let mut deepest = vec![f64::NEG_INFINITY; bodies.len()];
    for_pairs(bodies, kinds, |a, b, overlap| {
        for k in [a, b] {
            deepest[k] = overlap.max(deepest[k]);
        }
    });
    deepest
}

/// How many bodies the line along a surface normal pierces, counted by their inner spheres. Spheres count if their
/// centres are at most `reach` above or below `at`.
pub fn pierced(bodies: &[Body], kinds: &[Kind], (at, normal): (DVec3, DVec3), reach: f64) -> usize {
    let meets = |sphere: Sphere| {
        let away = sphere.centre - at;
        let along = away.dot(normal);
        let square = away.length_squared() - along * along;
        along.abs() <= reach && square < sphere.radius * sphere.radius
    };
    let kept = bodies.iter().filter(|b| b.fate == Fate::Kept);
    kept.filter(|b| b.spheres(kinds).any(meets)).count()
}

/// Calls `visit` with two kept bodies that are near each other, the lesser number first, and the deepest overlap of
/// their spheres in R of the smaller body.
fn for_pairs(bodies: &[Body], kinds: &[Kind], mut visit: impl FnMut(usize, usize, f64)) {
    let kept: Vec<usize> = (0..bodies.len())
        .filter(|&k| bodies[k].fate == Fate::Kept)
        .collect();
    let reach = kinds.iter().map(Kind::bound).fold(0.0, f64::max);
    let places = kept.iter().map(|&k| bodies[k].place());
    let mut hash = SurfaceHash::around(places.clone(), 2.0 * reach);
    for (own, place) in places.enumerate() {
        hash.any_near(place, 2.0 * reach, |other| {
            let (a, b) = (kept[other], kept[own]);
            if let Some(overlap) = overlap(&bodies[a], &bodies[b], kinds) {
                visit(a, b, overlap);
            }
            false
        });
        hash.push_at(place);
    }
}

/// The deepest overlap of the spheres of two bodies, in R of the smaller one; none if their bounds are apart.
fn overlap(a: &Body, b: &Body, kinds: &[Kind]) -> Option<f64> {
    let bound = |body: &Body| body.shape(kinds).bound * body.scale;
    if a.place().distance(b.place()) > bound(a) + bound(b) {
        return None;
    }
    let others: Vec<Sphere> = b.spheres(kinds).collect();
    let depth = |s: Sphere| {
        let each = others
            .iter()
            .map(move |o| s.radius + o.radius - s.centre.distance(o.centre));
        each.fold(f64::NEG_INFINITY, f64::max)
    };
    let deepest = a
        .spheres(kinds)
        .map(depth)
        .fold(f64::NEG_INFINITY, f64::max);
    Some(deepest / a.radius(kinds).min(b.radius(kinds)))
}
