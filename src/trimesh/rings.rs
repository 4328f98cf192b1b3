//! Rings of vertices about the y axis, joined by triangles that are as even as they can be.

use super::Soup;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The distance between rings for equilateral triangles, in edge lengths.
pub(crate) const ROW: f64 = 0.866_025_403_784_438_6;

/// A ring among the vertices of a soup.
pub(crate) struct VertexRing {
    first: usize,
    pub count: usize,
    /// The angle of the first vertex.
    turn: f64,
}

impl Soup {
    /// Adds a ring with the radius and height `at`. Its vertices are turned against those of the ring before it, if
    /// there is one.
    pub(crate) fn ring(
        &mut self,
        at: DVec2,
        count: usize,
        before: Option<&VertexRing>,
    ) -> VertexRing {
        // Vertices lie between those of the ring before.
        let beside = |last: &VertexRing| last.turn + 0.5 * TAU / last.count.max(count) as f64;
        let ring = VertexRing {
            first: self.positions.len(),
            count,
            turn: before.map_or(0.0, beside),
        };
        let angles = (0..count).map(|k| ring.turn + TAU * k as f64 / count as f64);
        let place = |angle: f64| DVec3::new(at.x * libm::cos(angle), at.y, at.x * libm::sin(angle));
        self.positions.extend(angles.map(place));
        ring
    }

    /// Joins two rings by triangles: goes round both, and steps each time to the next vertex of the ring that gives the
    /// shorter new edge. The triangles face away from the axis if the second ring is the upper one.
    pub(crate) fn sew(&mut self, lower: &VertexRing, upper: &VertexRing) {
        let name = |ring: &VertexRing, k: usize| (ring.first + k % ring.count) as u32;
        let steps = |ring: &VertexRing| if ring.count > 1 { ring.count } else { 0 };
        let (mut i, mut j) = (0, 0);
        while i < steps(lower) || j < steps(upper) {
            let (a, b) = (name(lower, i), name(upper, j));
            let (after_a, after_b) = (name(lower, i + 1), name(upper, j + 1));
            let far =
                |p: u32, q: u32| self.positions[p as usize].distance(self.positions[q as usize]);
            let is_lower =
                i < steps(lower) && (j == steps(upper) || far(after_a, b) <= far(a, after_b));
            if is_lower {
                self.triangles.push([a, b, after_a]);
                i += 1;
            } else {
                self.triangles.push([a, b, after_b]);
                j += 1;
            }
        }
    }
}
