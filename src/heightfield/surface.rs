//! A cell's surface as it stands in the planes, closed to a solid.
//!
//! To the solid, which is open at its base, come a cap over the base, the relief that the painter adds
//! to stones, and at each vertex the colour that the picture has there.
//!
//! The cap is a fan. The relief is taken between the pixels' middles, and the colour from the planes
//! wherever the cell's own id is to be seen; walls and hidden parts take theirs from their neighbours
//! along the surface. Then triangles go until no more are left than are wanted, and what stays has the
//! places and colours that it had.

use super::{Planes, TextureParams};
use crate::cells::Cell;
use crate::material::{Coat, Face, FaceNoise, floor};
use crate::order::{greater, lesser};
use crate::solid::{Solid, Surface, boundary_edges, normals, simplify};
use glam::Vec3;

/// From the base up to this part of a stone's height the relief grows from nothing to its full size.
const FOOT: f32 = 0.125;

/// Makes surfaces, and keeps what those of all cells share.
pub struct Surfaces {
    pub(super) params: TextureParams,
    noise: FaceNoise,
    /// Deviation of the relief, in picture units.
    deviation: f32,
    /// Triangles of each surface, about.
    most: usize,
}

impl Surfaces {
    /// For the planes made by these parameters, and so many triangles of each surface at most, as far as it
    /// can be simplified to so few.
    pub fn new(params: TextureParams, most: usize) -> Self {
        Self {
            most,
            noise: FaceNoise::new(params.seed, params.size, params.dimension, 0),
            deviation: params.relief(),
            params,
        }
    }

    /// The surface of a cell's solid, empty where that is; `index` is the cell's place in the list
    /// that the planes were painted from.
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

    /// Noise that all stones share.
    #[cfg(house)]
    pub(crate) fn noise(&self) -> &FaceNoise {
        &self.noise
    }

    /// Adds what the painter adds to each pixel of a stone.
    pub(crate) fn roughen(&self, face: &Face, positions: &mut [Vec3]) {
        let top = positions.iter().fold(0.0, |top, p| greater(top, p.z));
        let foot = greater(FOOT * top, f32::MIN_POSITIVE);
        for p in positions {
            let whole = lesser(p.z / foot, 1.0);
            p.z = greater(p.z + whole * self.raise(face, p.x - 0.5, p.y - 0.5), 0.0);
        }
    }

    /// What the painter adds at a place, interpolated between the middles of pixels.
    fn raise(&self, face: &Face, x: f32, y: f32) -> f32 {
        between(x, y, |[x, y]| {
            self.relief_at(face, [x, y]) + face.lift([x as f32, y as f32])
        })
    }

    /// The relief alone at a place, interpolated in the same way.
    pub(super) fn relief(&self, face: &Face, x: f32, y: f32) -> f32 {
        between(x, y, |pixel| self.relief_at(face, pixel))
    }

    fn relief_at(&self, face: &Face, pixel: [i32; 2]) -> f32 {
        self.deviation * face.relief(&self.noise, pixel)
    }
}

/// Bilinear interpolation of what pixels have.
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
    /// Makes the normals, of which the triangles from `cap` on have no say, and drops triangles without corners
    /// and vertices without triangles.
    fn tidy(self, cap: usize) -> Self {
        let normals = normals(&self.positions, &self.triangles[..cap]);
        let triangles = self.triangles.clone();
        Self { normals, ..self }.part(&triangles)
    }
}

/// The colours of the picture at the vertices where the stone `id` is to be seen; walls and what lies
/// under other stones go on in the colour that is nearest along the surface.
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
    // A stone of which nothing is to be seen has the colours of what covers it.
    let nearest = |p: &Vec3| {
        let [x, y] = [p.x, p.y].map(|v| floor(v * pixels).clamp(0, side - 1));
        planes.colour[(y * side + x) as usize]
    };
    let all = seen.iter().zip(positions);
    all.map(|(c, p)| c.unwrap_or_else(|| nearest(p))).collect()
}
