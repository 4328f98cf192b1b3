//! Tests of polyhedra.

use super::{Plane, Polyhedron};
use crate::masonry::footprint::Footprint;
use crate::random::{Purpose, Random};
use glam::{DVec2, DVec3};

fn unit(random: &mut Random) -> DVec3 {
    let p = DVec3::new(random.signed(), random.signed(), random.signed());
    p.try_normalize().unwrap_or(DVec3::X)
}

fn body(random: &mut Random) -> Polyhedron {
    let centre = 0.3 * unit(random);
    let planes: Vec<(Plane, f64)> = (0..6)
        .map(|_| {
            let n = unit(random);
            (
                Plane::through(centre + n * (0.3 + 0.4 * random.unit()), n),
                0.01,
            )
        })
        .collect();
    Polyhedron::from_planes(&planes, [centre - 0.8, centre + 0.8]).unwrap()
}

/// Each edge runs once in each direction, corners lie on their planes, and Euler's formula holds.
fn check(body: &Polyhedron) {
    let mut edges = Vec::new();
    for side in body.sides() {
        for k in 0..side.corners.len() {
            edges.push([side.corners[k], side.corners[(k + 1) % side.corners.len()]]);
        }
    }
    assert!(
        edges
            .iter()
            .all(|&[a, b]| edges.iter().filter(|&&e| e == [b, a]).count() == 1),
        "{body:?}"
    );
    assert_eq!(
        body.vertices().len() + body.sides().len(),
        edges.len() / 2 + 2,
        "{body:?}"
    );
    assert!(body.is_convex(1e-7) && body.volume() > 0.0);
}

#[test]
fn cuts_keep_bodies_closed_and_convex_and_their_volume() {
    let mut random = Random::new(1, Purpose::Scatter, 0);
    for _ in 0..300 {
        let body = body(&mut random);
        check(&body);
        let n = unit(&mut random);
        let plane = Plane::through(body.centre() + 0.2 * random.signed() * n, n);
        let other = Plane {
            normal: -plane.normal,
            offset: -plane.offset,
        };
        let parts = [plane, other].map(|plane| body.cut(plane, 0.0));
        parts.iter().flatten().for_each(check);
        let sum: f64 = parts.iter().flatten().map(Polyhedron::volume).sum();
        assert!(
            (sum - body.volume()).abs() < 1e-9,
            "{sum} {}",
            body.volume()
        );
    }
}

#[test]
fn planes_through_vertices_and_edges_cut_cleanly() {
    let cube = Polyhedron::cuboid(DVec3::ZERO, DVec3::ONE).unwrap();
    for (normal, volume) in [
        (DVec3::new(1.0, 1.0, 0.0), 0.5),
        (DVec3::new(1.0, -1.0, 0.0), 0.5),
        (DVec3::new(1.0, 1.0, 1.0), 1.0 / 6.0),
        (DVec3::new(0.0, 0.0, 1.0), 0.5),
    ] {
        let at = if volume < 0.2 {
            DVec3::X
        } else {
            DVec3::splat(0.5)
        };
        let part = cube.cut(Plane::through(at, normal), 0.0).unwrap();
        check(&part);
        assert!((part.volume() - volume).abs() < 1e-12, "{normal}");
    }
    let beside = Plane::through(DVec3::ONE, DVec3::X);
    assert_eq!(cube.cut(beside, 0.0).as_ref(), Some(&cube));
    assert_eq!(cube.cut(Plane::through(DVec3::ZERO, DVec3::X), 0.0), None);
}

#[test]
fn a_shared_volume_is_that_of_samples_and_the_same_both_ways() {
    let mut random = Random::new(2, Purpose::Scatter, 0);
    let mut largest = 0.0f64;
    for _ in 0..20 {
        let (a, b) = (body(&mut random), body(&mut random));
        let [shared, back] = [a.shared_volume(&b), b.shared_volume(&a)];
        assert!((shared - back).abs() < 1e-9);
        let [low, high] = a.bounds();
        let size = high - low;
        let [inner, outer] = [&a, &b].map(|body| body.planes().collect::<Vec<Plane>>());
        let hits = (0..4000).filter(|_| {
            let p = low + size * DVec3::new(random.unit(), random.unit(), random.unit());
            inner
                .iter()
                .chain(&outer)
                .all(|plane| plane.distance(p) <= 0.0)
        });
        let sampled = size.element_product() * hits.count() as f64 / 4000.0;
        assert!(
            (sampled - shared).abs() < 0.04 * size.element_product(),
            "{sampled} {shared}"
        );
        largest = largest.max(shared);
    }
    assert!(largest > 0.05);
    let cube = Polyhedron::cuboid(DVec3::ZERO, DVec3::ONE).unwrap();
    let next = Polyhedron::cuboid(DVec3::X, DVec3::new(2.0, 1.0, 1.0)).unwrap();
    assert_eq!(cube.shared_volume(&next), 0.0);
    assert!((cube.shared_volume(&cube) - 1.0).abs() < 1e-12);
}

#[test]
fn joints_shrink_and_exposed_sides_stay() {
    let base = Footprint::rectangle(DVec2::ZERO, DVec2::new(0.25, 0.083)).unwrap();
    let base = base.with_insets(|_| 0.005);
    let brick = Polyhedron::prism(&base, [-0.125, 0.0], [0.005, 0.0], |p, z| p.extend(z));
    check(&brick);
    let [low, high] = brick.shrunk().unwrap().bounds();
    assert!((low - DVec3::new(0.005, 0.005, -0.12)).abs().max_element() < 1e-12);
    assert!((high - DVec3::new(0.245, 0.078, 0.0)).abs().max_element() < 1e-12);
    let thin = brick.with_insets(|_, _| 0.05);
    assert_eq!(thin.shrunk(), None);
    assert_eq!(Polyhedron::cuboid(DVec3::ONE, DVec3::ZERO), None);
}
