//! Frames of any scene, size and slicing, and scenes that cannot be drawn.

use super::scene::around;
use super::scene_rays::*;
use bubblestone::scene::{Backdrop, Body, Frame, Lighting, Order, Place, Scene, Sharpness};
use bubblestone::solid::Surface;
use glam::Vec3;

const SIZE: [usize; 2] = [96, 72];

#[test]
fn frames_have_any_size() {
    let scene = still_life();
    for size in [[1, 1], [8192, 1], [1, 300]] {
        let camera = camera(330.0, 38.0, 2.6, 35.0);
        let frame = plain(&scene, order(camera, size));
        assert_eq!(frame.rgba().len(), 4 * size[0] * size[1]);
        let rays = Rays::new(&scene);
        let mut inner = 0;
        for at in (0..size[0] * size[1]).step_by(29) {
            let (x, y) = (at % size[0], at / size[0]);
            let hits = around(&rays, frame.order(), x, y).map(|hit| hit.map(|hit| hit.instance));
            if hits.iter().all(|hit| *hit == hits[0]) {
                inner += 1;
                assert_eq!(frame.instance_at(x, y), hits[0], "{size:?}: {x}, {y}");
            }
        }
        // The only pixel of the smallest frame is on edges.
        assert!(inner > 5 || size == [1, 1], "{size:?}");
    }
}

#[test]
fn nothing_gives_the_backdrop() {
    let empty = Scene::default();
    assert_eq!(empty.fault(), None);
    for (backdrop, _) in Backdrop::ALL {
        for samples in [1, 4] {
            let view = order(camera(330.0, 38.0, 2.0, 35.0), [20, 10]);
            let frame = plain(
                &empty,
                Order {
                    backdrop,
                    samples,
                    ..view
                },
            );
            let alpha = if backdrop == Backdrop::Nothing {
                0
            } else {
                255
            };
            assert!(frame.rgba().chunks(4).all(|pixel| pixel[3] == alpha));
            let is_dark = frame.rgba().chunks(4).all(|pixel| pixel[0] < 90);
            assert_eq!(is_dark, backdrop == Backdrop::Nothing);
            assert!(frame.ids().iter().all(|&id| id == 0) && frame.instance_at(3, 3).is_none());
        }
    }
}

#[test]
fn bad_scenes_are_told() {
    let told = |scene: Scene, word: &str| {
        let fault = scene.fault();
        assert!(
            fault.as_ref().is_some_and(|text| text.contains(word)),
            "{fault:?}"
        );
    };
    type Change = fn(&mut Surface);
    let changes: [(Change, &str); 7] = [
        (|s| s.positions[3].x = f32::NAN, "vertex 3"),
        (|s| s.positions[0].y = f32::INFINITY, "vertex 0"),
        (|s| s.positions[1].z = -1e30, "vertex 1"),
        (|s| s.normals[2].y = f32::NAN, "vertex 2"),
        (|s| s.triangles[5] = [0, 1, 99], "triangle 5"),
        (|s| s.colours.truncate(2), "colour"),
        (|s| s.normals.clear(), "normal"),
    ];
    for (change, word) in changes {
        let mut surface = block(Vec3::ONE);
        change(&mut surface);
        assert!(surface.fault().unwrap().contains(word));
        let mut scene = still_life();
        // The fault may also be in a coarser level.
        let levels = &mut scene.bodies[1].levels;
        *levels = [&levels[..], &[surface]].concat().into();
        told(scene, word);
    }
    let mut missing = still_life();
    missing.instances[2].body = 5;
    told(missing, "body 2");
    let mut without = still_life();
    without.bodies.push(Body::default());
    without.instances[1].body = 5;
    told(without, "body 1");
    let nowhere = [f32::NAN, f32::INFINITY, 1e30];
    for number in nowhere {
        let mut moved = still_life();
        moved.instances[3].place.origin.y = number;
        told(moved, "body 3");
        let mut turned = still_life();
        turned.instances[4].place.axes[2].z = number;
        told(turned, "body 4");
    }
    // The largest valid numbers can be drawn.
    let mut large = still_life();
    let mut levels = large.bodies[1].levels.to_vec();
    levels[0].positions[4] = Vec3::new(1e9, -1e9, 1e9);
    large.bodies[1] = Body::new(levels, 0);
    large.instances[1].place.axes = [Vec3::X * 1e9, Vec3::Y * 1e9, Vec3::Z * 1e9];
    large.instances[1].place.origin = Vec3::splat(-1e9);
    assert_eq!(large.fault(), None);
    for lamp in [sun(0.3, 0.8, 0.1), bulb([0.2, 1.0, 0.3])] {
        let light = lighting(&large, lamp, &PARAMS, 1_000_000);
        let view = order(camera(330.0, 38.0, 2.6, 35.0), SIZE);
        frame(&large, &light, view, 1_000_000);
    }
}

/// The slices are one row or triangle, or everything at once.
#[test]
fn slices_do_not_change_a_frame() {
    let mut scene = still_life();
    scene.lines = edges(&scene);
    let view = camera(330.0, 38.0, 2.2, 45.0);
    for lamp in [sun(0.5, 0.8, -0.3), bulb([0.2, 1.1, 0.4])] {
        let made = [1, 997, 1_000_000_000].map(|amount| {
            let light = lighting(&scene, lamp, &PARAMS, amount);
            [(1, false), (4, false), (1, true)].map(|(samples, is_moving)| {
                let order = Order {
                    samples,
                    is_moving,
                    backdrop: Backdrop::Floor,
                    cut: None,
                    ..order(view, [40, 30])
                };
                let frame = frame(&scene, &light, order, amount);
                let depths: Vec<u32> = frame.depths().iter().map(|d| d.to_bits()).collect();
                (
                    frame.rgba().to_vec(),
                    depths,
                    frame.ids().to_vec(),
                    frame.normals().to_vec(),
                )
            })
        });
        assert!(made[0] == made[1] && made[0] == made[2], "{lamp:?}");
    }
}

/// A frame that reuses the memory of another one is the same as a new one.
#[test]
fn memory_keeps_nothing_of_the_frame_before() {
    let scene = still_life();
    let light = lighting(&scene, sun(0.5, 0.8, -0.3), &PARAMS, 100_000);
    let small = order(camera(330.0, 38.0, 2.2, 45.0), [40, 30]);
    let large = Order {
        samples: 4,
        aperture: 0.1,
        backdrop: Backdrop::Sky,
        cut: None,
        ..order(camera(30.0, 60.0, 3.0, 45.0), [60, 50])
    };
    let mut kept = Frame::new(large);
    for order in [large, small, large] {
        kept.begin(order);
        while !kept.advance(&scene, &light, 700) {}
        let new = frame(&scene, &light, order, 700);
        assert!(kept.rgba() == new.rgba() && kept.depths() == new.depths());
        assert!(kept.ids() == new.ids() && kept.normals() == new.normals());
    }
}

/// A large body takes no larger slices than many small ones; neither do maps and planes.
#[test]
fn large_bodies_and_frames_are_cut_into_slices() {
    const AMOUNT: usize = 2000;
    let scene = scene(vec![(ball(100), Place::default())]);
    let triangles = scene.bodies[0].levels[0].triangles.len();
    for lamp in [sun(0.5, 0.8, -0.3), bulb([0.2, 3.0, 0.4])] {
        let mut light = Lighting::new(&scene, lamp, (&PARAMS, &[MATT]), Sharpness::Large);
        let mut calls = 1;
        while !light.advance(&scene, AMOUNT) {
            calls += 1;
        }
        assert!(calls > triangles / AMOUNT, "{calls} for the light");
        let mut before = 0;
        for size in [[40, 30], [400, 300]] {
            let mut frame = Frame::new(order(camera(330.0, 38.0, 4.0, 45.0), size));
            let (mut calls, mut progress) = (1, 0.0);
            while !frame.advance(&scene, &light, AMOUNT) {
                calls += 1;
                assert!(frame.progress() >= progress && frame.progress() < 1.0);
                progress = frame.progress();
            }
            // Shading alone takes as many slices as its pixels need.
            let least = triangles / AMOUNT + size[0] * size[1] / AMOUNT;
            assert!(calls > least.max(before), "{calls} for a frame of {size:?}");
            before = calls;
        }
    }
}
