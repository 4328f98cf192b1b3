//! The whole chain, from meshes to figures: what must hold of cells on all surfaces.

mod chain;
mod files;

use crate::field::Kind;
use crate::shapes::Shape;
use chain::{Asked, Body, Whole, by_rule, fit};

/// What must hold wherever cells fit, and of their connections everywhere.
fn check(body: &Body, asked: Asked) -> Whole {
    let whole = body.whole(asked);
    let (figures, fields) = (&whole.figures, &whole.fields);
    let what = format!("{} {asked:?} {figures:?}", body.name);
    let euler = body.mesh.euler();
    let index = fields.index_sum() + fields.border_index();
    assert!((index - euler as f64).abs() < 1e-9, "{index} {what}");
    if body.mesh.borders().is_empty() {
        assert_eq!(fields.border_index(), 0.0, "{what}");
    }
    assert_eq!((figures.euler, figures.doubled), (euler, 0), "{what}");
    assert_eq!(figures.rings, figures.cells, "{what}");
    assert!(whole.report.converged, "{what}");
    let told = fit(fields).notices().map_or(true, |told| !told.is_empty());
    let most = if told { 0.01 } else { 0.005 };
    assert!(figures.holes <= most && figures.overlaps <= most, "{what}");
    if told {
        return whole;
    }
    // A round cell of the size asked for has a polygon of less than its square.
    let least = 0.93 * cell_area(asked.kind).sqrt();
    assert!((least..=1.03).contains(&figures.size), "{what}");
    assert!((0.97..=1.03).contains(&figures.area), "{what}");
    if asked.kind == Kind::Square {
        assert!(figures.size_cv < 0.09, "{what}");
    }
    if asked.kind.has_corners() {
        assert!(figures.quads >= 0.92, "{what}");
    }
    whole
}

/// The area of a cell of size 1 in a dense packing.
fn cell_area(kind: Kind) -> f64 {
    if kind.has_corners() { 1.0 } else { 0.866 }
}

fn all(kind: Kind, aspect: f64, cells: f64) {
    let asked = Asked {
        kind,
        aspect,
        cells,
    };
    for shape in Shape::ALL {
        check(&by_rule(shape), asked);
    }
    for (name, soup) in files::all() {
        check(&chain::from_file(name, soup, asked), asked);
    }
}

#[test]
fn squares_lie_well_on_all_surfaces() {
    all(Kind::Square, 1.0, 900.0);
}

#[test]
fn rectangles_lie_well_on_all_surfaces() {
    all(Kind::Rectangle, 2.0, 500.0);
}

#[test]
fn circles_lie_well_on_all_surfaces() {
    all(Kind::Circle, 1.0, 500.0);
}

#[test]
fn ellipses_lie_well_on_all_surfaces() {
    all(Kind::Ellipse, 2.0, 500.0);
}

#[test]
fn squares_on_a_flat_square_are_all_alike() {
    let asked = Asked {
        kind: Kind::Square,
        aspect: 1.0,
        cells: 900.0,
    };
    let whole = check(&chain::from_file("flat", files::flat(), asked), asked);
    assert_eq!(whole.figures.cells, 900);
    assert!(whole.figures.size_cv < 0.01, "{:?}", whole.figures);
    assert!(whole.figures.quads >= 0.99, "{:?}", whole.figures);
}

#[test]
fn a_turn_and_another_scale_change_few_cells() {
    let asked = Asked {
        kind: Kind::Square,
        aspect: 1.0,
        cells: 600.0,
    };
    let body = by_rule(Shape::Leg);
    let count = |body: &Body| body.whole(asked).figures.cells as f64;
    let plain = count(&body);
    for (scale, angle) in [(10.0, 0.0), (1.0, 1.0), (1e-3, 2.5)] {
        let found = count(&body.moved(scale, angle));
        assert!((found / plain - 1.0).abs() <= 0.01, "{found} {plain}");
    }
}

#[test]
fn walls_thinner_than_a_cell_have_few_holes() {
    for (kind, cells, share, most) in [
        (Kind::Square, 800.0, 0.1, 0.01),
        (Kind::Square, 800.0, 0.25, 0.015),
        (Kind::Square, 250.0, 0.25, 0.01),
        (Kind::Circle, 800.0, 0.25, 0.01),
        (Kind::Rectangle, 800.0, 0.5, 0.01),
    ] {
        let asked = Asked {
            kind,
            aspect: if kind.is_stretched() { 2.0 } else { 1.0 },
            cells,
        };
        let size = (4.0 * std::f64::consts::PI / cells).sqrt();
        let body = chain::from_file("wall", files::wall(share * size), asked);
        let figures = body.whole(asked).figures;
        assert!(figures.holes <= most, "{share} {asked:?} {figures:?}");
        assert_eq!((figures.euler, figures.doubled), (0, 0));
    }
}
