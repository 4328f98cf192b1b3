//! The benchmarks, and the meshes that other programs are measured with.

use super::{Clock, object};
use crate::suite;
use glam::Vec3;
use js_sys::{Array, Object, Uint32Array};
use wasm_bindgen::prelude::*;

/// Runs all benchmarks. Returns a list of `{ name, ms }`.
#[wasm_bindgen]
pub fn bench() -> Array {
    let clock = Clock::new();
    let timings = suite::run(&mut || clock.now());
    let entry = |t: &suite::Timing| {
        let name = t.name.as_str().into();
        object(&[("name", name), ("ms", t.ms.into())])
    };
    timings.iter().map(entry).collect()
}

/// The stones that the benchmark subdivides, for other programs: `{ points, triangles, stones, levels }`.
#[wasm_bindgen]
pub fn bench_mesh() -> Object {
    let (points, triangles) = suite::control_mesh();
    mesh_object(&points, &triangles, suite::STONES, suite::LEVELS)
}

/// The same for the skin.
#[wasm_bindgen]
pub fn bench_skin() -> Object {
    let (mesh, levels, stones) = suite::skin_mesh();
    mesh_object(&mesh.vertices, &mesh.triangles, stones, levels)
}

/// The hide that the benchmark lights, for other programs: `{ positions, normals, colours, triangles, width,
/// height, eye, target, lens, lamp, middle, radius }`.
#[cfg(house)]
#[wasm_bindgen]
pub fn bench_hide() -> Object {
    let Some(hide) = suite::scene::Hide::new() else {
        return Object::new();
    };
    let (mut positions, mut normals, mut colours) = (Vec::new(), Vec::new(), Vec::new());
    let mut triangles = Vec::new();
    for (surface, place) in hide.surfaces() {
        let first = (positions.len() / 3) as u32;
        let corners = surface.triangles.as_flattened().iter();
        triangles.extend(corners.map(|corner| first + corner));
        positions.extend(
            surface
                .positions
                .iter()
                .flat_map(|&p| place.of(p).to_array()),
        );
        normals.extend(
            surface
                .normals
                .iter()
                .flat_map(|&n| place.turned(n).to_array()),
        );
        colours.extend_from_slice(surface.colours.as_flattened());
    }
    let (camera, [width, height]) = (suite::scene::CAMERA, suite::scene::SIZE);
    let view = camera.view(width, height);
    let (lamp, middle, radius) = hide.lit();
    let vector = |v: [f32; 3]| js_sys::Float32Array::from(&v[..]).into();
    object(&[
        (
            "positions",
            js_sys::Float32Array::from(&positions[..]).into(),
        ),
        ("normals", js_sys::Float32Array::from(&normals[..]).into()),
        ("colours", js_sys::Uint8Array::from(&colours[..]).into()),
        ("triangles", Uint32Array::from(&triangles[..]).into()),
        ("width", width.into()),
        ("height", height.into()),
        ("eye", vector(view.eye.to_array())),
        ("target", vector(camera.target.map(|v| v as f32))),
        ("lens", camera.lens.into()),
        ("lamp", vector(lamp)),
        ("middle", vector(middle)),
        ("radius", radius.into()),
    ])
}

fn mesh_object(points: &[Vec3], triangles: &[[u32; 3]], stones: usize, levels: u32) -> Object {
    let points: Vec<f32> = points.iter().flat_map(|p| p.to_array()).collect();
    object(&[
        ("points", js_sys::Float32Array::from(&points[..]).into()),
        (
            "triangles",
            Uint32Array::from(triangles.as_flattened()).into(),
        ),
        ("stones", stones.into()),
        ("levels", levels.into()),
    ])
}
