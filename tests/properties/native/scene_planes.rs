//! The other results of a frame: planes, transparency, levels of detail, lines.

use super::scene_rays::*;
use bubblestone::light::ShadeParams;
use bubblestone::scene::{Frame, Lighting, Order, Place, Scene, Sharpness};
use glam::Vec3;
use std::collections::BTreeSet;

const SIZE: [usize; 2] = [96, 72];

/// The coarser levels used during motion keep the silhouette.
#[test]
fn coarse_levels_keep_the_silhouette() {
    let mut scene = scene(vec![(ball(32), Place::default())]);
    let levels = &mut scene.bodies[0].levels;
    *levels = [&levels[..], &[ball(16), ball(8)]].concat().into();
    let still = order(camera(40.0, 30.0, 4.0, 35.0), [120, 100]);
    let moving = Order {
        is_moving: true,
        ..still
    };
    let [still, moving] = [still, moving].map(|order| plain(&scene, order));
    assert_ne!(still.depths(), moving.depths(), "the level is another one");
    let is_body = |frame: &Frame, x: i64, y: i64| {
        let is_in = x >= 0 && y >= 0;
        is_in && frame.instance_at(x as usize, y as usize).is_some()
    };
    for (x, y) in (0..100).flat_map(|y| (0..120).map(move |x| (x, y))) {
        for (one, other) in [(&still, &moving), (&moving, &still)] {
            let near = || (-3..=3).flat_map(|j| (-3..=3).map(move |i| (i, j)));
            let is_near = near().any(|(i, j)| is_body(other, x + i, y + j));
            assert!(!is_body(one, x, y) || is_near, "{x},{y}");
        }
    }
}

/// The background is empty: planes and alpha agree, and pixels at the rim have the colours of bodies.
#[test]
fn planes_say_where_bodies_are() {
    let mut scene = still_life();
    for (instance, id) in scene.instances.iter_mut().zip([70, 4, 900, 12, 33]) {
        instance.id = id;
    }
    let view = order(camera(330.0, 38.0, 2.6, 35.0), SIZE);
    let light = lighting(&scene, sun(0.5, 0.8, -0.3), &PARAMS, 100_000);
    let one = frame(&scene, &light, view, 100_000);
    let mut seen = BTreeSet::new();
    for at in 0..SIZE[0] * SIZE[1] {
        let (depth, id, alpha) = (one.depths()[at], one.ids()[at], one.rgba()[4 * at + 3]);
        let instance = one.instance_at(at % SIZE[0], at / SIZE[0]);
        assert_eq!(id, instance.map_or(0, |k| scene.instances[k].id));
        assert_eq!((depth > 0.0, alpha), (id > 0, if id > 0 { 255 } else { 0 }));
        let length = one.normals()[at].length();
        assert!((length - if id > 0 { 1.0 } else { 0.0 }).abs() < 1e-5);
        seen.insert(id);
    }
    assert_eq!(
        seen.into_iter().collect::<Vec<_>>(),
        [0, 4, 12, 33, 70, 900]
    );
    assert_eq!(one.instance_at(SIZE[0], 0), None);
    assert_eq!(one.instance_at(0, SIZE[1]), None);

    // In the light of the sky alone, a ball has one colour up to its rim: the background is not mixed in.
    let ball = scene_of_ball();
    let params = ShadeParams {
        diffuse: 0.0,
        specular: 0.0,
        occlusion: 0.0,
        shadow: 0.0,
        ..PARAMS
    };
    let light = Lighting::new(
        &ball,
        sun(0.0, 1.0, 0.0),
        (&params, &[MATT]),
        Sharpness::Large,
    );
    let above = order(camera(0.0, 90.0, 4.0, 35.0), SIZE);
    let [one, four] = [1, 4].map(|samples| frame(&ball, &light, Order { samples, ..above }, 9_999));
    let darkest = |frame: &Frame| {
        let there = frame.rgba().chunks(4).filter(|pixel| pixel[3] > 0);
        there.map(|pixel| pixel[0]).min().unwrap()
    };
    assert!(
        darkest(&four) + 6 > darkest(&one),
        "{} {}",
        darkest(&four),
        darkest(&one)
    );
    let parts: BTreeSet<u8> = four.rgba().chunks(4).map(|p| p[3]).collect();
    assert_eq!(
        parts.into_iter().collect::<Vec<_>>(),
        [0, 63, 127, 191, 255]
    );
}

fn scene_of_ball() -> Scene {
    scene(vec![(ball(24), Place::default())])
}

/// An edge in front of a body is drawn, one behind it is not. An edge that ends behind the eye is drawn as far
/// as it is visible.
#[test]
fn lines_are_hidden_by_what_is_before_them() {
    let mut scene = scene_of_ball();
    let size = [61, 61];
    let order = order(camera(0.0, 0.0, 4.0, 50.0), size);
    let dark = |scene: &Scene, y: usize| {
        let frame = plain(scene, order);
        let pixels = frame.rgba().chunks(4).skip(y * 61).take(61);
        pixels.filter(|p| p[0] < 45 && p[3] == 255).count()
    };
    let across = |z: f32| vec![[Vec3::new(-0.5, 0.0, z), Vec3::new(0.5, 0.0, z)]];
    assert_eq!(dark(&scene, 30), 0);
    scene.lines = across(1.1);
    assert!(dark(&scene, 30) > 15);
    scene.lines = across(-1.1);
    assert_eq!(dark(&scene, 30), 0);
    // The line lies on the surface.
    scene.lines = vec![[Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.1, 0.0, 0.995)]];
    assert!(dark(&scene, 30) > 1);
    // The line leads from the front of the ball to far behind the eye, to the right of it.
    scene.lines = vec![[Vec3::new(0.1, 0.0, 2.0), Vec3::new(0.5, 0.0, 400.0)]];
    assert!(dark(&scene, 30) > 15);
    // The line crosses the whole frame without a gap.
    scene.lines = vec![[Vec3::new(-1e4, 0.0, 1.1), Vec3::new(1e4, 0.0, 1.1)]];
    assert_eq!(dark(&scene, 30), 61);
    scene.lines = vec![[Vec3::new(-1e9, 0.0, 1e9), Vec3::new(1e9, 0.0, 1e9)]];
    assert_eq!(dark(&scene, 30), 0);
}
