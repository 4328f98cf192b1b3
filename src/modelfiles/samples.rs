//! Files for tests of the readers.

use crate::trimesh::testing::{self, Soup as Raw};
use glam::DVec3;

/// A model whose coordinates are exact as f32, as in most files.
pub fn model() -> Raw {
    let (positions, triangles) = testing::blob(2);
    let rounded = positions.iter().map(|p| p.as_vec3().as_dvec3());
    (rounded.collect(), triangles)
}

pub fn obj((positions, triangles): &Raw) -> String {
    let mut text = String::from("# a model\nmtllib x.mtl\no blob\n");
    for p in positions {
        text += &format!("v {} {} {}\n", p.x, p.y, p.z);
    }
    text += "vt 0 0\nvn 0 0 1\ng all\nusemtl stone\ns off\n";
    for t in triangles {
        let [a, b, c] = t.map(|v| v + 1);
        text += &format!("f {a}/1/1 {b}//1 {c}\n");
    }
    text
}

pub fn ply((positions, triangles): &Raw, format: &str) -> Vec<u8> {
    let head = format!(
        "ply\nformat {format} 1.0\ncomment made\nelement vertex {}\nproperty float x\nproperty uchar red\n\
         property double y\nproperty float z\nproperty list uchar short odd\nelement other 2\n\
         property int n\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        positions.len(),
        triangles.len()
    );
    let mut bytes = head.into_bytes();
    let big = format == "binary_big_endian";
    let mut put = |le: &[u8]| match big {
        true => bytes.extend(le.iter().rev()),
        false => bytes.extend(le),
    };
    if format == "ascii" {
        let mut text = String::new();
        for p in positions {
            text += &format!("{} 7 {} {} 2 -1 -2\n", p.x, p.y, p.z);
        }
        text += "5\n-6\n";
        for [a, b, c] in triangles {
            text += &format!("3 {a} {b} {c}\n");
        }
        bytes.extend(text.bytes());
        return bytes;
    }
    for p in positions {
        put(&(p.x as f32).to_le_bytes());
        put(&[7]);
        put(&p.y.to_le_bytes());
        put(&(p.z as f32).to_le_bytes());
        put(&[1]);
        put(&(-3i16).to_le_bytes());
    }
    put(&5i32.to_le_bytes());
    put(&(-6i32).to_le_bytes());
    for t in triangles {
        put(&[3]);
        t.iter().for_each(|v| put(&v.to_le_bytes()));
    }
    bytes
}

pub fn stl((positions, triangles): &Raw, head: &[u8]) -> Vec<u8> {
    let mut bytes = head.to_vec();
    bytes.resize(80, b' ');
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for t in triangles {
        bytes.extend([0; 12]);
        for v in t {
            let p = positions[*v as usize].as_vec3();
            bytes.extend(p.to_array().iter().flat_map(|x| x.to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

pub fn stl_text((positions, triangles): &Raw) -> String {
    let mut text = String::from("solid blob\n");
    for t in triangles {
        text += " facet normal 0 0 0\r\n  outer loop\n";
        for v in t {
            let p = positions[*v as usize];
            text += &format!("   vertex {:e} {} {}\n", p.x, p.y, p.z);
        }
        text += "  endloop\n endfacet\n";
    }
    text + "endsolid blob\n"
}

pub fn glb_of(json: &str, numbers: &[u8]) -> Vec<u8> {
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF".to_vec();
    let all = 12 + 8 + json.len() + 8 + numbers.len();
    for n in [2, all as u32, json.len() as u32] {
        bytes.extend(n.to_le_bytes());
    }
    bytes.extend(b"JSON");
    bytes.extend(json);
    bytes.extend((numbers.len() as u32).to_le_bytes());
    bytes.extend(b"BIN\0");
    bytes.extend(numbers);
    bytes
}

/// A GLB file of positions and corners; `nodes` and `more` are parts of its JSON.
pub fn glb(positions: &[DVec3], corners: &[u32], kind: u32, nodes: &str, more: &str) -> Vec<u8> {
    let mut numbers = Vec::new();
    for p in positions {
        let p = p.as_vec3();
        numbers.extend(p.to_array().iter().flat_map(|x| x.to_le_bytes()));
    }
    let places = numbers.len();
    let size = [1, 0, 2, 0, 4][kind as usize - 5121];
    for v in corners {
        numbers.extend(&v.to_le_bytes()[..size]);
    }
    numbers.resize(numbers.len().next_multiple_of(4), 0);
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{nodes}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1{more}}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}},
        {{"bufferView":1,"componentType":{kind},"count":{},"type":"SCALAR"}}],
        "bufferViews":[{{"buffer":0,"byteLength":{places}}},{{"buffer":0,"byteOffset":{places},"byteLength":{}}}],
        "buffers":[{{"byteLength":{}}}]}}"#,
        positions.len(),
        corners.len(),
        numbers.len() - places,
        numbers.len()
    );
    glb_of(&json, &numbers)
}

pub fn glb_model((positions, triangles): &Raw) -> Vec<u8> {
    let corners: Vec<u32> = triangles.iter().flatten().copied().collect();
    glb(positions, &corners, 5123, r#"{"mesh":0}"#, "")
}

/// One model as files of all kinds.
pub fn files() -> Vec<(&'static str, Vec<u8>)> {
    let model = model();
    vec![
        ("a.obj", obj(&model).into_bytes()),
        ("a.ply", ply(&model, "ascii")),
        ("b.ply", ply(&model, "binary_little_endian")),
        ("c.ply", ply(&model, "binary_big_endian")),
        ("a.stl", stl(&model, b"a head")),
        ("b.stl", stl(&model, b"solid but of numbers, with a facet")),
        ("c.stl", stl_text(&model).into_bytes()),
        ("a.glb", glb_model(&model)),
    ]
}
