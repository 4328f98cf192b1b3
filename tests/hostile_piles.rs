//! Links of piles and files of components from strangers: the work ends within a number of slices, with a sentence or
//! with a picture in which every number is finite.
//!
//! More of them, from another start: `BUBBLESTONE_RECIPES=2000 BUBBLESTONE_SEED=7 cargo test --release
//! --test hostile_piles`.

// Tests in WebAssembly are built without the feature `house`, so they make no piles.
#![cfg(not(target_arch = "wasm32"))]

mod common;
mod strangers;

use strangers::{broken, files, given_ends_well, link_ends_well, try_all, wild_pile};

#[test]
fn whatever_a_link_asks_for_the_pile_ends_well() {
    try_all(16, |random| {
        let link = wild_pile(random);
        println!("#{link}");
        link_ends_well(&link).text
    });
}

#[test]
fn whatever_is_in_a_file_it_becomes_a_component_or_a_sentence() {
    let files = files();
    try_all(30, |random| {
        let (name, bytes) = broken(random, &files);
        println!("{name}");
        let link = "make=pile&size=128&variants=2&ps=5";
        given_ends_well(link, name, bytes, &mut || 0.0).text
    });
}
