//! Tests of components from files.

use super::tests::{crossings, digest};
use super::*;
use crate::notice::Code;
use crate::trimesh::{Soup, testing};
use glam::DVec3;
use std::sync::Arc;

fn soup((positions, triangles): (Vec<DVec3>, Vec<[u32; 3]>)) -> Soup {
    Soup {
        positions,
        triangles,
    }
}

fn of_file(soup: Soup) -> Result<Original, ComponentFault> {
    let mut making = OriginalMaking::of_file(soup);
    let made = std::iter::from_fn(|| Some(making.advance(1_000))).find_map(|made| made);
    made.unwrap()
}

fn fault(soup: Soup) -> ComponentFault {
    of_file(soup).expect_err("a fault")
}

#[test]
fn a_files_mesh_becomes_a_component_with_variants() {
    let (positions, triangles) = testing::blob(4);
    let turned = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let made = Arc::new(of_file(soup((positions, turned))).unwrap());
    assert!(made.component.volume > 0.0);
    let variant = made.variant(1, 1);
    assert!(variant.volume > 0.0);
    assert_ne!(digest(&variant), digest(&made.component));
    assert_eq!(crossings(&variant.levels[0].mesh).pairs, 0);
}

#[test]
fn large_files_have_levels_of_detail() {
    let made = of_file(soup(testing::torus(160, 80, 0.4))).unwrap();
    let levels = &made.component.levels;
    let counts: Vec<usize> = levels.iter().map(|l| l.mesh.triangles().len()).collect();
    assert_eq!(counts[0], 25_600);
    assert!(
        counts.len() == 4 && counts[1] <= 3_000 && counts[2] <= 360 && counts[3] <= 130,
        "{counts:?}"
    );
    let variant = Arc::new(made).variant(1, 1);
    assert_eq!(variant.levels.len(), 3);
}

/// A ball around a place.
fn ball_at(by: DVec3) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let (positions, triangles) = testing::ball(3);
    (positions.iter().map(|p| *p + by).collect(), triangles)
}

#[test]
fn a_file_that_crosses_itself_is_refused_with_the_place() {
    let (mut positions, mut triangles) = ball_at(DVec3::ZERO);
    let (others, more) = ball_at(DVec3::new(0.9, 0.23, 0.11));
    let count = positions.len() as u32;
    positions.extend(others);
    triangles.extend(more.iter().map(|t| t.map(|v| v + count)));
    let ComponentFault::Crossing { pairs, at } = fault(soup((positions, triangles))) else {
        panic!("it crosses itself");
    };
    assert!(pairs > 20, "{pairs}");
    for centre in [DVec3::ZERO, DVec3::new(0.9, 0.23, 0.11)] {
        assert!((at.distance(centre) - 1.0).abs() < 0.05, "{at}");
    }
}

#[test]
fn cubes_that_overlap_on_a_lattice_cross() {
    let (mut positions, mut triangles) = testing::cube(1);
    let count = positions.len() as u32;
    positions.extend(positions.clone().iter().map(|p| *p + DVec3::splat(0.5)));
    triangles.extend(triangles.clone().iter().map(|t| t.map(|v| v + count)));
    let found = fault(soup((positions, triangles)));
    assert!(
        matches!(found, ComponentFault::Crossing { .. }),
        "{found:?}"
    );
}

#[test]
fn an_open_file_is_refused_with_its_edges() {
    let (positions, mut triangles) = testing::ball(3);
    triangles.pop();
    let found = fault(soup((positions, triangles)));
    assert_eq!(found, ComponentFault::Open { edges: 3 });
}

#[test]
fn thin_flat_empty_one_sided_and_broken_files_are_refused() {
    let (positions, triangles) = testing::cube(2);
    let scaled = |y: f64| {
        positions
            .iter()
            .map(|p| DVec3::new(p.x, p.y * y, p.z))
            .collect()
    };
    let found = fault(soup((scaled(1.0 / 300.0), triangles.clone())));
    assert!(
        matches!(found, ComponentFault::Thin { ratio } if ratio > 300.0),
        "{found:?}"
    );
    assert!(of_file(soup((scaled(1.0 / 100.0), triangles.clone()))).is_ok());

    // A cushion without filling: its two sides share their rim.
    let rim = [
        [1.0, 0.0, 1.0],
        [1.0, 0.0, -1.0],
        [-1.0, 0.0, -1.0],
        [-1.0, 0.0, 1.0],
    ];
    let mut places: Vec<DVec3> = rim.map(DVec3::from).into();
    places.extend([DVec3::new(0.2, 0.0, 0.0), DVec3::new(-0.2, 0.0, 0.1)]);
    let sides = (0..4).flat_map(|k| [[k, (k + 1) % 4, 4], [(k + 1) % 4, k, 5]]);
    assert_eq!(fault(soup((places, sides.collect()))), ComponentFault::Flat);

    assert_eq!(fault(Soup::default()), ComponentFault::Empty);

    let strip = testing::grid(24, 4, |u, v| {
        let (a, w) = (std::f64::consts::TAU * u, 0.3 * (v - 0.5));
        let r = 1.0 + w * libm::cos(0.5 * a);
        DVec3::new(r * libm::cos(a), w * libm::sin(0.5 * a), r * libm::sin(a))
    });
    assert_eq!(fault(soup(strip)), ComponentFault::OneSided);

    let mut broken = positions;
    broken[0].x = f64::NAN;
    let ComponentFault::Broken(notice) = fault(soup((broken, triangles))) else {
        panic!("a number is missing");
    };
    assert_eq!(notice.code, Code::ModelNotFinite);
}
