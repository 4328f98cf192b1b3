//! Cells on surfaces in space: a surface packed with cells, which become stones or scales (Miyata, Itoh, Shimada 2001,
//! Generating Pavement Textures via Close Packing of Squares, section 4, in Japanese; Itoh, Miyata, Shimada 2003,
//! Generation of Organic Textures with Controlled Anisotropy and Directionality via Packing Rectangular and Elliptical
//! Cells, section 5 and figures 18 and 19).

mod build;
#[cfg(not(target_arch = "wasm32"))]
mod data;
mod engine;
mod fields;
mod files;
mod made;
mod making;
mod params;
mod paving;
mod presets;
#[cfg(test)]
mod quality;
mod reduce;
mod schema;
mod stages;
mod subject;
#[cfg(test)]
mod tests;
mod tracing;
mod views;

pub use schema::keys;

use super::given::FileRules;
use super::scene_picture::SceneEngine;
use super::{Course, Generator, Views};
use crate::recipe::Schema;
use stages::Stages;

/// The parameters of a surface.
pub static SCHEMA: Schema = Schema {
    word: "surface",
    is_named: true,
    rows: schema::ROWS,
    rules: &FileRules(|_| keys::FORM),
};

/// The generator of cells on surfaces in space.
pub static SURFACE: Generator = Generator {
    schema: &SCHEMA,
    title: "Surfaces in space",
    presets: presets::PRESETS,
    stages: &stages::WORDS,
    course: Course {
        begins: &[0.0, 0.02, 0.1, 0.6, 0.62, 0.66, 0.85],
        stepping: "packing",
        placing: "stones",
        finisher: "stones",
        settled: "light",
        seen: &["surface", "surface", "packed", "mesh", "cells", "", ""],
    },
    views: Views {
        bases: &views::WORDS,
        overlays: &[],
    },
    offers: &[
        "frames", "models", "paint", "compare", "mesh", "forming", "moves", "rewind",
    ],
    names: &["form", "kind", "stone", "palette"],
    samples: &[],
    chance: "surface",
    home: "330,20,2.75,28",
    lowest: -85.0,
    engine: |recipe| Box::new(SurfaceEngine::new(recipe)),
};

/// The engine of surfaces.
pub(crate) type SurfaceEngine = SceneEngine<Stages>;
