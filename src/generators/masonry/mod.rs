//! Masonry: bricks and stones laid on a building (Legakis, Dorsey, Gortler 2001, Feature-based cellular texturing for
//! architectural models).

mod blocks;
mod colours;
mod congruent;
mod cuboid;
#[cfg(not(target_arch = "wasm32"))]
mod data;
mod diagrams;
mod disc;
mod engine;
mod figures;
#[cfg(test)]
mod file_tests;
mod files;
#[cfg(test)]
mod flip_tests;
mod grain;
mod ground;
mod kept;
#[cfg(test)]
mod kept_tests;
mod labels;
#[cfg(test)]
mod look_tests;
mod making;
#[cfg(test)]
mod making_tests;
mod params;
mod parts;
mod plan_sentences;
mod presets;
mod rounding;
mod schema;
mod sentences;
mod setting;
mod shapes;
mod site;
mod stages;
mod subject;
#[cfg(test)]
mod tests;
mod trodden;
mod units;
#[cfg(test)]
mod view_tests;
mod views;
mod weather;

pub use schema::keys;

use super::given::FileRules;
use super::scene_picture::SceneEngine;
use super::{Course, Generator, Views};
use crate::recipe::Schema;
use stages::MasonryStages;

/// The parameters of masonry.
pub static SCHEMA: Schema = Schema {
    word: "masonry",
    is_named: true,
    rows: schema::ROWS,
    rules: &FileRules(|_| keys::BUILDING),
};

/// The generator.
pub static MASONRY: Generator = Generator {
    schema: &SCHEMA,
    title: "Masonry",
    presets: presets::PRESETS,
    stages: &stages::WORDS,
    course: Course {
        begins: &[0.0, 0.05, 0.2, 0.6, 0.62],
        stepping: "laying",
        placing: "laying",
        finisher: "bodies",
        settled: "light",
        seen: &["mortar", "mortar", "auto", "", ""],
    },
    views: Views {
        bases: &views::WORDS,
        overlays: &[],
    },
    offers: &[
        "frames", "models", "cut", "compare", "mesh", "building", "forming",
    ],
    names: &["building", "pattern"],
    samples: &[],
    chance: "masonry",
    home: "330,16,2.8,28",
    lowest: -85.0,
    engine: |recipe| Box::new(MasonryEngine::new(recipe)),
};

/// The engine.
pub(crate) type MasonryEngine = SceneEngine<MasonryStages>;
