//! A point on a triangle mesh.

use super::TriMesh;
use glam::DVec3;

/// A point of a triangle of a mesh, with the surface's normal there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The triangle that it lies on.
    pub triangle: u32,
    /// Where it is, in the mesh's units.
    pub at: DVec3,
    /// The unit normal there, interpolated between the corners.
    pub normal: DVec3,
}

impl SurfacePoint {
    /// The point of a triangle with these barycentric weights.
    pub fn new(mesh: &TriMesh, triangle: u32, weights: DVec3) -> Self {
        let corners = mesh.corners(triangle);
        let at = corners[0] * weights.x + corners[1] * weights.y + corners[2] * weights.z;
        Self {
            triangle,
            at,
            normal: mesh.normal_at(triangle, weights),
        }
    }

    /// The barycentric weights in its triangle; at least 0, up to rounding.
    pub fn weights(&self, mesh: &TriMesh) -> DVec3 {
        mesh.weights(self.triangle, self.at)
    }
}
