use super::super::testing::{self, mesh};
use super::super::*;
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const MIDDLE: DVec3 = DVec3::splat(1.0 / 3.0);

/// The point of a mesh above or below a place of the plane y = 0.
fn above(mesh: &TriMesh, x: f64, z: f64) -> SurfacePoint {
    let inside = |t: &u32| mesh.weights(*t, DVec3::new(x, 0.0, z)).min_element() > -1e-12;
    let triangle = (0..mesh.triangles().len() as u32).find(inside).unwrap();
    let weights = mesh.weights(triangle, DVec3::new(x, 0.0, z));
    SurfacePoint::new(mesh, triangle, weights)
}

/// Walks by the tangential part of a vector in space.
fn go(mesh: &TriMesh, from: &SurfacePoint, by: DVec3) -> Walked {
    mesh.walk(from, from.frame().within(by))
}

fn is_near(a: DVec3, b: DVec3, most: f64) -> bool {
    (a - b).length() < most
}

#[test]
fn on_a_flat_irregular_mesh_a_walk_is_a_straight_line() {
    let mesh = mesh(testing::flat(23));
    let mut chance = testing::chance(1);
    for _ in 0..2000 {
        let mut place = || {
            DVec3::new(
                0.98 * chance.unit() + 0.01,
                0.0,
                -0.98 * chance.unit() - 0.01,
            )
        };
        let (from, to) = (place(), place());
        let start = above(&mesh, from.x, from.z);
        let walked = go(&mesh, &start, to - from);
        assert!(is_near(walked.to.at, to, 1e-12), "{from} {to}");
        let inside = walked.to.weights(&mesh).min_element();
        assert!(inside > -1e-12 && !walked.slid);
        assert!((walked.turn.0 - DVec2::X).length() < 1e-12);
    }
}

#[test]
fn through_vertices_and_along_edges_it_goes_straight_on() {
    let mesh = mesh(testing::grid(8, 8, |u, v| DVec3::new(u, 0.0, -v)));
    let vertex = |i: i32, j: i32| DVec3::new(f64::from(i) / 8.0, 0.0, -f64::from(j) / 8.0);
    for from in [[0, 0], [2, 4], [3, 5], [8, 8], [5, 0]] {
        for to in [
            [0, 0],
            [8, 8],
            [8, 0],
            [0, 4],
            [4, 8],
            [3, 5],
            [7, 1],
            [2, 5],
        ] {
            let (a, b) = (vertex(from[0], from[1]), vertex(to[0], to[1]));
            // The walk does not depend on which of the triangles around the vertex it begins in.
            for t in 0..mesh.triangles().len() as u32 {
                let weights = mesh.weights(t, a);
                if weights.min_element() > -1e-9 {
                    let start = SurfacePoint::new(&mesh, t, weights);
                    let walked = go(&mesh, &start, b - a);
                    assert!(is_near(walked.to.at, b, 1e-12), "{from:?} {to:?} {t}");
                }
            }
        }
    }
}

#[test]
fn scale_and_place_do_not_matter() {
    for (scale, moved) in [(1e-6, 0.0), (1e6, 0.0), (1.0, 1e3)] {
        let (positions, triangles) = testing::flat(9);
        let moved = DVec3::splat(moved);
        let positions = positions.iter().map(|&p| p * scale + moved).collect();
        let mesh = mesh((positions, triangles));
        let start = SurfacePoint::new(&mesh, 30, MIDDLE);
        let to = moved + scale * DVec3::new(0.4, 0.0, -0.8);
        let walked = go(&mesh, &start, to - start.at);
        assert!(is_near(walked.to.at, to, 1e-12 * (scale + moved.x)));
    }
}

#[test]
fn round_a_prism_it_comes_back() {
    for facets in [4, 7, 60] {
        let mesh = mesh(testing::tube(facets, 5));
        let round = f64::from(facets) * 2.0 * libm::sin(PI / f64::from(facets));
        let start = SurfacePoint::new(&mesh, 2 * facets + 1, DVec3::new(0.2, 0.3, 0.5));
        let face = mesh.face_normal(start.triangle);
        let frame = start.frame();
        // Around the tube, in the plane of the facet.
        let around = DVec3::Y.cross(face).normalize();
        let by = frame.within(frame::rotated(around, face, start.normal));
        for rounds in [1.0, -1.0, 3.0] {
            let walked = mesh.walk(&start, by * (round * rounds));
            assert!(is_near(walked.to.at, start.at, 1e-11), "{facets}");
            assert!((walked.turn.0 - DVec2::X).length() < 1e-11);
        }
    }
}

#[test]
fn round_a_cube_it_comes_back() {
    let mesh = mesh(testing::cube(3));
    // The top face y = 1; its normal is Y in the middle square only.
    let on_top = |t: &u32| mesh.face_normal(*t).y > 0.5;
    for triangle in (0..mesh.triangles().len() as u32).filter(on_top) {
        let start = SurfacePoint::new(&mesh, triangle, DVec3::new(0.5, 0.2, 0.3));
        let frame = start.frame();
        let walk = |v: DVec3| {
            mesh.walk(
                &start,
                frame.within(frame::rotated(v, DVec3::Y, start.normal)),
            )
        };
        for by in [DVec3::X, DVec3::Z, -DVec3::X] {
            assert!(is_near(walk(4.0 * by).to.at, start.at, 1e-12));
        }
        // Over an edge and half way down the next face.
        let down = walk(DVec3::X * (1.5 - start.at.x)).to.at;
        assert!(
            is_near(down, DVec3::new(1.0, 0.5, start.at.z), 1e-12),
            "{down}"
        );
    }
}

#[test]
fn at_the_border_it_goes_along_it() {
    let mesh = mesh(testing::flat(9));
    let start = above(&mesh, 0.5, -0.5);
    let walked = go(&mesh, &start, DVec3::new(1.0, 0.0, -0.25));
    // Half of the step reaches the border; an eighth of it goes on along the border.
    assert!(walked.slid && is_near(walked.to.at, DVec3::new(1.0, 0.0, -0.75), 1e-12));
    assert!((walked.turn.0 - DVec2::X).length() < 1e-12);
    // Into a corner, where the walk ends.
    for by in [[9.0, 8.0], [8.0, 9.0], [3.0, 3.0], [5.0, 0.5]] {
        let walked = go(&mesh, &start, DVec3::new(by[0], 0.0, -by[1]));
        assert!(
            walked.slid && is_near(walked.to.at, DVec3::new(1.0, 0.0, -1.0), 1e-12),
            "{by:?}"
        );
    }
    // Straight at the border, and back from it.
    let walked = go(&mesh, &start, DVec3::X);
    assert!(walked.slid && is_near(walked.to.at, DVec3::new(1.0, 0.0, -0.5), 1e-12));
    let back = go(&mesh, &walked.to, DVec3::new(-0.5, 0.0, 0.25));
    assert!(!back.slid && is_near(back.to.at, DVec3::new(0.5, 0.0, -0.25), 1e-12));
}

#[test]
fn in_a_sharp_corner_it_ends() {
    let needle = vec![
        DVec3::ZERO,
        DVec3::new(1.0, 0.0, 0.1),
        DVec3::new(1.0, 0.0, -0.1),
    ];
    let mesh = mesh((needle, vec![[0, 1, 2]]));
    let start = SurfacePoint::new(&mesh, 0, MIDDLE);
    for by in [[-5.0, 0.0], [-5.0, 0.3], [-2.0, -1.0]] {
        let walked = go(&mesh, &start, DVec3::new(by[0], 0.0, by[1]));
        assert!(
            walked.slid && is_near(walked.to.at, DVec3::ZERO, 1e-12),
            "{by:?} {}",
            walked.to.at
        );
    }
}

#[test]
fn round_the_outside_of_a_ring_the_border_carries_it() {
    let place = |u: f64, v: f64| {
        let r = 1.0 + v;
        DVec3::new(r * libm::cos(TAU * u), 0.0, -r * libm::sin(TAU * u))
    };
    let soup = testing::grid(90, 4, |u, v| {
        place((u * 90.0).round() % 90.0 / 90.0, 1.0 - v)
    });
    let mesh = mesh(testing::joined(soup));
    let start = above(&mesh, 2.0 - 1e-6, 0.0);
    let walked = go(&mesh, &start, DVec3::new(0.0, 0.0, -2.0));
    let at = walked.to.at;
    assert!(walked.slid && (at.length() - 2.0).abs() < 3e-3);
    // The path follows the border: about a radian, a little less because of the corners.
    assert!((libm::atan2(-at.z, at.x) - 1.0).abs() < 0.05, "{at}");
}

#[test]
fn a_vector_carried_round_a_ball_is_turned_by_the_angle_excess() {
    let mesh = mesh(testing::ball(6));
    let start = SurfacePoint::new(&mesh, 4321, MIDDLE);
    for (ahead, corners) in [(DVec2::X, 3), (DVec2::new(0.6, 0.8), 3)] {
        let (mut at, mut heading, mut carried) = (start, ahead, DVec2::X);
        for _ in 0..corners {
            let walked = mesh.walk(&at, heading * FRAC_PI_2);
            heading = walked.turn.apply(heading).perp();
            carried = walked.turn.apply(carried);
            at = walked.to;
        }
        assert!(is_near(at.at, start.at, 0.01), "{}", at.at);
        // An eighth of the ball has three right angles, so transport around it turns by a quarter turn.
        assert!((carried - DVec2::Y).length() < 0.02, "{carried}");
    }
}

#[test]
fn the_way_to_the_end_of_a_walk_is_the_walk() {
    let mesh = mesh(testing::blob(6));
    let mut chance = testing::chance(2);
    for _ in 0..500 {
        let triangle = chance.below(mesh.triangles().len()) as u32;
        let start = SurfacePoint::new(&mesh, triangle, MIDDLE);
        let by = 0.05 * DVec2::new(chance.signed(), chance.signed());
        let walked = mesh.walk(&start, by);
        let way = log(&start, &walked.to).unwrap();
        assert!(
            (way.to - by).length() < 0.03 * by.length(),
            "{} {by}",
            way.to
        );
        let turned = way.turn.apply(walked.turn.apply(DVec2::X));
        assert!((turned - DVec2::X).length() < 0.03);
    }
}

#[test]
fn steps_that_are_none_lead_nowhere() {
    let mesh = mesh(testing::ball(1));
    let start = SurfacePoint::new(&mesh, 3, MIDDLE);
    for by in [DVec2::ZERO, DVec2::NAN, DVec2::new(f64::INFINITY, 0.0)] {
        let walked = mesh.walk(&start, by);
        assert_eq!((walked.to, walked.turn), (start, Transport::NONE));
    }
    // The longest walks end, too.
    assert!(mesh.walk(&start, DVec2::splat(1e9)).to.at.is_finite());
}
