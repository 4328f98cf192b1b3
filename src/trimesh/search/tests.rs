use super::super::testing::{self, mesh};
use super::super::{Simplifying, SurfacePoint, log, samples};
use super::nearest::nearest_weights;
use super::ray::meets;
use super::*;
use glam::DVec3;

fn probes() -> impl Iterator<Item = DVec3> {
    (0..300).map(|k| {
        let t = f64::from(k);
        let r = 0.1 + 1.7 * t / 300.0;
        r * DVec3::new(libm::sin(t), libm::sin(1.7 * t), libm::cos(2.3 * t))
    })
}

#[test]
fn the_closest_place_is_that_of_all_triangles() {
    for mesh in [samples::blob(3), samples::torus(30, 12), samples::ball(0)] {
        let mut search = Search::begin(&mesh);
        while !search.advance(&mesh, 7) {}
        assert_eq!(search.triangles, Search::new(&mesh).triangles);
        for p in probes() {
            let found = search.closest(&mesh, p);
            let least = (0..mesh.triangles().len() as u32)
                .map(|t| {
                    let c = mesh.corners(t);
                    let w = nearest_weights(c, p);
                    (c[0] * w.x + c[1] * w.y + c[2] * w.z).distance(p)
                })
                .fold(f64::INFINITY, f64::min);
            assert!((found.at.distance(p) - least).abs() < 1e-12, "{p}");
            let weights = found.weights(&mesh);
            assert!(weights.min_element() > -1e-9);
        }
        // At a vertex all its triangles are equally near.
        for (v, &p) in mesh.positions().iter().enumerate() {
            let first = mesh.fan(v as u32).map(|(t, _)| t).min().unwrap();
            assert_eq!(search.closest(&mesh, p).triangle, first);
        }
    }
}

#[test]
fn a_search_can_be_cut_anywhere() {
    // All triangles of a ball are equally far from its middle.
    let mesh = samples::ball(3);
    let (search, count) = (Search::new(&mesh), mesh.triangles().len());
    for (p, least) in [(DVec3::ZERO, count / 50), (DVec3::new(2.0, 0.1, 0.3), 1)] {
        let mut walk = NearestWalk::new(p, f64::INFINITY);
        let mut slices = 1;
        while !walk.advance(&search, &mesh, &mut { 50 }) {
            slices += 1;
        }
        assert_eq!(walk.found(&mesh), Some(search.closest(&mesh, p)));
        assert!((least..=count / 10).contains(&slices), "{slices}");
    }
}

#[test]
fn rays_meet_what_all_triangles_say() {
    let mesh = samples::torus(30, 12);
    let search = Search::new(&mesh);
    let mut met = 0;
    for p in probes() {
        let along = DVec3::new(0.3, 0.2, 0.1) - p;
        let hit = search.ray(&mesh, p, along, |_| true);
        let least = (0..mesh.triangles().len() as u32)
            .filter_map(|t| meets(mesh.corners(t), p, along))
            .map(|(far, _)| far)
            .fold(f64::INFINITY, f64::min);
        assert_eq!(hit.map_or(f64::INFINITY, |h| h.along), least);
        if let Some(hit) = hit {
            met += 1;
            assert!((hit.point.at - (p + along * hit.along)).length() < 1e-9);
        }
    }
    assert!(met > 100, "{met}");
    let down = search.ray(&mesh, DVec3::new(1.0, 2.0, 0.0), DVec3::NEG_Y, |t| {
        mesh.face_normal(t).y < 0.0
    });
    assert!((down.unwrap().along - 2.4).abs() < 0.02);
}

#[test]
fn a_point_stays_on_its_side_of_a_thin_sheet() {
    // A plate whose thickness is a hundredth of its side.
    let (positions, triangles) = testing::cube(20);
    let flat = positions.iter().map(|p| DVec3::new(p.x, 0.01 * p.y, p.z));
    let plate = mesh((flat.collect(), triangles));
    let search = Search::new(&plate);
    let p = DVec3::new(0.52, 0.004, 0.47);
    for up in [1.0, -1.0] {
        let found = search.closest_facing(&plate, p, DVec3::Y * up);
        assert!(found.normal.y * up > 0.9 && (found.at.x - p.x).abs() < 1e-12);
    }
}

#[test]
fn points_of_a_simple_surface_are_carried_to_the_full_one() {
    let full = mesh(testing::blob(5));
    let simple = Simplifying::new(full.clone(), 600, f64::INFINITY).finish();
    let search = Search::new(&full);
    let mut chance = testing::chance(3);
    for t in 0..simple.triangles().len() as u32 {
        let (u, v) = (chance.unit(), 0.5 * chance.unit());
        let weights = DVec3::new(u * (1.0 - v), (1.0 - u) * (1.0 - v), v);
        let point = SurfacePoint::new(&simple, t, weights);
        let on = search.closest_facing(&full, point.at, point.normal);
        assert!((on.at - point.at).length() < 0.03);
        assert!(on.normal.dot(point.normal) > 0.8);
        assert!(on.weights(&full).min_element() > -1e-9 && log(&on, &on).is_some());
    }
}

#[test]
fn all_triangles_within_a_radius_are_found() {
    let mesh = samples::blob(3);
    let search = Search::new(&mesh);
    for p in probes() {
        let mut seen = vec![false; mesh.triangles().len()];
        let stopped = search.any_within(p, 0.4, |t| {
            seen[t as usize] = true;
            false
        });
        assert!(!stopped);
        for (t, seen) in (0..).zip(seen) {
            let near = nearest_in(mesh.corners(t), p).distance(p) < 0.4;
            assert!(seen || !near, "{p} {t}");
            assert!(!near || search.any_within(p, 0.4, |other| other == t));
        }
    }
}
