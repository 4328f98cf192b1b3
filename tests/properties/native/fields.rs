//! Fields: directions, sizes, and singular points.

use crate::paving::row;
use bubblestone::domain::{Domain, Outline};
use bubblestone::field::{
    CellKind, Direction, FieldBuilder, FieldParams, Fields, Grading, SoftSpot,
};
use bubblestone::generators::pavement::{self, PavementRecipe, keys};
use glam::DVec2;

const SIDE: f64 = 512.0;

fn at(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn unit(t: f64) -> DVec2 {
    at(libm::cos(t), libm::sin(t))
}

fn ring(n: usize, r: f64, sense: f64) -> Vec<DVec2> {
    (0..n)
        .map(|k| {
            let t = sense * k as f64 / n as f64 * std::f64::consts::TAU;
            DVec2::splat(256.0) + r * unit(t)
        })
        .collect()
}

fn domain(outer: Vec<DVec2>, holes: Vec<Vec<DVec2>>, lines: Vec<Vec<DVec2>>) -> Domain {
    let rings = std::iter::once(outer).chain(holes).collect();
    Domain::from_checked(&Outline { rings, lines })
}

fn picture() -> Domain {
    let (a, b) = (6.0, 506.0);
    domain(vec![at(a, a), at(b, a), at(b, b), at(a, b)], vec![], vec![])
}

fn params(direction: Direction, kind: CellKind) -> FieldParams {
    FieldParams {
        direction,
        kind,
        size: 20.0,
        aspect: if kind.is_stretched() { 2.0 } else { 1.0 },
        ..FieldParams::default()
    }
}

/// The sine of the angle between the field and a direction, up to the symmetry of the cell.
fn off(fields: &Fields, p: DVec2, wanted: DVec2) -> f64 {
    let e = fields.direction(p);
    match fields.kind(p).symmetry() {
        4 => e.dot(wanted).abs().min(e.perp_dot(wanted).abs()),
        _ => e.perp_dot(wanted).abs(),
    }
}

#[test]
fn an_annulus_is_followed_round() {
    let annulus = domain(ring(128, 232.0, 1.0), vec![ring(96, 104.0, -1.0)], vec![]);
    for kind in [CellKind::Square, CellKind::Ellipse] {
        let fields = FieldBuilder::build(&annulus, params(Direction::Boundary, kind));
        for k in 0..200 {
            let radial = unit(f64::from(k) * 0.37);
            let p = DVec2::splat(256.0) + (110.0 + f64::from(k % 6) * 23.0) * radial;
            let off = off(&fields, p, radial.perp());
            assert!(off < 0.03, "{kind:?} {k}: {off}");
        }
    }
}

#[test]
fn the_direction_does_not_depend_on_how_a_side_is_cut() {
    let corners = [at(40., 40.), at(470., 60.), at(400., 460.), at(60., 300.)];
    let mut fine = Vec::new();
    for k in 0..4 {
        for i in 0..50 {
            fine.push(corners[k].lerp(corners[(k + 1) % 4], f64::from(i) / 50.0));
        }
    }
    let build = |outer| {
        let domain = domain(outer, vec![], vec![]);
        FieldBuilder::build(&domain, params(Direction::Boundary, CellKind::Square))
    };
    let (a, b) = (build(corners.to_vec()), build(fine));
    for k in 0..100 {
        let q = at(100.0 + f64::from(k) * 2.5, 130.0 + f64::from(k * 17 % 100));
        let off = off(&a, q, b.direction(q));
        assert!(off < 0.004, "{q}: {off}");
    }
}

#[test]
fn rows_turn_about_a_point() {
    for (angle, kind) in [
        (0.0, CellKind::Square),
        (0.0, CellKind::Ellipse),
        (0.6, CellKind::Ellipse),
        (std::f64::consts::FRAC_PI_2, CellKind::Rectangle),
    ] {
        let centre = at(200.0, 300.0);
        let mut params = params(Direction::Spiral, kind);
        (params.angle, params.centre) = (angle, centre);
        let fields = FieldBuilder::build(&picture(), params);
        for k in 0..200 {
            let p = at(f64::from(k * 37 % 500) + 7.0, f64::from(k * 91 % 500) + 7.0);
            if p.distance(centre) > 40.0 {
                let wanted = unit(angle).rotate((p - centre).normalize());
                let off = off(&fields, p, wanted);
                assert!(off < 0.02, "{angle} {kind:?} {p}: {off}");
            }
        }
        let points = fields.singularities(&picture());
        assert_eq!(points.len(), 1, "{points:?}");
        assert_eq!(points[0].index, 1.0);
        assert!(points[0].point.distance(centre) < 10.0, "{points:?}");
    }
}

#[test]
fn strokes_are_followed_near_them_and_the_base_far_from_them() {
    let mut params = params(Direction::Constant, CellKind::Rectangle);
    params.strokes = vec![vec![at(100., 100.), at(300., 300.)]];
    params.reach = 50.0;
    let fields = FieldBuilder::build(&picture(), params.clone());
    assert!(off(&fields, at(205., 195.), unit(std::f64::consts::FRAC_PI_4)) < 0.01);
    assert!(off(&fields, at(480., 60.), DVec2::X) < 0.05);
    // With strokes alone, the direction is the same far away.
    params.direction = Direction::Strokes;
    let fields = FieldBuilder::build(&picture(), params.clone());
    assert!(off(&fields, at(480., 60.), unit(std::f64::consts::FRAC_PI_4)) < 0.01);
    // Without strokes, the angle is constant.
    params.strokes.clear();
    params.angle = 0.3;
    let fields = FieldBuilder::build(&picture(), params);
    assert!(off(&fields, at(480., 60.), unit(0.3)) < 1e-12);
}

#[test]
fn constraint_lines_count_as_the_boundary_does() {
    let line = vec![at(150., 120.), at(330., 380.)];
    let along = (line[1] - line[0]).normalize();
    let outline = picture().rings()[0].clone();
    let with_line = domain(outline, vec![], vec![line]);
    let fields = FieldBuilder::build(&with_line, params(Direction::Boundary, CellKind::Square));
    for p in [at(245., 250.), at(200., 200.), at(270., 280.)] {
        let off = off(&fields, p, along);
        assert!(off < 0.02, "{p}: {off}");
    }
}

#[test]
fn the_ends_of_a_road_do_not_turn_stretched_cells() {
    let road = domain(
        vec![at(20., 180.), at(490., 180.), at(490., 320.), at(20., 320.)],
        vec![],
        vec![],
    );
    let mut params = params(Direction::Boundary, CellKind::Ellipse);
    let fields = FieldBuilder::build(&road, params.clone());
    let end = at(30., 250.);
    for p in [end, at(20.5, 250.), at(489., 200.), at(489.5, 319.)] {
        assert!(off(&fields, p, DVec2::X) < 1e-6, "{p}");
    }
    params.ends = 1.0;
    let fields = FieldBuilder::build(&road, params);
    assert!(off(&fields, end, DVec2::Y) < 1e-3);
}

#[test]
fn singular_points_of_a_disc_and_a_triangle() {
    let disc = domain(ring(200, 230.0, 1.0), vec![], vec![]);
    for kind in [CellKind::Square, CellKind::Ellipse] {
        let fields = FieldBuilder::build(&disc, params(Direction::Boundary, kind));
        let points = fields.singularities(&disc);
        // The polygon's symmetry may cause several singular points, but their indices add up to one.
        let turns: f64 = points.iter().map(|s| s.index).sum();
        assert_eq!(turns, 1.0, "{kind:?} {points:?}");
    }
    // Squares in a triangle: each of the three corners of 60 degrees counts as a quarter turn.
    let triangle = domain(ring(3, 240.0, 1.0), vec![], vec![]);
    let fields = FieldBuilder::build(&triangle, params(Direction::Boundary, CellKind::Square));
    let points = fields.singularities(&triangle);
    assert_eq!(points.len(), 1, "{points:?}");
    assert_eq!(points[0].index, 0.25);
    assert!(points[0].point.distance(DVec2::splat(256.0)) < 8.0);
    // A square has no singular points.
    let square = picture();
    for kind in [CellKind::Square, CellKind::Ellipse] {
        let fields = FieldBuilder::build(&square, params(Direction::Boundary, kind));
        let points = fields.singularities(&square);
        assert!(points.is_empty(), "{kind:?} {points:?}");
    }
}

#[test]
fn sizes_grow_from_the_boundary_and_in_spots() {
    let mut params = params(Direction::Constant, CellKind::Ellipse);
    params.size_grading = Grading {
        factor: 0.25,
        reach: 200.0,
    };
    params.size_spots = vec![SoftSpot {
        centre: at(256., 256.),
        radius: 50.0,
        value: 2.0,
    }];
    params.aspect_grading = Grading {
        factor: 2.0,
        reach: 100.0,
    };
    params.aspect_spots = vec![SoftSpot {
        centre: at(256., 256.),
        radius: 50.0,
        value: 1.0,
    }];
    let fields = FieldBuilder::build(&picture(), params);
    let near = |a: f64, b: f64| assert!((a - b).abs() < 0.02 * b, "{a} for {b}");
    near(fields.size(at(6., 256.)), 5.0);
    near(fields.size(at(106., 256.)), 10.0);
    near(fields.size(at(256., 256.)), 40.0);
    near(fields.size(at(206., 256.)), 20.0);
    near(fields.aspect(at(6., 256.)), 4.0);
    near(fields.aspect(at(150., 256.)), 2.0);
    near(fields.aspect(at(256., 256.)), 1.0);
    // The size changes by less than one unit per unit of length everywhere.
    for k in 0..4000 {
        let p = at(f64::from(k % 63) * 8.0 + 6.0, f64::from(k / 63) * 7.9 + 6.0);
        let change = fields.size(p + DVec2::X) - fields.size(p);
        assert!(change.abs() < 1.0, "{p}: {change}");
    }
}

#[test]
fn parts_have_kinds_and_directions_of_their_own() {
    let outline = picture().rings()[0].clone();
    let cut = domain(outline, vec![], vec![vec![at(0., 200.), at(512., 300.)]]);
    assert_eq!(cut.parts(), 2);
    let mut params = params(Direction::Boundary, CellKind::Square);
    params.aspect = 2.0;
    // If two places are in one part, the later one counts. A place outside the outline belongs to no part.
    params.part_kinds = vec![
        (at(300., 400.), CellKind::Circle),
        (at(250., 400.), CellKind::Ellipse),
        (at(250., -9.), CellKind::Rectangle),
    ];
    let fields = FieldBuilder::build(&cut, params);
    assert_eq!(fields.kind(at(250., 100.)), CellKind::Square);
    assert_eq!(fields.kind(at(250., 400.)), CellKind::Ellipse);
    assert_eq!(fields.aspect(at(250., 100.)), 1.0);
    assert_eq!(fields.aspect(at(250., 400.)), 2.0);
    // Squares stand alike at both walls, which meet at right angles; ellipses follow the nearest wall.
    assert!(off(&fields, at(12., 400.), DVec2::Y) < 0.05);
    assert!(off(&fields, at(250., 490.), DVec2::X) < 0.05);
}

#[test]
fn a_torus_has_no_seam() {
    let line = vec![at(100., 40.), at(180., 30.), at(300., 90.)];
    for (direction, lines) in [
        (Direction::Boundary, vec![line.clone()]),
        (Direction::Spiral, vec![]),
        (Direction::Strokes, vec![]),
        (Direction::Printed, vec![]),
    ] {
        let torus = Domain::torus(SIDE, &lines);
        let mut params = params(direction, CellKind::Ellipse);
        params.strokes = vec![vec![at(480., 300.), at(500., 350.)]];
        params.linear = at(0.4, -0.3);
        params.radial = 0.2;
        params.size_spots = vec![SoftSpot {
            centre: at(500., 20.),
            radius: 90.0,
            value: 0.4,
        }];
        params.aspect_spots = vec![SoftSpot {
            centre: at(10., 200.),
            radius: 80.0,
            value: 4.0,
        }];
        let fields = FieldBuilder::build(&torus, params);
        for k in 0..100 {
            let t = f64::from(k) * 5.12;
            for (a, b) in [
                (at(1e-7, t), at(SIDE - 1e-7, t)),
                (at(t, 1e-7), at(t, SIDE - 1e-7)),
            ] {
                assert!((fields.size(a) - fields.size(b)).abs() < 1e-5, "{a}");
                assert!((fields.aspect(a) - fields.aspect(b)).abs() < 1e-5, "{a}");
                let off = off(&fields, a, fields.direction(b));
                assert!(off < 1e-5, "{direction:?} {a}: {off}");
            }
            let p = at(t, 3.0 * t);
            let change = fields.size(p) - fields.size(p - at(SIDE, 0.0));
            assert!(change.abs() < 1e-9, "{p}: {change}");
        }
        let turns: f64 = fields.singularities(&torus).iter().map(|s| s.index).sum();
        assert_eq!(turns, 0.0, "{direction:?}");
    }
}

#[test]
fn sizes_on_a_torus_fit_a_whole_number_of_times() {
    let torus = Domain::torus(SIDE, &[]);
    let mut params = params(Direction::Constant, CellKind::Square);
    params.size = 23.0;
    let fields = FieldBuilder::build(&torus, params.clone());
    assert_eq!(fields.size(at(3., 7.)), SIDE / 22.0);
    params.angle = 0.3;
    let fields = FieldBuilder::build(&torus, params);
    let across = fields.direction(DVec2::ZERO) * SIDE / fields.size(DVec2::ZERO);
    assert!((across - across.round()).length() < 1e-9, "{across}");
}

#[test]
fn every_built_in_outline_has_directions_throughout() {
    for choice in row(keys::OUTLINE).choices {
        let recipe = pavement::recipe(&format!("outline={}", choice.word)).0;
        let domain = Domain::from_checked(&recipe.outline());
        for kind in [CellKind::Square, CellKind::Ellipse] {
            let fields = FieldBuilder::build(&domain, params(Direction::Boundary, kind));
            let mut without = 0;
            for k in 0..10_000 {
                let p = at(f64::from(k % 100) * 5.12, f64::from(k / 100) * 5.12);
                if domain.contains(p) && fields.direction(p) == DVec2::ZERO {
                    without += 1;
                }
            }
            // Two-fold directions cancel on lines at 45 degrees, and some of these points lie there.
            assert!(without < 20, "{} {kind:?}: {without}", choice.word);
        }
    }
}
