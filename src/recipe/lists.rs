//! Text values of a recipe: rows of whole numbers for rings, lines, spots or seeds.
//!
//! Rows are stored as the whole numbers of the link, so they scale with the picture.

use super::rows::{self, BOX_STEPS, Form, POINTS, Rows, STEPS};
use super::{Item, Key, Recipe, Schema};
use crate::decimal;
use crate::notice::{Code, Notice};
use glam::DVec2;

/// Most rows of a text, except for rings and features.
pub const MAX_ROWS: usize = 64;
/// Most given cells in a text.
const MAX_BUBBLES: usize = 256;
/// Most features in a text, and the numbers that they may have.
const MAX_FEATURES: usize = 256;
const FEATURES: std::ops::Range<i64> = 0..1 << 20;
/// Most corners of a plan.
const MAX_CORNERS: usize = 64;
/// The numbers of an opening's row.
const OPENING: usize = 6;
/// Most points in all rows of a text, except for rings and plans.
pub const MAX_ROW_POINTS: usize = 256;

/// A spot's value is stored in steps of 1 / `VALUE`.
const VALUE: f64 = 1024.0;
/// How far outside the picture a point may lie, in sides of the picture.
const OUTSIDE: f64 = 0.5;
/// Smallest and largest radius of a spot, in sides.
const RADIUS: (f64, f64) = (0.01, 2.0);

/// The form of rows with places on a surface.
const IN_BOX: Form = Form {
    coordinates: usize::MAX,
    dimension: 3,
    steps: BOX_STEPS,
    units: &[],
};
/// How far outside its box a place on a surface may lie, in sides of the box: a simplified model may have
/// been larger.
const BEYOND: f64 = 1.0 / 64.0;
/// The most characters of a file's name.
pub const MAX_NAME: usize = 80;

/// The row of points, each rounded to the grid of 1/32768 of the side.
pub fn row(points: &[DVec2], side: f64) -> Vec<i64> {
    let steps = |p: &DVec2| (*p * STEPS / side).round().to_array();
    points.iter().flat_map(steps).map(|x| x as i64).collect()
}

/// The points of a row, in pictures of this side.
pub fn points(row: &[i64], side: f64) -> Vec<DVec2> {
    let point = |pair: &[i64]| DVec2::new(pair[0] as f64, pair[1] as f64) * side / STEPS;
    row.chunks_exact(2).map(point).collect()
}

impl Item {
    pub(super) fn form(self) -> Form {
        match self {
            Item::Ring(_) | Item::Line => POINTS,
            Item::Spot(..) => Form {
                coordinates: 2,
                units: &[STEPS, VALUE],
                ..POINTS
            },
            Item::Seed(_) | Item::Bubble => Form {
                coordinates: 2,
                units: &[1.0],
                ..POINTS
            },
            Item::Trace => IN_BOX,
            Item::Patch(..) => Form {
                coordinates: 3,
                units: &[BOX_STEPS, VALUE],
                ..IN_BOX
            },
            Item::Plan => Form {
                steps: 1.0,
                ..POINTS
            },
            Item::File | Item::Feature | Item::Opening => Form {
                coordinates: 0,
                steps: 1.0,
                ..POINTS
            },
        }
    }

    fn most_points(self) -> usize {
        match self {
            Item::Ring(most) => most,
            Item::Plan => MAX_CORNERS,
            _ => MAX_ROW_POINTS,
        }
    }

    fn most_rows(self) -> usize {
        match self {
            Item::Feature => MAX_FEATURES,
            Item::Bubble => MAX_BUBBLES,
            Item::Plan => 1,
            _ => MAX_ROWS,
        }
    }

    /// Whether a place of a row is too far outside of the picture or the box.
    fn is_outside(self, row: &[i64]) -> bool {
        let form = self.form();
        let outside = match self {
            // The building checks its own limits.
            Item::Plan => f64::INFINITY,
            _ if form.dimension == 3 => BEYOND,
            _ => OUTSIDE,
        };
        let far = |&x: &i64| (x as f64 / form.steps - 0.5).abs() > 0.5 + outside;
        row.iter().take(form.coordinates).any(far)
    }

    /// The fault of a row, if any, without the row's number in the list.
    fn flaw(self, row: &[i64], schema: &Schema) -> Option<Notice> {
        let form = self.form();
        if self.is_outside(row) {
            let code = match form.dimension {
                2 => Code::RowOutside,
                _ => Code::RowOffBox,
            };
            return Some(code.into());
        }
        match (self, row) {
            (Item::Ring(_), _) | (Item::Line | Item::Plan, [_, _, _, _, ..]) => None,
            (Item::Line | Item::Plan, _) => Some(Code::RowShort.into()),
            (Item::Trace, [_, _, _, _, _, _, ..]) => None,
            (Item::Trace, _) => Some(Code::RowShort.into()),
            (Item::File, row) => (!is_file(row)).then(|| Code::RowModel.into()),
            (Item::Feature, [0 | 1, number]) if FEATURES.contains(number) => None,
            (Item::Feature, _) => Some(Code::RowFeature.into()),
            (Item::Opening, row) => (row.len() != OPENING).then(|| Code::RowOpening.into()),
            (Item::Spot(min, max), &[_, _, radius, value])
            | (Item::Patch(min, max), &[_, _, _, radius, value]) => {
                spot_flaw(radius as f64 / form.steps, value as f64 / VALUE, [min, max])
            }
            (Item::Spot(..), _) => Some(Code::RowSpot.into()),
            (Item::Patch(..), _) => Some(Code::RowPatch.into()),
            (Item::Seed(key), &[_, _, place]) => {
                let words = schema.row(key.0).map_or(0, |row| row.choices.len());
                let most = words.saturating_sub(1);
                let known = (0..=most as i64).contains(&place);
                (!known).then(|| Notice::new(Code::RowKind).with("most", most))
            }
            (Item::Seed(_), _) => Some(Code::RowSeed.into()),
            (Item::Bubble, [_, _, 0 | 1]) => None,
            (Item::Bubble, _) => Some(Code::RowBubble.into()),
        }
    }
}

/// Whether a row is a file: its digest in four numbers, and the characters of its name.
fn is_file(row: &[i64]) -> bool {
    let [a, b, c, d, name @ ..] = row else {
        return false;
    };
    let fits = |n: &i64| (0..1 << 16).contains(n);
    let is_character = |n: &i64| u32::try_from(*n).is_ok_and(|n| char::from_u32(n).is_some());
    [a, b, c, d].into_iter().all(fits) && name.iter().all(is_character) && name.len() <= MAX_NAME
}

/// The fault of a spot's radius or value.
fn spot_flaw(radius: f64, value: f64, [min, max]: [f64; 2]) -> Option<Notice> {
    // The limits themselves may lie between two numbers that a link can hold.
    let within = |x: f64, min: f64, max: f64| x > min - 1e-3 && x < max + 1e-3;
    if !within(radius, RADIUS.0, RADIUS.1) {
        Some(between(Code::RowRadius, RADIUS.0, RADIUS.1))
    } else if !within(value, min, max) {
        Some(between(Code::RowValue, min, max))
    } else {
        None
    }
}

impl Recipe {
    fn item(&self, key: Key) -> Option<Item> {
        self.schema.row(key.0)?.item
    }

    fn form(&self, key: Key) -> Form {
        self.item(key).map_or(POINTS, Item::form)
    }

    /// The rows as text.
    pub(super) fn rows_text(&self, key: Key) -> String {
        rows::encode(self.rows(key), self.form(key))
    }

    /// Reads rows; an empty text has none.
    ///
    /// # Errors
    /// A part of a sentence that describes the fault.
    pub(super) fn read_rows(&self, key: Key, text: &str) -> Result<Rows, Notice> {
        match self.item(key) {
            Some(item) if !text.is_empty() => rows::decode(text, item.form(), item.most_points()),
            _ => Ok(Rows::new()),
        }
    }

    /// The rows of a text in decimal numbers, as in its readable form: lengths in sides of the picture,
    /// values unscaled.
    pub fn list(&self, key: Key) -> Vec<Vec<f64>> {
        let form = self.form(key);
        let decimal = |(k, &number): (usize, &i64)| number as f64 / form.unit(k);
        let row = |row: &Vec<i64>| row.iter().enumerate().map(decimal).collect();
        self.rows(key).iter().map(row).collect()
    }

    /// Sets rows of lines, spots or seeds.
    ///
    /// # Errors
    /// A part of a sentence that describes the fault; the old rows stay.
    pub fn set_rows(&mut self, key: Key, rows: Rows) -> Result<(), Notice> {
        let Some(item) = self.item(key) else {
            return Ok(());
        };
        let form = item.form();
        let points = |row: &Vec<i64>| row.len().min(form.coordinates) / form.dimension;
        if rows.iter().map(points).sum::<usize>() > item.most_points() {
            let most = item.most_points();
            return Err(Notice::new(Code::TooManyPoints).with("most", most));
        }
        let rows = checked(rows, item, self.schema)?;
        self.put_rows(key, rows);
        Ok(())
    }

    /// Sets rows that were checked.
    pub fn put_rows(&mut self, key: Key, rows: Rows) {
        if let Some(place) = self.schema.place(key) {
            self.values[place].rows = rows;
        }
    }

    /// The points of each row, in picture units.
    pub fn polylines(&self, key: Key) -> Vec<Vec<DVec2>> {
        let points = |row: &Vec<i64>| points(row, self.side());
        self.rows(key).iter().map(points).collect()
    }

    /// Spots: x, y and radius in picture units, and the value there.
    pub fn spots(&self, key: Key) -> Vec<[f64; 4]> {
        let unit = self.side() / STEPS;
        let Some(Item::Spot(min, max)) = self.item(key) else {
            return Vec::new();
        };
        let spot = |row: &Vec<i64>| {
            let number = |k: usize| row[k] as f64;
            let value = (number(3) / VALUE).clamp(min, max);
            [number(0) * unit, number(1) * unit, number(2) * unit, value]
        };
        self.rows(key).iter().map(spot).collect()
    }

    /// Seeds: points in picture units, each with a word of the choice.
    pub fn seeds(&self, key: Key) -> Vec<(DVec2, &'static str)> {
        let words = match self.item(key) {
            Some(Item::Seed(choice)) => self.schema.row(choice.0).map_or(&[][..], |r| r.choices),
            _ => &[],
        };
        let seed = |row: &Vec<i64>| {
            let place = points(&row[..2], self.side());
            let word = words.get(row[2] as usize).map_or("", |choice| choice.word);
            (place[0], word)
        };
        self.rows(key).iter().map(seed).collect()
    }
}

/// A notice with limits.
fn between(code: Code, min: f64, max: f64) -> Notice {
    let limits = Notice::new(code).with("min", decimal::text(min));
    limits.with("max", decimal::text(max))
}

/// Removes repeated neighbouring points from lines, and checks all rows.
fn checked(mut rows: Rows, item: Item, schema: &Schema) -> Result<Rows, Notice> {
    let most = item.most_rows();
    if rows.len() > most {
        return Err(Notice::new(Code::TooManyRows).with("most", most));
    }
    for (index, row) in rows.iter_mut().enumerate() {
        if matches!(item, Item::Line | Item::Trace | Item::Plan) {
            let n = item.form().dimension;
            let mut kept = n.min(row.len());
            for k in (n..row.len()).step_by(n) {
                if row[k..k + n] != row[kept - n..kept] {
                    row.copy_within(k..k + n, kept);
                    kept += n;
                }
            }
            row.truncate(kept);
        }
        if let Some(flaw) = item.flaw(row, schema) {
            return Err(flaw.with("row", index + 1));
        }
    }
    let is_taken = |k: &usize| rows[..*k].iter().any(|row| row[..2] == rows[*k][..2]);
    if item == Item::Bubble
        && let Some(again) = (1..rows.len()).find(is_taken)
    {
        return Err(Notice::new(Code::RowTwice).with("row", again + 1));
    }
    Ok(rows)
}
