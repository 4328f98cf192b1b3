//! A surface element, ready to be lit.

use glam::Vec3;

/// The properties of a surface element before light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surfel {
    /// Its place in the world.
    pub position: Vec3,
    /// Unit vector outwards, in the world.
    pub normal: Vec3,
    /// Red, green, blue, 0..255, before light (sRGB).
    pub colour: [f32; 3],
    /// Row of the table of materials.
    pub material: u8,
    /// The visible share of the sky, 0..1, past the relief that details add; the surroundings are not part of it.
    pub open: f32,
}

/// Details of surfaces beyond their triangles: finer relief, colours, other materials.
pub trait Detail {
    /// Adds details to an element of the body with this id. `spread` is the width of a pixel there, in units of the
    /// world.
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32);

    /// A number for the digest of the scene, which changes with all effects on colours and materials. Details that
    /// follow from the bodies alone need none.
    fn mark(&self) -> Option<u64> {
        None
    }
}
