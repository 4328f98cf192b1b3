//! Tiles of eight by eight pixels, which are processed together: surfaces, texels and pixels of a tile lie close
//! together in memory, and compilers make loops over numbers do four at a time.

use super::View;
use super::visibility::VisibilityBuffer;
use glam::Vec3;

/// Rows and columns of a tile.
pub(super) const BAND: usize = 8;
/// Pixels of a tile.
pub(super) const SQUARE: usize = BAND * BAND;

/// A tile of eight by eight pixels, fewer at the end of a frame: its first column and row.
#[derive(Clone, Copy)]
pub(super) struct Tile(pub [usize; 2]);

/// A number for each pixel of a tile, row after row.
pub(super) type Each = [f32; SQUARE];
/// A vector for each pixel, by components.
pub(super) type Vectors = [Each; 3];

/// Vectors to be overwritten.
pub(super) const NO_VECTORS: Vectors = [[0.0; SQUARE]; 3];

impl Tile {
    /// The tile's pixels: index in the tile, and column, row and index in the frame.
    #[inline(always)]
    pub fn pixels(self, view: &View) -> impl Iterator<Item = (usize, [usize; 3])> + use<> {
        let ([x0, y0], [width, height]) = (self.0, view.size);
        (y0..height.min(y0 + BAND)).flat_map(move |y| {
            let pixel = move |x| ((y - y0) * BAND + x - x0, [x, y, y * width + x]);
            (x0..width.min(x0 + BAND)).map(pixel)
        })
    }

    /// The rays from the eye through the pixels, with depth 1.
    #[inline(always)]
    pub fn rays(self, view: &View) -> Vectors {
        let mut rays = NO_VECTORS;
        let [x0, y0] = self.0.map(|v| v as f32 + 0.5);
        for k in 0..SQUARE {
            let ray = view.ray(x0 + (k % BAND) as f32, y0 + (k / BAND) as f32);
            set(&mut rays, k, ray);
        }
        rays
    }

    /// The points where rays meet visible surfaces.
    #[inline(always)]
    pub fn points(self, sight: &VisibilityBuffer, rays: &Vectors) -> Vectors {
        let view = sight.view();
        let (mut inverse, mut points) = ([1.0; SQUARE], NO_VECTORS);
        for (k, [_, _, at]) in self.pixels(view) {
            inverse[k] = sight.inverse[at];
        }
        for (k, inverse) in inverse.into_iter().enumerate() {
            set(&mut points, k, view.eye + get(rays, k) * (1.0 / inverse));
        }
        points
    }
}

#[inline(always)]
pub(super) fn get(list: &Vectors, k: usize) -> Vec3 {
    Vec3::new(list[0][k], list[1][k], list[2][k])
}

#[inline(always)]
pub(super) fn set(list: &mut Vectors, k: usize, v: Vec3) {
    (list[0][k], list[1][k], list[2][k]) = (v.x, v.y, v.z);
}

/// Normalises vectors; zero ones are replaced by the vector of the other list.
#[inline(always)]
pub(super) fn units(list: &Vectors, others: &Vectors) -> Vectors {
    let mut units = NO_VECTORS;
    for k in 0..SQUARE {
        let (v, other) = (get(list, k), get(others, k));
        let square = v.length_squared();
        let (unit, is_there) = (v * (1.0 / square.sqrt()), square > f32::MIN_POSITIVE);
        let pick = |unit, other| if is_there { unit } else { other };
        let [x, y, z] = [
            pick(unit.x, other.x),
            pick(unit.y, other.y),
            pick(unit.z, other.z),
        ];
        set(&mut units, k, Vec3::new(x, y, z));
    }
    units
}
