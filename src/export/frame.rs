//! From a surface's axes and units to those of mesh files.

use glam::Vec3;

/// What a surface's places are.
pub(super) enum Frame {
    /// x, y down and height in picture units, of which so many files' units are one.
    Picture { unit: f32 },
    /// Those of a model, as files have them.
    #[cfg(house)]
    Model,
}

impl Frame {
    pub fn place(&self, p: Vec3) -> [f32; 3] {
        match *self {
            Self::Picture { unit } => [p.x * unit - 0.5, p.z * unit, p.y * unit - 0.5],
            #[cfg(house)]
            Self::Model => p.to_array(),
        }
    }

    /// From the upper left corner of the maps to the right and down, 0..1 in the picture; a model has no maps.
    pub fn place_in_maps(&self, p: Vec3) -> Option<[f32; 2]> {
        match *self {
            Self::Picture { unit } => Some([p.x * unit, p.y * unit]),
            #[cfg(house)]
            Self::Model => None,
        }
    }

    pub fn has_maps(&self) -> bool {
        self.place_in_maps(Vec3::ZERO).is_some()
    }

    pub fn direction(&self, n: Vec3) -> [f32; 3] {
        match self {
            Self::Picture { .. } => [n.x, n.z, n.y],
            #[cfg(house)]
            Self::Model => n.to_array(),
        }
    }

    /// Exchanging two axes turns triangles over: here they go counter-clockwise seen from outside.
    pub fn turned(&self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        match self {
            Self::Picture { .. } => [a, c, b],
            #[cfg(house)]
            Self::Model => [a, b, c],
        }
    }
}
