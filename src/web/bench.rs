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

/// The skin that the benchmark subdivides, for other programs: an object as from [`bench_mesh`].
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

/// The pebbles in a bowl that the benchmark heaps, for other programs: `{ hulls, shapes, sizes, bound, positions,
/// triangles, radius, top, overlaps }`.
#[cfg(house)]
#[wasm_bindgen]
pub fn bench_pile() -> Object {
    let Some(pebbles) = suite::pile::Pebbles::new() else {
        return Object::new();
    };
    let hulls: Array = pebbles
        .hulls()
        .map(|hull| js_sys::Float32Array::from(hull.as_flattened()))
        .collect();
    let shapes: Vec<u32> = pebbles.bodies.iter().map(|body| body.shape).collect();
    let sizes: Vec<f64> = pebbles.bodies.iter().map(|body| body.scale).collect();
    let bowl = pebbles.bowl();
    let places: Vec<f32> = bowl.positions.iter().flat_map(|p| p.to_array()).collect();
    let most = |of: fn(&Vec3) -> f32| bowl.positions.iter().map(of).fold(0.0, f32::max);
    let numbers = |list: &[f64]| list.iter().map(|&v| JsValue::from(v)).collect::<Array>();
    object(&[
        ("hulls", hulls.into()),
        ("shapes", Uint32Array::from(&shapes[..]).into()),
        ("sizes", js_sys::Float64Array::from(&sizes[..]).into()),
        ("bound", pebbles.bound().into()),
        ("positions", js_sys::Float32Array::from(&places[..]).into()),
        (
            "triangles",
            Uint32Array::from(bowl.triangles.as_flattened()).into(),
        ),
        ("radius", most(|p| (p.x * p.x + p.z * p.z).sqrt()).into()),
        ("top", most(|p| p.y).into()),
        ("overlaps", numbers(&pebbles.overlaps()).into()),
    ])
}

/// How deep the inner spheres of these pebbles overlap at other places, of which each has seven numbers: x, y, z, and a
/// quaternion. Returns `[deepest, mean]`.
#[cfg(house)]
#[wasm_bindgen]
pub fn bench_overlaps(places: &[f64]) -> Vec<f64> {
    let pebbles = suite::pile::Pebbles::new();
    let overlaps = pebbles.map(|pebbles| pebbles.moved(places.as_chunks::<7>().0).overlaps());
    overlaps.map_or(Vec::new(), |overlaps| overlaps.to_vec())
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
