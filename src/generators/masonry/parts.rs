//! Parts of a scene that are no blocks.

use crate::scene::{Body, Instance, Paint, Place, Scene};
use crate::solid::Surface;

/// Adds a surface in the scene's own coordinates, with an id, in one colour and material.
pub(super) fn add_plain(
    scene: &mut Scene,
    surface: Surface,
    (id, tint, material): (u32, [u8; 3], u8),
) {
    scene.instances.push(Instance {
        body: scene.bodies.len() as u32,
        place: Place::default(),
        id,
        paint: Some(Paint { tint, material }),
    });
    scene.bodies.push(Body::new(vec![surface], material));
}
