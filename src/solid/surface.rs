//! A triangle surface for drawing and export.

use super::simplify;
use crate::csr::Csr;
use crate::order::lesser;
use glam::Vec3;

/// A triangle surface. Those of cells are closed: each side of a triangle is that of exactly one other, in
/// the opposite direction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// x, y (down) and height above the base level, in picture units.
    pub positions: Vec<Vec3>,
    /// Unit vectors outwards; around the base, the normals of the walls.
    pub normals: Vec<Vec3>,
    /// Red, green, blue, 8 bits each, before lighting (sRGB).
    pub colours: Vec<[u8; 3]>,
    /// Clockwise on screen seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Surface {
    /// Largest coordinate: sums of products stay finite.
    pub const LARGEST: f32 = 1e9;

    /// The first fault, if any: lists of different lengths, a coordinate that is not a number, or a corner
    /// without a vertex. A surface without faults can be drawn.
    pub fn fault(&self) -> Option<String> {
        let count = self.positions.len();
        if self.normals.len() != count || self.colours.len() != count {
            return Some("each vertex needs a normal and a colour".to_owned());
        }
        let is_good = |v: &Vec3| v.is_finite() && v.abs().max_element() <= Self::LARGEST;
        let pairs = self.positions.iter().zip(&self.normals);
        let mut good = pairs.map(|(p, n)| is_good(p) && is_good(n));
        if let Some(n) = good.position(|good| !good) {
            return Some(format!("vertex {n} has a number that is too large or none"));
        }
        let misses = |t: &[u32; 3]| t.iter().any(|&v| v as usize >= count);
        let missing = self.triangles.iter().position(misses);
        missing.map(|n| format!("triangle {n} has a corner without a vertex"))
    }
}

impl Surface {
    /// The surface in scene coordinates, right-handed with y up; pictures have x, y down and the height.
    /// `place` maps each point, given in these axes.
    pub fn upright(&self, place: impl Fn(Vec3) -> Vec3) -> Self {
        let swapped = |v: &Vec3| Vec3::new(v.x, v.z, v.y);
        let turned = |&[a, b, c]: &[u32; 3]| [a, c, b];
        Self {
            positions: self.positions.iter().map(swapped).map(place).collect(),
            normals: self.normals.iter().map(swapped).collect(),
            colours: self.colours.clone(),
            triangles: self.triangles.iter().map(turned).collect(),
        }
    }

    /// The surface with at most `most` triangles, as far as simplification reaches that; parts below `floor`
    /// may be coarser. The remaining vertices keep their normals and colours.
    pub fn coarser(&self, most: usize, floor: f32) -> Self {
        let mut triangles = self.triangles.clone();
        simplify(&self.positions, &mut triangles, most, floor);
        self.part(&triangles)
    }

    /// The part of this surface with these triangles (removed ones are left out) and the vertices that they use.
    pub(crate) fn part(&self, triangles: &[[u32; 3]]) -> Self {
        let left: Vec<[u32; 3]> = triangles.iter().copied().filter(|t| t[0] != t[1]).collect();
        let (kept, triangles) = used(&left, self.positions.len());
        let kept = || kept.iter().map(|&k| k as usize);
        Self {
            positions: kept().map(|k| self.positions[k]).collect(),
            normals: kept().map(|k| self.normals[k]).collect(),
            colours: kept().map(|k| self.colours[k]).collect(),
            triangles,
        }
    }
}

/// The vertices of these triangles in the order of their first use, and the triangles as indices into this list.
pub(crate) fn used(triangles: &[[u32; 3]], vertices: usize) -> (Vec<u32>, Vec<[u32; 3]>) {
    let mut places = vec![u32::MAX; vertices];
    let mut kept = Vec::new();
    let mut place = |v: u32| {
        let place = &mut places[v as usize];
        if *place == u32::MAX {
            *place = kept.len() as u32;
            kept.push(v);
        }
        *place
    };
    let triangles = triangles.iter().map(|t| t.map(&mut place)).collect();
    (kept, triangles)
}

impl Surface {
    /// Closes the base by a fan, at the level of the lowest point of the boundary.
    pub(crate) fn cap(&mut self, boundary: &[[u32; 2]]) {
        let on_boundary = |list: &[Vec3]| -> Vec<Vec3> {
            boundary.iter().map(|&[a, _]| list[a as usize]).collect()
        };
        let ring = on_boundary(&self.positions);
        if ring.is_empty() {
            return;
        }
        let level = ring.iter().fold(f32::MAX, |low, p| lesser(low, p.z));
        for &[a, _] in boundary {
            self.positions[a as usize].z = level;
        }
        let middle = ring.iter().sum::<Vec3>() / ring.len() as f32;
        let colour = self.colours[boundary[0][0] as usize];
        let new = self.positions.len() as u32;
        self.positions.push(Vec3::new(middle.x, middle.y, level));
        self.colours.push(colour);
        self.triangles
            .extend(boundary.iter().map(|&[a, b]| [b, a, new]));
    }
}

/// The edges that belong to one triangle only, in its direction.
pub(crate) fn boundary_edges(triangles: &[[u32; 3]], vertices: usize) -> Vec<[u32; 2]> {
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let ends = Csr::from_pairs(vertices, sides.clone().map(|[a, b]| (a as usize, b)));
    sides
        .filter(|[a, b]| !ends.row(*b as usize).contains(a))
        .collect()
}

/// Area-weighted means of the normals of the triangles around each vertex; downwards if there are none.
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
