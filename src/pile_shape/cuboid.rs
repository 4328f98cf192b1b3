//! Boxes with rounded edges, as grids.

use crate::trimesh::Soup;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_4;

/// A box about the origin with these half sides and this radius of its edges, which is above 0 and at most half a side:
/// vertices, unit normals, and triangles, counter-clockwise seen from outside. Squares have sides of at most `step`.
pub(super) fn cuboid(half: DVec3, radius: f64, step: f64) -> (Soup, Vec<DVec3>) {
    let cuts = half.to_array().map(|half| cuts(half, radius, step));
    let last = [0, 1, 2].map(|axis| cuts[axis].len() - 1);
    let inner = half - DVec3::splat(radius);
    let (mut soup, mut normals) = (Soup::default(), Vec::new());
    let mut numbers: BTreeMap<[usize; 3], u32> = BTreeMap::new();
    let mut number = |key: [usize; 3]| {
        *numbers.entry(key).or_insert_with(|| {
            let at = DVec3::new(cuts[0][key[0]], cuts[1][key[1]], cuts[2][key[2]]);
            let middle = at.clamp(-inner, inner);
            let normal = (at - middle).normalize();
            normals.push(normal);
            soup.positions.push(middle + radius * normal);
            soup.positions.len() as u32 - 1
        })
    };
    for (axis, end) in (0..3).flat_map(|axis| [(axis, 0), (axis, last[axis])]) {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for (i, j) in (0..last[u]).flat_map(|i| (0..last[v]).map(move |j| (i, j))) {
            let mut quad = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| {
                let mut key = [end; 3];
                (key[u], key[v]) = (i, j);
                number(key)
            });
            if end == 0 {
                quad.reverse();
            }
            // Diagonals run towards the middle of a side, so that all corners are alike.
            if (2 * i < last[u]) != (2 * j < last[v]) {
                quad.rotate_left(1);
            }
            let [a, b, c, d] = quad;
            soup.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (soup, normals)
}

/// Where a side of the box is cut: evenly where it is flat, and by even angles where it is round.
fn cuts(half: f64, radius: f64, step: f64) -> Vec<f64> {
    let inner = half - radius;
    let bends = (radius * FRAC_PI_4 / step).ceil().max(1.0) as u32;
    let flats = (2.0 * inner / step).ceil() as u32;
    let bend = |k: u32| {
        let angle = FRAC_PI_4 * f64::from(k) / f64::from(bends);
        inner + radius * libm::tan(angle)
    };
    let before = (1..=bends).rev().map(|k| -bend(k));
    let between = (0..=flats).map(|k| inner * (2.0 * f64::from(k) / f64::from(flats.max(1)) - 1.0));
    before.chain(between).chain((1..=bends).map(bend)).collect()
}
