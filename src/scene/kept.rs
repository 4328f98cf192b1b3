//! What of a frame is kept beside its picture, for files and the pointer.

use super::Scene;
use super::sight::{FLOOR, Sight};
use glam::Vec3;
use std::ops::Range;

/// Of the first sample of each pixel.
#[derive(Default)]
pub(super) struct Kept {
    /// In units of the scene; 0 where no body is.
    pub depths: Vec<f32>,
    /// 0 where no body is.
    pub ids: Vec<u32>,
    /// Places of the instances.
    pub instances: Vec<u32>,
    /// Zero where no body is.
    pub normals: Vec<Vec3>,
}

impl Kept {
    /// Begins anew with room for so many pixels.
    pub fn begin(&mut self, pixels: usize) {
        self.depths.clear();
        self.depths.reserve_exact(pixels);
        for list in [&mut self.ids, &mut self.instances] {
            list.clear();
            list.reserve_exact(pixels);
        }
        self.normals.clear();
        self.normals.reserve_exact(pixels);
    }

    /// Makes room for normals of pixels up to this one.
    pub fn make_room(&mut self, pixels: usize) {
        self.normals.resize(pixels, Vec3::ZERO);
    }

    /// Keeps all but the normals of the next pixels.
    pub fn add(&mut self, scene: &Scene, sight: &Sight, pixels: Range<usize>) {
        for at in pixels {
            let owner = sight.owner[at];
            let (id, depth) = match scene.instances.get(owner as usize) {
                Some(instance) if owner < FLOOR => (instance.id, 1.0 / sight.inverse[at]),
                _ => (0, 0.0),
            };
            self.ids.push(id);
            self.depths.push(depth);
            self.instances.push(owner);
        }
    }
}
