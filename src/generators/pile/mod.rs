//! Piles: bodies heaped on a shape (Sakurai, Miyata 2014, Modelling of Non-Periodic Aggregates Having a Pile Structure).

mod components;
mod darting;
#[cfg(not(target_arch = "wasm32"))]
mod data;
mod detail;
mod diagrams;
mod dress;
mod engine;
mod figures;
mod files;
mod heap;
mod made;
mod materials;
mod params;
mod places;
mod presets;
#[cfg(test)]
mod quality;
mod schema;
mod site;
mod stages;
mod subject;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod view_tests;
mod views;

pub use schema::keys;

use super::scene_picture::SceneEngine;
use super::{Course, Generator, Views};
use crate::recipe::Schema;
use stages::PileStages;

/// The parameters of a pile.
pub static SCHEMA: Schema = Schema {
    word: "pile",
    is_named: true,
    rows: schema::ROWS,
    rules: &schema::PileRules,
};

/// The generator.
pub static PILE: Generator = Generator {
    schema: &SCHEMA,
    title: "Piles",
    presets: presets::PRESETS,
    stages: &stages::WORDS,
    course: Course {
        begins: &[0.0, 0.3, 0.35, 0.45, 0.7, 0.72],
        stepping: "refine",
        placing: "refine",
        finisher: "bodies",
        settled: "light",
        seen: &["darts", "darts", "darts", "auto", "", ""],
    },
    views: Views {
        bases: &views::WORDS,
        overlays: &[],
    },
    offers: &[
        "frames", "models", "cut", "bodies", "compare", "mesh", "places", "forming", "moves",
    ],
    names: &["c1", "form"],
    samples: &schema::SAMPLES,
    chance: "pile",
    home: "330,24,2.65,28",
    lowest: -85.0,
    engine: |recipe| Box::new(PileEngine::new(recipe)),
};

/// The engine.
pub(crate) type PileEngine = SceneEngine<PileStages>;
