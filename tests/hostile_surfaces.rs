//! Links of surfaces and model files from strangers. Recipes are drawn at random, extremes before all, and written with
//! nonsense between; files are cut, mixed up and overwritten. The work ends within a number of slices, with a sentence
//! or with a picture in which every number is finite.
//!
//! More of them, from another start: `BUBBLESTONE_RECIPES=2000 BUBBLESTONE_SEED=7 cargo test --release
//! --test hostile_surfaces`.

// The WebAssembly module without the feature `house` makes no surfaces.
#![cfg(any(not(target_arch = "wasm32"), feature = "house"))]

mod common;

use bubblestone::generators::surface::{SCHEMA, keys};
use bubblestone::generators::{ALL, GivenFile, TurnOrder};
use bubblestone::notice::Notice;
use bubblestone::random::{Purpose, Random};
use bubblestone::recipe::{Item, Kind, Parameter, Recipe};
use bubblestone::scene::Camera;
use bubblestone::studio::Studio;
use common::{number, wished};
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Slices of work after which a recipe counts as hanging: about ten times as many as the slowest one took.
const MOST_SLICES: usize = 130_000;

/// Texts that are not valid for any parameter, or hardly.
const NONSENSE: [&str; 16] = [
    "",
    "NaN",
    "-inf",
    "1e999",
    "-0",
    "0x10",
    "1,,2",
    ";;;",
    "%00%ff",
    "AAAA",
    "gggBgggB",
    "!",
    "0.5,0.5,0.5",
    "0.5,0.5,0.5,-1,NaN",
    "9,9,9,9,9",
    "99999999999999999999",
];

/// Tries cases from a start, and lists those that fail.
fn try_all(count: u64, case: impl Fn(&mut Random) -> String) {
    let seed = wished("BUBBLESTONE_SEED", 1);
    let mut bad = Vec::new();
    for index in 0..wished("BUBBLESTONE_RECIPES", count) {
        let mut random = Random::new(seed, Purpose::Attribute, index);
        // The output is printed only if the test fails.
        match catch_unwind(AssertUnwindSafe(|| case(&mut random))) {
            Ok(end) => println!("{index}: {end}"),
            Err(_) => bad.push(index),
        }
    }
    assert!(bad.is_empty(), "cases {bad:?} from start {seed}");
}

/// Asserts that a notice is a sentence.
fn assert_sentence(notice: &Notice) {
    let text = notice.to_string();
    assert!(text.ends_with('.') && text.len() > 20, "{text}");
}

/// Works slice by slice up to the end. Returns a description of the end.
fn ends_well(mut studio: Studio) -> String {
    let mut slices = 0;
    while studio.at_work().is_some() {
        studio.tick(&mut || 0.0, 0.0, u32::MAX);
        slices += 1;
        assert!(slices < MOST_SLICES, "no end: {}", studio.stage());
    }
    let remarks = studio.engine().remarks();
    remarks.iter().for_each(assert_sentence);
    if let Some(why) = studio.problem() {
        assert_sentence(why);
        return format!("{slices} slices, {why}");
    }
    assert_finite(&mut studio);
    let cells = studio.engine().progress().cells;
    format!("{slices} slices, {cells} cells, {remarks:?}")
}

/// Asserts that the picture, a frame of the bodies, and the numbers of cells and mesh are finite.
fn assert_finite(studio: &mut Studio) {
    let picture = studio.picture().expect("a picture");
    assert_eq!(picture.len(), 4 * studio.side() * studio.side());
    assert!(studio.engine_mut().energy().is_finite());
    let order = TurnOrder {
        subject: String::new(),
        camera: Camera::default(),
        size: [48, 32],
        how: "moving+nothing".to_owned(),
    };
    let frame = studio.finish_frame(&order, &mut || 0.0).expect("a frame");
    assert!(frame.depths().iter().all(|depth| depth.is_finite()));
    assert!(frame.normals().iter().all(|normal| normal.is_finite()));
    #[cfg(not(target_arch = "wasm32"))]
    for (name, text) in studio.engine().data() {
        assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
    }
}

/// Places in the box around the model, or somewhat outside it.
fn places(random: &mut Random, count: usize) -> String {
    let numbers = (0..3 * count).map(|_| (1.2 * random.unit() - 0.1).to_string());
    numbers.collect::<Vec<_>>().join(",")
}

/// Rows of a list: a few, the most allowed, or one more.
fn rows(random: &mut Random, item: Item) -> String {
    let count = [1, 3, 64, 65][random.below(4)];
    let rows = (0..count).map(|_| match item {
        Item::Patch(min, max) => {
            let radius = number(random, (0.01, 2.0));
            format!(
                "{},{radius},{}",
                places(random, 1),
                number(random, (min, max))
            )
        }
        Item::File => "1,2,3,4,97".to_owned(),
        _ => {
            let points = [1, 2, 4, 30][random.below(4)];
            places(random, points)
        }
    });
    rows.collect::<Vec<_>>().join(";")
}

/// A value from anywhere in its range, or nonsense.
fn text(random: &mut Random, row: &Parameter) -> String {
    if random.below(12) == 0 {
        return NONSENSE[random.below(NONSENSE.len())].to_owned();
    }
    match (row.kind, row.item) {
        (Kind::Choice, _) => row.choices[random.below(row.choices.len())].word.to_owned(),
        (Kind::Text, Some(item)) => rows(random, item),
        _ => number(random, (row.min, row.max)).to_string(),
    }
}

/// A link with some parameters far from their defaults, and few cells, so that it takes little time.
fn wild(random: &mut Random) -> String {
    let mut link = String::from("make=surface");
    let share = random.unit();
    for row in SCHEMA.rows {
        let is_fixed = [keys::SIZE, keys::CN, keys::MODEL].contains(&row.key);
        if !is_fixed && (row.key == keys::FORM || random.unit() < share) {
            write!(link, "&{}={}", row.key.0, text(random, row)).unwrap();
        }
    }
    write!(link, "&size=128&cn={}", number(random, (30.0, 120.0))).unwrap();
    link
}

/// The recipe of a link with any faults. Asserts that its own link gives the same recipe.
fn mended(link: &str) -> Recipe {
    let (recipe, notices) = ALL.recipe(link);
    notices.iter().for_each(assert_sentence);
    let (again, notices) = ALL.recipe(&recipe.link());
    assert!(notices.is_empty(), "{notices:?}");
    assert!(again == recipe, "{}", recipe.link());
    recipe
}

#[test]
fn whatever_a_link_asks_for_the_work_ends_well() {
    let count = if cfg!(target_arch = "wasm32") { 8 } else { 40 };
    try_all(count, |random| {
        let link = wild(random);
        println!("#{link}");
        ends_well(Studio::new(ALL, mended(&link)))
    });
}

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

fn ply(format: &str) -> Vec<u8> {
    let (places, triangles) = ring();
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
    bytes.extend(places.iter().flatten().flat_map(|x| x.to_le_bytes()));
    for t in triangles {
        bytes.push(3);
        bytes.extend(t.iter().flat_map(|v| v.to_le_bytes()));
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
fn files() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("a.obj", obj()),
        ("a.ply", ply("ascii")),
        ("b.ply", ply("binary_little_endian")),
        ("a.stl", stl()),
        ("b.stl", stl_text()),
        ("a.glb", glb()),
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

/// Options for covering a file: each kind of cells, and each option that only models have.
const COVERED: [&str; 4] = [
    "kind=square&on=simple",
    "kind=rectangle&crease=cut&dir=border",
    "kind=circle&open=block&stone=skin&up=z",
    "kind=ellipse&open=capped&cc=20&dir=curvature&on=whole",
];

fn opened(how: &str, name: &str, bytes: Vec<u8>) -> String {
    let recipe = mended(&format!("make=surface&size=128&cn=120&{how}"));
    let mut studio = Studio::new(ALL, recipe);
    match studio.open_file(None, GivenFile::whole(name, bytes)) {
        Ok(notices) => notices.iter().for_each(assert_sentence),
        Err(why) => {
            assert_sentence(&why);
            return why.to_string();
        }
    }
    ends_well(studio)
}

#[test]
fn the_files_are_good_before_they_are_broken() {
    for (k, (name, bytes)) in files().into_iter().enumerate() {
        let end = opened(COVERED[k % COVERED.len()], name, bytes);
        assert!(end.contains(" cells, "), "{name}: {end}");
    }
}

#[test]
fn whatever_is_in_a_file_the_work_ends_well() {
    let files = files();
    let count = if cfg!(target_arch = "wasm32") {
        40
    } else {
        200
    };
    try_all(count, |random| {
        let (name, bytes) = &files[random.below(files.len())];
        let mut bytes = bytes.clone();
        (0..=random.below(3)).for_each(|_| mutate(random, &mut bytes));
        // Sometimes the name promises another kind.
        let name = match random.below(8) {
            0 => files[random.below(files.len())].0,
            _ => name,
        };
        let how = COVERED[random.below(COVERED.len())];
        println!("{name}, {how}");
        opened(how, name, bytes)
    });
}
