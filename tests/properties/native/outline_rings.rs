//! Outlines of several rings: holes, islands in them, and rings that must not meet.

use super::outlines::{SIDE, big, hole, outline, rectangle, ring, says};
use bubblestone::domain::{Domain, Outline};
use glam::DVec2;

#[test]
fn no_rings_that_meet() {
    says(
        &outline(big(), &[hole(400., 100., 500., 200.)]),
        &["outer ring and hole 1", "(480, "],
    );
    says(
        &outline(
            big(),
            &[hole(100., 100., 200., 200.), hole(150., 150., 250., 250.)],
        ),
        &["hole 1 and hole 2"],
    );
    // The other hole touches along a side or at a corner, or it is the same hole.
    let first = hole(100., 100., 200., 200.);
    for other in [
        hole(200., 120., 300., 180.),
        hole(200., 200., 300., 300.),
        first.clone(),
    ] {
        says(
            &outline(big(), &[first.clone(), other]),
            &["hole 1 and hole 2"],
        );
    }
    says(
        &outline(big(), &[hole(32., 100., 90., 200.)]),
        &["outer ring and hole 1", "(32, "],
    );
}

#[test]
fn rings_inside_an_even_number_of_others_are_islands() {
    let small = rectangle(32., 32., 200., 200.);
    let apart = rectangle(300., 300., 400., 400.);
    let pool = hole(60., 60., 160., 160.);
    let in_pool = rectangle(80., 80., 140., 140.);
    let all = [small.clone(), apart.clone(), pool.clone(), in_pool.clone()];
    let given = Outline {
        rings: all.to_vec(),
        ..Outline::default()
    };
    assert_eq!(given.check(SIDE), Ok((given.clone(), vec![])));
    let domain = Domain::from_checked(&given);
    let islands = domain
        .islands()
        .iter()
        .map(|island| island.rings().to_vec());
    assert_eq!(
        islands.collect::<Vec<_>>(),
        [
            vec![small.clone(), pool.clone()],
            vec![in_pool.clone()],
            vec![apart.clone()]
        ]
    );
    assert_eq!(
        domain.area(),
        168. * 168. - 100. * 100. + 60. * 60. + 100. * 100.
    );
    let place = |x: f64, y: f64| {
        let p = DVec2::new(x, y);
        (domain.contains(p), domain.island(p), domain.part(p))
    };
    assert_eq!(place(40., 40.), (true, 0, 0));
    assert_eq!(place(110., 110.), (true, 1, 1));
    assert_eq!(place(350., 350.), (true, 2, 2));
    assert!(!place(70., 70.).0 && !place(250., 250.).0);
    assert_eq!(domain.parts(), 3);
    // Rings may have any orientation and order. The first one here is an outer ring.
    let mut turned = given.clone();
    turned.rings.rotate_left(2);
    turned.rings.iter_mut().for_each(|ring| ring.reverse());
    let (mended, notices) = turned.check(SIDE).unwrap();
    assert_eq!(notices.len(), 4, "{notices:?}");
    assert_eq!(mended.rings[0], in_pool);
    let mended = Domain::from_checked(&mended);
    assert_eq!(mended.area(), domain.area());
    assert_eq!(mended.islands().len(), 3);
    // A ring around the first one makes the first one a hole.
    let (mended, _) = outline(small, &[hole(10., 10., 400., 400.)])
        .check(SIDE)
        .unwrap();
    assert_eq!(
        Domain::from_checked(&mended).area(),
        390. * 390. - 168. * 168.
    );
}

#[test]
fn no_islands_that_meet() {
    let first = rectangle(40., 40., 100., 100.);
    let island = rectangle(200., 200., 300., 300.);
    for other in [
        // The same island; one that touches along a side; one at a corner; one with a corner on a side; one
        // that overlaps a corner.
        island.clone(),
        rectangle(300., 220., 400., 280.),
        rectangle(300., 300., 400., 400.),
        ring(&[(300., 250.), (400., 200.), (400., 300.)]),
        rectangle(250., 250., 400., 400.),
    ] {
        let outline = outline(first.clone(), &[island.clone(), other]);
        says(&outline, &[" 1 and ", " 2 cross or touch"]);
    }
    says(
        &outline(first.clone(), &[rectangle(100., 100., 200., 200.)]),
        &["outer ring and island 1", "(100, 100)"],
    );
    let bow = ring(&[(200., 200.), (300., 300.), (300., 200.), (200., 300.)]);
    says(
        &outline(first.clone(), &[bow]),
        &["island 1 crosses", "(250, 250)"],
    );
    says(
        &outline(first, &[rectangle(200., 200., 201., 201.)]),
        &["island 1", "too small"],
    );
    says(&Outline::default(), &["outer ring", "has 0"]);
    let empty = Outline {
        rings: vec![vec![]; 1_000_000],
        ..Outline::default()
    };
    says(&empty, &["has 1000000 points"]);
}
