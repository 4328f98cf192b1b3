//! Singular points of the direction.

use super::SurfaceFields;
use crate::field::symmetry::representation;
use crate::planar::signed_angle;
use crate::trimesh::adjacency::carried;
use crate::trimesh::{SurfacePoint, TangentFrame};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;
use std::ops::Range;

/// A singular point: the direction turns around it, and is undefined there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceSingularity {
    /// The middle of the triangle around which the direction turns.
    pub at: SurfacePoint,
    /// By how much the direction turns on the way once around, in quarter turns for squares, half turns for stretched
    /// cells, sixths for circles.
    pub turns: i32,
    /// `turns` in full turns: 1/4 where three rows of squares meet, -1/4 where five do.
    pub index: f64,
}

impl SurfaceFields {
    /// The singular points of the direction, by triangle. On a closed surface their indices sum to its Euler
    /// characteristic; see [`SurfaceFields::border_index`] for others.
    pub fn singular_points(&self) -> Vec<SurfaceSingularity> {
        self.singular_among(0..self.mesh.triangles().len())
    }

    /// The singular points in some of the triangles.
    pub fn singular_among(&self, triangles: Range<usize>) -> Vec<SurfaceSingularity> {
        let symmetry = self.symmetry();
        let mut found = Vec::new();
        if self.axes.is_empty() {
            return found;
        }
        for t in triangles {
            let corners = &self.mesh.triangles()[t];
            let [a, b, c] = *corners;
            let turns = self.turn(a, b) + self.turn(b, c) + self.turn(c, a);
            let around = turns + f64::from(symmetry) * self.holonomy(*corners);
            let turns = (around / TAU).round() as i32;
            if turns != 0 {
                found.push(SurfaceSingularity {
                    at: SurfacePoint::new(&self.mesh, t as u32, DVec3::splat(1.0 / 3.0)),
                    turns,
                    index: f64::from(turns) / f64::from(symmetry),
                });
            }
        }
        found
    }

    /// The sum of the indices of all singular points.
    pub fn index_sum(&self) -> f64 {
        let turns: i32 = self.singular_points().iter().map(|s| s.turns).sum();
        f64::from(turns) / f64::from(self.symmetry())
    }

    /// How often the borders turn against the direction on the way along them, in full turns. This and the sum of the
    /// indices add up to the Euler characteristic.
    pub fn border_index(&self) -> f64 {
        if self.axes.is_empty() {
            return 0.0;
        }
        let at = |v: u32| self.mesh.positions()[v as usize];
        let mut sum = 0.0;
        for ring in self.mesh.borders() {
            let count = ring.len();
            let along = |k: usize| {
                let (before, v, next) = (
                    ring[(k + count - 1) % count],
                    ring[k % count],
                    ring[(k + 1) % count],
                );
                let way = (at(v) - at(before)).normalize_or_zero()
                    + (at(next) - at(v)).normalize_or_zero();
                let normal = self.mesh.normals()[v as usize];
                way - normal * normal.dot(way)
            };
            for k in 0..count {
                let (v, next) = (ring[k], ring[(k + 1) % count]);
                let tangent = self.angle(along(k), v, along(k + 1), next, 1);
                sum += tangent - self.turn(v, next) / f64::from(self.symmetry());
            }
        }
        // Rounding is removed: the result is a whole number of parts of a turn.
        (sum / TAU * f64::from(self.symmetry())).round() / f64::from(self.symmetry())
    }

    /// How far the direction's representation turns from one end of an edge to the other, -pi..pi. The reverse
    /// direction gives exactly the negative.
    fn turn(&self, a: u32, b: u32) -> f64 {
        let (from, to) = (self.axes[a as usize], self.axes[b as usize]);
        if a < b {
            self.angle(from, a, to, b, self.symmetry())
        } else {
            -self.angle(to, b, from, a, self.symmetry())
        }
    }

    fn angle(&self, from: DVec3, a: u32, to: DVec3, b: u32, symmetry: u32) -> f64 {
        let [n, m] = [a, b].map(|v| self.mesh.normals()[v as usize]);
        let frame = TangentFrame::of(m);
        let told = |v: DVec3| -> DVec2 {
            let unit = frame.within(v).normalize_or_zero();
            representation(unit, symmetry)
        };
        let (carried, here) = (told(carried(from, n, m)), told(to));
        signed_angle(carried, here)
    }

    /// The angle by which parallel transport around a triangle turns a vector: the area of the triangle of the
    /// normals on the unit ball (van Oosterom, Strackee 1983, The Solid Angle of a Plane Triangle).
    fn holonomy(&self, corners: [u32; 3]) -> f64 {
        let [a, b, c] = corners.map(|v| self.mesh.normals()[v as usize]);
        let below = 1.0 + a.dot(b) + b.dot(c) + c.dot(a);
        2.0 * libm::atan2(a.dot(b.cross(c)), below)
    }
}
