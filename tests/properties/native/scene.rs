//! Frames of bodies agree with rays from the eye.

use super::scene_rays::*;
use bubblestone::scene::{Camera, Instance, Order, Place, Scene};
use glam::Vec3;

const SIZE: [usize; 2] = [96, 72];

/// The hits of the rays through a pixel: through its middle first, then through its corners.
pub(super) fn around(rays: &Rays, order: &Order, x: usize, y: usize) -> [Option<Hit>; 5] {
    let view = order.camera.view(order.size[0], order.size[1]);
    let places = [[0.5, 0.5], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    places.map(|[i, j]| rays.seen(&view, x as f64 + i, y as f64 + j))
}

/// Compares a frame with rays. A pixel is on an edge if the rays through its middle and its corners do not all
/// meet the same body. In other pixels the body must agree. If the rays meet one triangle, depth and normal
/// must agree, too; otherwise they must lie between those of the rays.
fn compare(scene: &Scene, order: Order, words: &str) {
    let (rays, frame) = (Rays::new(scene), plain(scene, order));
    let [width, height] = order.size;
    let (mut inner, mut covered) = (0, 0);
    for at in 0..width * height {
        let (x, y) = (at % width, at / width);
        let hits = around(&rays, &order, x, y);
        let body = |hit: &Option<Hit>| hit.map(|hit| hit.instance);
        if hits.iter().any(|hit| body(hit) != body(&hits[0])) {
            continue;
        }
        inner += 1;
        let words = format!("{words}: pixel {x},{y}");
        assert_eq!(frame.instance_at(x, y), body(&hits[0]), "{words}");
        let [Some(middle), corners @ ..] = hits.map(|hit| hit.filter(|hit| hit.away > 0.0)) else {
            assert_eq!(
                (frame.depths()[at], frame.rgba()[4 * at + 3]),
                (0.0, 0),
                "{words}"
            );
            continue;
        };
        covered += 1;
        let depth = f64::from(frame.depths()[at]);
        let all = || {
            corners
                .iter()
                .flatten()
                .chain([&middle])
                .map(|hit| hit.away)
        };
        let (near, far) = all().fold((f64::MAX, 0.0f64), |(a, b), t| (a.min(t), b.max(t)));
        // Corners are rounded to 1/256 of a pixel, and numbers to f32.
        let is_one = corners
            .iter()
            .flatten()
            .all(|hit| hit.triangle == middle.triangle);
        let error = 2e-5 * far + 0.02 * (far - near);
        let (least, most) = if is_one {
            (middle.away, middle.away)
        } else {
            (near, far)
        };
        let in_bounds = depth > least - error && depth < most + error;
        assert!(
            in_bounds,
            "{words}: depth {depth} of {least}..{most}, error {error}"
        );
        let normal = frame.normals()[at];
        let wanted = normal_at(scene, &middle);
        let spread = corners
            .iter()
            .flatten()
            .map(|hit| normal_at(scene, hit).distance(wanted));
        let part = if is_one { 0.03 } else { 1.0 };
        let error = 4e-3 + part * spread.fold(0.0, f32::max);
        assert!(
            normal.distance(wanted) < error,
            "{words}: normal {normal} of {wanted}"
        );
    }
    assert!(
        covered > 300 && 2 * inner > width * height,
        "{words}: {covered} of {inner}"
    );
}

#[test]
fn frames_are_what_rays_meet() {
    let scene = still_life();
    let cameras = [
        camera(330.0, 38.0, 2.6, 35.0),
        camera(100.0, 5.0, 3.0, 40.0),
        camera(200.0, 90.0, 2.6, 50.0),
        camera(45.0, -60.0, 3.0, 35.0),
        // A wide lens among the bodies, and a narrow one far away.
        camera(20.0, 30.0, 1.2, 100.0),
        camera(280.0, 25.0, 18.0, 5.0),
    ];
    for camera in cameras {
        compare(&scene, order(camera, SIZE), &format!("{camera:?}"));
    }
}

/// Bodies with many triangles, rotated and scaled, far away and near, agree with rays in position and normal.
#[test]
fn places_turn_and_scale_bodies() {
    for (degrees, scale, lens) in [(200.0, 0.01, 5.0), (77.0, 1.0, 40.0), (310.0, 6.0, 90.0)] {
        let turned = |degrees: f64, at: [f32; 3]| {
            place([0.3, 1.0, -0.7], degrees, scale, at.map(|v| v * scale))
        };
        let mut scene = scene(vec![
            (torus(32, 16), turned(degrees, [0.0, 0.0, 0.0])),
            (ball(16), turned(degrees, [0.0, 1.3, 0.0])),
        ]);
        for instance in &mut scene.instances {
            instance.place.origin += Vec3::new(0.3, -0.2, 0.5);
        }
        let far = 1.8 / libm::tan(0.5 * f64::to_radians(lens)) * f64::from(scale);
        let camera = Camera {
            target: [0.3, -0.2 + 0.4 * f64::from(scale), 0.5],
            ..camera(130.0, 30.0, far, lens)
        };
        compare(&scene, order(camera, SIZE), &format!("scale {scale}"));
    }
}

/// If the ray of a pixel and those of its neighbours meet a closed body, the pixel shows it.
#[test]
fn closed_bodies_have_no_holes() {
    let bodies = [ball(24), torus(48, 24), rod(40)];
    let size = [48, 36];
    for (k, body) in bodies.into_iter().enumerate() {
        let scene = scene(vec![(body, Place::default())]);
        let rays = Rays::new(&scene);
        let is_checked = |turn: usize| turn.is_multiple_of(25);
        for turn in 0..200 {
            // Directions of a Fibonacci sphere.
            let height = libm::asin(1.0 - 2.0 * (turn as f64 + 0.5) / 200.0).to_degrees();
            let angle = (137.507_764 * turn as f64) % 360.0;
            let order = order(camera(angle, height, 4.0, 35.0), size);
            let frame = plain(&scene, order);
            let is_body = |x: usize, y: usize| frame.instance_at(x, y).is_some();
            let view = order.camera.view(size[0], size[1]);
            let meets =
                |x: usize, y: usize| rays.seen(&view, x as f64 + 0.5, y as f64 + 0.5).is_some();
            for (x, y) in (1..size[1] - 1).flat_map(|y| (1..size[0] - 1).map(move |x| (x, y))) {
                let block = || (y - 1..=y + 1).flat_map(|j| (x - 1..=x + 1).map(move |i| (i, j)));
                let count = block().filter(|&(i, j)| is_body(i, j)).count();
                // A hole is a background pixel with the body on all sides. Rays are computed at such pixels,
                // and for some directions at all pixels.
                if !is_body(x, y) && (count >= 6 || is_checked(turn)) {
                    let all = block().all(|(i, j)| meets(i, j));
                    assert!(!all, "body {k} from {angle}, {height}: {x},{y}");
                }
            }
        }
    }
}

#[test]
fn triangles_of_any_size_are_drawn() {
    // From straight above, squares as large as the frame or larger cover all of it.
    let above = order(camera(0.0, 90.0, 1.0, 60.0), SIZE);
    for half in [0.8, 80.0, 8000.0] {
        let scene = scene(vec![(square(half), Place::default())]);
        let frame = plain(&scene, above);
        for (at, depth) in frame.depths().iter().enumerate() {
            assert!((depth - 1.0).abs() < 1e-3, "{half}: {depth} at {at}");
        }
    }
    // Seen along its surface, a square through the near plane and far beyond ends at the horizon.
    let along = order(camera(30.0, 10.0, 0.2, 60.0), SIZE);
    for half in [2.0, 2000.0] {
        let scene = scene(vec![(square(half), Place::default())]);
        compare(&scene, along, &format!("square of {half}"));
    }
    compare(
        &still_life(),
        order(camera(70.0, 20.0, 0.35, 80.0), SIZE),
        "near plane",
    );
}

#[test]
fn what_is_behind_the_camera_or_around_it_is_not_seen() {
    let view = order(camera(0.0, 0.0, 2.0, 60.0), SIZE);
    for z in [4.0, 2.0, 3.1, 2.9] {
        // The ball is behind the eye at z = 2, or around it: the inside of a body is not visible.
        let scene = scene(vec![(ball(12), Place::at(Vec3::new(0.0, 0.0, z)))]);
        let frame = plain(&scene, view);
        assert!(frame.ids().iter().all(|&id| id == 0), "at {z}");
    }
}

/// Many bodies smaller than a pixel are dots of their own colour; the nearest one is visible.
#[test]
fn small_bodies_are_dots() {
    let mut scene = scene(vec![(ball(4), Place::default())]);
    let mut chance = Chance(7);
    let place = |chance: &mut Chance| {
        let at = [(); 3].map(|()| chance.next() - 0.5);
        place([0.0, 1.0, 0.0], 0.0, 2e-4, at)
    };
    scene.instances = (0..200_000)
        .map(|k| Instance {
            body: 0,
            place: place(&mut chance),
            id: k + 1,
            paint: None,
        })
        .collect();
    let order = order(camera(20.0, 30.0, 2.0, 45.0), SIZE);
    let frame = plain(&scene, order);
    let view = order.camera.view(SIZE[0], SIZE[1]);
    let mut wanted = vec![(0.0, 0); SIZE[0] * SIZE[1]];
    for instance in &scene.instances {
        let [x, y, near] = view.on_screen(view.of(instance.place.origin));
        if x >= 0.0 && y >= 0.0 && x < SIZE[0] as f32 && y < SIZE[1] as f32 {
            let at = y as usize * SIZE[0] + x as usize;
            if near > wanted[at].0 {
                wanted[at] = (near, instance.id);
            }
        }
    }
    let same = (0..wanted.len()).filter(|&at| frame.ids()[at] == wanted[at].1);
    // A body's middle is that of its box, which differs from its origin by rounding.
    assert!(same.count() * 1000 > 995 * wanted.len());
    assert!(frame.ids().iter().filter(|&&id| id > 0).count() > 2000);
}

/// A ball far to the side of a wide lens is drawn, however large it looks. It is hidden only where a nearer
/// ball covers it.
#[test]
fn balls_at_the_side_of_a_wide_lens_are_not_overlooked() {
    let mut chance = Chance(11);
    let ball = ball(5);
    for turn in 0..10 {
        let at = |chance: &mut Chance, z: f32| {
            let [x, y] = [(); 2].map(|()| 3.2 * (chance.next() - 0.5));
            [x * 1.3, y, z]
        };
        let mut parts = Vec::new();
        for k in 0..10 {
            let z = -0.15 * k as f32;
            let scale = if k < 5 { 0.35 } else { 0.2 };
            parts.push((
                ball.clone(),
                place(
                    [0.0, 1.0, 0.3],
                    40.0 * f64::from(k),
                    scale,
                    at(&mut chance, z),
                ),
            ));
        }
        let scene = scene(parts);
        compare(
            &scene,
            order(camera(0.0, 0.0, 1.0, 100.0), SIZE),
            &format!("turn {turn}"),
        );
    }
}
