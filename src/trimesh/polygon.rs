//! Polygons in space, cut into triangles.

use glam::DVec3;
use std::borrow::Borrow;

/// Polygons with more corners are not triangulated.
const MOST_CORNERS: usize = 600;
/// Polygons of files with more corners become fans, since a file may have many of them.
const MOST_IN_FILES: usize = 64;

/// The sum of the cross products of neighbouring corners (Newell): normal to the polygon's mean plane, twice its area
/// long.
///
/// Sutherland, Sproull, Schumacker (1974), A Characterization of Ten Hidden-Surface Algorithms.
pub(crate) fn across(points: impl IntoIterator<Item = impl Borrow<DVec3>>) -> DVec3 {
    let mut points = points.into_iter().map(|p| *p.borrow());
    let Some(first) = points.next() else {
        return DVec3::ZERO;
    };
    let mut from = DVec3::ZERO;
    let arms = points.map(|p| p - first);
    arms.map(|arm| std::mem::replace(&mut from, arm).cross(arm))
        .sum()
}

/// Triangulates by cutting off ears: each time the one with the best triangle and no other corner in it. `may_join`
/// tells whether an edge may join two corners. `None` if there is no such triangulation, or if there are too many
/// corners.
pub(crate) fn cut(
    points: &[DVec3],
    may_join: impl Fn(usize, usize) -> bool,
) -> Option<Vec<[usize; 3]>> {
    if !(3..=MOST_CORNERS).contains(&points.len()) {
        return None;
    }
    let up = across(points).normalize_or_zero();
    let mut ring: Vec<usize> = (0..points.len()).collect();
    let mut triangles = Vec::with_capacity(points.len() - 2);
    while ring.len() > 3 {
        let n = ring.len();
        let mut best: Option<(bool, f64, usize)> = None;
        for k in 0..n {
            let [i, j, l] = [ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]];
            let quality = quality(points, [i, j, l], up);
            let is_better = |best: (bool, f64, usize), empty| (empty, quality) > (best.0, best.1);
            // Skip the slow tests for ears that cannot win.
            if best.is_some_and(|best| !is_better(best, true)) || !may_join(i, l) {
                continue;
            }
            let empty = quality > 0.0 && is_empty(points, &ring, [i, j, l], up);
            if best.is_none_or(|best| is_better(best, empty)) {
                best = Some((empty, quality, k));
            }
        }
        let (_, _, k) = best?;
        triangles.push([ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]]);
        ring.remove(k);
    }
    triangles.push([ring[0], ring[1], ring[2]]);
    Some(triangles)
}

/// Area over the sum of the squared sides: greatest for equilateral triangles, negative for triangles that are turned
/// over.
fn quality(points: &[DVec3], triangle: [usize; 3], up: DVec3) -> f64 {
    let [a, b, c] = triangle.map(|v| points[v]);
    let sides = (b - a).length_squared() + (c - b).length_squared() + (a - c).length_squared();
    if sides == 0.0 {
        return 0.0;
    }
    (b - a).cross(c - a).dot(up) / sides
}

/// Whether no other corner lies in a triangle, seen along `up`.
fn is_empty(points: &[DVec3], ring: &[usize], triangle: [usize; 3], up: DVec3) -> bool {
    let corners = triangle.map(|v| points[v]);
    let is_inside = |p: DVec3| {
        (0..3).all(|k| {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            (b - a).cross(p - a).dot(up) >= 0.0
        })
    };
    let others = ring.iter().filter(|v| !triangle.contains(v));
    others
        .map(|&v| points[v])
        .all(|p| corners.contains(&p) || !is_inside(p))
}

/// Adds a polygon of a file to `triangles`: by cutting off ears if it may be concave and has at most [`MOST_IN_FILES`]
/// corners, else as a fan.
pub(crate) fn add(positions: &[DVec3], corners: &[u32], triangles: &mut Vec<[u32; 3]>) {
    let places = || {
        let places = corners.iter().map(|&v| positions.get(v as usize).copied());
        places.collect::<Option<Vec<DVec3>>>()
    };
    let cut = match corners.len() {
        4..=MOST_IN_FILES => places().and_then(|places| cut(&places, |_, _| true)),
        _ => None,
    };
    match cut {
        Some(cut) => triangles.extend(cut.iter().map(|t| t.map(|k| corners[k]))),
        None => {
            for k in 2..corners.len() {
                triangles.push([corners[0], corners[k - 1], corners[k]]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(points: &[DVec3], triangles: &[[usize; 3]]) -> f64 {
        let each = triangles.iter().map(|t| {
            let [a, b, c] = t.map(|k| points[k]);
            0.5 * (b - a).cross(c - a).length()
        });
        each.sum()
    }

    #[test]
    fn hollow_polygons_are_cut_within() {
        let star: Vec<DVec3> = (0..10)
            .map(|k| {
                let angle = std::f64::consts::TAU * f64::from(k) / 10.0;
                let r = if k % 2 == 0 { 1.0 } else { 0.3 };
                DVec3::new(r * libm::cos(angle), 3.0 + r * libm::sin(angle), 0.0)
            })
            .collect();
        let arrow = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]];
        let arrow = arrow.map(|[x, y]| DVec3::new(x, 0.0, -y)).to_vec();
        for polygon in [star, arrow] {
            for turn in 0..polygon.len() {
                let mut points = polygon.clone();
                points.rotate_left(turn);
                let triangles = cut(&points, |_, _| true).unwrap();
                assert_eq!(triangles.len(), points.len() - 2);
                let whole = 0.5 * across(&points).length();
                assert!((area(&points, &triangles) - whole).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn polygons_of_no_area_and_of_lost_corners_are_cut_somehow() {
        let mut triangles = Vec::new();
        add(&[DVec3::ONE; 5], &[0, 1, 2, 3, 4], &mut triangles);
        add(&[DVec3::ONE; 3], &[0, 1, 2, 9], &mut triangles);
        add(&[DVec3::ONE; 3], &[0, 1], &mut triangles);
        assert_eq!(triangles.len(), 5);
    }
}
