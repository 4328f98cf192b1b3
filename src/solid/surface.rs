//! A surface of triangles, as it is drawn and written to files.

use super::simplify;
use crate::notice::{Code, Notice};
use glam::Vec3;

/// A surface. Those of cells are closed: each side of a triangle is that of another one, in the other
/// direction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// x, y (down) and height above the base level, in picture units.
    pub positions: Vec<Vec3>,
    /// Unit vectors outwards; around the base those of the walls.
    pub normals: Vec<Vec3>,
    /// Red, green, blue, 8 bits each, before light (sRGB).
    pub colours: Vec<[u8; 3]>,
    /// Clockwise on screen seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// No coordinate may be larger: sums of products stay finite.
pub(crate) const LARGEST: f32 = 1e9;

impl Surface {
    /// What is wrong with it, if anything is: lists of different lengths, a coordinate that is not a number, a
    /// corner that is not there. One without a fault can be drawn.
    pub fn fault(&self) -> Option<Notice> {
        let count = self.positions.len();
        let fault = |why: Notice| Some(Notice::new(Code::SurfaceFault).with("why", why));
        if self.normals.len() != count || self.colours.len() != count {
            return fault(Code::SurfaceLists.into());
        }
        let is_good = |v: &Vec3| v.is_finite() && v.abs().max_element() <= LARGEST;
        let pairs = self.positions.iter().zip(&self.normals);
        let mut good = pairs.map(|(p, n)| is_good(p) && is_good(n));
        if let Some(n) = good.position(|good| !good) {
            return fault(Notice::new(Code::SurfaceNumber).with("n", n));
        }
        let misses = |t: &[u32; 3]| t.iter().any(|&v| v as usize >= count);
        let missing = self.triangles.iter().position(misses);
        missing.and_then(|n| fault(Notice::new(Code::SurfaceCorner).with("n", n)))
    }
}

impl Surface {
    /// The same with at most so many triangles, as far as it can be simplified to so few; what lies below `floor`
    /// may be coarser. Vertices that stay have the normals and colours that they had.
    pub fn coarser(&self, most: usize, floor: f32) -> Self {
        let mut triangles = self.triangles.clone();
        simplify(&self.positions, &mut triangles, most, floor);
        self.part(&triangles)
    }

    /// These of its triangles (those that are none are left out), with the vertices that they have.
    pub(crate) fn part(&self, triangles: &[[u32; 3]]) -> Self {
        let mut places = vec![u32::MAX; self.positions.len()];
        let mut kept = Self::default();
        for &triangle in triangles.iter().filter(|t| t[0] != t[1]) {
            kept.triangles.push(triangle.map(|k| {
                let at = k as usize;
                if places[at] == u32::MAX {
                    places[at] = kept.positions.len() as u32;
                    kept.positions.push(self.positions[at]);
                    kept.normals.push(self.normals[at]);
                    kept.colours.push(self.colours[at]);
                }
                places[at]
            }));
        }
        kept
    }
}

/// Means of the normals of the triangles around each vertex, by their areas; down where there are none.
pub fn normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|k| positions[k as usize]);
        let normal = (b - a).cross(c - a);
        for &k in triangle {
            sums[k as usize] += normal;
        }
    }
    sums.iter()
        .map(|n| n.try_normalize().unwrap_or(Vec3::NEG_Z))
        .collect()
}
