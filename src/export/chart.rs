//! Texture coordinates of bodies on a model.
//!
//! A body's coordinates are its positions, projected to one plane, in the model's units. So all bodies have one scale,
//! and a repeated texture has the same size everywhere. The plane is the tangent plane at the cell's centre, and the
//! texture runs along the cell. No image belongs to these coordinates: bodies overlap in them.

use crate::solid::Surface;
use crate::surface_cells::SurfaceCell;
use crate::trimesh::TangentFrame;
use glam::{DVec3, Vec3};

/// A plane for texture coordinates: seen from outside, its first axis to the right and its second one down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chart {
    right: Vec3,
    down: Vec3,
}

impl Chart {
    /// The tangent plane of a cell, with the first axis along it.
    pub fn of_cell(cell: &SurfaceCell) -> Self {
        let frame = cell.centre.frame();
        let along = frame.x * cell.axis.x + frame.y * cell.axis.y;
        let right = along.try_normalize().unwrap_or(frame.x);
        Self::facing(cell.centre.normal, right)
    }

    /// The plane at right angles to the mean normal of a surface that has no cell.
    pub fn of_surface(surface: &Surface) -> Self {
        let at = |k: u32| surface.positions[k as usize].as_dvec3();
        let area = |&[a, b, c]: &[u32; 3]| (at(b) - at(a)).cross(at(c) - at(a));
        let sum: DVec3 = surface.triangles.iter().map(area).sum();
        let normal = sum.try_normalize().unwrap_or(DVec3::Y);
        Self::facing(normal, TangentFrame::of(normal).x)
    }

    fn facing(normal: DVec3, right: DVec3) -> Self {
        Self {
            right: right.as_vec3(),
            down: right.cross(normal).as_vec3(),
        }
    }

    /// The coordinates of a point.
    pub fn of(&self, p: Vec3) -> [f32; 2] {
        [self.right.dot(p), self.down.dot(p)]
    }
}
