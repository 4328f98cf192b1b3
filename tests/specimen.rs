//! Functions that every generator gets from the shared code, tested with one that is a folder and a line: the
//! link's codec, the studio, and the files of the native programs.

mod common;
#[cfg(not(target_arch = "wasm32"))]
#[path = "../examples/native/mod.rs"]
mod native;

use bubblestone::generators::pavement::Pavement;
use bubblestone::generators::{ALL, specimen};
use bubblestone::notice::Code;
use bubblestone::studio::Studio;
use common::{finished, recipe};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const SQUARES: &str = "v=1&make=specimen&size=128&across=4";

#[test]
fn links_name_their_generator() {
    for link in [
        "v=1&make=specimen",
        SQUARES,
        "v=1&make=specimen&moss=0.5&el=30",
    ] {
        let recipe = recipe(link);
        assert!(recipe.is_of(&specimen::SCHEMA));
        assert!(recipe.link().starts_with("v=1&make=specimen"));
        assert_eq!(ALL.recipe(&recipe.link()).0, recipe);
    }
    assert_eq!(recipe(" #MAKE=Specimen ").link(), "v=1&make=specimen");
    assert_eq!(recipe("make=pavement&cs=30").link(), "v=1&cs=30");
    assert_eq!(recipe("cs=30").link(), "v=1&cs=30");
}

#[test]
fn an_unknown_generator_gets_a_sentence_and_a_pavement() {
    let (recipe, notices) = ALL.recipe("make=castle&cs=30");
    assert_eq!(recipe.link(), "v=1&cs=30");
    assert_eq!(
        notices[0].to_string(),
        "Make must be pavement, surface or specimen; \"castle\" was given, kept pavement."
    );
    // A parameter of another generator gets the same notice as an unknown word.
    let (recipe, notices) = ALL.recipe("make=specimen&across=3&cs=30");
    assert_eq!(recipe.link(), "v=1&make=specimen&across=3");
    assert_eq!(notices[0].code, Code::NotAParameter);
}

#[test]
fn only_what_is_stale_runs() {
    let mut studio = finished(SQUARES);
    let mut runs = [1; 4];
    for (change, stage) in [("el=30", 3), ("moss=0.5", 2), ("af=4", 1), ("gap=0.5", 0)] {
        let changed = recipe(&format!("{SQUARES}&{change}"));
        studio.set_recipe(changed);
        assert_eq!(studio.finish(&mut || 0.0), Ok(()));
        // The previous change, which concerns a later stage, is undone at the same time.
        runs[stage..].iter_mut().for_each(|run| *run += 1);
        let found: Vec<u64> = studio.runs().iter().map(|&(_, runs)| runs).collect();
        assert_eq!(found, runs, "{change}");
        assert_eq!(studio.digest(), finished(&studio.recipe().link()).digest());
    }
    let stages: Vec<&str> = studio.runs().iter().map(|&(word, _)| word).collect();
    assert_eq!(stages, ["grid", "planes", "weather", "shading"]);
}

#[test]
fn a_studio_goes_from_one_generator_to_another_and_back() {
    let mut studio = finished("size=128&cs=24");
    let pavement = studio.digest();
    assert!(studio.engine_as::<Pavement>().is_some());
    studio.set_recipe(recipe(SQUARES));
    assert_eq!((studio.stage(), studio.progress().cells), ("grid", 0));
    assert!(studio.engine_as::<Pavement>().is_none());
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    assert_eq!(studio.progress().cells, 16);
    assert_eq!(studio.digest(), finished(SQUARES).digest());
    studio.set_recipe(recipe("size=128&cs=24"));
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    assert_eq!(studio.digest(), pavement);
}

#[test]
fn the_way_of_slices_does_not_matter() {
    let whole = finished(SQUARES);
    let mut slices = Studio::new(ALL, recipe(SQUARES));
    while !slices.done() {
        slices.step(&mut || 0.0);
        slices.tick(&mut || 0.0, 0.0, 0);
        assert_eq!(slices.engine_mut().view("auto").len(), 4 * 128 * 128);
    }
    assert_eq!(slices.digest(), whole.digest());
    assert_eq!(slices.picture(), whole.picture());
}

#[test]
fn a_bigger_picture_is_the_same_one() {
    let mut studio = finished(SQUARES);
    let made = studio.engine_mut();
    let made = made.picture_file((2, &[]), &mut || 0.0, f64::INFINITY);
    let made = made.unwrap();
    let rows = &made.rows[0];
    assert_eq!(
        (rows.side, rows.bytes.len(), made.done),
        (256, 3 * 256 * 256, true)
    );
    let small = studio.picture().unwrap();
    let mean = |bytes: &mut dyn Iterator<Item = u8>, count: usize| {
        bytes.map(f64::from).sum::<f64>() / count as f64
    };
    let reds = mean(&mut small.iter().copied().step_by(4), 128 * 128);
    let finer = mean(&mut rows.bytes.iter().copied().step_by(3), 256 * 256);
    assert!((reds - finer).abs() < 6.0, "{reds} {finer}");
}

#[test]
fn presets_are_canonical() {
    for preset in specimen::SPECIMEN.presets {
        assert_eq!(recipe(preset.link).link(), preset.link);
    }
}

/// The files that the native program writes for any generator.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn the_native_program_writes_its_files() {
    let out = std::env::temp_dir().join(format!("bubblestone-specimen-{}", std::process::id()));
    let mut studio = finished(SQUARES);
    native::write_all(&mut studio, Vec::new(), None, &out).unwrap();
    native::write_views(&mut studio, &out).unwrap();
    native::write_bigger(&mut studio, 2, true, &out).unwrap();
    let text = std::fs::read_to_string(out.join("report.json")).unwrap();
    let report: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(
        (&report["link"], &report["cells"]),
        (&SQUARES.into(), &16.into())
    );
    assert_eq!(report["hash"], studio.digest());
    assert!(report["milliseconds"]["grid"].is_number());
    for name in [
        "picture.png",
        "cells.json",
        "view-albedo.png",
        "picture-2x.png",
        "ao-2x.png",
    ] {
        assert!(out.join(name).is_file(), "{name}");
    }
    assert!(native::write_svg(&studio, &out).is_err());
    assert!(native::write_meshes(&mut studio, 100, &out).is_err());
    std::fs::remove_dir_all(&out).unwrap();
}
