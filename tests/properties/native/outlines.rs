//! The check of outlines: valid ones pass, invalid ones get a sentence that names ring and place.

use crate::common::{star, valid};
use bubblestone::domain::{Domain, MAX_POINTS, Outline, signed_area};
use bubblestone::generators::pavement::{self, PavementRecipe};
use bubblestone::notice::text;
use glam::DVec2;
use proptest::prelude::*;

pub(super) const SIDE: f64 = 512.0;

pub(super) fn ring(points: &[(f64, f64)]) -> Vec<DVec2> {
    points.iter().map(|&p| p.into()).collect()
}

/// A rectangle with the orientation of an outer ring.
pub(super) fn rectangle(left: f64, top: f64, right: f64, bottom: f64) -> Vec<DVec2> {
    ring(&[(left, top), (right, top), (right, bottom), (left, bottom)])
}

pub(super) fn hole(left: f64, top: f64, right: f64, bottom: f64) -> Vec<DVec2> {
    rectangle(left, top, right, bottom)
        .into_iter()
        .rev()
        .collect()
}

pub(super) fn outline(outer: Vec<DVec2>, holes: &[Vec<DVec2>]) -> Outline {
    Outline {
        rings: [vec![outer], holes.to_vec()].concat(),
        ..Outline::default()
    }
}

fn scaled(outline: &Outline, scale: f64) -> Outline {
    let ring = |ring: &Vec<DVec2>| ring.iter().map(|p| *p * scale).collect();
    Outline {
        rings: outline.rings.iter().map(ring).collect(),
        ..Outline::default()
    }
}

/// The sentence that refuses an outline, which is refused at every scale.
fn refused(outline: &Outline) -> String {
    for scale in [1e-3, 0.25, 1e3] {
        let verdict = scaled(outline, scale).check(SIDE * scale);
        assert!(verdict.is_err(), "passes at scale {scale}");
    }
    outline.check(SIDE).expect_err("refused").to_string()
}

pub(super) fn says(outline: &Outline, words: &[&str]) {
    let sentence = refused(outline);
    assert!(
        sentence.ends_with('.') && sentence.len() < 160,
        "{sentence}"
    );
    for word in words {
        assert!(
            sentence.to_lowercase().contains(&word.to_lowercase()),
            "{sentence:?} does not say {word:?}"
        );
    }
}

pub(super) fn big() -> Vec<DVec2> {
    rectangle(32., 32., 480., 480.)
}

#[test]
fn good_outlines_pass_as_they_are() {
    let good = [
        outline(big(), &[]),
        outline(
            big(),
            &[hole(100., 100., 200., 200.), hole(201., 100., 300., 200.)],
        ),
        outline(ring(&[(0., 0.), (512., 0.), (256., 512.)]), &[]),
        // Points in the middle of a straight side are allowed.
        outline(
            ring(&[
                (10., 10.),
                (99., 10.),
                (300., 10.),
                (300., 200.),
                (10., 200.),
            ]),
            &[],
        ),
        // A road may leave the picture.
        outline(rectangle(-200., 100., 700., 300.), &[]),
    ];
    for outline in good {
        for scale in [1e-3, 1.0, 1e3] {
            let outline = scaled(&outline, scale);
            assert_eq!(outline.check(SIDE * scale), Ok((outline.clone(), vec![])));
        }
    }
}

#[test]
fn wrong_orientation_is_mended_and_told() {
    let wrong = outline(
        hole(32., 32., 480., 480.),
        &[rectangle(100., 100., 200., 200.)],
    );
    let (mended, notices) = wrong.check(SIDE).unwrap();
    assert!(signed_area(&mended.rings[0]) > 0.0 && signed_area(&mended.rings[1]) < 0.0);
    assert!(
        text(&notices[..1]).contains("outer ring") && text(&notices[1..]).contains("Hole 1"),
        "{notices:?}"
    );
    assert_eq!(mended.check(SIDE), Ok((mended.clone(), vec![])));
}

#[test]
fn of_many_things_mended_some_are_told() {
    let place = |k: usize| 40. + 20. * k as f64;
    let holes = (0..20).map(|k| rectangle(place(k), 100., place(k) + 10., 200.));
    let (mended, notices) = outline(big(), &holes.collect::<Vec<_>>())
        .check(SIDE)
        .unwrap();
    assert!(mended.rings[1..].iter().all(|hole| signed_area(hole) < 0.0));
    assert!(
        notices.len() < 8 && text(&notices).contains("16 more"),
        "{notices:?}"
    );
}

#[test]
fn repeated_points_are_dropped_and_told() {
    let closed = ring(&[
        (10., 10.),
        (400., 10.),
        (400., 10.),
        (400., 400.),
        (10., 10.),
    ]);
    let (mended, notices) = outline(closed, &[]).check(SIDE).unwrap();
    assert_eq!(mended.rings[0].len(), 3);
    assert_eq!(
        text(&notices),
        "The outer ring repeats 2 points, the first at (400, 10); dropped."
    );
}

#[test]
fn no_ring_of_fewer_than_three_points() {
    says(
        &outline(vec![], &[]),
        &["outer ring", "3 different points", "has 0"],
    );
    says(&outline(ring(&[(5., 5.)]), &[]), &["outer ring", "has 1"]);
    says(
        &outline(ring(&[(5., 5.), (9., 9.)]), &[]),
        &["outer ring", "has 2"],
    );
    says(
        &outline(ring(&[(5., 5.); 9]), &[]),
        &["outer ring", "has 1"],
    );
    says(&outline(big(), &[vec![]]), &["hole 1", "has 0"]);
    let pair = ring(&[(50., 50.), (90., 50.), (50., 50.), (50., 50.)]);
    says(
        &outline(big(), &[hole(60., 60., 99., 99.), pair]),
        &["hole 2", "has 2"],
    );
}

#[test]
fn no_ring_on_a_line() {
    says(
        &outline(ring(&[(10., 10.), (200., 200.), (100., 100.)]), &[]),
        &["outer ring", "one line", "(10, 10)"],
    );
    let flat = ring(&[(50., 50.), (90., 50.), (70., 50.)]);
    says(
        &outline(big(), &[flat]),
        &["hole 1", "one line", "(50, 50)"],
    );
}

#[test]
fn no_ring_that_turns_back() {
    let spike = ring(&[
        (10., 10.),
        (400., 10.),
        (500., 10.),
        (400., 10.),
        (400., 300.),
    ]);
    says(
        &outline(spike, &[]),
        &["outer ring", "turns back", "(500, 10)"],
    );
}

#[test]
fn no_ring_that_crosses_or_touches_itself() {
    let bow = ring(&[(100., 100.), (400., 400.), (400., 100.), (100., 400.)]);
    says(&outline(bow, &[]), &["outer ring crosses", "(250, 250)"]);
    let bow = ring(&[(100., 100.), (200., 200.), (200., 100.), (100., 200.)]);
    says(&outline(big(), &[bow]), &["hole 1 crosses", "(150, 150)"]);
    // A corner lies on a side.
    let touch = ring(&[
        (10., 10.),
        (400., 10.),
        (400., 400.),
        (200., 10.),
        (10., 400.),
    ]);
    says(
        &outline(touch, &[]),
        &["outer ring", "touches itself", "(200, 10)"],
    );
    // The same point occurs twice, but not in succession.
    let pinch = ring(&[
        (10., 10.),
        (200., 200.),
        (10., 400.),
        (400., 400.),
        (200., 200.),
        (400., 10.),
    ]);
    says(
        &outline(pinch, &[]),
        &["outer ring", "touches itself", "(200, 200)"],
    );
    // Two sides overlap on one line, first a slanted one, then a vertical one.
    let overlap = ring(&[
        (0., 0.),
        (300., 300.),
        (300., 400.),
        (200., 200.),
        (100., 100.),
        (0., 300.),
    ]);
    says(&outline(overlap, &[]), &["outer ring"]);
    let overlap = ring(&[
        (10., 10.),
        (10., 300.),
        (60., 300.),
        (10., 250.),
        (10., 50.),
        (60., 20.),
    ]);
    says(&outline(overlap, &[]), &["outer ring", "(10, "]);
}

#[test]
fn no_ring_too_small() {
    says(
        &outline(rectangle(100., 100., 103., 103.), &[]),
        &[
            "outer ring",
            "(100, 100)",
            "too small",
            "is 9 square",
            "least 16 is",
        ],
    );
    says(
        &outline(big(), &[hole(100., 100., 101., 101.)]),
        &["hole 1", "too small"],
    );
}

#[test]
fn no_strange_numbers() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..4 {
            let mut outer = big();
            outer[place].y = bad;
            says(
                &outline(outer, &[]),
                &["outer ring", &format!("Point {}", place + 1), "finite"],
            );
        }
        let mut bad_hole = hole(100., 100., 200., 200.);
        bad_hole[2].x = bad;
        says(
            &outline(big(), &[bad_hole]),
            &["Point 3 of hole 1", "finite"],
        );
    }
    for far in [-300.0, 800.0, 1e300, -1e300, f64::MAX / 1e4] {
        let mut outer = big();
        outer[1].x = far;
        says(&outline(outer, &[]), &["outer ring", "far outside"]);
    }
    assert!(
        outline(rectangle(1e-300, 0., 1e-300, 1e-310), &[])
            .check(SIDE)
            .is_err()
    );
}

#[test]
fn no_more_points_than_allowed() {
    let radii = vec![0.8; MAX_POINTS];
    assert!(outline(star(SIDE, &radii), &[]).check(SIDE).is_ok());
    let radii = vec![0.8; MAX_POINTS + 1];
    says(
        &outline(star(SIDE, &radii), &[]),
        &["4097 points", "at most 4096"],
    );
}

/// A comb and a burst put many segments into few squares of the search grid.
#[test]
fn many_long_sides_are_no_trouble() {
    let n = MAX_POINTS / 2;
    let burst: Vec<f64> = (0..2 * n)
        .map(|k| if k % 2 == 0 { 0.9 } else { 0.05 })
        .collect();
    assert!(outline(star(SIDE, &burst), &[]).check(SIDE).is_ok());
    let tooth = |k: usize, y: f64| DVec2::new(40.0 + k as f64 * 0.2, y);
    let mut comb: Vec<DVec2> = (0..n - 1)
        .flat_map(|k| [tooth(2 * k, 40.0), tooth(2 * k + 1, 400.0)])
        .map(|p| DVec2::new(p.x / 2.0, p.y))
        .collect();
    comb.push(DVec2::new(460.0, 450.0));
    comb.push(DVec2::new(20.0, 450.0));
    assert!(outline(comb, &[]).check(SIDE).is_ok());
}

proptest! {
    #[test]
    fn star_shaped_polygons_pass(radii in prop::collection::vec(0.05..0.99f64, 5..200)) {
        let given = outline(star(SIDE, &radii), &[]);
        let (checked, notices) = given.check(SIDE).unwrap();
        prop_assert_eq!(&checked, &given);
        prop_assert!(notices.is_empty());
        // An outline that passes is valid for the next stage.
        let domain = Domain::from_checked(&checked);
        prop_assert!(domain.contains(DVec2::splat(SIDE / 2.0)));
        let mut recipe = pavement::recipe("").0;
        prop_assert_eq!(recipe.set_polygon(&given), Ok(vec![]));
        valid(&recipe);
        let mut turned = given.clone();
        turned.rings[0].reverse();
        let (mended, notices) = turned.check(SIDE).unwrap();
        prop_assert_eq!(mended, given);
        prop_assert_eq!(notices.len(), 1);
    }

    /// On a coarse grid points often meet, repeat, and lie on lines.
    #[test]
    fn scrambles_pass_or_get_a_sentence(
        outer in prop::collection::vec((0..6, 0..6), 0..9),
        holes in prop::collection::vec(prop::collection::vec((0..6, 0..6), 0..5), 0..3),
        scale in prop_oneof![Just(1e-3), Just(1.0), Just(1e3)],
    ) {
        let ring = |points: &Vec<(i32, i32)>| -> Vec<DVec2> {
            points.iter().map(|&(x, y)| DVec2::new(x.into(), y.into()) * scale * SIDE / 6.0).collect()
        };
        let given = outline(ring(&outer), &holes.iter().map(ring).collect::<Vec<_>>());
        match given.check(scale * SIDE) {
            Ok((checked, _)) => {
                prop_assert!(signed_area(&checked.rings[0]) > 0.0);
                prop_assert_eq!(checked.check(scale * SIDE), Ok((checked.clone(), vec![])));
                prop_assert!(Domain::from_checked(&checked).area() > 0.0);
            }
            Err(error) => {
                let sentence = error.to_string();
                prop_assert!(sentence.ends_with('.'));
                let lower = sentence.to_lowercase();
                prop_assert!(["ring", "hole", "island"].iter().any(|word| lower.contains(word)));
            }
        }
    }

    #[test]
    fn strange_numbers_never_panic(
        points in prop::collection::vec((prop::num::f64::ANY, prop::num::f64::ANY), 0..12),
    ) {
        let outer: Vec<DVec2> = points.iter().map(|&p| p.into()).collect();
        let _ = outline(outer, &[]).check(SIDE);
    }
}
