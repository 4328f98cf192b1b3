//! Mesh files of bodies in space, as other programs read them.

use crate::common::{finished, recipe};
use bubblestone::export::{MeshFormat, MeshOrder};
use bubblestone::generators::{ALL, GivenFile};
use bubblestone::studio::Studio;
use glam::DVec3;
use serde_json::Value;
use std::collections::BTreeMap;

const STAIRS: &str = "v=1&make=pile&form=stairs&ps=4&size=128";

/// The mesh file of a finished picture.
fn mesh_file(studio: &mut Studio, format: MeshFormat) -> Vec<u8> {
    let order = MeshOrder {
        format,
        detail: 100,
        images: None,
        joined: false,
    };
    let meshes = studio.meshes().expect("mesh files");
    let file = meshes.mesh_file(&order, &mut || 0.0, f64::INFINITY);
    file.expect("a file").parts.concat()
}

/// The JSON of a GLB file.
fn json_of(glb: &[u8]) -> Value {
    let length = u32::from_le_bytes(glb[12..16].try_into().expect("four bytes")) as usize;
    serde_json::from_slice(&glb[20..20 + length]).expect("JSON")
}

fn vector(value: &Value) -> DVec3 {
    DVec3::from([0, 1, 2].map(|k| value[k].as_f64().expect("a number")))
}

/// The places of the kept bodies, and their scales, by their darts, of the table of places.
fn table(studio: &mut Studio) -> BTreeMap<String, (DVec3, f64)> {
    let text = studio.meshes().expect("meshes").places().expect("a table");
    let row = |line: &str| {
        let words: Vec<&str> = line.split(',').collect();
        let number = |k: usize| words[k].parse::<f64>().expect("a number");
        let name = format!("{}_{}_layer_{}", words[8], words[10], words[11]);
        let place = DVec3::from([0, 1, 2].map(number));
        (name, (place, number(7)))
    };
    text.lines().skip(1).map(row).collect()
}

#[test]
fn mesh_files_of_a_pile_have_the_lengths_of_its_table_of_places() {
    let mut studio = finished(STAIRS);
    let table = table(&mut studio);
    assert!(table.len() > 20);
    let json = json_of(&mesh_file(&mut studio, MeshFormat::Glb));
    let nodes = json["nodes"].as_array().expect("nodes");
    let (scale, origin) = (vector(&nodes[0]["scale"]), vector(&nodes[0]["translation"]));
    let mut found = 0;
    for node in nodes {
        let Some((place, size)) = node["name"].as_str().and_then(|name| table.get(name)) else {
            continue;
        };
        found += 1;
        let at = origin + scale * vector(&node["translation"]);
        assert!(at.distance(*place) < 1e-5, "{at} is not {place}");
        let own = scale * vector(&node["scale"]);
        assert!((own - DVec3::splat(*size)).length() < 1e-5, "{own}, {size}");
    }
    assert_eq!(found, table.len());
    let objects = objects(&mesh_file(&mut studio, MeshFormat::Obj));
    for (name, (place, _)) in &table {
        let (low, high) = bounds(&objects[name].positions);
        // The place is within the body.
        assert!(place.cmpge(low).all() && place.cmple(high).all(), "{name}");
    }
}

/// An object of an OBJ file.
struct Object {
    positions: Vec<DVec3>,
    corners: Vec<u32>,
}

/// The objects of an OBJ file by their names. Those of the same name are one.
fn objects(obj: &[u8]) -> BTreeMap<String, Object> {
    let read = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
    let options = tobj::LoadOptions::default();
    let (models, _) = tobj::load_obj_buf(&mut &obj[..], &options, read).expect("an OBJ file");
    let mut objects = BTreeMap::new();
    for model in models {
        let object = objects.entry(model.name).or_insert(Object {
            positions: Vec::new(),
            corners: Vec::new(),
        });
        let first = object.positions.len() as u32;
        let places = model.mesh.positions.as_chunks::<3>().0;
        let places = places.iter().map(|p| DVec3::from(p.map(f64::from)));
        object.positions.extend(places);
        object
            .corners
            .extend(model.mesh.indices.iter().map(|k| first + k));
    }
    objects
}

fn bounds(places: &[DVec3]) -> (DVec3, DVec3) {
    let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    places
        .iter()
        .fold(start, |(low, high), &p| (low.min(p), high.max(p)))
}

/// Stairs have upright borders, and so squares without a width below them. A part of the vase is simplified to a triangle
/// with a corner twice.
#[test]
fn no_triangle_of_the_ground_is_without_area() {
    let surface = "v=1&make=surface&cn=200&size=128";
    for link in [
        STAIRS.to_owned(),
        format!("{surface}&form=stairs"),
        format!("{surface}&form=vase"),
    ] {
        let mut studio = finished(&link);
        let objects = objects(&mesh_file(&mut studio, MeshFormat::Obj));
        let ground = objects.get("ground").or(objects.get("shape"));
        let Object { positions, corners } = ground.expect("ground");
        for triangle in corners.as_chunks::<3>().0 {
            let [a, b, c] = triangle.map(|k| positions[k as usize]);
            assert!((b - a).cross(c - a).length() > 0.0, "{link}: {a}, {b}, {c}");
        }
        let bytes = mesh_file(&mut studio, MeshFormat::Glb);
        assert_eq!(short_normals(&bytes), 0, "{link}");
    }
}

/// The number of the file's normals that are not of length 1.
fn short_normals(glb: &[u8]) -> usize {
    let json = json_of(glb);
    let text = u32::from_le_bytes(glb[12..16].try_into().expect("four bytes")) as usize;
    let binary = &glb[28 + text..];
    let whole = |value: &Value| value.as_u64().unwrap_or(0) as usize;
    let meshes = json["meshes"].as_array().expect("meshes").iter();
    let primitives = meshes.flat_map(|mesh| mesh["primitives"].as_array().expect("primitives"));
    let is_short = |at: usize| {
        let number = |k: usize| binary[at + 4 * k..][..4].try_into().expect("four bytes");
        let normal = [0, 1, 2].map(|k| f64::from(f32::from_le_bytes(number(k))));
        (DVec3::from(normal).length() - 1.0).abs() > 1e-3
    };
    let short = primitives.map(|primitive| {
        let accessor = &json["accessors"][whole(&primitive["attributes"]["NORMAL"])];
        let view = &json["bufferViews"][whole(&accessor["bufferView"])];
        let first = whole(&view["byteOffset"]) + whole(&accessor["byteOffset"]);
        let places = (0..whole(&accessor["count"])).map(|k| first + k * whole(&view["byteStride"]));
        places.filter(|&at| is_short(at)).count()
    });
    short.sum()
}

/// A surface on a model: an octahedron, its corners at the distance `size` from `middle`.
fn on_model(middle: DVec3, size: f64) -> Studio {
    let corners = [
        DVec3::X,
        DVec3::NEG_X,
        DVec3::Y,
        DVec3::NEG_Y,
        DVec3::Z,
        DVec3::NEG_Z,
    ];
    let places = corners.map(|corner| {
        let [x, y, z] = (middle + size * corner).to_array();
        format!("v {x} {y} {z}\n")
    });
    let faces = [
        "1 3 5", "3 2 5", "2 4 5", "4 1 5", "3 1 6", "2 3 6", "4 2 6", "1 4 6",
    ];
    let faces = faces.map(|face| format!("f {face}\n"));
    let text = places.concat() + &faces.concat();
    let mut studio = Studio::new(ALL, recipe("v=1&make=surface&form=sphere&cn=60&size=128"));
    let file = GivenFile::whole("model.obj", text.into_bytes());
    assert!(studio.open_file(None, file).expect("a file").is_empty());
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    studio
}

/// The vertices of an OBJ file in double precision.
fn vertices(obj: &[u8]) -> Vec<DVec3> {
    let text = std::str::from_utf8(obj).expect("text");
    let vertex = |line: &str| {
        let numbers = line.strip_prefix("v ")?.split(' ').take(3);
        let numbers: Vec<f64> = numbers
            .map(|word| word.parse().expect("a number"))
            .collect();
        Some(DVec3::from_slice(&numbers))
    };
    text.lines().filter_map(vertex).collect()
}

/// The places of all rings of a file of cells.
fn rings(studio: &Studio) -> Vec<DVec3> {
    let data = studio.engine().data();
    let (_, text) = data
        .iter()
        .find(|(name, _)| *name == "cells.json")
        .expect("cells");
    let value: Value = serde_json::from_str(text).expect("JSON");
    let cells = value["cells"].as_array().expect("a list").iter();
    cells
        .flat_map(|cell| cell["ring"].as_array().expect("a ring").iter().map(vector))
        .collect()
}

fn assert_near(found: &[DVec3], wanted: &[DVec3], most: f64) {
    assert_eq!(found.len(), wanted.len());
    let off = found.iter().zip(wanted).map(|(a, b)| a.distance(*b));
    let off = off.fold(0.0, f64::max);
    assert!(off < most, "{off}");
}

#[test]
fn stones_keep_their_shape_on_a_model_far_from_its_origin() {
    let far = DVec3::new(1048576.0, 0.0, -524288.0);
    let [mut here, mut there] = [DVec3::ZERO, far].map(|middle| on_model(middle, 0.5));
    assert!(here.picture() == there.picture());
    let moved = |places: Vec<DVec3>| -> Vec<DVec3> { places.iter().map(|p| *p + far).collect() };
    assert_near(&rings(&there), &moved(rings(&here)), 1e-9);
    let [near, away] =
        [&mut here, &mut there].map(|studio| vertices(&mesh_file(studio, MeshFormat::Obj)));
    assert_near(&away, &moved(near), 1e-6);
    let root = json_of(&mesh_file(&mut there, MeshFormat::Glb))["nodes"][0].clone();
    assert_eq!(vector(&root["translation"]), far);
    let model = |studio: &Studio| {
        let data = studio.engine().data();
        let model = data.into_iter().find(|(name, _)| *name == "model.obj");
        vertices(model.expect("a model").1.as_bytes())
    };
    assert_near(&model(&there), &moved(model(&here)), 1e-9);
}

#[test]
fn stones_keep_their_shape_on_a_tiny_and_on_a_huge_model() {
    for power in [-31, 56] {
        let mut studio = on_model(DVec3::ZERO, libm::exp2(f64::from(power)));
        let objects = objects(&mesh_file(&mut studio, MeshFormat::Obj));
        for (name, Object { positions, corners }) in &objects {
            let flat = corners.as_chunks::<3>().0.iter().filter(|triangle| {
                let [a, b, c] = triangle.map(|k| positions[k as usize]);
                (b - a).cross(c - a) == DVec3::ZERO
            });
            assert_eq!(flat.count(), 0, "{name}, 2 to {power}");
        }
    }
}
