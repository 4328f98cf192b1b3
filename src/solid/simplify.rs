//! Simplifies closed surfaces.
//!
//! A collapse moves one end of an edge to the other end. So the remaining vertices are a subset of the old ones, and
//! keep all their attributes. An edge is collapsed only if the surface stays closed (its ends have two common
//! neighbours: Dey, Edelsbrunner, Guha, Nekhayev 1999) and no triangle flips.

use super::collapse::{Collapse, LENGTH};
use super::quadric::Quadric;
use crate::order::greater;
use glam::{DVec3, Vec3};

/// Cosine of the largest angle by which a collapse may turn a triangle.
const TURN: f64 = 0.2;
/// A triangle with a smaller area, in square units, may turn freely.
const NO_AREA: f64 = 1e-9;
/// A removed triangle.
const REMOVED: [u32; 3] = [0; 3];

struct Simplifier {
    collapse: Collapse,
    /// Upper limit of the mean squared distance to the original planes.
    square: f64,
}

/// Removes triangles from a closed surface until at most `most` are left, or no more can be removed. Removed
/// ones become `[0, 0, 0]`. Errors below the height `floor` count a tenth.
pub(crate) fn simplify(positions: &[Vec3], triangles: &mut [[u32; 3]], most: usize, floor: f32) {
    simplify_between(positions, triangles, (most, f64::INFINITY), floor, |_| {
        false
    });
}

/// Like [`simplify`], for a surface with borders. Vertices on borders stay, as do those for which `stays` is true. No
/// place moves much farther than `far` from the original.
pub(crate) fn simplify_between(
    positions: &[Vec3],
    triangles: &mut [[u32; 3]],
    (most, far): (usize, f64),
    floor: f32,
    stays: impl Fn(u32) -> bool,
) {
    let mut left = triangles.len();
    if left <= most {
        return;
    }
    let mut simplifier = Simplifier::new(positions, triangles, far, floor);
    while left > most.max(4) {
        let Some([a, b]) = simplifier.collapse.pop() else {
            break;
        };
        if !stays(a) && simplifier.may_go(a, b) {
            simplifier.merge(a, b);
            left -= 2;
        }
    }
    triangles.copy_from_slice(&simplifier.collapse.triangles);
}

impl Simplifier {
    fn new(positions: &[Vec3], triangles: &[[u32; 3]], far: f64, floor: f32) -> Self {
        // Sums relative to a nearby origin lose fewer digits.
        let origin = positions[0];
        let places = positions.iter().map(|&p| (p - origin).as_dvec3()).collect();
        let mut new = Self {
            collapse: Collapse::new(places, triangles.to_vec()),
            square: far * far,
        };
        let floor = f64::from(floor - origin.z);
        for k in 0..triangles.len() {
            new.weigh(k, floor);
        }
        // Each edge occurs once in each direction.
        for &[a, b, c] in triangles {
            for [a, b] in [[a, b], [b, c], [c, a]] {
                new.offer(a, b);
            }
        }
        new
    }

    fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|v| self.collapse.places[v as usize])
    }

    /// Adds a triangle's plane to its corners.
    fn weigh(&mut self, k: usize, floor: f64) {
        let [a, b, c] = self.corners(self.collapse.triangles[k]);
        let normal = (b - a).cross(c - a);
        let area = normal.length();
        let normal = normal.try_normalize().unwrap_or_default();
        let hidden = greater(greater(a.z, b.z), c.z) < floor;
        let weight = if hidden { 0.1 * area } else { area };
        let plane = Quadric::of_plane(normal, -normal.dot(a), weight);
        self.collapse.weigh(k, &plane);
    }

    /// Computes the cost of collapsing `a` to `b` and queues it.
    fn offer(&mut self, a: u32, b: u32) {
        let [qa, qb] = [a, b].map(|v| &self.collapse.quadrics[v as usize]);
        let [from, to] = [a, b].map(|v| self.collapse.places[v as usize]);
        let off = greater(qa.at(to) + qb.at(to), 0.0);
        if off > self.square * (qa.weight() + qb.weight()) {
            return;
        }
        let cost = off + LENGTH * qa.weight() * (to - from).length_squared();
        self.collapse.offer([a, b], cost);
    }

    /// The neighbours of a vertex: in each of its triangles the next one.
    fn beside(&self, v: u32) -> Vec<u32> {
        let next = |[a, b, c]: [u32; 3]| match v {
            _ if a == v => b,
            _ if b == v => c,
            _ => a,
        };
        let around = self.collapse.living(v);
        around.map(|(_, triangle)| next(triangle)).collect()
    }

    fn may_go(&self, a: u32, b: u32) -> bool {
        let (from_a, from_b) = (self.beside(a), self.beside(b));
        let common = from_a.iter().filter(|v| from_b.contains(v)).count();
        from_a.contains(&b) && common == 2 && self.keeps_upright(a, b)
    }

    fn keeps_upright(&self, a: u32, b: u32) -> bool {
        let normal = |triangle: [u32; 3]| {
            let [p, q, r] = self.corners(triangle);
            (q - p).cross(r - p)
        };
        let mut others = self.collapse.living(a).filter(|(_, t)| !t.contains(&b));
        others.all(|(_, triangle)| {
            let moved = triangle.map(|v| if v == a { b } else { v });
            let (before, after) = (normal(triangle), normal(moved));
            let sizes = before.length() * after.length();
            before.length() < NO_AREA || (sizes > 0.0 && before.dot(after) > TURN * sizes)
        })
    }

    fn merge(&mut self, a: u32, b: u32) {
        self.collapse.merge(a, b, REMOVED);
        for v in self.beside(b) {
            self.offer(v, b);
            self.offer(b, v);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solid::Solid;
    use crate::solid::subdivide::tests::loop_subdivide;
    use std::collections::HashSet;

    /// A sphere: an octahedron after some Loop steps.
    fn ball(steps: u32) -> Solid {
        let axes = [Vec3::X, Vec3::Y, Vec3::Z];
        let vertices = axes.into_iter().chain(axes.map(|v| -v)).map(|v| v * 10.0);
        let triangles = (0..8).map(|k: u32| {
            let corner = |axis: u32| axis + 3 * (k >> axis & 1);
            let [x, y, z] = [0, 1, 2].map(corner);
            if k.count_ones().is_multiple_of(2) {
                [x, y, z]
            } else {
                [x, z, y]
            }
        });
        let mesh = Solid {
            vertices: vertices.collect(),
            triangles: triangles.collect(),
        };
        (0..steps).fold(mesh, |mesh, _| loop_subdivide(&mesh))
    }

    fn volume(mesh: &Solid) -> f32 {
        let six = mesh.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|k| mesh.vertices[k as usize]);
            a.dot(b.cross(c))
        });
        six.sum::<f32>() / 6.0
    }

    #[test]
    fn a_ball_of_fewer_triangles_is_closed_and_nearly_as_large() {
        let whole = ball(4);
        for (most, least) in [(500, 0.97), (100, 0.85), (20, 0.5), (4, 0.0)] {
            let mut triangles = whole.triangles.to_vec();
            simplify(&whole.vertices, &mut triangles, most, f32::MIN);
            triangles.retain(|t| *t != REMOVED);
            let mesh = Solid {
                triangles: triangles.into(),
                ..whole.clone()
            };
            assert!(mesh.triangles.len() <= most.max(8), "{most}");
            let sides = |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]];
            let all: HashSet<[u32; 2]> = mesh.triangles.iter().flat_map(|&t| sides(t)).collect();
            assert_eq!(all.len(), 3 * mesh.triangles.len());
            assert!(all.iter().all(|&[a, b]| all.contains(&[b, a])));
            let part = volume(&mesh) / volume(&whole);
            assert!(part > least && part < 1.01, "{most}: {part}");
        }
    }

    #[test]
    fn few_triangles_stay() {
        let mesh = ball(1);
        let mut triangles = mesh.triangles.to_vec();
        simplify(&mesh.vertices, &mut triangles, 32, 0.0);
        assert_eq!(*mesh.triangles, *triangles);
    }
}
