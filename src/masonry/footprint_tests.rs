//! Tests of convex polygons.

use super::footprint::{Footprint, FootprintFault, HalfPlane};
use crate::random::{Purpose, Random};
use glam::DVec2;

fn square(at: f64, side: f64) -> Footprint {
    Footprint::rectangle(DVec2::splat(at), DVec2::splat(at + side)).unwrap()
}

/// A convex polygon with corners on an ellipse.
fn round(random: &mut Random) -> Footprint {
    let centre = DVec2::new(random.signed(), random.signed());
    let axes = DVec2::new(0.2 + random.unit(), 0.2 + random.unit());
    let count = 3 + random.below(6);
    let corners: Vec<DVec2> = (0..count)
        .map(|k| {
            let turn = std::f64::consts::TAU * (k as f64 + 0.8 * random.unit()) / count as f64;
            centre + axes * DVec2::new(libm::cos(turn), libm::sin(turn))
        })
        .collect();
    Footprint::new(&corners).unwrap()
}

#[test]
fn what_is_no_convex_polygon_is_refused() {
    let of = |corners: &[(f64, f64)]| {
        let corners: Vec<DVec2> = corners.iter().map(|&p| p.into()).collect();
        Footprint::new(&corners).map(|_| ())
    };
    assert_eq!(of(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]), Ok(()));
    let dart = [(0.0, 0.0), (2.0, 0.0), (0.5, 0.5), (0.0, 2.0)];
    assert_eq!(of(&dart), Err(FootprintFault::NotConvex));
    let clockwise = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0)];
    assert_eq!(of(&clockwise), Err(FootprintFault::Flat));
    assert_eq!(
        of(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]),
        Err(FootprintFault::Flat)
    );
    assert_eq!(
        of(&[(0.0, f64::NAN), (1.0, 0.0), (1.0, 1.0)]),
        Err(FootprintFault::NotFinite)
    );
    assert_eq!(Footprint::rectangle(DVec2::ONE, DVec2::ZERO), None);
}

#[test]
fn the_two_parts_of_a_cut_fill_the_whole() {
    let mut random = Random::new(3, Purpose::Scatter, 0);
    for _ in 0..200 {
        let (polygon, other) = (round(&mut random), round(&mut random));
        for half in other.half_planes() {
            let area = |half| polygon.clip(half, 0.0).map_or(0.0, |part| part.area());
            let sum = area(half) + area(half.opposite());
            assert!((sum - polygon.area()).abs() < 1e-9, "{sum} {polygon:?}");
        }
        let [a, b] = [polygon.shared_area(&other), other.shared_area(&polygon)];
        assert!((a - b).abs() < 1e-12 && a <= polygon.area());
    }
}

#[test]
fn a_shared_area_is_that_of_samples() {
    let mut random = Random::new(4, Purpose::Scatter, 0);
    let (a, b) = (round(&mut random), square(-0.4, 0.9));
    let [low, high] = a.bounds();
    let count = 40_000;
    let hits = (0..count).filter(|_| {
        let p = low + (high - low) * DVec2::new(random.unit(), random.unit());
        a.contains(p) && b.contains(p)
    });
    let box_area = (high - low).x * (high - low).y;
    let sampled = box_area * hits.count() as f64 / f64::from(count);
    assert!((sampled - a.shared_area(&b)).abs() < 0.01 * box_area);
}

#[test]
fn a_side_keeps_its_inset_through_cuts() {
    // Only the left side is a joint.
    let joint = |[a, b]: [DVec2; 2]| if a.x == 0.0 && b.x == 0.0 { 0.1 } else { 0.0 };
    let polygon = square(0.0, 1.0).with_insets(joint);
    let lower = HalfPlane {
        normal: DVec2::NEG_Y,
        offset: -0.5,
    };
    let cut = polygon.clip(lower, 0.02).unwrap();
    for k in 0..cut.corners().len() {
        let [a, b] = cut.side(k);
        let wanted = if a.y == 0.5 && b.y == 0.5 {
            0.02
        } else {
            joint([a, b])
        };
        assert_eq!(cut.corners()[k].inset, wanted, "{a} {b}");
    }
    let area = cut.shrunk().unwrap().area();
    assert!((area - 0.9 * 0.48).abs() < 1e-12, "{area}");
    assert_eq!(square(0.0, 0.1).with_insets(|_| 0.05).shrunk(), None);
}

#[test]
fn a_hull_has_all_points_and_only_them_as_corners() {
    let mut random = Random::new(6, Purpose::Scatter, 0);
    for count in [3, 4, 8, 40] {
        let points: Vec<DVec2> = (0..count)
            .map(|_| DVec2::new(random.unit(), random.unit()))
            .collect();
        let hull = Footprint::hull(&points).unwrap();
        assert!(hull.places().all(|p| points.contains(&p)));
        assert!(
            points
                .iter()
                .all(|&p| hull.half_planes().all(|half| half.distance(p) > -1e-12))
        );
    }
    let line = [(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (1.0, 1.0)].map(DVec2::from);
    assert_eq!(Footprint::hull(&line), None);
    assert_eq!(Footprint::hull(&[]), None);
}

#[test]
fn the_centre_moves_with_the_polygon() {
    let by = DVec2::new(3.0, -7.0);
    let mut random = Random::new(5, Purpose::Scatter, 0);
    let polygon = round(&mut random);
    assert!(polygon.contains(polygon.centre()));
    let moved = polygon.clone().moved(by);
    assert!((moved.centre() - polygon.centre()).distance(by) < 1e-12);
}
