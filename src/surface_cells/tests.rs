//! Cells on made-up meshes: properties that hold for all of them.

mod packed;
mod shapes;

use super::*;
use crate::field::CellKind;
use glam::DVec3;
use shapes::{ball, boxed, build, cells, check, on_ball, on_torus, patch, torus};

#[test]
fn squares_on_a_flat_square_are_the_squares() {
    let mesh = patch([25, 25], [false; 2], |u, v| {
        DVec3::new(10.0 * u, 10.0 * v, 0.0)
    });
    let at = |k: u32| {
        let (i, j) = (f64::from(k % 10), f64::from(k / 10));
        (DVec3::new(i + 0.5, j + 0.5, 0.0), DVec3::X)
    };
    let places: Vec<_> = (0..100).map(at).collect();
    let made = build(&mesh, cells(&mesh, &places, CellKind::Square, 1.0, 1.0));
    let figures = check("flat", &mesh, &made);
    assert_eq!(
        (figures.rings, figures.quads, made.elements.len()),
        (100, 1.0, 81)
    );
    assert!(figures.size_cv < 1e-6 && (figures.area - 1.0).abs() < 1e-6);
    assert_eq!((figures.holes, figures.overlaps), (0.0, 0.0));
    assert!(made.rings.iter().all(|ring| ring.len() == 4));
}

#[test]
fn a_row_of_cells_and_a_lone_one_are_covered() {
    for (count, width) in [(1, 1.0), (2, 1.0), (3, 0.4), (12, 1.0)] {
        let length = f64::from(count);
        let mesh = patch([5 * count, 5], [false; 2], |u, v| {
            DVec3::new(length * u, width * v, 0.0)
        });
        let at = |k: u32| (DVec3::new(f64::from(k) + 0.5, 0.5 * width, 0.0), DVec3::X);
        let places: Vec<_> = (0..count).map(at).collect();
        let made = build(&mesh, cells(&mesh, &places, CellKind::Square, 1.0, 1.0));
        let figures = check("row", &mesh, &made);
        assert_eq!(figures.rings, count as usize);
        assert!(made.elements.is_empty());
        assert!((figures.area - 1.0).abs() < 1e-6, "{count}: {figures:?}");
        assert_eq!((figures.holes, figures.overlaps), (0.0, 0.0));
    }
}

#[test]
fn rows_on_a_torus_close() {
    let mesh = torus(240, 80);
    let mut places = Vec::new();
    for j in 0..20 {
        for i in 0..60 {
            let [u, v] = [f64::from(i) / 60.0, (f64::from(j) + 0.3) / 20.0];
            places.push((on_torus(u, v), on_torus(u + 1e-3, v) - on_torus(u, v)));
        }
    }
    let made = build(&mesh, cells(&mesh, &places, CellKind::Square, 0.314, 1.0));
    let figures = check("torus", &mesh, &made);
    assert_eq!((figures.euler, figures.rings), (0, 1200));
    assert_eq!(figures.quads, 1.0);
    assert!(figures.holes < 0.002 && (figures.area - 1.0).abs() < 0.01);
}

#[test]
fn meshes_on_a_ball_are_balls() {
    let mesh = ball(40);
    for (count, kind) in [
        (1000, CellKind::Circle),
        (1000, CellKind::Square),
        (200, CellKind::Square),
        (40, CellKind::Circle),
        (12, CellKind::Square),
        (6, CellKind::Square),
        (4, CellKind::Circle),
    ] {
        let size = (4.0 * std::f64::consts::PI / f64::from(count)).sqrt();
        let places = on_ball(count, 0.1 * size);
        let made = build(&mesh, cells(&mesh, &places, kind, size, 1.0));
        let figures = check("ball", &mesh, &made);
        assert_eq!((figures.euler, figures.rings), (2, count as usize));
        // With four cells the triangles about their centres are far from their parts of the ball.
        assert!(
            count == 4 || figures.holes < 0.005 && figures.overlaps < 0.002,
            "{count}"
        );
    }
}

#[test]
fn stretched_cells_need_few_flips_and_close() {
    let mesh = ball(40);
    let size = (4.0 * std::f64::consts::PI / 800.0).sqrt();
    for kind in [CellKind::Rectangle, CellKind::Ellipse] {
        let made = build(&mesh, cells(&mesh, &on_ball(800, 0.1), kind, size, 2.0));
        let figures = check("stretched", &mesh, &made);
        assert_eq!(figures.euler, 2);
    }
}

#[test]
fn cells_on_a_thin_plate_stay_on_their_side() {
    let mesh = boxed([40, 40, 2], DVec3::new(4.0, 4.0, 0.05));
    let mut places = Vec::new();
    for z in [0.0, 0.05] {
        for k in 0..16 {
            let (i, j) = (f64::from(k % 4), f64::from(k / 4));
            places.push((DVec3::new(i + 0.5, j + 0.5, z), DVec3::X));
        }
    }
    let made = build(&mesh, cells(&mesh, &places, CellKind::Square, 1.0, 1.0));
    let figures = check("plate", &mesh, &made);
    assert_eq!((figures.euler, figures.rings), (2, 32));
    assert!(
        figures.holes < 0.01 && figures.overlaps < 0.01,
        "{figures:?}"
    );
}

#[test]
fn a_cube_is_covered_over_its_edges() {
    let mesh = boxed([20; 3], DVec3::splat(5.0));
    let mut places = Vec::new();
    for axis in 0..3 {
        for end in [0.0, 5.0] {
            for k in 0..25 {
                let (i, j) = (f64::from(k % 5) + 0.5, f64::from(k / 5) + 0.5);
                let mut p = DVec3::ZERO;
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                (p[axis], p[u], p[v]) = (end, i, j);
                let mut along = DVec3::ZERO;
                along[u] = 1.0;
                places.push((p, along));
            }
        }
    }
    let square = cells(&mesh, &places, CellKind::Square, 1.0, 1.0);
    for (join, straighten) in [(false, false), (false, true), (true, false)] {
        let polish = Polish { join, straighten };
        check(
            "cube",
            &mesh,
            &SurfaceMesh::build(&mesh, square.clone(), polish),
        );
    }
    let made = build(&mesh, square);
    let figures = check("cube", &mesh, &made);
    assert_eq!((figures.euler, figures.rings), (2, 150));
    assert!(
        (figures.area - 1.0).abs() < 0.01 && figures.size_cv < 0.02,
        "{figures:?}"
    );
    // Eight of the elements are triangles, at the corners of the box.
    assert_eq!(made.elements.len(), 150 - 2 + 4);
    assert!(figures.holes < 0.002);
}
