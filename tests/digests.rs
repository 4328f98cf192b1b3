//! The link is the picture: every preset has the same planes, bit for bit, natively and in
//! WebAssembly. Both are compared with `digests.txt`.
//!
//! After a change that is meant to change pictures:
//! `BUBBLESTONE_UPDATE=1 cargo test --test digests`.

use bubblestone::generators::ALL;
use bubblestone::generators::pavement::{self, PAVEMENT};
use bubblestone::studio::Studio;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const GOLDEN: &str = include_str!("digests.txt");

/// A line for each preset: its name and its digest.
fn digests() -> String {
    let line = |preset: &bubblestone::generators::Preset| {
        let (recipe, _) = pavement::recipe(preset.link);
        let mut studio = Studio::new(ALL, recipe);
        let finished = studio.finish(&mut || 0.0);
        assert_eq!(finished, Ok(()), "{}", preset.name);
        format!("{} {}\n", preset.name, studio.digest())
    };
    PAVEMENT.presets.iter().map(line).collect()
}

#[test]
fn every_preset_has_the_same_planes_everywhere() {
    let found = digests();
    #[cfg(not(target_arch = "wasm32"))]
    if std::env::var_os("BUBBLESTONE_UPDATE").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/digests.txt");
        std::fs::write(path, found).unwrap();
        return;
    }
    let differs: Vec<&str> = found
        .lines()
        .filter(|line| !GOLDEN.lines().any(|golden| golden == *line))
        .collect();
    assert!(
        differs.is_empty(),
        "other than in digests.txt: {differs:#?}"
    );
    assert_eq!(found.lines().count(), GOLDEN.lines().count());
}
