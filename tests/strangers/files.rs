//! Eight files of one small model, files of buildings, and damage to them.

use bubblestone::building::{Module, Rule, write_json};
use bubblestone::random::Random;
use std::fmt::Write;

/// A ring of 8 by 6 squares, each of two triangles.
fn ring() -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    const AROUND: u32 = 8;
    const ACROSS: u32 = 6;
    let turn = |k: u32, of: u32| libm::sincos(std::f64::consts::TAU * f64::from(k) / f64::from(of));
    let (mut places, mut triangles) = (Vec::new(), Vec::new());
    for i in 0..AROUND {
        for j in 0..ACROSS {
            let ((sin, cos), (up, out)) = (turn(i, AROUND), turn(j, ACROSS));
            let r = 1.0 + 0.4 * out;
            places.push([r * cos, 0.4 * up, -r * sin].map(|x| x as f32));
            let at = |i: u32, j: u32| (i % AROUND) * ACROSS + j % ACROSS;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (places, triangles)
}

fn obj() -> Vec<u8> {
    let (places, triangles) = ring();
    let mut text = String::from("# a ring\no ring\n");
    for [x, y, z] in places {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    for [a, b, c] in triangles {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
    }
    text.into_bytes()
}

/// The same with faces of four corners, which count back from the last vertex.
fn obj_of_squares() -> Vec<u8> {
    let (places, triangles) = ring();
    let mut text = String::new();
    for [x, y, z] in &places {
        writeln!(text, "v {x:e} {y:e} {z:e}").unwrap();
    }
    for pair in triangles.chunks_exact(2) {
        let [a, b, c] = pair[0].map(|v| v as usize);
        let [a, b, c, d] = [a, b, c, pair[1][2] as usize].map(|v| places.len() - v);
        writeln!(text, "f -{a}/1 -{b}/2 -{c}/3 -{d}/4").unwrap();
    }
    text.into_bytes()
}

fn ply(format: &str) -> Vec<u8> {
    let (places, triangles) = ring();
    let big = format == "binary_big_endian";
    let mut text = format!(
        "ply\nformat {format} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        places.len(),
        triangles.len()
    );
    if format == "ascii" {
        for [x, y, z] in places {
            writeln!(text, "{x} {y} {z}").unwrap();
        }
        for [a, b, c] in triangles {
            writeln!(text, "3 {a} {b} {c}").unwrap();
        }
        return text.into_bytes();
    }
    let mut bytes = text.into_bytes();
    let ordered = |word: [u8; 4]| match big {
        true => u32::from_be_bytes(word).to_le_bytes(),
        false => word,
    };
    bytes.extend(
        places
            .iter()
            .flatten()
            .flat_map(|x| ordered(x.to_le_bytes())),
    );
    for t in triangles {
        bytes.push(3);
        bytes.extend(t.iter().flat_map(|v| ordered(v.to_le_bytes())));
    }
    bytes
}

fn stl() -> Vec<u8> {
    let (places, triangles) = ring();
    let mut bytes = vec![b' '; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for t in triangles {
        bytes.extend([0; 12]);
        let corners = t.iter().flat_map(|&v| places[v as usize]);
        bytes.extend(corners.flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}

fn stl_text() -> Vec<u8> {
    let (places, triangles) = ring();
    let mut text = String::from("solid ring\n");
    for t in triangles {
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in t.map(|v| places[v as usize]) {
            writeln!(text, "vertex {x} {y} {z}").unwrap();
        }
        text += "endloop\nendfacet\n";
    }
    (text + "endsolid ring\n").into_bytes()
}

fn glb() -> Vec<u8> {
    let (places, triangles) = ring();
    let mut numbers: Vec<u8> = places
        .iter()
        .flatten()
        .flat_map(|x| x.to_le_bytes())
        .collect();
    let start = numbers.len();
    numbers.extend(triangles.iter().flatten().flat_map(|v| v.to_le_bytes()));
    let (all, size) = (numbers.len(), numbers.len() - start);
    let mut json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0,"scale":[1,2,1]}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}},
        {{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}}],
        "bufferViews":[{{"buffer":0,"byteLength":{start}}},{{"buffer":0,"byteOffset":{start},"byteLength":{size}}}],
        "buffers":[{{"byteLength":{all}}}]}}"#,
        places.len(),
        3 * triangles.len()
    )
    .into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF".to_vec();
    let length = 28 + json.len() + all;
    bytes.extend(
        [2, length as u32, json.len() as u32]
            .map(u32::to_le_bytes)
            .concat(),
    );
    bytes.extend(b"JSON");
    bytes.extend(json);
    bytes.extend((all as u32).to_le_bytes());
    bytes.extend(b"BIN\0");
    bytes.extend(numbers);
    bytes
}

/// The same model as a file of each kind.
pub fn files() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("a.obj", obj()),
        ("b.obj", obj_of_squares()),
        ("a.ply", ply("ascii")),
        ("b.ply", ply("binary_little_endian")),
        ("c.ply", ply("binary_big_endian")),
        ("a.stl", stl()),
        ("b.stl", stl_text()),
        ("a.glb", glb()),
    ]
}

/// A block of 3 by 2 by 2.5 metres with a group for each side, as text.
fn obj_of_block() -> Vec<u8> {
    let mut text = String::from("# metres\n");
    for k in 0..8 {
        let [x, y, z] = [(0, 3.0), (1, 2.5), (2, 2.0)].map(|(axis, side)| match k >> axis & 1 {
            0 => 0.0,
            _ => side,
        });
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    for (group, face) in [
        ("Left", "1 5 7 3"),
        ("Right", "2 4 8 6"),
        ("Bottom", "1 2 6 5"),
        ("Top", "3 7 8 4"),
        ("Back", "1 3 4 2"),
        ("Front", "5 6 8 7"),
    ] {
        writeln!(text, "g {group}\nf {face}").unwrap();
    }
    text.into_bytes()
}

/// Files of buildings: some by rule, and a block as polygons.
pub fn buildings() -> Vec<(&'static str, Vec<u8>)> {
    let json = |rule: Rule| write_json(&rule.draft(&Module::NORMAL, &[])).into_bytes();
    vec![
        ("block.json", json(Rule::Block)),
        ("gate.json", json(Rule::Gate)),
        ("steps.json", json(Rule::Steps)),
        ("tower.json", json(Rule::Tower)),
        ("block.obj", obj_of_block()),
    ]
}

/// Damages a file in one of several ways, typical ones and others.
fn mutate(random: &mut Random, bytes: &mut Vec<u8>) {
    if bytes.is_empty() {
        return;
    }
    let at = random.below(bytes.len());
    let end = (at + 1 + random.below(64)).min(bytes.len());
    match random.below(8) {
        0 => bytes.truncate(at),
        1 => (0..=random.below(8)).for_each(|_| {
            let place = random.below(bytes.len());
            bytes[place] = random.bits() as u8;
        }),
        2 => bytes[at] ^= 1 << random.below(8),
        3 => {
            let piece: Vec<u8> = bytes.drain(at..end).collect();
            let to = random.below(bytes.len() + 1);
            bytes.splice(to..to, piece);
        }
        4 => {
            let piece = bytes[at..end].repeat([1, 2, 200][random.below(3)]);
            bytes.splice(at..at, piece);
        }
        5 => {
            let word = [u32::MAX, 1 << 31, 1 << 30, 0][random.below(4)];
            let at = at & !3;
            let end = (at + 4).min(bytes.len());
            bytes[at..end].copy_from_slice(&word.to_le_bytes()[..end - at]);
        }
        6 => replace_number(random, bytes, at),
        _ => {
            bytes.drain(at..end);
        }
    }
}

/// Replaces the first number after `from` by another text.
fn replace_number(random: &mut Random, bytes: &mut Vec<u8>, from: usize) {
    const NUMBERS: [&[u8]; 8] = [
        b"4294967295",
        b"999999999999999999999",
        b"-1",
        b"0",
        b"nan",
        b"1e999",
        b"1e38",
        b"1e-300",
    ];
    let is_part = |b: &u8| b.is_ascii_digit() || b"+-.".contains(b);
    let Some(start) = bytes[from..].iter().position(is_part) else {
        return;
    };
    let start = from + start;
    let length = bytes[start..].iter().take_while(|b| is_part(b)).count();
    let other = NUMBERS[random.below(NUMBERS.len())];
    bytes.splice(start..start + length, other.iter().copied());
}

/// A damaged copy of one of the files, and its name, which sometimes promises another kind.
pub fn broken(random: &mut Random, files: &[(&'static str, Vec<u8>)]) -> (&'static str, Vec<u8>) {
    let (name, bytes) = &files[random.below(files.len())];
    let mut bytes = bytes.clone();
    (0..=random.below(3)).for_each(|_| mutate(random, &mut bytes));
    match random.below(8) {
        0 => (files[random.below(files.len())].0, bytes),
        _ => (name, bytes),
    }
}
