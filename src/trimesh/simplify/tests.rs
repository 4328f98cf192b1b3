use super::super::testing::{self, mesh};
use super::super::{Search, TriMesh};
use super::*;

/// The greatest distance of corners and triangle middles of one surface from another, as a share of the diagonal.
fn farthest(from: &TriMesh, to: &TriMesh) -> f64 {
    let search = Search::new(to);
    let mut most = 0.0f64;
    for t in 0..from.triangles().len() as u32 {
        let [a, b, c] = from.corners(t);
        for p in [a, (a + b + c) / 3.0] {
            let near = search.closest(to, p);
            most = most.max((near.at - p).length());
        }
    }
    most / to.diagonal()
}

#[test]
fn fewer_triangles_are_the_same_surface() {
    for (soup, most, error) in [
        (testing::ball(5), 500, 0.008),
        (testing::blob(5), 1000, 0.008),
        (testing::torus(96, 40, 0.4), 800, 0.01),
        (testing::two_holes(8), 300, 1e-3),
        (testing::tube(60, 20), 300, 0.005),
        (testing::flat(30), 40, 1e-6),
        (testing::cubes(&[[0; 3], [3, 0, 0]], 9), 48, 1e-3),
    ] {
        let full = mesh(soup);
        let simple = Simplifying::new(full.clone(), most, f64::INFINITY).finish();
        assert!(
            simple.triangles().len() <= most,
            "{}",
            simple.triangles().len()
        );
        assert_eq!(simple.euler(), full.euler());
        assert_eq!(simple.parts().1, full.parts().1);
        assert_eq!(simple.borders().len(), full.borders().len());
        let off = farthest(&simple, &full).max(farthest(&full, &simple));
        assert!(off < error, "{off}");
        assert!((simple.area() / full.area() - 1.0).abs() < 0.03);
    }
}

#[test]
fn it_ends_where_the_surface_would_move_too_far() {
    let full = mesh(testing::blob(5));
    let simple = Simplifying::new(full.clone(), 0, 0.002).finish();
    assert!(
        (50..4000).contains(&simple.triangles().len()),
        "{}",
        simple.triangles().len()
    );
    assert!(farthest(&simple, &full) < 0.01);
    let cube = Simplifying::new(mesh(testing::cube(9)), 0, 1e-5).finish();
    assert_eq!(cube.triangles().len(), 12);
    assert!((cube.area() - 6.0).abs() < 1e-5);
}

#[test]
fn however_few_are_asked_for_a_surface_is_left() {
    for soup in [
        testing::ball(3),
        testing::torus(24, 10, 0.4),
        testing::two_holes(2),
        testing::flat(6),
        testing::tube(7, 3),
    ] {
        let full = mesh(soup);
        let simple = Simplifying::new(full.clone(), 0, f64::INFINITY).finish();
        assert_eq!(simple.euler(), full.euler());
        assert_eq!(simple.borders().len(), full.borders().len());
        assert!(simple.triangles().len() < full.triangles().len());
    }
}

#[test]
fn place_and_size_do_not_matter() {
    let (positions, triangles) = testing::blob(4);
    let simple = |scale: f64, moved: f64| {
        let placed = positions.iter().map(|&p| p * scale + DVec3::splat(moved));
        let mesh = mesh((placed.collect(), triangles.clone()));
        Simplifying::new(mesh, 400, f64::INFINITY).finish()
    };
    let one = simple(1.0, 0.0);
    assert_eq!(simple(1.0, 0.0), one);
    let large = simple(1024.0, 0.0);
    assert_eq!(large.triangles(), one.triangles());
    let moved = simple(1.0, 64.0);
    assert!((moved.area() / one.area() - 1.0).abs() < 0.01);
}

/// The number of slices until a surface is simple.
fn slices(soup: testing::Soup, most: usize) -> usize {
    let mut work = Simplifying::new(mesh(soup), most, f64::INFINITY);
    let mut count = 1;
    while work.advance().is_none() {
        count += 1;
    }
    count
}

#[test]
fn a_fan_takes_time_proportional_to_its_size() {
    let [few, many] = [1, 4].map(|k| slices(testing::disc(k * 8000), 100));
    assert!(many < 5 * few, "{few} {many}");
}

#[test]
fn each_vertex_knows_its_triangles_and_few_removed_ones() {
    for soup in [testing::blob(3), testing::disc(500), testing::flat(12)] {
        let full = mesh(soup);
        let vertices = full.positions().len() as u32;
        let mut work = Simplifying::new(full, 40, f64::INFINITY);
        while work.stage != SimplifyingPhase::Collapse {
            assert!(work.advance().is_none());
        }
        let mut left = i64::MAX;
        while work.next(&mut left) {
            for v in 0..vertices {
                let living = work.collapse.living(v).count();
                assert_eq!(work.degrees[v as usize] as usize, living);
                let listed = work.collapse.listed(v);
                assert!(
                    listed <= (2 * living).max(MANY as usize),
                    "{listed} {living}"
                );
            }
        }
        assert!(work.left <= 80, "{}", work.left);
    }
}
