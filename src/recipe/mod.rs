//! All parameters of a pavement in one checked value, its link, and the presets.
//!
//! Everything that comes from outside passes here: a [`Recipe`] only ever holds values within their
//! limits and a polygon that [`Outline::check`] accepts. What did not fit is told in sentences.

mod link;
mod lists;
mod parameter;
mod poly;
mod presets;
mod rows;
mod schema;
mod value;

pub use link::VERSION;
pub use lists::{MAX_ROW_POINTS, MAX_ROWS};
pub use parameter::{Choice, Kind, Parameter};
pub use presets::{PRESETS, Part, Preset, Timing};
pub use schema::{Key, SCHEMA};

use crate::domain::Outline;
use crate::domain::shape::{ShapeParams, built_in};

/// The stages of the pipeline, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// The outline with its distances.
    Domain,
    /// Size and direction of the cells.
    Fields,
    /// The relaxation of the cells.
    Packing,
    /// The mesh that joins neighbouring cells.
    Mesh,
    /// One polygon per cell.
    Cells,
    /// Stones, painted as they are made into planes of bump, colour, material and id.
    Planes,
    /// What years and weather do to the planes, and how much of the sky each place sees.
    Weather,
    /// The picture.
    Shading,
}

impl Stage {
    /// All stages in their order.
    pub const ALL: [Stage; 8] = [
        Stage::Domain,
        Stage::Fields,
        Stage::Packing,
        Stage::Mesh,
        Stage::Cells,
        Stage::Planes,
        Stage::Weather,
        Stage::Shading,
    ];

    /// The stage's name in scripts and reports.
    pub const fn word(self) -> &'static str {
        match self {
            Stage::Domain => "domain",
            Stage::Fields => "fields",
            Stage::Packing => "packing",
            Stage::Mesh => "mesh",
            Stage::Cells => "cells",
            Stage::Planes => "planes",
            Stage::Weather => "weather",
            Stage::Shading => "shading",
        }
    }
}

/// A value for every parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// By `Key as usize`: the number, or the place of the word among the choices.
    values: Vec<f64>,
    /// The free polygon in picture units; always one that passed the check. It is kept while another
    /// outline is chosen, but it is part of the link only while it is in use.
    polygon: Option<Outline>,
    lists: [lists::Rows; lists::COUNT],
}

impl Default for Recipe {
    fn default() -> Self {
        Self {
            values: SCHEMA.iter().map(|row| row.default).collect(),
            polygon: None,
            lists: Default::default(),
        }
    }
}

/// The word for the outline that is given by its points.
const POLYGON: &str = "polygon";

/// The word for skin cells among the stones.
const SKIN: &str = "skin";

/// Finest and coarsest cells: this many along a side of the picture.
const MOST_CELLS: f64 = 400.0;
const FEWEST_CELLS: f64 = 2.0;
/// Cells below this many pixels could not be told from noise.
const LEAST_CELL: f64 = 2.0;

impl Recipe {
    /// The value of a number or whole number; of a choice, the place of its word.
    pub fn number(&self, key: Key) -> f64 {
        self.values[key as usize]
    }

    /// The word of a choice; empty for other kinds.
    pub fn choice(&self, key: Key) -> &'static str {
        let place = self.number(key) as usize;
        key.parameter().choices.get(place).map_or("", |c| c.word)
    }

    /// The free polygon in picture units, where one was given (in use or not).
    pub fn polygon(&self) -> Option<&Outline> {
        self.polygon.as_ref()
    }

    /// The picture's side in pixels, which are the picture units.
    pub fn side(&self) -> f64 {
        self.number(Key::Size)
    }

    /// Is the picture a tile, whose edges fit each other? Then the outline does not count.
    pub fn is_tile(&self) -> bool {
        self.choice(Key::Tile) == "1"
    }

    /// The outline that the recipe asks for, with the constraint lines, checked, in picture units.
    pub fn outline(&self) -> Outline {
        let mut outline = match (&self.polygon, self.choice(Key::Outline)) {
            (Some(polygon), POLYGON) => polygon.clone(),
            (_, name) => built_in(
                name,
                &ShapeParams {
                    side: self.side(),
                    width: self.number(Key::Ow),
                    count: self.number(Key::On) as u32,
                    turn: self.number(Key::Oa).to_radians(),
                },
            ),
        };
        outline.lines = self.lines();
        outline
    }

    /// The limits of a number in this recipe: those of the schema, except that cells go from a 400th
    /// to half of the picture's side (and never below 2 px).
    pub fn limits(&self, key: Key) -> (f64, f64) {
        let row = key.parameter();
        match key {
            Key::Cs => (
                (self.side() / MOST_CELLS).floor().max(LEAST_CELL),
                self.side() / FEWEST_CELLS,
            ),
            _ => (row.min, row.max),
        }
    }

    /// Are the stones skin cells, whose numbers have defaults of their own?
    pub fn is_skin(&self) -> bool {
        self.choice(Key::Stone) == SKIN
    }

    /// The default of a number in this recipe (of a choice, 0: its first word). The papers measure
    /// skin in parts of a cell and stones in pixels, so some numbers have one for each.
    pub fn default_of(&self, key: Key) -> f64 {
        let row = key.parameter();
        match row.skin_default {
            Some(own) if self.is_skin() => own,
            _ => row.default,
        }
    }
}
