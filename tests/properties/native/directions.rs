//! The direction at a point: equation (1) as printed beside our sum, and the index of a walk.

use bubblestone::domain::{Domain, Outline};
use bubblestone::field::{
    Direction, FieldBuilder, FieldParams, Fields, printed_sum, printed_terms,
};
use bubblestone::generators::ALL;
use glam::DVec2;
use std::f64::consts::TAU;

fn domain(ring: Vec<DVec2>) -> Domain {
    Domain::from_checked(&Outline {
        rings: vec![ring],
        ..Outline::default()
    })
}

fn fields(domain: &Domain) -> Fields {
    FieldBuilder::build(domain, FieldParams::default())
}

/// The corners with the first side cut into pieces of the same length.
fn cut(corners: &[DVec2], pieces: u32) -> Vec<DVec2> {
    let (first, second) = (corners[0], corners[1]);
    let cuts = (0..pieces).map(|k| first.lerp(second, f64::from(k) / f64::from(pieces)));
    cuts.chain(corners[1..].iter().copied()).collect()
}

/// A road five times as long as wide.
fn road() -> Vec<DVec2> {
    let corners = [(56.0, 216.0), (456.0, 216.0), (456.0, 296.0), (56.0, 296.0)];
    corners.map(DVec2::from).to_vec()
}

/// Four sides with four directions.
fn skew() -> Vec<DVec2> {
    let corners = [(60.0, 120.0), (450.0, 60.0), (400.0, 320.0), (130.0, 430.0)];
    corners.map(DVec2::from).to_vec()
}

fn circle(radius: f64, points: u32) -> Vec<DVec2> {
    let at = |k: u32| {
        let turn = TAU * f64::from(k) / f64::from(points);
        DVec2::splat(256.0) + radius * DVec2::new(libm::cos(turn), libm::sin(turn))
    };
    (0..points).map(at).collect()
}

/// Places all over the inside, at least `depth` from the boundary.
fn inside(domain: &Domain, depth: f64) -> Vec<DVec2> {
    let places = (0..32 * 32).map(|k| 16.0 * DVec2::new(f64::from(k % 32), f64::from(k / 32)));
    let is_inside = |p: &DVec2| domain.nearest(*p).distance > depth;
    places.filter(is_inside).collect()
}

/// The angle between two directions of squares, in degrees.
fn apart(a: DVec2, b: DVec2) -> f64 {
    let turn = libm::atan2(a.perp_dot(b), a.dot(b)).to_degrees();
    (turn - 90.0 * (turn / 90.0).round()).abs()
}

#[test]
fn the_printed_sum_vanishes_in_the_middle_of_a_road() {
    let road = domain(road());
    assert!(printed_sum(&road, DVec2::splat(256.0)).length() < 1e-12);
    for k in 0..=200 {
        let place = DVec2::new(156.0 + f64::from(k), 256.0);
        let terms = printed_terms(&road, place);
        assert_eq!(terms.len(), 4);
        let vectors = terms.iter().map(|term| term.vector);
        let sum = printed_sum(&road, place);
        assert!(vectors.clone().sum::<DVec2>().distance(sum) < 1e-12);
        let lengths: f64 = vectors.map(DVec2::length).sum();
        assert!(sum.length() < 0.02 * lengths, "{place}");
    }
    // Our sum is certain there.
    let ours = fields(&road).direction_sum(&road, DVec2::splat(256.0));
    assert!(apart(ours.direction, DVec2::X) < 1e-6 && ours.certainty > 0.999);
}

#[test]
fn pieces_of_a_side_change_the_printed_direction_and_not_ours() {
    for corners in [road(), skew()] {
        let (whole, pieces) = (domain(cut(&corners, 1)), domain(cut(&corners, 10)));
        assert_eq!(pieces.segments().len(), whole.segments().len() + 9);
        let both = [fields(&whole), fields(&pieces)];
        let mut printed_turns = 0.0_f64;
        for p in inside(&whole, 20.0) {
            let [a, b] = [&whole, &pieces].map(|domain| printed_sum(domain, p));
            printed_turns = printed_turns.max(a.angle_to(b).to_degrees().abs());
            let sums = [
                both[0].direction_sum(&whole, p),
                both[1].direction_sum(&pieces, p),
            ];
            if sums[0].certainty < 0.1 {
                continue;
            }
            let turn = apart(sums[0].direction, sums[1].direction);
            assert!(turn < 0.5, "{p}: {turn}");
            let turn = apart(both[0].direction(p), both[1].direction(p));
            assert!(turn < 0.5, "{p}, sampled: {turn}");
        }
        assert!(printed_turns > 20.0, "{printed_turns}");
    }
}

#[test]
fn the_sampled_direction_is_that_of_the_sum() {
    let base = |direction| FieldParams {
        direction,
        angle: 0.3,
        strokes: vec![vec![DVec2::new(100.0, 200.0), DVec2::new(300.0, 260.0)]],
        ..FieldParams::default()
    };
    let skew = domain(skew());
    for direction in [
        Direction::Boundary,
        Direction::Strokes,
        Direction::Constant,
        Direction::Spiral,
    ] {
        let fields = FieldBuilder::build(&skew, base(direction));
        for p in inside(&skew, 8.0) {
            let sum = fields.direction_sum(&skew, p);
            assert!((0.0..=1.0 + 1e-12).contains(&sum.certainty));
            let turn = apart(sum.direction, fields.direction(p));
            assert!(sum.certainty < 0.5 || turn < 1.5, "{direction:?} {p}: {turn}");
        }
    }
    // Beside the printed sum stands that of the boundary.
    let printed = FieldBuilder::build(&skew, base(Direction::Printed));
    let boundary = FieldBuilder::build(&skew, base(Direction::Boundary));
    let place = DVec2::new(250.0, 200.0);
    let sums = [printed, boundary].map(|fields| fields.direction_sum(&skew, place));
    assert_eq!(sums[0], sums[1]);
}

#[test]
fn a_walk_around_all_singular_points_of_a_disc_counts_four_quarter_turns() {
    let disc = domain(circle(200.0, 96));
    let fields = fields(&disc);
    let points = fields.singularities(&disc);
    let whole: f64 = points.iter().map(|point| point.index).sum();
    assert_eq!(whole, 1.0, "{points:?}");
    let turns = fields.turns(&circle(160.0, 24));
    assert_eq!(turns.len(), 25);
    assert_eq!((turns[0], turns[24]), (0.0, 1.0));
    // It turns evenly: by symmetry, half of it on half the way.
    assert!((turns[12] - 0.5).abs() < 0.01, "{turns:?}");
    let back: Vec<DVec2> = circle(160.0, 24).into_iter().rev().collect();
    assert_eq!(fields.turns(&back)[24], -1.0);
    // A walk around one of them has its index.
    for point in &points {
        let middle = DVec2::splat(256.0);
        let small = circle(24.0, 12);
        let around: Vec<DVec2> = small.iter().map(|p| *p - middle + point.point).collect();
        assert_eq!(fields.turns(&around).last(), Some(&point.index));
    }
}

#[test]
fn a_ring_turns_once_around_its_hole_and_a_square_never() {
    let of = |link: &str| {
        let domain = Domain::from_checked(&ALL.recipe(link).0.outline());
        let fields = fields(&domain);
        let walk: Vec<DVec2> = circle(150.0, 24);
        fields.turns(&walk).last().copied()
    };
    assert_eq!(of("outline=annulus"), Some(1.0));
    assert_eq!(of("outline=square"), Some(0.0));
}

#[test]
fn walks_without_an_index_have_no_turns() {
    let square = domain(vec![
        DVec2::new(100.0, 100.0),
        DVec2::new(400.0, 100.0),
        DVec2::new(400.0, 400.0),
        DVec2::new(100.0, 400.0),
    ]);
    let fields = fields(&square);
    // Far outside there is no direction.
    assert_eq!(fields.turns(&circle(240.0, 8)), []);
    assert_eq!(fields.turns(&[]), [0.0]);
    assert_eq!(fields.turns(&[DVec2::splat(250.0)]), [0.0, 0.0]);
    let constant = FieldParams {
        direction: Direction::Constant,
        ..FieldParams::default()
    };
    let constant = FieldBuilder::build(&square, constant);
    assert_eq!(constant.turns(&circle(100.0, 3)), [0.0; 4]);
}
