//! A place of a surface, as it is lit.

use glam::Vec3;

/// What is known of a place of a surface before light falls on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surfel {
    /// In the world.
    pub position: Vec3,
    /// Unit vector outwards, in the world.
    pub normal: Vec3,
    /// Red, green, blue, 0..255, before light (sRGB).
    pub colour: [f32; 3],
    /// Row of the table of materials.
    pub material: u8,
    /// Part of the sky that is seen from it, 0..1, as far as is known without its surroundings.
    pub open: f32,
}

/// What surfaces have beyond their triangles: finer relief, colour, other materials.
pub trait Detail {
    /// Adds it to a place on the body of that id; `spread` is the part of the world that a pixel covers there,
    /// along a side.
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32);

    /// A number for the digest of the scene, which changes with all that it does to colours and materials. Details
    /// that follow from the bodies alone need none.
    fn mark(&self) -> Option<u64> {
        None
    }
}
