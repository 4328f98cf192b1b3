//! Coarse shadow maps leave out hidden bodies, and all texels stay the same.

use super::super::{Body, Instance, Place};
use super::*;
use crate::random::{Purpose, Random};
use crate::solid::Surface;

/// A tetrahedron whose corners are 1 away from the origin.
fn tetrahedron() -> Body {
    let mut surface = Surface::default();
    let corners = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ];
    for corner in corners {
        surface.positions.push(Vec3::from(corner).normalize());
        surface.normals.push(Vec3::from(corner).normalize());
        surface.colours.push([128; 3]);
    }
    surface.triangles = vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
    Body::new(vec![surface], 0)
}

/// Tetrahedra of any size and turn in a ball, most of them hidden by others.
fn heap(seed: u64) -> Scene {
    let mut random = Random::new(seed, Purpose::Scatter, 0);
    let mut place = |largest: f32| {
        let mut vector = || Vec3::from([0; 3].map(|_| random.signed() as f32));
        let (x, across) = (vector().normalize_or(Vec3::X), vector());
        let y = x.cross(across).normalize_or(Vec3::Y);
        let origin = vector();
        let size = largest * random.unit() as f32;
        Place {
            axes: [x, y, x.cross(y)].map(|axis| axis * size),
            origin,
        }
    };
    let instance = |id: u32| Instance {
        body: 0,
        place: place(if id.is_multiple_of(8) { 0.4 } else { 0.05 }),
        id,
        paint: None,
    };
    Scene {
        bodies: vec![tetrahedron()],
        instances: (1..=600).map(instance).collect(),
        ..Scene::default()
    }
}

/// All texels of the finished maps.
fn texels(mut maps: ShadowMaps, scene: &Scene) -> Vec<u32> {
    while !maps.advance(scene, 1_000) {}
    let all = maps.maps.iter().flat_map(|map| &map.near);
    all.map(|near| near.to_bits()).collect()
}

#[test]
fn bodies_that_are_left_out_would_change_no_texel() {
    // With one level of detail, coarse maps draw the same surfaces as others, but leave out hidden
    // bodies.
    for seed in 0..6 {
        let scene = heap(seed);
        let mut random = Random::new(seed, Purpose::Scatter, 1);
        let to = Vec3::from([0; 3].map(|_| random.signed() as f32)).normalize();
        for (side, to) in [(64, Vec3::Y), (64, to), (300, to)] {
            let of = |is_coarse| {
                texels(
                    ShadowMaps::new(&scene, Lamp::Sun(to), side, is_coarse),
                    &scene,
                )
            };
            assert!(of(true) == of(false), "{seed} {side} {to}");
        }
    }
}

#[test]
fn hidden_bodies_are_left_out() {
    let scene = heap(1);
    let slices = |is_coarse| {
        let mut maps = ShadowMaps::new(&scene, Lamp::Sun(Vec3::Y), 64, is_coarse);
        let mut slices = 0;
        while !maps.advance(&scene, 1) {
            slices += 1;
        }
        slices
    };
    let [all, shown] = [false, true].map(slices);
    assert!(4 * shown < 3 * all, "{shown} {all}");
}
