//! A box without a lid, and its content.

use super::cuboid::cuboid;
use super::piled::{PiledShape, Vessel};
use crate::pile::Wall;
use crate::trimesh::Soup;
use glam::DVec3;
use std::f64::consts::FRAC_1_SQRT_2;

/// The thickness of boards, and the radius of their edges.
const THICK: f64 = 0.05;
const ROUND: f64 = 0.008;
/// The joints between boards, and the distance of boards from the walls, so that bodies do not cut them.
const GAP: f64 = 0.001;
/// The distance of the content from the walls.
const INSET: f64 = 0.035;
/// The greatest side of the squares of a board's grid.
const BOARD_STEP: f64 = 0.05;

/// The open box for the numbers `[depth, height, full]`. The content is level; bodies stand out of it by half of their
/// size and more, so its surface stays below the rim.
pub(super) fn open_box(n: &[f64], edge: f64) -> PiledShape {
    let outer = DVec3::new(0.5, n[1], 0.5 * n[0]);
    let inner = outer - THICK * (DVec3::X + DVec3::Z);
    let height = THICK + (n[1] - THICK) * (0.4 + 0.6 * n[2]);
    let walls = [
        (DVec3::X, inner.x),
        (DVec3::NEG_X, inner.x),
        (DVec3::Z, inner.z),
        (DVec3::NEG_Z, inner.z),
        (DVec3::NEG_Y, -THICK),
    ];
    let walls = walls.map(|(normal, offset)| Wall::Plane { normal, offset });
    let mut vessel = Vessel::new("wood");
    for (lo, hi) in boards(outer, inner) {
        let (half, middle) = (0.5 * (hi - lo), 0.5 * (lo + hi));
        let (mut soup, normals) = cuboid(half, ROUND, BOARD_STEP);
        soup.positions.iter_mut().for_each(|p| *p += middle);
        vessel.add(&soup, &normals);
    }
    PiledShape {
        surface: level(inner - DVec3::splat(INSET), height, edge),
        walls: walls.to_vec(),
        vessel: Some(vessel),
    }
}

/// The least and greatest corners of the boards: front and back over the whole width, the sides between them, and the
/// floor between all.
fn boards(outer: DVec3, inner: DVec3) -> [(DVec3, DVec3); 5] {
    let board =
        |x: [f64; 2], y: f64, z: [f64; 2]| (DVec3::new(x[0], 0.0, z[0]), DVec3::new(x[1], y, z[1]));
    let (x, z) = (inner.x + GAP, inner.z + GAP);
    let (wide, deep) = ([-outer.x, outer.x], [-inner.z, inner.z]);
    [
        board(wide, outer.y, [z, outer.z]),
        board(wide, outer.y, [-outer.z, -z]),
        board([x, outer.x], outer.y, deep),
        board([-outer.x, -x], outer.y, deep),
        board([-inner.x, inner.x], THICK - GAP, deep),
    ]
}

/// A level rectangle with these half sides, which faces up.
fn level(half: DVec3, height: f64, edge: f64) -> Soup {
    let count = |half: f64| (2.0 * half / (FRAC_1_SQRT_2 * edge)).ceil().max(1.0) as u32;
    let (across, deep) = (count(half.x), count(half.z));
    let at = |half: f64, k: u32, count: u32| half * (2.0 * f64::from(k) / f64::from(count) - 1.0);
    let mut soup = Soup::default();
    for j in 0..=deep {
        let z = at(half.z, j, deep);
        let row = (0..=across).map(|i| DVec3::new(at(half.x, i, across), height, z));
        soup.positions.extend(row);
    }
    for (i, j) in (0..deep).flat_map(|j| (0..across).map(move |i| (i, j))) {
        let a = j * (across + 1) + i;
        let [b, c, d] = [a + 1, a + across + 2, a + across + 1];
        soup.triangles.extend(match (i + j) % 2 {
            0 => [[a, c, b], [a, d, c]],
            _ => [[a, d, b], [b, d, c]],
        });
    }
    soup
}
