//! The outline of a recipe, and the free polygon that may replace it.

use super::schema::{POLYGON, keys};
use crate::domain::Outline;
use crate::domain::shape::{ShapeParams, built_in};
use crate::generators::rows::stones::SKIN;
use crate::notice::{Code, Notice};
use crate::recipe::{Key, Recipe, Rows, Rules, STEPS, points, row};
use glam::DVec2;

/// Values of a pavement's recipe that take more than one row.
pub trait PavementRecipe {
    /// The outline with the constraint lines, checked, in picture units.
    fn outline(&self) -> Outline;

    /// The free polygon in picture units, if one was given (in use or not).
    fn polygon(&self) -> Option<Outline>;

    /// Takes the outline as the free polygon and selects it, and also its constraint lines if it has any. Its points
    /// are moved to the nearest ones that a link can hold (1/32768 of the picture's side).
    ///
    /// # Errors
    /// Those of [`Outline::check`]; the recipe stays as it was. `Ok` holds notices of the repairs.
    fn set_polygon(&mut self, outline: &Outline) -> Result<Vec<Notice>, Notice>;

    /// Whether the picture is a tile, whose edges fit each other. Then the outline has no effect.
    fn is_tile(&self) -> bool;

    /// Whether the stones are skin, whose numbers have defaults of their own.
    fn is_skin(&self) -> bool;

    /// The constraint lines, in picture units.
    fn lines(&self) -> Vec<Vec<DVec2>>;
}

impl PavementRecipe for Recipe {
    fn outline(&self) -> Outline {
        let drawn = self
            .polygon()
            .filter(|_| self.choice(keys::OUTLINE) == POLYGON);
        let mut outline = drawn.unwrap_or_else(|| {
            built_in(
                self.choice(keys::OUTLINE),
                &ShapeParams {
                    side: self.side(),
                    width: self.number(keys::OW),
                    count: self.number(keys::ON) as u32,
                    turn: self.number(keys::OA).to_radians(),
                },
            )
        });
        outline.lines = self.lines();
        outline
    }

    fn polygon(&self) -> Option<Outline> {
        let rows = self.rows(keys::POLY);
        (!rows.is_empty()).then(|| of_rows(rows, self.side()))
    }

    fn set_polygon(&mut self, outline: &Outline) -> Result<Vec<Notice>, Notice> {
        let side = self.side();
        // Check before the points are moved, too: a notice should give the original places.
        let (given, mut notices) = outline.check(side)?;
        let (checked, more) = snap(&given, side).check(side)?;
        notices.extend(more);
        let rows = |lines: &[Vec<DVec2>]| lines.iter().map(|line| row(line, side)).collect();
        if !checked.lines.is_empty() {
            self.set_rows(keys::LINES, rows(&checked.lines))
                .map_err(|why| Notice::new(Code::LinesRefused).with("why", why))?;
        }
        self.put_rows(keys::POLY, rows(&checked.rings));
        self.choose(keys::OUTLINE, POLYGON);
        Ok(notices)
    }

    fn is_tile(&self) -> bool {
        self.choice(keys::TILE) == "1"
    }

    fn is_skin(&self) -> bool {
        self.choice(keys::STONE) == SKIN
    }

    fn lines(&self) -> Vec<Vec<DVec2>> {
        self.polylines(keys::LINES)
    }
}

fn of_rows(rows: &[Vec<i64>], side: f64) -> Outline {
    Outline {
        rings: rows.iter().map(|row| points(row, side)).collect(),
        ..Outline::default()
    }
}

/// Moves every point to the nearest one that a link can hold.
fn snap(outline: &Outline, side: f64) -> Outline {
    let snapped = |p: &DVec2| (*p * STEPS / side).round() * side / STEPS;
    let ring = |ring: &Vec<DVec2>| ring.iter().map(snapped).collect();
    Outline {
        rings: outline.rings.iter().map(ring).collect(),
        lines: outline.lines.iter().map(ring).collect(),
    }
}

/// The rules of a pavement's recipe that concern more than one row.
pub(super) struct PavementRules;

impl Rules for PavementRules {
    /// Replaces the keys and words of older links by present ones. `br`, the bevel ratio Br of the 2001 paper, sets
    /// both `bh` and `bv`.
    fn modern(&self, key: String, value: String) -> Vec<(String, String)> {
        match key.as_str() {
            "br" => ["bh", "bv"].map(|k| (k.to_owned(), value.clone())).to_vec(),
            "outline" => {
                let word = value.trim().to_ascii_lowercase();
                let modern = OUTLINE_WORDS.iter().find(|(old, _)| *old == word);
                vec![(key, modern.map_or(value, |(_, new)| (*new).to_owned()))]
            }
            _ => vec![(key, value)],
        }
    }

    /// Makes these rows the free polygon; without rows, the present outline.
    fn draw(&self, recipe: &mut Recipe, _: Key, rows: Option<Rows>) -> Result<Vec<Notice>, Notice> {
        let outline = match rows {
            Some(rows) => of_rows(&rows, recipe.side()),
            None => recipe.outline(),
        };
        recipe.set_polygon(&outline)
    }
}

/// Alternative words for outlines, accepted in links only.
const OUTLINE_WORDS: [(&str, &str); 8] = [
    ("road", "road_straight"),
    ("s_curve", "road_s"),
    ("spiral", "road_spiral"),
    ("ring", "annulus"),
    ("fork", "y_fork"),
    ("notch", "road_notch"),
    ("l", "l_shape"),
    ("free", "polygon"),
];
