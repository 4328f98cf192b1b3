//! Links of surfaces and model files from strangers. Recipes are drawn at random, extremes before all, and written with
//! nonsense between; files are cut, mixed up and overwritten. The work ends within a number of slices, with a sentence
//! or with a picture in which every number is finite.
//!
//! More of them, from another start: `BUBBLESTONE_RECIPES=2000 BUBBLESTONE_SEED=7 cargo test --release
//! --test hostile_surfaces`.

// Tests in WebAssembly are built without the feature `house`, so they make no surfaces.
#![cfg(not(target_arch = "wasm32"))]

mod common;
mod strangers;

use bubblestone::generators::{ALL, GivenFile};
use bubblestone::modelfiles::Reading;
use bubblestone::random::{Purpose, Random};
use bubblestone::studio::Studio;
use bubblestone::trimesh::repair::MeshRepair;
use strangers::{
    COVERED, Ended, assert_sentence, broken, broken_link, file_ends_well, files, link_ends_well,
    mended, try_all, wild,
};

#[test]
fn whatever_a_link_asks_for_the_work_ends_well() {
    try_all(40, |random| {
        let link = wild(random);
        println!("#{link}");
        link_ends_well(&link).text
    });
}

/// Covers a file without a clock.
fn covered(link: &str, name: &str, bytes: Vec<u8>) -> Ended {
    file_ends_well(link, name, bytes, &mut || 0.0)
}

#[test]
fn the_files_are_good_before_they_are_broken() {
    for (k, (name, bytes)) in files().into_iter().enumerate() {
        let link = format!("cn=120&{}", COVERED[k % COVERED.len()]);
        let end = covered(&link, name, bytes);
        assert!(end.cells.is_some(), "{name}: {}", end.text);
    }
}

#[test]
fn whatever_is_in_a_file_the_work_ends_well() {
    let files = files();
    try_all(200, |random| {
        let (name, bytes) = broken(random, &files);
        let how = COVERED[random.below(COVERED.len())];
        println!("{name}, {how}");
        covered(&format!("cn=120&{how}"), name, bytes).text
    });
}

#[test]
fn two_thousand_broken_files_are_read_or_refused() {
    let files = files();
    let mut read = 0;
    for index in 0..2000 {
        let mut random = Random::new(7, Purpose::Attribute, index);
        let (name, bytes) = broken(&mut random, &files);
        match Reading::read(name, bytes).and_then(MeshRepair::mend) {
            Ok(mended) => {
                assert!(
                    mended.mesh.positions().iter().all(|p| p.is_finite()),
                    "{index}"
                );
                read += 1;
            }
            Err(why) => assert_sentence(&why),
        }
    }
    // Most damage is found, and some does no harm.
    assert!((200..1800).contains(&read), "{read}");
}

#[test]
fn ten_thousand_broken_links_are_mended() {
    for index in 0..10_000 {
        mended(&broken_link(&mut Random::new(8, Purpose::Attribute, index)));
    }
}

/// A closed box of these sides as text.
fn text_of_box(sides: [f64; 3]) -> Vec<u8> {
    let mut text = String::new();
    for k in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|axis| if k >> axis & 1 == 0 { 0.0 } else { sides[axis] });
        text += &format!("v {x:e} {y:e} {z:e}\n");
    }
    for face in [
        "1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6",
    ] {
        text += &format!("f {face}\n");
    }
    text.into_bytes()
}

/// The number of cells on a model, whose bodies are made but not drawn.
fn cells_on(link: &str, bytes: Vec<u8>) -> usize {
    let mut studio = Studio::new(ALL, mended(link));
    let given = studio.open_file(None, GivenFile::whole("a.obj", bytes));
    assert_eq!(given, Ok(vec![]));
    while studio.stage() != "light" {
        assert_eq!(studio.problem(), None);
        studio.tick(&mut || 0.0, 0.0, u32::MAX);
    }
    studio.engine().progress().cells
}

/// A box of the usual shape in another unit.
fn box_in(exponent: i32) -> Vec<u8> {
    let unit: f64 = format!("1e{exponent}").parse().unwrap();
    text_of_box([1.0, 2.0, 1.5].map(|side| side * unit))
}

/// Models are scaled into a range as they are read. Those that end up near its ends are drawn, too.
#[test]
fn a_model_has_the_same_cells_in_any_unit() {
    let plain = covered("cn=150", "a.obj", box_in(0));
    assert!(plain.cells.is_some(), "{}", plain.text);
    for exponent in [-300, -76, 76, 300] {
        let end = covered("cn=150", "a.obj", box_in(exponent));
        assert_eq!(end.cells, plain.cells, "1e{exponent}: {}", end.text);
    }
    for exponent in [-99, -80, -75, -40, -10, 10, 40, 75, 80, 99] {
        let cells = cells_on("make=surface&size=128&cn=150", box_in(exponent));
        assert_eq!(Some(cells), plain.cells, "1e{exponent}");
    }
}

#[test]
fn thin_models_take_few_slices() {
    for thin in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5] {
        let flat = format!("v 0 0 0\nv 1 0 0\nv 1 0 -{thin}\nv 0 0 -{thin}\nf 1 2 3 4\n");
        for bytes in [flat.into_bytes(), text_of_box([1.0, thin, thin])] {
            let end = covered("cn=40", "a.obj", bytes);
            assert!(end.slices < 10_000, "{thin}: {}", end.text);
        }
    }
}

#[test]
fn a_fan_of_many_triangles_takes_few_slices() {
    let corner = |k: usize| libm::sincos(std::f64::consts::TAU * k as f64 / 20_000.0);
    let ring = (0..20_000).map(corner);
    let places: String = ring
        .map(|(sin, cos)| format!("v {cos} 0 {}\n", -sin))
        .collect();
    let fan: String = (1..20_000)
        .map(|k| format!("f {k} {} 20001\n", k + 1))
        .collect();
    let corners: String = (1..=20_000).map(|k| format!(" {k}")).collect();
    for faces in [
        format!("v 0 0 0\n{fan}f 20000 1 20001\n"),
        format!("f{corners}\n"),
    ] {
        let end = covered("cn=40", "a.obj", format!("{places}{faces}").into_bytes());
        assert!(end.cells.is_some() && end.slices < 10_000, "{}", end.text);
    }
}
