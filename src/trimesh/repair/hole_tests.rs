//! Tests of holes, and of parts too small for cells.

use super::super::testing;
use super::tests::{mend, said};
use super::*;

#[test]
fn small_holes_are_closed_and_large_ones_stay() {
    let (positions, mut triangles) = testing::ball(4);
    // Remove single triangles, a star of six, and a large cap.
    let low = |t: &[u32; 3]| t.iter().all(|v| positions[*v as usize].y < -0.2);
    let below: Vec<[u32; 3]> = triangles.iter().copied().filter(low).collect();
    let alone = [below[5], below[150], below[250]];
    let star = below[400][0];
    let cap = |v: &u32| positions[*v as usize].y > 0.6;
    triangles.retain(|t| !t.contains(&star) && !t.iter().all(cap) && !alone.contains(t));
    let mesh = mend((positions, triangles)).mesh;
    assert_eq!(mesh.borders().len(), 5);
    let filled = HoleFilling::fill_all(mesh.clone(), 0.3).unwrap();
    assert_eq!(said(&filled.notices), [(Code::MendedHoles, 4)]);
    assert_eq!((filled.mesh.borders().len(), filled.mesh.euler()), (1, 1));
    assert_eq!(filled.bare.len(), filled.mesh.triangles().len());
    assert!(!filled.bare.contains(&true));
    // No triangle is turned over.
    for t in 0..filled.mesh.triangles().len() as u32 {
        let middle: DVec3 = filled.mesh.corners(t).into_iter().sum();
        assert!(filled.mesh.face_normal(t).dot(middle.normalize()) > 0.8);
    }
    let same = HoleFilling::fill_all(mesh.clone(), 0.001).unwrap();
    assert!((same.mesh.as_ref(), same.notices) == (&mesh, vec![]));
}

#[test]
fn a_ragged_hole_of_many_corners_is_closed() {
    let (positions, mut triangles) = testing::flat(120);
    let inside = |v: &u32| (positions[*v as usize] - DVec3::new(0.5, 0.0, -0.5)).length() < 0.2;
    triangles.retain(|t| !t.iter().any(inside));
    let mesh = mend((positions, triangles)).mesh;
    println!(
        "{:?}",
        mesh.borders().iter().map(Vec::len).collect::<Vec<_>>()
    );
    let filled = HoleFilling::fill_all(mesh, 0.6).unwrap();
    assert_eq!(said(&filled.notices), [(Code::MendedHoles, 1)]);
    assert_eq!((filled.mesh.euler(), filled.mesh.borders().len()), (1, 1));
    let area = filled.mesh.area();
    assert!((area - 1.0).abs() < 1e-4, "{area}");
}

#[test]
fn parts_smaller_than_a_cell_stay_bare() {
    let (mut p, mut t) = testing::cube(4);
    for at in [5.0, 6.0] {
        let (ball, triangles) = testing::ball(2);
        let first = p.len() as u32;
        p.extend(ball.iter().map(|p| *p * 0.01 + DVec3::splat(at)));
        t.extend(triangles.iter().map(|t| t.map(|v| v + first)));
    }
    let mesh = mend((p, t)).mesh;
    let filled = HoleFilling::fill_all(mesh.clone(), 0.2).unwrap();
    assert_eq!(said(&filled.notices), [(Code::ModelBare, 2)]);
    assert_eq!(filled.bare.iter().filter(|&&bare| bare).count(), 256);
    let none = HoleFilling::fill_all(mesh, 9.0).unwrap_err();
    assert_eq!(none.code, Code::ModelTooSmall);
}

#[test]
fn a_strip_much_narrower_than_a_cell_stays_bare() {
    let strip = |width: f64| {
        let (positions, triangles) = testing::flat(20);
        let narrow = positions
            .iter()
            .map(|p| DVec3::new(100.0 * p.x, p.y, width * p.z));
        HoleFilling::fill_all(testing::mesh((narrow.collect(), triangles)), 2.0)
    };
    assert_eq!(
        strip(0.05).expect_err("no surface").code,
        Code::ModelTooSmall
    );
    assert_eq!(strip(0.1).expect("a surface").notices, []);
    // The borders of holes that are closed do not count.
    let (positions, mut triangles) = testing::flat(120);
    let mut k = 0;
    triangles.retain(|_| {
        let [square, half] = [k / 2, k % 2];
        let is_inside = [square % 120, square / 120].map(|at| at % 2 == 1 && at < 119);
        k += 1;
        half == 1 || is_inside != [true, true]
    });
    let torn = testing::mesh((positions, triangles));
    assert_eq!(torn.borders().len(), 59 * 59 + 1);
    let filled = HoleFilling::fill_all(torn, 0.9).expect("a surface");
    assert_eq!(said(&filled.notices), [(Code::MendedHoles, 59 * 59)]);
}

/// All triangles of these surfaces lie on the border: each pass over its corners is cut into slices.
#[test]
fn a_long_border_takes_many_slices() {
    let length = 1 << 16;
    let strip = testing::grid(1, length, |u, v| DVec3::new(u, 0.0, -f64::from(length) * v));
    let dust = testing::apart(&strip);
    for (raw, borders) in [(strip, 1), (dust, 2 * length as usize)] {
        let mesh = testing::mesh(raw);
        assert_eq!(mesh.borders().len(), borders);
        let count = mesh.triangles().len();
        let mut filling = HoleFilling::new(mesh, 0.1);
        let mut slices = 1;
        let filled = loop {
            match filling.advance() {
                Some(filled) => break filled.expect("a surface"),
                None => slices += 1,
            }
        };
        assert_eq!(filled.notices, []);
        // Parts, their areas, edges, rings, keys, places and loops.
        assert!(slices > 7 * (count / SLICE), "{slices} slices");
    }
}

#[test]
fn a_patch_that_is_itself_small_is_not_closed() {
    let (p, t) = testing::flat(3);
    let mesh = mend((p, t)).mesh;
    let filled = HoleFilling::fill_all(mesh, 0.99).unwrap();
    assert_eq!((filled.notices, filled.mesh.borders().len()), (vec![], 1));
}
