//! Piles: bodies of every component on every shape are the same, bit for bit, on every machine, by each search and in
//! each order. Each line of `piles.txt` has a digest and a link; `node/shipped.test.mjs` compares with it, too.
//!
//! After an intended change: `BUBBLESTONE_UPDATE=1 cargo test --test piles`.

// The tests under Node compare the digests in WebAssembly.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use bubblestone::recipe::Recipe;
use common::{formed, recipe};

const GOLDEN: &str = include_str!("piles.txt");

/// The digest and the canonical link of a pile.
fn line(link: &str) -> String {
    let studio = formed(link);
    format!("{} {}\n", studio.engine().digest(), studio.recipe().link())
}

#[test]
fn piles_are_the_same_everywhere() {
    let links = GOLDEN
        .lines()
        .map(|line| line.split_once(' ').expect("two parts").1);
    let found: String = links.map(line).collect();
    if std::env::var_os("BUBBLESTONE_UPDATE").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/piles.txt");
        std::fs::write(path, found).unwrap();
        return;
    }
    assert_eq!(found, GOLDEN);
}

/// The table includes each component, each shape, each search, and each order.
#[test]
fn all_that_there_is_stands_in_the_table() {
    let links = GOLDEN
        .lines()
        .map(|line| line.split_once(' ').expect("two parts").1);
    let recipes: Vec<Recipe> = links.map(recipe).collect();
    for key in [
        "c1", "form", "darts", "merge", "frame", "refine", "reading", "reach", "order", "first",
        "core", "gloss",
    ] {
        let row = recipes[0].schema().row(key).expect("a row");
        for choice in row.choices.iter().filter(|choice| choice.word != "file") {
            let has = |recipe: &Recipe| recipe.choice(row.key) == choice.word;
            assert!(recipes.iter().any(has), "{key}={}", choice.word);
        }
    }
}
