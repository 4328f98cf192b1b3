//! The link determines the picture: every preset has the same planes, bit for bit, on every machine. This file
//! compares them with `digests.txt`; `node/shipped.test.mjs` does the same with the shipped module. Other
//! properties of all presets are also tested here, because making each preset takes time.
//!
//! After an intended change of pictures:
//! `BUBBLESTONE_UPDATE=1 cargo test --test digests`.

// Tests under Node compare the digests in WebAssembly.
#![cfg(not(target_arch = "wasm32"))]

mod common;
mod paving;

use bubblestone::generators::Preset;
use bubblestone::generators::pavement::{PAVEMENT, PavementRecipe};
use bubblestone::heightfield::{GROUND, Planes};
use bubblestone::notice::Notice;
use common::finished;
use paving::OfPavement;
use std::sync::OnceLock;

const GOLDEN: &str = include_str!("digests.txt");

/// The facts about a preset's finished picture.
struct Made {
    name: &'static str,
    digest: String,
    converged: bool,
    remarks: Vec<Notice>,
    /// The difference between a dark and a light tone, at the 5th and 95th percentile.
    contrast: u8,
    /// Whether all heights are finite.
    finite: bool,
    cracks: usize,
    /// The share of the picture that is skin, for a preset of skin.
    skin: Option<f64>,
}

impl Made {
    fn of(preset: &'static Preset) -> Self {
        let studio = finished(preset.link);
        let made = studio.pavement();
        let planes = made.planes.expect("planes");
        let stones = planes.id.iter().filter(|&&id| id != GROUND).count();
        let skin = || stones as f64 / planes.id.len() as f64;
        Self {
            name: preset.name,
            digest: studio.digest(),
            remarks: studio.engine().remarks(),
            converged: made.packing.expect("a packing").report().converged,
            contrast: contrast(studio.picture().expect("a picture")),
            finite: planes.bump.iter().all(|h| h.is_finite()),
            cracks: cracks(planes),
            skin: studio.recipe().is_skin().then(skin),
        }
    }
}

/// All presets, made once for all tests.
fn presets() -> &'static [Made] {
    static PRESETS: OnceLock<Vec<Made>> = OnceLock::new();
    PRESETS.get_or_init(|| PAVEMENT.presets.iter().map(Made::of).collect())
}

fn contrast(picture: &[u8]) -> u8 {
    let mut tones: Vec<u8> = picture.chunks(4).map(|p| p[1]).collect();
    tones.sort_unstable();
    let (dark, light) = (tones[tones.len() / 20], tones[tones.len() * 19 / 20]);
    light - dark
}

/// The number of pixels surrounded by one stone that are not part of it and lie below all their neighbours.
fn cracks(planes: &Planes) -> usize {
    let side = planes.side;
    let mut count = 0;
    for y in 1..side - 1 {
        for x in 1..side - 1 {
            let i = y * side + x;
            let around = [
                i - side - 1,
                i - side,
                i - side + 1,
                i - 1,
                i + 1,
                i + side - 1,
                i + side,
                i + side + 1,
            ];
            let id = planes.id[around[0]];
            let within = id != GROUND && around.iter().all(|&k| planes.id[k] == id);
            let below = around
                .iter()
                .all(|&k| planes.bump[k] > planes.bump[i] + 0.5);
            if within && planes.id[i] != id && below {
                count += 1;
            }
        }
    }
    count
}

#[test]
fn every_preset_has_the_same_planes_everywhere() {
    let line = |made: &Made| format!("{} {}\n", made.name, made.digest);
    let found: String = presets().iter().map(line).collect();
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

#[test]
fn every_preset_is_rendered() {
    for made in presets() {
        assert!(made.converged, "{}: the packing", made.name);
        assert!(made.contrast > 40, "{}: flat picture", made.name);
        assert!(made.remarks.is_empty(), "{}: {:?}", made.name, made.remarks);
    }
}

#[test]
fn no_preset_has_a_crack() {
    for made in presets() {
        assert_eq!(made.cracks, 0, "{}", made.name);
        assert!(made.finite, "{}", made.name);
        assert!(
            made.skin.is_none_or(|share| share * 3.0 > 1.0),
            "{}: {:?}",
            made.name,
            made.skin
        );
    }
}
