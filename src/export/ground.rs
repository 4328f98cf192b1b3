//! The ground as files have it.

use crate::solid::Surface;
use glam::DVec3;
use std::borrow::Cow;

/// A triangle whose height is this share of its longest side, or less, has no area.
const FLAT: f64 = 1e-7;

/// A surface of the ground without its triangles that have no area, and without the vertices that only these use. Walls
/// below an upright border have such triangles. Programs can give them no normal, and warn of them.
pub(super) fn with_areas(surface: &Surface) -> Cow<'_, Surface> {
    let has_area = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|v| surface.positions[v as usize].as_dvec3());
        let longest = [a - b, b - c, c - a].map(DVec3::length_squared);
        let longest = longest.into_iter().fold(0.0, f64::max);
        (b - a).cross(c - a).length() > FLAT * longest
    };
    if surface.triangles.iter().all(has_area) {
        return Cow::Borrowed(surface);
    }
    let all = surface.triangles.iter().copied();
    let left: Vec<[u32; 3]> = all.filter(has_area).collect();
    Cow::Owned(surface.part(&left))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn triangles_without_area_go_with_their_vertices() {
        let places = [Vec3::ZERO, Vec3::X, Vec3::Y, 2.0 * Vec3::X, Vec3::Y];
        let mut surface = Surface {
            positions: places.to_vec(),
            normals: vec![Vec3::Z; 5],
            colours: vec![[9; 3]; 5],
            triangles: vec![[0, 1, 3], [0, 1, 2], [2, 4, 0], [1, 1, 2]],
        };
        let kept = with_areas(&surface);
        assert_eq!(kept.triangles, [[0, 1, 2]]);
        assert_eq!(kept.positions, places[..3]);
        assert_eq!((kept.normals.len(), kept.colours.len()), (3, 3));
        surface.triangles = vec![[0, 1, 2], [4, 0, 3]];
        assert!(matches!(with_areas(&surface), Cow::Borrowed(_)));
    }
}
