//! Test meshes, as files may contain them.

use crate::trimesh::testing::{self, Soup};
use glam::DVec3;
use std::f64::consts::TAU;

pub fn all() -> Vec<(&'static str, Soup)> {
    vec![
        ("facets", testing::torus(24, 10, 0.4)),
        ("noise", testing::noisy(testing::ball(5), 0.01)),
        ("blob", testing::blob(5)),
        ("open", testing::tube(24, 12)),
        ("genus 2", testing::two_holes(4)),
        ("sharp", testing::cube(6)),
        ("scan", testing::scan(40)),
    ]
}

pub fn flat() -> Soup {
    testing::flat(12)
}

/// A wall of height 1 inside a circle of radius 1.
pub fn wall(thick: f64) -> Soup {
    const AROUND: u32 = 96;
    let corners = [
        (1.0, 0.0),
        (1.0, 1.0),
        (1.0 - thick, 1.0),
        (1.0 - thick, 0.0),
    ];
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for i in 0..AROUND {
        let angle = TAU * f64::from(i) / f64::from(AROUND);
        let (cos, sin) = (libm::cos(angle), libm::sin(angle));
        positions.extend(corners.map(|(x, y)| DVec3::new(x * cos, y, -x * sin)));
        for k in 0..4 {
            let at = |i: u32, k: u32| (i % AROUND) * 4 + k % 4;
            let [a, b, c, d] = [at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (positions, triangles)
}
