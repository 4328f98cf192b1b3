//! Tests of GLB files.

use super::samples::{glb, glb_of};
use super::tests::{read, refused};
use super::*;
use glam::DVec3;

#[test]
fn nodes_of_a_glb_put_meshes_where_they_are() {
    let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let nodes = format!(
        r#"{{"translation":[10,0,0],"children":[1,2]}},
        {{"mesh":0,"rotation":[0,0,{half},{half}],"scale":[2,3,1]}},
        {{"mesh":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,5,1]}}"#
    );
    let soup = read("a.glb", glb(&triangle, &[0, 1, 2], 5125, &nodes, ""));
    let wanted = [
        [10.0, 0.0, 0.0],
        [10.0, 2.0, 0.0],
        [7.0, 0.0, 0.0],
        [10.0, 0.0, 5.0],
        [9.0, 0.0, 5.0],
        [10.0, 1.0, 5.0],
    ];
    for (p, q) in soup.positions.iter().zip(wanted) {
        assert!((*p - DVec3::from(q)).length() < 1e-12, "{p}");
    }
    // The triangle of the mirrored node is reversed.
    assert_eq!(soup.triangles, [[0, 1, 2], [3, 5, 4]]);
}

#[test]
fn strips_and_fans_of_a_glb_are_read() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 0.0)];
    for kind in [5121, 5123, 5125] {
        let mesh = r#"{"mesh":0}"#;
        let triangles = |corners: [u32; 4], mode: u32| {
            let mode = format!(r#","mode":{mode}"#);
            read("a.glb", glb(&square, &corners, kind, mesh, &mode)).triangles
        };
        assert_eq!(triangles([0, 1, 2, 3], 5), [[0, 1, 2], [2, 1, 3]]);
        assert_eq!(triangles([0, 1, 3, 2], 6), [[0, 1, 3], [0, 3, 2]]);
        assert_eq!(triangles([0, 1, 3, 2], 1).len(), 0);
    }
}

#[test]
fn what_a_glb_needs_is_told() {
    for (json, code) in [
        (
            r#"{"extensionsRequired":["KHR_draco_mesh_compression"]}"#,
            Code::FileCompressed,
        ),
        (
            r#"{"extensionsRequired":["EXT_meshopt_compression"]}"#,
            Code::FileCompressed,
        ),
        (r#"{"extensionsRequired":["ABC_unknown"]}"#, Code::FileNeeds),
        (
            r#"{"nodes":[{"children":[1]},{"children":[0]}],"scenes":[{"nodes":[0]}]}"#,
            Code::FileBroken,
        ),
        (r#"{"nodes":[{"mesh":7}]}"#, Code::FileBroken),
        ("{]", Code::FileHead),
    ] {
        assert_eq!(refused("a.glb", glb_of(json, &[])), code, "{json}");
    }
    let part = r#"{"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"VEC3"}],
        "bufferViews":[{"buffer":0,"byteLength":12}],"buffers":[{"byteLength":12,"uri":"a.bin"}]}"#;
    assert_eq!(refused("a.glb", glb_of(part, &[0; 12])), Code::FileInParts);
    let sentence = Reading::read(
        "a.glb",
        glb_of(
            r#"{"extensionsRequired":["KHR_draco_mesh_compression"]}"#,
            &[],
        ),
    );
    assert!(sentence.unwrap_err().to_string().contains("draco"));
}

/// A GLB file with `visits` nodes that draw nothing, and more text at the end of its head and of its first node.
fn visited(visits: usize, in_root: &str, in_node: &str) -> Vec<u8> {
    let children = "1,".repeat(visits - 1);
    let json = format!(
        r#"{{"scenes":[{{"nodes":[0]}}],"nodes":[{{"children":[{children}1]}},{{"a":0{in_node}}}]{in_root}}}"#
    );
    glb_of(&json, &[])
}

#[test]
fn a_head_of_a_glb_is_read_in_short_slices() {
    let matrix = format!(r#","matrix":[{}0]"#, "0,".repeat(1_000_000));
    let junk: String = (0..60_000).map(|k| format!(r#","k{k}":{k}"#)).collect();
    let deep = format!(r#","extras":{}{}"#, "[".repeat(5000), "]".repeat(5000));
    for (bytes, least) in [
        (visited(90_000, "", &matrix), 25),
        (visited(90_000, &junk, ""), 25),
        (visited(10, &deep, &deep), 3),
        (visited(99_999, "", r#","children":[]"#), 20),
    ] {
        let mut reading = Reading::new("a.glb", bytes).unwrap();
        let mut slices = 1;
        while reading.advance().map(|soup| soup.unwrap()).is_none() {
            slices += 1;
        }
        assert!(slices >= least, "{slices}");
    }
    assert_eq!(refused("a.glb", visited(100_001, "", "")), Code::FileBroken);
    // Primitives that are lines draw nothing, but they count towards the limit.
    let lines = r#"{"mode":1},"#.repeat(1000);
    let json = format!(
        r#"{{"nodes":[{}{{"mesh":0}}],"meshes":[{{"primitives":[{lines}{{}}]}}]}}"#,
        r#"{"mesh":0},"#.repeat(2000)
    );
    assert_eq!(refused("a.glb", glb_of(&json, &[])), Code::FileBroken);
}

#[test]
fn what_a_glb_says_of_itself_is_told_alike_on_all_machines() {
    let sentence = |json: &str| {
        let why = Reading::read("a.glb", glb_of(json, &[])).expect_err("no model");
        why.to_string()
    };
    let primitive = |text: &str| {
        format!(r#"{{"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{{text}}}]}}]}}"#)
    };
    let said = sentence(&primitive(r#""attributes":{"POSITION":0},"indices":-1"#));
    assert!(said.contains("its accessor is not"), "{said}");
    let said = sentence(r#"{"nodes":[{}],"scenes":[{"nodes":[1.5]}]}"#);
    assert!(said.contains("its node is not"), "{said}");
    let said = sentence(r#"{"extensionsRequired":["KHR_draco_mesh_compression"]}"#);
    assert!(said.contains("\"KHR_draco_mesh_compression\""), "{said}");
}
