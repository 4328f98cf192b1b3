//! Links of masonry and files of buildings from strangers: the work ends within a number of slices, with a sentence or
//! with a picture in which every number is finite.
//!
//! More of them, from another start: `BUBBLESTONE_RECIPES=2000 BUBBLESTONE_SEED=7 cargo test --release
//! --test hostile_masonry`.

// Tests in WebAssembly are built without the feature `house`, so they make no masonry.
#![cfg(not(target_arch = "wasm32"))]

mod common;
mod strangers;

use strangers::{broken, buildings, given_ends_well, link_ends_well, try_all, wild_building};

/// A building of a file, in a small picture.
const FILE: &str = "make=masonry&building=file&size=128";

#[test]
fn whatever_a_link_asks_for_the_building_ends_well() {
    try_all(24, |random| {
        let link = wild_building(random);
        println!("#{link}");
        link_ends_well(&link).text
    });
}

#[test]
fn the_files_are_good_before_they_are_broken() {
    for (name, bytes) in buildings() {
        let end = given_ends_well(FILE, name, bytes, &mut || 0.0);
        assert!(
            end.cells.is_some_and(|blocks| blocks > 100),
            "{name}: {}",
            end.text
        );
    }
}

#[test]
fn whatever_is_in_a_file_it_becomes_a_building_or_a_sentence() {
    let files = buildings();
    try_all(100, |random| {
        let (name, bytes) = broken(random, &files);
        println!("{name}");
        given_ends_well(FILE, name, bytes, &mut || 0.0).text
    });
}
