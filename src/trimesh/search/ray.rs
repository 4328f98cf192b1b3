//! The first triangle of a mesh that a ray hits.

use super::super::{NONE, SurfacePoint, TriMesh};
use super::tree::{OpenNodes, Search};
use glam::DVec3;

/// The tolerance of barycentric weights. With it, a ray through an edge meets at least one of the edge's triangles.
const NEAR_EDGE: f64 = 1e-12;

/// The hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The point that is hit.
    pub point: SurfacePoint,
    /// The distance along the ray, in lengths of its direction.
    pub along: f64,
}

impl Search {
    /// The first hit of a ray on a triangle for which `wanted` is true, from either side.
    pub fn ray(
        &self,
        mesh: &TriMesh,
        from: DVec3,
        along: DVec3,
        wanted: impl Fn(u32) -> bool,
    ) -> Option<Hit> {
        self.ray_within(mesh, (from, along), f64::INFINITY, wanted)
    }

    /// The first hit of a ray no farther than `most`, in lengths of its direction.
    pub fn ray_within(
        &self,
        mesh: &TriMesh,
        (from, along): (DVec3, DVec3),
        most: f64,
        wanted: impl Fn(u32) -> bool,
    ) -> Option<Hit> {
        let inverse = along.recip();
        let mut best = (most, NONE, DVec3::ZERO);
        let mut open = OpenNodes::new();
        let leaves = self.leaf_count();
        while let Some((near, node)) = open.pop() {
            if near > best.0 {
                continue;
            }
            if node < leaves {
                open.split(node, |child| self.entry(child, from, inverse));
                continue;
            }
            for &t in self.leaf(node - leaves) {
                if wanted(t)
                    && let Some((far, w)) = meets(mesh.corners(t), from, along)
                    && (far < best.0 || (far == best.0 && t < best.1))
                {
                    best = (far, t, w);
                }
            }
        }
        (best.1 != NONE).then(|| Hit {
            point: SurfacePoint::new(mesh, best.1, best.2),
            along: best.0,
        })
    }
}

/// The distance along a ray at which it meets a triangle, and the weights there (Moller, Trumbore 1997, Fast, Minimum
/// Storage Ray-Triangle Intersection).
pub(super) fn meets([a, b, c]: [DVec3; 3], from: DVec3, along: DVec3) -> Option<(f64, DVec3)> {
    let (e, f) = (b - a, c - a);
    let across = along.cross(f);
    let volume = e.dot(across);
    if volume == 0.0 {
        return None;
    }
    let off = from - a;
    let u = off.dot(across) / volume;
    // Most triangles of a leaf are missed, about half of them by this test.
    if u < -NEAR_EDGE {
        return None;
    }
    let q = off.cross(e);
    let v = along.dot(q) / volume;
    let far = f.dot(q) / volume;
    let within = u >= -NEAR_EDGE && v >= -NEAR_EDGE && u + v <= 1.0 + NEAR_EDGE && far >= 0.0;
    within.then(|| {
        let w = DVec3::new(1.0 - u - v, u, v).max(DVec3::ZERO);
        (far, w / (w.x + w.y + w.z))
    })
}
