//! A cell's surface as it stands in the planes, closed to a solid.
//!
//! The solid is open at its base. It gets a cap over the base, the relief that the painter adds to stones,
//! and at each vertex the picture's colour there.
//!
//! The cap is a fan. The relief is interpolated between the pixels' centres, and the colour is taken from the
//! planes where the cell's own id is visible; walls and hidden parts take it from their neighbours along the
//! surface. Then triangles are collapsed down to the wanted number; the remaining vertices keep their places
//! and colours.

use super::{Planes, TextureParams};
use crate::cells::Cell;
use crate::material::{Coat, StoneTexture, TextureNoise, floor};
use crate::order::{greater, lesser};
use crate::solid::{Solid, Surface, boundary_edges, normals, simplify};
use glam::Vec3;

/// The relief grows from nothing at the base to its full size at this share of a stone's height.
const FOOT: f32 = 0.125;

/// Makes surfaces, and keeps the data shared by all cells.
pub struct Surfaces {
    pub(super) params: TextureParams,
    noise: TextureNoise,
    /// Standard deviation of the relief, in picture units.
    deviation: f32,
    /// About the number of triangles of each surface.
    most: usize,
}

impl Surfaces {
    /// For planes made with these parameters, with at most `most` triangles for each surface, as far as
    /// simplification reaches that.
    pub fn new(params: TextureParams, most: usize) -> Self {
        Self {
            most,
            noise: TextureNoise::new(params.seed, params.size, params.dimension, 0),
            deviation: params.relief(),
            params,
        }
    }

    /// The surface of a cell's solid, empty if the solid is; `index` is the cell's index in the list that the
    /// planes were painted from.
    pub fn close(&self, solid: &Solid, cell: &Cell, index: usize, planes: &Planes) -> Surface {
        if solid.vertices.is_empty() {
            return Surface::default();
        }
        let boundary = boundary_edges(&solid.triangles, solid.vertices.len());
        let mut positions = solid.vertices.clone();
        let face = self.params.face(cell, Coat::default());
        self.roughen(&face, &mut positions);
        let colours = colours(&positions, &solid.triangles, index as u32 + 1, planes);
        let mut surface = Surface {
            positions,
            normals: Vec::new(),
            colours,
            triangles: solid.triangles.to_vec(),
        };
        surface.cap(&boundary);
        let floor = self.params.level() as f32;
        simplify(&surface.positions, &mut surface.triangles, self.most, floor);
        surface.tidy(solid.triangles.len())
    }

    /// The noise shared by all stones.
    #[cfg(house)]
    pub(crate) fn noise(&self) -> &TextureNoise {
        &self.noise
    }

    /// Adds the painter's relief to positions on a stone.
    pub(crate) fn roughen(&self, face: &StoneTexture, positions: &mut [Vec3]) {
        let top = positions.iter().fold(0.0, |top, p| greater(top, p.z));
        let foot = greater(FOOT * top, f32::MIN_POSITIVE);
        for p in positions {
            let whole = lesser(p.z / foot, 1.0);
            p.z = greater(p.z + whole * self.raise(face, p.x - 0.5, p.y - 0.5), 0.0);
        }
    }

    /// The painter's relief at a place, interpolated between the centres of pixels.
    fn raise(&self, face: &StoneTexture, x: f32, y: f32) -> f32 {
        between(x, y, |[x, y]| {
            self.relief_at(face, [x, y]) + face.lift([x as f32, y as f32])
        })
    }

    /// Like `raise`, without the lift of the stone's face.
    pub(super) fn relief(&self, face: &StoneTexture, x: f32, y: f32) -> f32 {
        between(x, y, |pixel| self.relief_at(face, pixel))
    }

    fn relief_at(&self, face: &StoneTexture, pixel: [i32; 2]) -> f32 {
        self.deviation * face.relief(&self.noise, pixel)
    }
}

/// Bilinear interpolation of values at pixels.
pub(crate) fn between(x: f32, y: f32, value: impl Fn([i32; 2]) -> f32) -> f32 {
    let (ix, iy) = (floor(x), floor(y));
    let (tx, ty) = (x - ix as f32, y - iy as f32);
    let mut sum = 0.0;
    for k in 0..4 {
        let (right, below) = (k & 1, k >> 1);
        let across = if right == 1 { tx } else { 1.0 - tx };
        let down = if below == 1 { ty } else { 1.0 - ty };
        sum += across * down * value([ix + right, iy + below]);
    }
    sum
}

impl Surface {
    /// Makes the normals, without regard to the triangles from `cap` on, and drops degenerate triangles and
    /// unused vertices.
    fn tidy(self, cap: usize) -> Self {
        let normals = normals(&self.positions, &self.triangles[..cap]);
        let triangles = self.triangles.clone();
        Self { normals, ..self }.part(&triangles)
    }
}

/// The picture's colours at the vertices where the stone `id` is visible; walls and parts under other stones
/// take the nearest colour along the surface.
fn colours(positions: &[Vec3], triangles: &[[u32; 3]], id: u32, planes: &Planes) -> Vec<[u8; 3]> {
    let (side, pixels) = (planes.side as i32, planes.pixel_scale.max(1) as f32);
    let mut seen: Vec<Option<[u8; 3]>> = vec![None; positions.len()];
    for (colour, p) in seen.iter_mut().zip(positions) {
        let (mut x, mut y) = (floor(p.x * pixels), floor(p.y * pixels));
        if planes.tile {
            (x, y) = (x.rem_euclid(side), y.rem_euclid(side));
        }
        let at = (y * side + x) as usize;
        let inside = x >= 0 && y >= 0 && x < side && y < side;
        if inside && planes.id[at] == id {
            *colour = Some(planes.colour[at]);
        }
    }
    let mut spreads = true;
    while spreads {
        spreads = false;
        for &[a, b, c] in triangles {
            let [a, b, c] = [a as usize, b as usize, c as usize];
            let colour = seen[a].or(seen[b]).or(seen[c]);
            for k in [a, b, c] {
                if seen[k].is_none() && colour.is_some() {
                    seen[k] = colour;
                    spreads = true;
                }
            }
        }
    }
    // A completely hidden stone has the colours of the stones over it.
    let nearest = |p: &Vec3| {
        let [x, y] = [p.x, p.y].map(|v| floor(v * pixels).clamp(0, side - 1));
        planes.colour[(y * side + x) as usize]
    };
    let all = seen.iter().zip(positions);
    all.map(|(c, p)| c.unwrap_or_else(|| nearest(p))).collect()
}
