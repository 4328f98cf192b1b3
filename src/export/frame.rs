//! From the picture's axes and units to those of mesh files.

use glam::Vec3;

/// From picture units to those of the files.
pub(super) struct Frame {
    /// Files' units for each of the picture's.
    pub unit: f32,
}

impl Frame {
    pub fn place(&self, p: Vec3) -> [f32; 3] {
        [
            p.x * self.unit - 0.5,
            p.z * self.unit,
            p.y * self.unit - 0.5,
        ]
    }

    /// From the upper left corner of the maps to the right and down, 0..1 in the picture.
    pub fn place_in_maps(&self, p: Vec3) -> [f32; 2] {
        [p.x * self.unit, p.y * self.unit]
    }

    pub fn direction(&self, n: Vec3) -> [f32; 3] {
        [n.x, n.z, n.y]
    }

    /// Exchanging two axes turns triangles over: here they go counter-clockwise seen from outside.
    pub fn turned(&self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        [a, c, b]
    }
}
