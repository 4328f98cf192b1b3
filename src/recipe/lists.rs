//! Lists that a recipe holds: constraint lines, strokes, spots, and seeds of parts.
//!
//! They are kept as the whole numbers of the link, so they grow with the picture by themselves.

use super::rows::{self, Form, POINTS, STEPS};
use super::{Key, Recipe, poly};
use crate::decimal;
use crate::notice::{Code, Notice};
use crate::order;
use glam::DVec2;

/// Most rows of a list.
pub const MAX_ROWS: usize = 64;
/// Most points in all rows of a list.
pub const MAX_ROW_POINTS: usize = 256;

/// The rows of a list.
pub(super) type Rows = Vec<Vec<i64>>;

/// What 1 is in a spot's value.
const VALUE: f64 = 1024.0;
/// How far outside the picture a point may lie, in sides.
const OUTSIDE: f64 = 0.5;
/// Smallest and largest radius of a spot, in sides.
const RADIUS: (f64, f64) = (0.01, 2.0);

/// What the rows of a list are.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Item {
    /// A polyline.
    Line,
    /// x, y, radius and a value between two limits.
    Spot(f64, f64),
    /// x, y and a choice of [`Key::Kind`].
    Seed,
}

/// The keys of the lists and what their rows are.
const LISTS: [(Key, Item); 5] = [
    (Key::Lines, Item::Line),
    (Key::Parts, Item::Seed),
    (Key::Spots, Item::Spot(0.2, 3.0)),
    (Key::Strokes, Item::Line),
    (Key::Stretch, Item::Spot(1.0, 5.0)),
];

/// Number of lists.
pub(super) const COUNT: usize = LISTS.len();

/// The place of a key's list.
fn place(key: Key) -> Option<usize> {
    LISTS.iter().position(|&(k, _)| k == key)
}

impl Item {
    fn form(self) -> Form {
        match self {
            Item::Line => POINTS,
            Item::Spot(..) => Form {
                coordinates: 2,
                units: &[STEPS, VALUE],
            },
            Item::Seed => Form {
                coordinates: 2,
                units: &[1.0],
            },
        }
    }

    /// Why a row is none of these, but for its number.
    fn flaw(self, row: &[i64]) -> Option<Notice> {
        let coordinates = &row[..row.len().min(self.form().coordinates)];
        let far = |&x: &i64| (x as f64 / STEPS - 0.5).abs() > 0.5 + OUTSIDE;
        if coordinates.iter().any(far) {
            return Some(Code::RowOutside.into());
        }
        match (self, row) {
            (Item::Line, [_, _, _, _, ..]) => None,
            (Item::Line, _) => Some(Code::RowShort.into()),
            (Item::Spot(min, max), &[_, _, radius, value]) => {
                let (radius, value) = (radius as f64 / STEPS, value as f64 / VALUE);
                // The limits themselves may lie between two of the numbers that a link can hold.
                let within = |x: f64, min: f64, max: f64| x > min - 1e-3 && x < max + 1e-3;
                if !within(radius, RADIUS.0, RADIUS.1) {
                    Some(between(Code::RowRadius, RADIUS.0, RADIUS.1))
                } else if !within(value, min, max) {
                    Some(between(Code::RowValue, min, max))
                } else {
                    None
                }
            }
            (Item::Spot(..), _) => Some(Code::RowSpot.into()),
            (Item::Seed, &[_, _, kind]) => {
                let most = Key::Kind.parameter().choices.len() - 1;
                let known = (0..=most as i64).contains(&kind);
                (!known).then(|| Notice::new(Code::RowKind).with("most", most))
            }
            (Item::Seed, _) => Some(Code::RowSeed.into()),
        }
    }
}

impl Recipe {
    /// The rows of a list; none for the keys of other values.
    pub(super) fn rows(&self, key: Key) -> &[Vec<i64>] {
        place(key).map_or(&[], |at| &self.lists[at])
    }

    /// The text of a list.
    pub(super) fn list_text(&self, key: Key) -> String {
        let form = place(key).map_or(POINTS, |at| LISTS[at].1.form());
        rows::encode(self.rows(key), form)
    }

    /// The rows of a list in decimal numbers: lengths in sides of the picture, values as they are,
    /// the numbers that its readable text has.
    pub fn list(&self, key: Key) -> Vec<Vec<f64>> {
        let form = place(key).map_or(POINTS, |at| LISTS[at].1.form());
        let decimal = |(k, &number): (usize, &i64)| number as f64 / form.unit(k);
        let row = |row: &Vec<i64>| row.iter().enumerate().map(decimal).collect();
        self.rows(key).iter().map(row).collect()
    }

    /// Takes a list from its text; an empty one clears it.
    ///
    /// # Errors
    /// A part of a sentence that says what is wrong; the old list stays.
    pub(super) fn take_list(&mut self, key: Key, text: &str) -> Result<(), Notice> {
        let Some(at) = place(key) else {
            return Ok(());
        };
        let item = LISTS[at].1;
        let rows = if text.is_empty() {
            Rows::new()
        } else {
            rows::decode(text, item.form(), MAX_ROW_POINTS)?
        };
        self.lists[at] = checked(rows, item)?;
        Ok(())
    }

    /// Takes the constraint lines of an outline.
    ///
    /// # Errors
    /// A part of a sentence that says what is wrong; the old lines stay.
    pub(super) fn take_lines(&mut self, lines: &[Vec<DVec2>]) -> Result<(), Notice> {
        let rows: Rows = lines.iter().map(|l| poly::row(l, self.side())).collect();
        if rows.iter().map(Vec::len).sum::<usize>() > 2 * MAX_ROW_POINTS {
            return Err(Notice::new(Code::TooManyPoints).with("most", MAX_ROW_POINTS));
        }
        self.lists[0] = checked(rows, Item::Line)?;
        Ok(())
    }

    /// The constraint lines, in picture units.
    pub fn lines(&self) -> Vec<Vec<DVec2>> {
        self.polylines(Key::Lines)
    }

    /// The painted strokes, in picture units.
    pub fn strokes(&self) -> Vec<Vec<DVec2>> {
        self.polylines(Key::Strokes)
    }

    fn polylines(&self, key: Key) -> Vec<Vec<DVec2>> {
        let points = |row: &Vec<i64>| poly::points(row, self.side());
        self.rows(key).iter().map(points).collect()
    }

    /// Spots of the size: x, y and radius in picture units, and a factor.
    pub fn size_spots(&self) -> Vec<[f64; 4]> {
        self.spots(Key::Spots)
    }

    /// Spots of the aspect ratio: x, y and radius in picture units, and the ratio there.
    pub fn aspect_spots(&self) -> Vec<[f64; 4]> {
        self.spots(Key::Stretch)
    }

    fn spots(&self, key: Key) -> Vec<[f64; 4]> {
        let unit = self.side() / STEPS;
        let (min, max) = match place(key).map(|at| LISTS[at].1) {
            Some(Item::Spot(min, max)) => (min, max),
            _ => return Vec::new(),
        };
        let spot = |row: &Vec<i64>| {
            let number = |k: usize| row[k] as f64;
            let value = order::within(number(3) / VALUE, min, max);
            [number(0) * unit, number(1) * unit, number(2) * unit, value]
        };
        self.rows(key).iter().map(spot).collect()
    }

    /// Points, in picture units, and the kind's word for the part that holds each.
    pub fn part_kinds(&self) -> Vec<(DVec2, &'static str)> {
        let seed = |row: &Vec<i64>| {
            let point = poly::points(&row[..2], self.side())[0];
            let words = Key::Kind.parameter().choices;
            (point, words[row[2] as usize].word)
        };
        self.rows(Key::Parts).iter().map(seed).collect()
    }
}

/// What is said of limits.
fn between(code: Code, min: f64, max: f64) -> Notice {
    let limits = Notice::new(code).with("min", decimal::text(min));
    limits.with("max", decimal::text(max))
}

/// A list without repeated points in lines.
fn checked(mut rows: Rows, item: Item) -> Result<Rows, Notice> {
    if rows.len() > MAX_ROWS {
        return Err(Notice::new(Code::TooManyRows).with("most", MAX_ROWS));
    }
    for (index, row) in rows.iter_mut().enumerate() {
        if item == Item::Line {
            let mut kept = 2.min(row.len());
            for k in (2..row.len()).step_by(2) {
                if row[k..k + 2] != row[kept - 2..kept] {
                    row.copy_within(k..k + 2, kept);
                    kept += 2;
                }
            }
            row.truncate(kept);
        }
        if let Some(flaw) = item.flaw(row) {
            return Err(flaw.with("row", index + 1));
        }
    }
    Ok(rows)
}
