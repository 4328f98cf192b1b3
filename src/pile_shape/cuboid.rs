//! Boxes with rounded edges, as grids.

use crate::trimesh::{Soup, box_triangles};
use glam::DVec3;
use std::f64::consts::FRAC_PI_4;

/// A box about the origin with these half sides and this radius of its edges, which is above 0 and at most half a side:
/// vertices, unit normals, and triangles, counter-clockwise seen from outside. Squares have sides of at most `step`.
pub(super) fn cuboid(half: DVec3, radius: f64, step: f64) -> (Soup, Vec<DVec3>) {
    let cuts = half.to_array().map(|half| cuts(half, radius, step));
    let squares = [0, 1, 2].map(|axis| cuts[axis].len() - 1);
    let inner = half - DVec3::splat(radius);
    let (mut soup, mut normals) = (Soup::default(), Vec::new());
    soup.triangles = box_triangles(squares, |[i, j, k]| {
        let at = DVec3::new(cuts[0][i], cuts[1][j], cuts[2][k]);
        let middle = at.clamp(-inner, inner);
        let normal = (at - middle).normalize();
        normals.push(normal);
        soup.positions.push(middle + radius * normal);
        soup.positions.len() as u32 - 1
    });
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
