//! The measurements, and what peers are measured with.

use super::{Clock, object};
use crate::suite;
use glam::Vec3;
use js_sys::{Array, Object, Uint32Array};
use wasm_bindgen::prelude::*;

/// All measurements: a list of `{ name, ms }`.
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

/// What the subdivision is measured with, to be measured elsewhere, too:
/// `{ points, triangles, stones, levels }`.
#[wasm_bindgen]
pub fn bench_mesh() -> Object {
    let (points, triangles) = suite::control_mesh();
    mesh_object(&points, &triangles, suite::STONES, suite::LEVELS)
}

/// The same of the skin.
#[wasm_bindgen]
pub fn bench_skin() -> Object {
    let (mesh, levels, stones) = suite::skin_mesh();
    mesh_object(&mesh.vertices, &mesh.triangles, stones, levels)
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
