//! The direction at a point: equation (1) as printed beside our sum, and the index of a walk.

use bubblestone::domain::{Domain, Outline};
use bubblestone::field::{Direction, FieldBuilder, FieldParams, Fields, printed_sum};
use bubblestone::generators::ALL;
use bubblestone::generators::pavement::PavementRecipe;
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
    let fields = fields(&road);
    assert!(printed_sum(&road, DVec2::splat(256.0)).length() < 1e-12);
    for k in 0..=200 {
        let place = DVec2::new(156.0 + f64::from(k), 256.0);
        let terms = fields.segment_terms(&road, place);
        assert_eq!(terms.len(), 4);
        assert_eq!((terms[0].distance, terms[2].distance), (40.0, 40.0));
        let vectors = terms.iter().map(|term| term.printed);
        let sum = printed_sum(&road, place);
        assert!(vectors.clone().sum::<DVec2>().distance(sum) < 1e-12);
        let lengths: f64 = vectors.map(DVec2::length).sum();
        assert!(sum.length() < 0.02 * lengths, "{place}");
        // Our sum is certain there, and is that of its terms.
        let ours = fields.direction_sum(&road, place);
        assert!(apart(ours.direction, DVec2::X) < 1e-9 && ours.certainty > 1.0 - 1e-9);
        let turned: DVec2 = terms.iter().map(|term| term.turned).sum();
        assert!(turned.distance(DVec2::X) < 1e-9, "{turned}");
    }
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
            let turn = libm::atan2(a.perp_dot(b), a.dot(b)).to_degrees();
            printed_turns = printed_turns.max(turn.abs());
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
        let (mut turns, mut most) = (Vec::new(), 0.0_f64);
        for p in inside(&skew, 8.0) {
            let sum = fields.direction_sum(&skew, p);
            assert!((0.0..=1.0 + 1e-12).contains(&sum.certainty));
            if sum.certainty > 0.5 {
                let turn = apart(sum.direction, fields.direction(p));
                turns.push(turn);
                most = most.max(turn);
                if turn > 1.0 {
                    println!("{p} {turn} {}", sum.certainty);
                }
            }
        }
        let mean = turns.iter().sum::<f64>() / turns.len() as f64;
        assert!(mean < 0.3 && most < 8.0, "{direction:?}: {mean}, {most}");
    }
    // Beside the printed sum stands that of the boundary.
    let printed = FieldBuilder::build(&skew, base(Direction::Printed));
    let boundary = FieldBuilder::build(&skew, base(Direction::Boundary));
    let place = DVec2::new(250.0, 200.0);
    let sums = [printed, boundary].map(|fields| fields.direction_sum(&skew, place));
    assert_eq!(sums[0], sums[1]);
}

#[test]
fn directions_that_cancel_are_certain_to_nothing() {
    // Lines halfway between 10 and 80 degrees point to 0 or 90; halfway between 10 and 55 nothing is left.
    let square = domain(cut(&circle(240.0, 4), 1));
    let stroke = |middle: DVec2, degrees: f64| {
        let turn = degrees.to_radians();
        let half = 30.0 * DVec2::new(libm::cos(turn), libm::sin(turn));
        vec![middle - half, middle + half]
    };
    let between = |first, second| {
        let params = FieldParams {
            direction: Direction::Strokes,
            strokes: vec![
                stroke(DVec2::new(196.0, 316.0), first),
                stroke(DVec2::new(316.0, 196.0), second),
            ],
            ..FieldParams::default()
        };
        FieldBuilder::build(&square, params).direction_sum(&square, DVec2::splat(256.0))
    };
    let sum = between(10.0, 80.0);
    assert!(apart(sum.direction, DVec2::X) < 1e-9, "{sum:?}");
    assert!((0.7..0.8).contains(&sum.certainty), "{sum:?}");
    assert!(between(10.0, 55.0).certainty < 0.1);
    let disc = domain(circle(200.0, 96));
    let middle = fields(&disc).direction_sum(&disc, DVec2::splat(256.0));
    assert!(middle.certainty < 1e-12, "{middle:?}");
}

/// The turns of the direction along a walk.
fn turns(domain: &Domain, walk: &[DVec2]) -> Vec<f64> {
    let places = fields(domain).along_walk(domain, walk);
    places.iter().map(|place| place.turns).collect()
}

#[test]
fn a_walk_around_all_singular_points_of_a_disc_counts_four_quarter_turns() {
    let disc = domain(circle(200.0, 96));
    let points = fields(&disc).singularities(&disc);
    let whole: f64 = points.iter().map(|point| point.index).sum();
    assert_eq!(whole, 1.0, "{points:?}");
    let walk = circle(160.0, 24);
    let places = fields(&disc).along_walk(&disc, &walk);
    assert_eq!(places.len(), 25);
    assert_eq!((places[0].turns, places[24].turns), (0.0, 1.0));
    assert_eq!(places[0].sum, places[24].sum);
    for (place, at) in places.iter().zip(&walk) {
        assert_eq!(place.sum, fields(&disc).direction_sum(&disc, *at));
    }
    // It turns evenly: by symmetry, half of it on half the way.
    assert!((places[12].turns - 0.5).abs() < 1e-9, "{places:?}");
    let back: Vec<DVec2> = walk.into_iter().rev().collect();
    assert_eq!(turns(&disc, &back)[24], -1.0);
    // Beside the middle nothing is counted.
    let beside = circle(50.0, 72)
        .into_iter()
        .map(|p| p + DVec2::new(110.0, 0.0));
    assert_eq!(turns(&disc, &beside.collect::<Vec<_>>())[72], 0.0);
}

#[test]
fn a_ring_turns_once_around_its_hole_a_square_never_and_a_fork_against_the_walk() {
    let of = |link: &str, middle: [f64; 2], radius: f64| {
        let domain = Domain::from_checked(&ALL.recipe(link).0.outline());
        let by = 512.0 * DVec2::from(middle) - DVec2::splat(256.0);
        let walk: Vec<DVec2> = circle(512.0 * radius, 72).iter().map(|p| *p + by).collect();
        turns(&domain, &walk).last().copied()
    };
    let middle = [0.5, 0.5];
    assert_eq!(of("outline=annulus", middle, 0.35), Some(1.0));
    assert_eq!(of("outline=square", middle, 0.35), Some(0.0));
    assert_eq!(of("outline=y_fork", [0.5, 0.43], 0.1), Some(-0.5));
    // A walk that leaves the outline has no index.
    assert_eq!(of("outline=annulus", middle, 0.1), None);
    assert_eq!(of("outline=square", [0.9, 0.5], 0.3), None);
}

#[test]
fn short_walks_and_constant_directions_turn_by_nothing() {
    let square = domain(circle(200.0, 4));
    let constant = FieldParams {
        direction: Direction::Constant,
        angle: 0.5,
        ..FieldParams::default()
    };
    let constant = FieldBuilder::build(&square, constant);
    for count in [1, 2, 9] {
        let places = constant.along_walk(&square, &circle(80.0, count));
        assert_eq!(places.len() as u32, count + 1);
        assert!(places.iter().all(|place| place.turns == 0.0));
        let along = DVec2::new(libm::cos(0.5), libm::sin(0.5));
        assert!(apart(places[0].sum.direction, along) < 1e-9);
    }
    assert_eq!(constant.along_walk(&square, &[]), []);
}
