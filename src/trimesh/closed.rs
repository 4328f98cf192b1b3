//! Meshes without a border, which have an inside.

use super::{NONE, TriMesh};
use glam::DVec3;
use std::f64::consts::PI;

/// A closed mesh: every edge joins two triangles. So it has a volume, and an inside and an outside.
#[derive(Clone, Copy, Debug)]
pub struct Closed<'a> {
    mesh: &'a TriMesh,
}

impl TriMesh {
    /// The mesh as the surface of a body; `None` if it has a border.
    pub fn closed(&self) -> Option<Closed<'_>> {
        let is_closed = !self.across.as_flattened().contains(&NONE);
        (is_closed && !self.triangles.is_empty()).then_some(Closed { mesh: self })
    }
}

impl Closed<'_> {
    /// The enclosed volume, by the divergence theorem: negative if the triangles are clockwise seen from outside.
    pub fn volume(&self) -> f64 {
        // Sums relative to a nearby origin lose fewer digits.
        let origin = self.mesh.positions[0];
        let six = self.corners().map(|corners| {
            let [a, b, c] = corners.map(|p| p - origin);
            a.dot(b.cross(c))
        });
        six.sum::<f64>() / 6.0
    }

    /// The centre of mass of the body with uniform density; not finite if the volume is zero.
    pub fn centroid(&self) -> DVec3 {
        let origin = self.mesh.positions[0];
        let (mut sum, mut six) = (DVec3::ZERO, 0.0);
        for corners in self.corners() {
            let [a, b, c] = corners.map(|p| p - origin);
            let volume = a.dot(b.cross(c));
            sum += volume * (a + b + c);
            six += volume;
        }
        origin + sum / (4.0 * six)
    }

    /// How often the surface encloses a point: 1 inside, 0 outside, 2 where two parts overlap. On the surface itself
    /// the value is one of these or between them. It is the sum of the solid angles of all triangles (van Oosterom,
    /// Strackee 1983, The Solid Angle of a Plane Triangle), so its time is proportional to their number.
    pub fn winding_number(&self, p: DVec3) -> f64 {
        let half = self.corners().map(|corners| {
            let [a, b, c] = corners.map(|q| q - p);
            let [x, y, z] = [a, b, c].map(DVec3::length);
            let below = x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y;
            libm::atan2(a.dot(b.cross(c)), below)
        });
        half.sum::<f64>() / (2.0 * PI)
    }

    /// Whether a point is inside.
    pub fn contains(&self, p: DVec3) -> bool {
        self.winding_number(p) > 0.5
    }

    fn corners(&self) -> impl Iterator<Item = [DVec3; 3]> {
        (0..self.mesh.triangles.len() as u32).map(|t| self.mesh.corners(t))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{samples, testing};
    use super::*;

    #[test]
    fn only_a_mesh_without_border_is_closed() {
        assert!(samples::torus(24, 10).closed().is_some());
        assert!(samples::hill(8).closed().is_none());
        assert!(samples::cylinder(16, 8).closed().is_none());
        assert!(TriMesh::none().closed().is_none());
    }

    #[test]
    fn volume_and_centroid_are_those_of_the_body() {
        let cubes = testing::mesh(testing::cubes(&[[0; 3], [4, 0, 0], [4, 0, 1]], 2));
        let body = cubes.closed().unwrap();
        assert!((body.volume() - 3.0).abs() < 1e-12);
        let wanted = DVec3::new(9.5, 1.5, 2.5) / 3.0;
        assert!(
            body.centroid().distance(wanted) < 1e-12,
            "{}",
            body.centroid()
        );
        let ball = testing::mesh(testing::ball(5));
        let whole = 4.0 / 3.0 * PI;
        let part = ball.closed().unwrap().volume() / whole;
        assert!((0.995..1.0).contains(&part), "{part}");
    }

    #[test]
    fn a_mesh_inside_out_has_a_negative_volume() {
        let (positions, triangles) = testing::cube(1);
        let turned = triangles.iter().map(|&[a, b, c]| [a, c, b]);
        let mesh = testing::mesh((positions, turned.collect()));
        let body = mesh.closed().unwrap();
        assert!((body.volume() + 1.0).abs() < 1e-12);
        assert!((body.winding_number(DVec3::splat(0.4)) + 1.0).abs() < 1e-12);
        assert!(!body.contains(DVec3::splat(0.4)));
    }

    #[test]
    fn the_winding_number_tells_inside_from_outside() {
        let torus = samples::torus(48, 24);
        let body = torus.closed().unwrap();
        let mut chance = testing::chance(3);
        for _ in 0..400 {
            let p = DVec3::from([0; 3].map(|_| 1.5 * chance.signed()));
            let to_ring = DVec3::new(DVec3::new(p.x, 0.0, p.z).length() - 1.0, p.y, 0.0).length();
            // Near the surface the facets differ from the exact torus.
            if (to_ring - 0.4).abs() < 0.02 {
                continue;
            }
            let number = body.winding_number(p);
            let wanted = f64::from(u8::from(to_ring < 0.4));
            assert!((number - wanted).abs() < 1e-9, "{p}: {number}");
            assert_eq!(body.contains(p), to_ring < 0.4, "{p}");
        }
    }

    #[test]
    fn parts_that_overlap_count_twice() {
        let (mut positions, mut triangles) = testing::cube(2);
        let count = positions.len() as u32;
        positions.extend(positions.clone().iter().map(|p| *p + DVec3::splat(0.5)));
        triangles.extend(triangles.clone().iter().map(|t| t.map(|v| v + count)));
        let mesh = testing::mesh((positions, triangles));
        let body = mesh.closed().unwrap();
        for (at, wanted) in [(0.25, 1.0), (0.75, 2.0), (1.25, 1.0), (1.75, 0.0)] {
            let number = body.winding_number(DVec3::splat(at));
            assert!((number - wanted).abs() < 1e-12, "{at}: {number}");
        }
    }
}
