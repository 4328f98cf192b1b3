//! A surface of triangles, as it is drawn and written to files.

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
