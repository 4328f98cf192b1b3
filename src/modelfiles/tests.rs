use super::samples::{files, glb, glb_of, model, obj, ply, stl, stl_text};
use super::*;
use crate::trimesh::TriMesh;
use crate::trimesh::repair::MeshRepair;
use crate::trimesh::testing;
use glam::DVec3;

pub(super) fn read(name: &str, bytes: impl Into<Vec<u8>>) -> Soup {
    Reading::read(name, bytes.into()).expect("a model")
}

pub(super) fn refused(name: &str, bytes: impl Into<Vec<u8>>) -> Code {
    Reading::read(name, bytes.into())
        .expect_err("no model")
        .code
}

#[test]
fn files_of_all_kinds_hold_the_same_model() {
    let (positions, triangles) = model();
    let apart = testing::apart(&model());
    for (name, bytes) in files() {
        // The content tells the kind, whatever the name.
        for named in [name, "model"] {
            let soup = read(named, bytes.clone());
            let wanted = if name.ends_with("stl") {
                (&apart.0, &apart.1)
            } else {
                (&positions, &triangles)
            };
            assert!((&soup.positions, &soup.triangles) == wanted, "{name}");
            assert_eq!(MeshRepair::mend(soup).unwrap().mesh.euler(), 2);
        }
    }
}

#[test]
fn a_file_is_read_in_slices() {
    let raw = testing::ball(7);
    let files = [
        obj(&raw).into_bytes(),
        ply(&raw, "ascii"),
        ply(&raw, "binary_big_endian"),
        stl(&raw, b""),
        stl_text(&raw).into_bytes(),
    ];
    for bytes in files {
        let mut reading = Reading::new("a.obj", bytes).unwrap();
        let (mut slices, mut last) = (0, 0.0);
        let soup = loop {
            if let Some(done) = reading.advance() {
                break done.unwrap();
            }
            assert!((last..=1.0).contains(&reading.progress()));
            last = reading.progress();
            slices += 1;
        };
        assert_eq!(soup.triangles.len(), raw.1.len());
        assert!(slices > 2, "{slices}");
    }
}

#[test]
fn broken_files_are_a_sentence_or_a_model() {
    let mut chance = testing::chance(8);
    for (name, bytes) in files() {
        let step = 1 + bytes.len() / 700;
        for length in (0..bytes.len()).step_by(step) {
            try_all(name, bytes[..length].to_vec());
        }
        for _ in 0..1500 {
            let mut bytes = bytes.clone();
            for _ in 0..=chance.below(4) {
                // Change bytes of the head more often than of the rest.
                let span = [bytes.len(), 1000][chance.below(2)].min(bytes.len());
                let at = chance.below(span);
                bytes[at] = match chance.below(3) {
                    0 => bytes[at] ^ 1 << chance.below(8),
                    1 => chance.bits() as u8,
                    _ => b"0129-. \n\"{}[]"[chance.below(13)],
                };
            }
            try_all(name, bytes);
        }
    }
    for _ in 0..300 {
        let noise: Vec<u8> = (0..chance.below(3000))
            .map(|_| chance.bits() as u8)
            .collect();
        for name in ["a.obj", "a.stl", "a.ply", "a.glb", ""] {
            try_all(name, noise.clone());
        }
    }
}

fn try_all(name: &str, bytes: Vec<u8>) {
    match Reading::read(name, bytes).and_then(MeshRepair::mend) {
        Ok(mended) => assert_is_sound(&mended.mesh),
        Err(why) => {
            let why = why.to_string();
            assert!(why.len() > 20 && why.ends_with('.'), "{name}: {why}");
        }
    }
}

/// Positions are finite, and faces beside each other agree on their common side.
fn assert_is_sound(mesh: &TriMesh) {
    assert!(mesh.positions().iter().all(|p| p.is_finite()));
    for t in 0..mesh.triangles().len() as u32 {
        for k in 0..3 {
            if let Some((other, side)) = mesh.across(t, k) {
                assert_eq!(mesh.across(other, side), Some((t, k)));
            }
        }
    }
}

#[test]
fn what_an_obj_may_have_is_read() {
    let text = "\u{FEFF}# comment\r\n\r\nv 0 0 0 1\r\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\n  v\t0 1 \\\n 0\n\
        f 1 2 3 4\nf -4 -3 -2 # the same\nvt 0 0\nf 1/1 2/1 \\\r\n 3/1\nl 1 2\np 1\nf 1 2\ncurv 0 1 2";
    let soup = read("a.obj", text);
    assert_eq!(soup.positions.len(), 4);
    assert_eq!(soup.positions[3], DVec3::new(0.0, 1.0, 0.0));
    assert_eq!(soup.triangles.len(), 4);
    assert_eq!(soup.triangles[2..], [[0, 1, 2], [0, 1, 2]]);
    // A concave polygon is triangulated within its outline.
    let text = "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 0.5 1 0\nf 1 2 3 4\n";
    let mesh = MeshRepair::mend(read("a.obj", text)).unwrap().mesh;
    assert!((mesh.area() - 1.5).abs() < 1e-12 && mesh.face_normal(0) == DVec3::Z);
}

#[test]
fn bad_lines_are_told_by_their_numbers() {
    for (text, n) in [
        ("v 0 0 0\nv 0 one 0\n", "2"),
        ("v 0 0\n", "1"),
        ("v 0 0 0\n\nf 1 0 1\n", "3"),
        ("v 0 0 0\nf -2 1 1\n", "2"),
        ("v 0 0 0\nf 1 1 \\\n x\n", "2"),
        ("v 0 0 nan\n", "1"),
    ] {
        let why = Reading::read("a.obj", text.as_bytes().to_vec()).unwrap_err();
        assert_eq!(why.code, Code::FileLine, "{text}");
        assert!(
            why.to_string().starts_with(&format!("Line {n} of the OBJ")),
            "{why}"
        );
    }
    // A corner may name a vertex that comes later: corners are checked at the end.
    let soup = read("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\nv 0 1 0\n");
    assert!(MeshRepair::mend(soup).is_ok());
    let soup = read("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
    assert_eq!(MeshRepair::mend(soup).unwrap_err().code, Code::ModelCorner);
}

#[test]
fn what_is_no_model_is_told_so() {
    for (name, bytes, code) in [
        ("a.txt", &b"hello"[..], Code::FileUnknown),
        ("a.png", b"\x89PNG\r\n", Code::FileUnknown),
        ("a.json", b"{}", Code::FileUnknown),
        ("a.gltf", b"{\"asset\":{}}", Code::FileInParts),
        ("", b"", Code::FileUnknown),
        ("a.ply", b"ply\nformat ascii 1.0\n", Code::FileEnds),
        (
            "a.ply",
            b"ply\nformat ascii 1.0\nend_header\n",
            Code::FileHead,
        ),
        ("a.ply", b"ply\nformat utf 1.0\n", Code::FileHead),
        ("a.glb", b"glTF\x01\0\0\0\x0C\0\0\0", Code::FileHead),
        ("a.glb", b"glTF\x02\0\0\0\xFF\0\0\0", Code::FileEnds),
    ] {
        assert_eq!(refused(name, bytes), code, "{name}");
    }
    // The content is of no known kind, whatever the name.
    for name in ["a.obj", "a.ply", "a.stl", "a.glb"] {
        let soup = Reading::read(name, b"nothing of the sort".to_vec());
        let code = soup.and_then(MeshRepair::mend).unwrap_err().code;
        assert!(
            matches!(code, Code::FileUnknown | Code::ModelEmpty),
            "{code:?}"
        );
    }
}

#[test]
fn great_counts_take_no_memory() {
    let head = |vertices: &str, faces: &str| {
        format!(
            "ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\nproperty float x\n\
             property float y\nproperty float z\nelement face {faces}\n\
             property list uint int vertex_index\nend_header\n"
        )
    };
    assert_eq!(refused("a.ply", head("999999999999", "1")), Code::FileEnds);
    let mut list = head("0", "1").into_bytes();
    list.extend([0xFF; 5]);
    assert_eq!(refused("a.ply", list), Code::FileEnds);
    let empty = "ply\nformat ascii 1.0\nelement nothing 999999999999999\nelement vertex 0\nproperty float x\n\
        property float y\nproperty float z\nend_header\n";
    assert_eq!(read("a.ply", empty), Soup::default());
    let mut many = vec![b' '; 84];
    many[80..84].fill(0xFF);
    assert_eq!(refused("a.stl", many), Code::FileEnds);
    let json = r#"{"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":4294967295,"type":"VEC3"}],
        "bufferViews":[{"buffer":0,"byteLength":4294967295}],"buffers":[{"byteLength":4294967295}]}"#;
    assert_eq!(refused("a.glb", glb_of(json, &[0; 12])), Code::FileBroken);
}

#[test]
fn more_triangles_than_can_be_taken_are_refused_while_reading() {
    // Each node draws the same quad.
    let quad = [DVec3::ZERO, DVec3::X, DVec3::ONE, DVec3::Y];
    let corners: Vec<u32> = (0..60_000).map(|k| k % 4).collect();
    let children: Vec<String> = (1..=120).map(|k: u32| k.to_string()).collect();
    let mut nodes = format!(r#"{{"children":[{}]}}"#, children.join(","));
    for _ in 0..120 {
        nodes += r#",{"mesh":0}"#;
    }
    let bytes = glb(&quad, &corners, 5121, &nodes, "");
    assert_eq!(refused("a.glb", bytes), Code::ModelTooLarge);
    let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    text += &"f 1 2 3\n".repeat(2_000_001);
    assert_eq!(refused("a.obj", text), Code::ModelTooLarge);
}

#[test]
fn points_without_faces_are_told() {
    let text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
        end_header\n1 2 3\n";
    assert_eq!(refused("a.ply", text), Code::FilePoints);
}

#[test]
fn strips_of_a_ply_are_read() {
    let text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
        0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 -1 2 3 4 -1\n";
    let soup = read("a.ply", text);
    assert_eq!(soup.triangles, [[0, 1, 2], [2, 1, 3], [2, 3, 4]]);
}

#[test]
fn our_own_files_are_read() {
    use crate::export::model_obj;
    let mesh = testing::mesh(testing::blob(3));
    let soup = read("model.obj", model_obj(&mesh, DVec3::ZERO));
    assert_eq!(soup.positions, mesh.positions());
    assert_eq!(soup.triangles, mesh.triangles());
}

/// A file's text in other spellings that programs use: a byte order mark, other ends of lines, capitals, tabs, and no
/// end of the last line.
fn spelled(text: &str) -> Vec<Vec<u8>> {
    let text = text.replace("\r\n", "\n");
    [
        format!("\u{FEFF}{text}"),
        text.replace('\n', "\r\n"),
        text.replace('\n', "\r"),
        text.to_ascii_uppercase(),
        text.replace(' ', "\t"),
        text.trim_end().to_owned(),
        format!(
            "\u{FEFF}{}",
            text.to_ascii_uppercase().replace('\n', "\r").trim_end()
        ),
    ]
    .map(String::into_bytes)
    .into()
}

#[test]
fn text_is_read_in_every_spelling() {
    let model = model();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    for (name, text) in [
        ("a.obj", obj(&model)),
        ("a.ply", text(ply(&model, "ascii"))),
        ("a.stl", stl_text(&model)),
    ] {
        let wanted = read(name, text.clone());
        assert_eq!(wanted.triangles.len(), model.1.len());
        for (k, bytes) in spelled(&text).into_iter().enumerate() {
            for named in [name, "model"] {
                assert!(read(named, bytes.clone()) == wanted, "{name}, spelling {k}");
            }
        }
    }
}

#[test]
fn lines_of_text_may_end_with_a_return() {
    let text = "\u{FEFF}v 0 0 0\rv 1 0 0\rv 1 0 -1\rf 1 2 3\rv one\r";
    let why = Reading::read("a.obj", text.into()).unwrap_err();
    assert!(why.to_string().starts_with("Line 5 of the OBJ"), "{why}");
    let text = "solid a\r\nfacet\r\nouter loop\r\nvertex 0 0 zero";
    let why = Reading::read("a.stl", text.into()).unwrap_err();
    assert!(why.to_string().starts_with("Line 4 of the STL"), "{why}");
    // The numbers of a binary PLY follow its head, whatever ends the head's lines.
    let binary = ply(&model(), "binary_little_endian");
    let head = binary
        .windows(11)
        .position(|w| w == b"end_header\n")
        .unwrap()
        + 11;
    let wanted = read("a.ply", binary.clone());
    for end in ["\r", "\r\n"] {
        let text = String::from_utf8(binary[..head].to_vec())
            .unwrap()
            .replace('\n', end);
        let other = [text.as_bytes(), &binary[head..]].concat();
        assert!(read("a.ply", other) == wanted, "{end:?}");
    }
}

#[test]
fn facets_of_an_stl_may_have_more_corners() {
    let square = "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let next = square.replace("vertex 0", "vertex 2");
    let soup = read(
        "a.stl",
        format!("solid\n{square}{next}facet\nouter loop\nendloop\nendsolid"),
    );
    assert_eq!(soup.positions.len(), 8);
    let mesh = MeshRepair::mend(soup).unwrap().mesh;
    assert!((mesh.area() - 2.0).abs() < 1e-12);
    let cut = square.replace("vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n", "");
    assert_eq!(refused("a.stl", format!("solid\n{cut}")), Code::FileEnds);
}

#[test]
fn a_line_without_an_end_is_refused() {
    let text = format!("v 0 0 0\nf{}", " 1".repeat(3_000_000));
    let why = Reading::read("a.obj", text.into_bytes()).unwrap_err();
    assert!(why.to_string().starts_with("Line 2 of the OBJ"), "{why}");
}
