//! The light that the surfaces of a tile reflect.

use super::Lighting;
use super::four_lanes::{FourVectors, four};
use super::four_pixels::LANES;
use super::reflection::{FINISH, LitPoints};
use super::tile::{Each, NO_VECTORS, SQUARE, Vectors};

/// The surface elements of a tile's pixels, by components.
pub(super) struct TileSurfels {
    pub normals: Vectors,
    /// The normals before details were added.
    pub smooth: Vectors,
    pub colours: Vectors,
    /// The numbers of [`super::reflection::Reaching`], in its order.
    pub reaching: Vectors,
    pub finishes: [Each; FINISH],
}

impl TileSurfels {
    pub const NOTHING: Self = Self {
        normals: NO_VECTORS,
        smooth: NO_VECTORS,
        colours: NO_VECTORS,
        reaching: NO_VECTORS,
        finishes: [[0.0; SQUARE]; FINISH],
    };

    /// The light reflected to the eye, four pixels at once. `ways` are the directions from the eye.
    #[inline(always)]
    pub fn reflected(&self, light: &Lighting, points: &Vectors, ways: &Vectors) -> Vectors {
        let mut lights = NO_VECTORS;
        for k in (0..SQUARE).step_by(LANES) {
            let reflected = light.reflected(&LitPoints {
                positions: FourVectors::of(points, k),
                normals: FourVectors::of(&self.normals, k),
                smooth: FourVectors::of(&self.smooth, k),
                to_eye: -FourVectors::of(ways, k),
                reaching: FourVectors::of(&self.reaching, k),
                colours: FourVectors::of(&self.colours, k),
                finish: self.finishes.each_ref().map(|list| four(list, k)),
            });
            reflected.put(&mut lights, k);
        }
        lights
    }
}
