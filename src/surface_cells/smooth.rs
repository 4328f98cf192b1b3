//! Moves nodes of the mesh so that the quadrilaterals around irregular places become more rectangular. As in
//! `crate::mesh`, each quadrilateral pulls its corners towards the rectangle that fits it best.
//!
//! Nodes stay in the tangent planes of their centres during the work, and walk to their final places at the end.

use super::nodes::SurfaceNodes;
use crate::mesh::{Movable, from_middle};
use crate::trimesh::TriMesh;
use glam::{DVec2, DVec3};

impl Movable for SurfaceNodes {
    fn place(&self, node: u32) -> DVec3 {
        self.points[node as usize].at
    }

    fn put(&mut self, node: u32, place: DVec3) {
        self.points[node as usize].at = place;
    }

    fn proposal(&self, corners: [u32; 4]) -> Option<(DVec3, f64)> {
        let (frame, nodes) = self.plane(corners)?;
        let (by, length) = from_middle(&nodes);
        let [p, q, r, s] = nodes;
        let middle: DVec2 = (p.at + q.at + r.at + s.at) / 4.0;
        Some((frame.out(middle + by - p.at), length))
    }

    fn way(&self, node: u32, mean: DVec3) -> DVec3 {
        let normal = self.points[node as usize].normal;
        mean - normal * normal.dot(mean)
    }
}

/// Walks nodes from the cells' centres to their new places.
pub(super) fn settle(
    mesh: &TriMesh,
    nodes: &mut SurfaceNodes,
    from: usize,
    to: usize,
    home: impl Fn(usize) -> crate::trimesh::SurfacePoint,
) {
    for k in from..to {
        let start = home(k);
        let by = nodes.points[k].at - start.at;
        if by != DVec3::ZERO {
            nodes.points[k] = mesh.walk(&start, start.frame().within(by)).to;
        }
    }
}
