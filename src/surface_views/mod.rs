//! Views of the stages of a surface: scenes in the same place and light as the finished scene.
//!
//! - [`Particles`]: packed cells as they move, each a bubble that lies on the surface.
//! - [`FieldView`]: the direction as bars, crosses or stars, and its singular points.
//! - [`MeshView`]: the cells' mesh.
//! - [`CellsView`]: the cells' polygons.
//! - [`MapView`]: the surface in the colours of its curvature, or of the wanted size.
//!
//! All use the same [`Fit`](crate::surface_stones::Fit), so a change of view moves nothing. They share the bare
//! surface, which is made once, in parts at several levels of detail: [`BareSurface`]. Bodies of one shape are stored
//! once. Differences between them, and lines within a face, are not geometry but a [`Detail`](crate::scene::Detail):
//! it is computed for visible pixels only, and sharp at any distance.

mod bars;
mod cells;
mod domes;
mod elements;
mod field;
mod ground;
mod map;
mod paint;
mod particles;
mod spread;
mod tally;
#[cfg(test)]
mod tests;

pub use cells::CellsView;
pub use elements::MeshView;
pub use field::FieldView;
pub use ground::BareSurface;
pub use map::{Legend, MapView, Quantity};
pub use particles::{Particles, particles};
pub use tally::Tally;

use crate::draw::Colour;
use crate::material::Material;
use crate::scene::{Instance, Place};
use glam::{DVec3, Vec3};

/// The materials of views, for the table of [`crate::scene::Lighting`]. The tables of palettes have similar rows.
pub const MATERIALS: [Material; 4] = [
    Material::new(1.0, 0.92, 0.0, 4.0),
    // Maps, whose colours must be readable.
    Material::new(1.3, 0.68, 0.0, 4.0),
    // Bars and balls.
    Material::new(1.05, 0.88, 0.16, 24.0),
    // Bubbles.
    Material::new(1.05, 0.86, 0.34, 42.0),
];

/// Rows of [`MATERIALS`].
const BARE: u8 = 0;
const MAP: u8 = 1;
const SATIN: u8 = 2;
const GLOSS: u8 = 3;

/// The colour of the bare surface.
const CALM: [u8; 3] = [168, 162, 151];
/// The brightness of the inside, relative to the outside.
const INSIDE: f32 = 0.72;

/// A colour of drawings as bytes.
fn bytes(colour: Colour) -> [u8; 3] {
    [0, 1, 2].map(|k| (colour[k].clamp(0.0, 1.0) * 255.0 + 0.5) as u8)
}

/// Places a body with its x along the surface and its y out of it, scaled by `scale`.
fn standing(body: u32, id: u32, at: Vec3, [along, out]: [DVec3; 2], scale: f64) -> Instance {
    let across = along.cross(out);
    Instance {
        body,
        place: Place {
            axes: [along, out, across].map(|axis| (axis * scale).as_vec3()),
            origin: at,
        },
        id,
        paint: None,
    }
}
