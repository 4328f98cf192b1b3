//! Surfaces in space: bodies on every shape are the same, bit for bit, on every machine. Each line of
//! `surfaces.txt` has a digest and a link; `node/shipped.test.mjs` compares with it, too.
//!
//! After an intended change: `BUBBLESTONE_UPDATE=1 cargo test --test surfaces`.

// The tests under Node compare the digests in WebAssembly.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use bubblestone::generators::ALL;
use bubblestone::generators::surface::SURFACE;
use common::formed;

const GOLDEN: &str = include_str!("surfaces.txt");

#[test]
fn bodies_on_surfaces_are_the_same_everywhere() {
    let made = |line: &str| {
        let (_, link) = line.split_once(' ').expect("a digest and a link");
        format!("{} {link}\n", formed(link).engine().digest())
    };
    let found: String = GOLDEN.lines().map(made).collect();
    if std::env::var_os("BUBBLESTONE_UPDATE").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/surfaces.txt");
        std::fs::write(path, found).unwrap();
        return;
    }
    assert_eq!(found, GOLDEN);
}

/// The table includes each shape, each kind of cells, and each kind of stones.
#[test]
fn all_that_there_is_stands_in_the_table() {
    let (recipes, notices): (Vec<_>, Vec<_>) = GOLDEN
        .lines()
        .map(|line| ALL.recipe(line.split_once(' ').expect("a digest and a link").1))
        .unzip();
    assert!(notices.iter().all(Vec::is_empty), "{notices:?}");
    for key in [
        "form", "kind", "stone", "dir", "flow", "pattern", "crease", "open", "ends", "pt",
    ] {
        let row = recipes[0].schema().row(key).expect("a row");
        for choice in row.choices.iter().filter(|choice| choice.word != "file") {
            let has = |recipe: &bubblestone::recipe::Recipe| recipe.choice(row.key) == choice.word;
            assert!(recipes.iter().any(has), "{key}={}", choice.word);
        }
    }
}

/// Presets give no notice: neither about their links, nor about the fit of their cells.
#[test]
fn no_preset_gives_a_notice() {
    for preset in SURFACE.presets {
        let studio = formed(preset.link);
        assert_eq!(studio.recipe().link(), preset.link, "{}", preset.name);
        assert!(
            !preset.link.contains("size="),
            "{}: its own size",
            preset.name
        );
        let remarks = studio.engine().remarks();
        assert!(remarks.is_empty(), "{}: {remarks:?}", preset.name);
    }
}
