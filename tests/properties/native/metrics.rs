//! Metrics of arrangements that can be computed by hand.

use crate::common::{finished, recipe};
use crate::paving::OfPavement;
use bubblestone::cells::Cell;
use bubblestone::domain::{Domain, Outline};
use bubblestone::field::{CellKind, Direction, FieldBuilder, FieldParams, Fields};
use bubblestone::mesh::{Face, Mesh};
use bubblestone::metrics::{CellMetrics, MeshMetrics};
use bubblestone::packing::Particle;
use glam::DVec2;

fn p(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn rectangle(x: f64, y: f64, width: f64, height: f64) -> Vec<DVec2> {
    vec![
        p(x, y),
        p(x + width, y),
        p(x + width, y + height),
        p(x, y + height),
    ]
}

/// A square domain with a side of 40 units.
fn square() -> Domain {
    Domain::from_checked(&Outline {
        rings: vec![rectangle(0.0, 0.0, 40.0, 40.0)],
        ..Outline::default()
    })
}

/// Fields with one direction, in degrees.
fn fields(domain: &Domain, degrees: f64) -> Fields {
    let params = FieldParams {
        direction: Direction::Constant,
        angle: degrees.to_radians(),
        size: 10.0,
        side: 40.0,
        ..FieldParams::default()
    };
    FieldBuilder::build(domain, params)
}

fn cell(kind: CellKind, size: f64, aspect: f64, ring: Vec<DVec2>) -> Cell {
    Cell {
        id: 0,
        centre: ring.iter().sum::<DVec2>() / ring.len() as f64,
        kind,
        size,
        aspect,
        axis: DVec2::X,
        ring,
    }
}

fn checkers(size: f64) -> Vec<Cell> {
    let at = |k: u32| p(f64::from(k % 4), f64::from(k / 4)) * 10.0;
    (0..16)
        .map(|k| {
            cell(
                CellKind::Square,
                size,
                1.0,
                rectangle(at(k).x, at(k).y, 10.0, 10.0),
            )
        })
        .collect()
}

fn measured(cells: &[Cell], degrees: f64) -> CellMetrics {
    let domain = square();
    CellMetrics::new(&domain, &fields(&domain, degrees), cells)
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} is not {b}");
}

#[test]
fn squares_that_fill_the_outline() {
    let figures = measured(&checkers(10.0), 10.0);
    assert_eq!(figures.count, 16);
    near(figures.cover.coverage, 1.0);
    near(figures.cover.overlap, 0.0);
    near(figures.cover.outside, 0.0);
    near(figures.size_error, 0.0);
    near(figures.area_cv, 0.0);
    near(figures.small, 0.0);
    near(figures.edge_angle.unwrap(), 10.0);
    near(figures.aspect.unwrap(), 1.0);
    assert_eq!(figures.axis_angle, None);
    assert_eq!(figures.sides[4], 16);
    // With a wanted side of 8, the cells are larger by 100 / 64.
    near(measured(&checkers(8.0), 0.0).size_error, 100.0 / 64.0 - 1.0);
    near(measured(&checkers(10.0), -80.0).edge_angle.unwrap(), 10.0);
}

#[test]
fn gaps_overlaps_and_what_sticks_out() {
    let mut cells = checkers(10.0);
    // The last cell, in the corner, moves by 2.5 to the right and by 1 up.
    for corner in &mut cells[15].ring {
        *corner += p(2.5, -1.0);
    }
    let cover = measured(&cells, 0.0).cover;
    // In a domain of 1,600 units: it sticks out by 2.5 over its height, and overlaps the cell above by 1 along
    // 7.5. The rest is a gap.
    near(cover.outside, 25.0 / 1600.0);
    near(cover.overlap, 7.5 / 1600.0);
    near(cover.coverage, 1.0 - (100.0 - 7.5 * 9.0) / 1600.0);
    // One cell is there twice.
    let mut cells = checkers(10.0);
    cells.push(cells[5].clone());
    near(measured(&cells, 0.0).cover.overlap, 100.0 / 1600.0);
    near(measured(&cells[..8], 0.0).cover.coverage, 0.5);
    near(measured(&[], 0.0).cover.coverage, 0.0);
}

#[test]
fn on_a_torus_cells_go_on_at_the_other_side() {
    let torus = Domain::torus(40.0, &[]);
    let fields = fields(&torus, 0.0);
    let mut cells = checkers(10.0);
    // All cells move by 3 to the right and 4 up: no gap and no overlap results.
    for corner in cells.iter_mut().flat_map(|c| &mut c.ring) {
        *corner += p(3.0, -4.0);
    }
    let cover = CellMetrics::new(&torus, &fields, &cells).cover;
    near(cover.coverage, 1.0);
    near(cover.overlap, 0.0);
    near(cover.outside, 0.0);
    // The cell in the upper left corner moves by 1 to the left, over the last one of its row.
    for corner in &mut cells[0].ring {
        corner.x -= 1.0;
    }
    let cover = CellMetrics::new(&torus, &fields, &cells).cover;
    near(cover.coverage, 1.0 - 10.0 / 1600.0);
    near(cover.overlap, 10.0 / 1600.0);
    // The mesh of their centres has as many faces as nodes.
    let vertices: Vec<DVec2> = checkers(10.0).iter().map(|c| c.centre).collect();
    let quad = |k: u32| {
        let at = |x: u32, y: u32| x % 4 + y % 4 * 4;
        let (x, y) = (k % 4, k / 4);
        Face::quad([at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)])
    };
    let faces = (0..16).map(quad).collect();
    let mesh = Mesh {
        vertices,
        faces,
        ..Mesh::default()
    };
    let figures = MeshMetrics::new(&torus, &particles(&mesh.vertices, CellKind::Square), &mesh);
    near(figures.cover.coverage, 1.0);
    near(figures.cover.overlap, 0.0);
    assert_eq!(figures.valence[4], 16);
    assert_eq!(figures.quads_to_boundary, None);
}

#[test]
fn edges_that_cross_are_measured_well() {
    let diamond = |x: f64| vec![p(x, 10.0), p(x + 10.0, 20.0), p(x, 30.0), p(x - 10.0, 20.0)];
    let cells = [13.0, 23.0, 35.0].map(|x| cell(CellKind::Square, 14.0, 1.0, diamond(x)));
    let cover = measured(&cells, 0.0).cover;
    // Diamonds with a width and height of 10 and 8 are covered twice; one corner sticks out by 5.
    let (overlap, outside) = (50.0 + 32.0, 25.0);
    let covered = 600.0 - overlap - outside;
    assert!((cover.overlap - overlap / 1600.0).abs() < 1e-5, "{cover:?}");
    assert!((cover.outside - outside / 1600.0).abs() < 1e-5, "{cover:?}");
    assert!(
        (cover.coverage - covered / 1600.0).abs() < 1e-5,
        "{cover:?}"
    );
}

/// A hexagon of this width between its left and right sides, stretched along x.
fn hexagon(width: f64, aspect: f64) -> Vec<DVec2> {
    let stretch = p(aspect.sqrt(), 1.0 / aspect.sqrt());
    (0..6)
        .map(|k| {
            let t = f64::from(60 * k + 30).to_radians();
            let radius = width / 3.0_f64.sqrt();
            p(20.0, 20.0) + stretch * radius * p(libm::cos(t), libm::sin(t))
        })
        .collect()
}

#[test]
fn round_cells_are_measured_as_honeycombs() {
    for (kind, aspect) in [(CellKind::Circle, 1.0), (CellKind::Ellipse, 2.0)] {
        let cells = [cell(kind, 12.0, aspect, hexagon(12.0, aspect))];
        let along = measured(&cells, 0.0);
        near(along.size_error, 0.0);
        near(along.edge_angle.unwrap(), 0.0);
        near(along.aspect.unwrap(), aspect);
        assert_eq!(along.sides[6], 1);
        assert_eq!(along.axis_angle.is_some(), kind == CellKind::Ellipse);
    }
    let cells = [cell(CellKind::Circle, 12.0, 1.0, hexagon(12.0, 1.0))];
    near(measured(&cells, 30.0).edge_angle.unwrap(), 30.0);
    near(measured(&cells, 70.0).edge_angle.unwrap(), 10.0);
}

#[test]
fn long_cells_have_an_axis() {
    let ring = rectangle(10.0, 15.0, 20.0, 8.0);
    let cells = [cell(CellKind::Rectangle, 160.0_f64.sqrt(), 2.5, ring)];
    let figures = measured(&cells, 75.0);
    near(figures.size_error, 0.0);
    near(figures.aspect.unwrap(), 2.5);
    near(figures.axis_angle.unwrap(), 75.0);
    near(figures.edge_angle.unwrap(), 15.0);
}

#[test]
fn flat_corners_are_no_corners() {
    let mut ring = rectangle(10.0, 10.0, 20.0, 20.0);
    ring.insert(1, p(20.0, 9.0));
    assert_eq!(
        measured(&[cell(CellKind::Square, 20.0, 1.0, ring.clone())], 0.0).sides[5],
        1
    );
    // The side now bends by only 9.1 degrees.
    ring[1].y = 9.2;
    assert_eq!(
        measured(&[cell(CellKind::Square, 20.0, 1.0, ring)], 0.0).sides[4],
        1
    );
}

fn particles(vertices: &[DVec2], kind: CellKind) -> Vec<Particle> {
    let particle = |(&centre, id)| Particle {
        id,
        centre,
        kind,
        size: 10.0,
        aspect: 1.0,
        axis: DVec2::X,
        fixed: false,
    };
    vertices.iter().zip(0..).map(particle).collect()
}

#[test]
fn a_mesh_of_squares_one_of_them_dented() {
    let mut vertices: Vec<DVec2> = (0..25_u32)
        .map(|k| p(f64::from(k % 5), f64::from(k / 5)) * 10.0)
        .collect();
    // A corner of the outline moves inwards beyond the diagonal.
    vertices[24] = p(34.0, 34.0);
    let quad = |k: u32| Face::quad([k, k + 1, k + 6, k + 5]);
    let faces: Vec<Face> = (0..4)
        .flat_map(|y| (0..4).map(move |x| quad(5 * y + x)))
        .collect();
    let mesh = Mesh {
        vertices,
        faces,
        ..Mesh::default()
    };
    let domain = square();
    let figures = MeshMetrics::new(&domain, &particles(&mesh.vertices, CellKind::Square), &mesh);
    assert_eq!((figures.faces, figures.quads), (16, 1.0));
    let jacobian = figures.jacobian.unwrap();
    // The two sides at the tip of the dent are the vectors (6, -4) and (-4, 6).
    near(jacobian.min, (36.0 - 16.0) / -52.0);
    near(jacobian.mean, (15.0 + jacobian.min) / 16.0);
    assert_eq!(jacobian.not_positive, 1);
    near(figures.cover.coverage, 1.0 - 60.0 / 1600.0);
    near(figures.cover.outside, 0.0);
    assert_eq!(figures.valence[4], 9);
    assert_eq!(figures.valence.iter().sum::<usize>(), 9);
    assert_eq!(figures.ideal_valence, Some(1.0));
    near(figures.quads_to_boundary.unwrap(), 0.0);
    assert!(figures.triangles.is_none() && figures.triangles_to_boundary.is_none());
    let round = MeshMetrics::new(&domain, &particles(&mesh.vertices, CellKind::Circle), &mesh);
    assert_eq!(round.ideal_valence, Some(0.0));
}

#[test]
fn a_wheel_of_triangles_with_a_square_at_its_rim() {
    let mut vertices = vec![p(20.0, 20.0)];
    for k in 0..6 {
        let t = f64::from(60 * k).to_radians();
        vertices.push(p(20.0, 20.0) + 10.0 * p(libm::cos(t), libm::sin(t)));
    }
    let out = (vertices[2] - vertices[1]).perp();
    vertices.extend([vertices[1] - out, vertices[2] - out]);
    let mut faces: Vec<Face> = (1..=6).map(|k| Face::triangle([0, k, k % 6 + 1])).collect();
    faces.push(Face::quad([1, 7, 8, 2]));
    let mesh = Mesh {
        vertices,
        faces,
        ..Mesh::default()
    };
    let figures = MeshMetrics::new(
        &square(),
        &particles(&mesh.vertices, CellKind::Circle),
        &mesh,
    );
    near(figures.quads, 1.0 / 7.0);
    near(figures.jacobian.unwrap().min, 1.0);
    let quality = figures.triangles.unwrap();
    near(quality.mean, 1.0);
    near(quality.min, 1.0);
    assert_eq!(figures.valence[6], 1);
    assert_eq!(figures.ideal_valence, Some(1.0));
    // Every spoke is at 0, 30 or 60 degrees to the sides of the outline.
    assert!(figures.triangles_to_boundary.unwrap() <= 30.0);
    let nothing = MeshMetrics::new(&square(), &[], &Mesh::default());
    assert_eq!(
        (nothing.faces, nothing.quads, nothing.ideal_valence),
        (0, 0.0, None)
    );
}

/// While other particles move, the metrics are still those of the present cells.
#[test]
fn figures_are_of_the_packing_that_ended() {
    let mut studio = finished("size=128&cs=14&vs=0.2");
    let figures = studio.pavement().metrics();
    assert!(figures.is_some());
    studio.set_recipe(recipe("size=128&cs=14&vs=0.2&seed=9"));
    while studio.progress().steps < 3 {
        studio.tick(&mut || 0.0, 0.0, 1);
    }
    assert_eq!(studio.pavement().metrics(), figures);
}
