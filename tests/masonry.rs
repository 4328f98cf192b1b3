//! Masonry: the blocks of every tree on every building are the same, bit for bit, on every machine. Each line of
//! `masonry.txt` has a digest and a link; `node/shipped.test.mjs` compares with it, too. A building that is written and
//! read again has the same blocks.
//!
//! After an intended change: `BUBBLESTONE_UPDATE=1 cargo test --test masonry`.

// The tests under Node compare the digests in WebAssembly.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use bubblestone::generators::{ALL, GivenFile};
use bubblestone::recipe::Recipe;
use bubblestone::studio::Studio;
use common::{formed, recipe};
use std::collections::{BTreeMap, BTreeSet};

const GOLDEN: &str = include_str!("masonry.txt");

fn links() -> impl Iterator<Item = &'static str> {
    GOLDEN
        .lines()
        .map(|line| line.split_once(' ').expect("two parts").1)
}

/// The digest and the canonical link of a building.
fn line(link: &str) -> String {
    let studio = formed(link);
    format!("{} {}\n", studio.engine().digest(), studio.recipe().link())
}

#[test]
fn blocks_are_the_same_everywhere() {
    let found: String = links().map(line).collect();
    if std::env::var_os("BUBBLESTONE_UPDATE").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/masonry.txt");
        std::fs::write(path, found).unwrap();
        return;
    }
    assert_eq!(found, GOLDEN);
}

/// The table includes each building and each pattern, and all pairs of them.
#[test]
fn all_that_there_is_stands_in_the_table() {
    let recipes: Vec<Recipe> = links().map(recipe).collect();
    let words = |key: &str| {
        let row = recipes[0].schema().row(key).expect("a row");
        let words = row.choices.iter().map(|choice| choice.word);
        words.filter(|&word| word != "file").collect::<Vec<&str>>()
    };
    let has = |key: &str, word: &str, recipe: &Recipe| {
        recipe.choice(recipe.schema().row(key).expect("a row").key) == word
    };
    for building in words("building") {
        for pattern in words("pattern") {
            let both = |recipe: &&Recipe| {
                has("building", building, recipe) && has("pattern", pattern, recipe)
            };
            assert!(
                recipes.iter().any(|recipe| both(&recipe)),
                "{building} {pattern}"
            );
        }
    }
}

/// The files of data of a studio, by name.
fn data(studio: &Studio, name: &str) -> String {
    let files = studio.engine().data();
    let file = files.into_iter().find(|(known, _)| *known == name);
    file.expect("a file").1
}

#[test]
fn a_building_that_is_written_and_read_has_the_same_blocks() {
    for building in ["gabled", "gate", "steps", "tower"] {
        let first = formed(&format!("make=masonry&size=128&building={building}"));
        let mut second = Studio::new(ALL, recipe("make=masonry&size=128"));
        let text = data(&first, "model.json").into_bytes();
        let file = GivenFile::whole("model.json", text);
        second.open_file(None, file).expect("a building");
        while !["light", "done"].contains(&second.stage()) {
            assert_eq!(second.problem(), None);
            second.tick(&mut || 0.0, 0.0, u32::MAX);
        }
        for name in ["model.json", "blocks.json"] {
            assert!(
                data(&first, name) == data(&second, name),
                "{building} {name}"
            );
        }
    }
}

#[test]
fn each_block_has_its_feature_its_node_and_its_course() {
    let gabled = formed("make=masonry&size=128&building=gabled");
    let read = |name: &str| -> serde_json::Value {
        serde_json::from_str(&data(&gabled, name)).expect("JSON")
    };
    let (model, blocks, measures) = (
        read("model.json"),
        read("blocks.json"),
        read("measures.json"),
    );
    let blocks = blocks["blocks"].as_array().expect("a list");
    let faces = model["faces"].as_array().expect("a list");
    let (mut features, mut kinds) = (BTreeMap::new(), BTreeMap::new());
    let mut courses = BTreeSet::new();
    for block in blocks {
        let word = |key: &str| block[key].as_str().expect(key).to_owned();
        let name = word("name");
        let (feature, number) = name.rsplit_once('_').expect("a number");
        assert_eq!(feature, word("feature"));
        let number: usize = number.parse().expect("a number");
        if feature == "face" {
            let labels = faces[number]["label"].as_array();
            let labels = labels.into_iter().flatten().filter_map(|one| one.as_str());
            assert_eq!(labels.collect::<Vec<_>>().join(" "), word("label"));
        }
        // The tree of bricks begins with a choice by label, so each block's node has a path.
        assert_ne!(word("node"), "", "{name}");
        courses.extend(block["course"].as_u64());
        *features.entry(word("feature")).or_insert(0) += 1;
        *kinds.entry(word("kind")).or_insert(0) += 1;
    }
    let last = courses.len() as u64;
    assert!(last > 20 && courses.into_iter().eq(1..=last));
    assert_eq!(measures["cells"], blocks.len());
    assert_eq!(measures["features"], serde_json::json!(features));
    assert_eq!(measures["kinds"], serde_json::json!(kinds));
}
