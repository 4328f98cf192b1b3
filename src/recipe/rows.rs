//! Lists of rows of numbers as compact text: the free polygon, lines, strokes, spots, seeds.
//!
//! Points lie on a grid of 1/32768 of the picture's side, so all of them scale with the picture without
//! rounding. A row is a sequence of numbers. Coordinates (x and y in turn) are differences from the point
//! before; the first point is relative to the last one of the row before, or to the origin. Each number is
//! mapped from 0, -1, 1, -2, 2 ... to 0, 1, 2, 3, 4 ... and written in groups of five bits, lowest first,
//! with 32 added to all but the last group, as characters of the base64url alphabet. A dot separates rows.
//!
//! Rows may also be given in decimal numbers, with commas between them and semicolons between rows.

use crate::decimal;
use crate::notice::{Code, Notice, quote};

/// Grid steps along the picture's side; a power of two, so that the scaling is exact.
pub const STEPS: f64 = 32768.0;

/// Grid steps along the longest side of the box around a model.
pub const BOX_STEPS: f64 = 4096.0;

/// The rows of a text.
pub type Rows = Vec<Vec<i64>>;

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Larger numbers are refused: they are far outside any picture, and sums of smaller ones stay exact.
const MOST: i64 = 1 << 29;

/// The format of the numbers in a row.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    /// The number of coordinates at the row's beginning.
    pub coordinates: usize,
    /// The number of coordinates of a place, 2 or 3.
    pub dimension: usize,
    /// Grid steps for each unit of a coordinate.
    pub steps: f64,
    /// Factors from decimal numbers to whole ones, for each number after the coordinates. Further numbers have `steps`.
    pub units: &'static [f64],
}

impl Form {
    /// The factor from decimal numbers to whole ones at an index of a row.
    pub fn unit(&self, place: usize) -> f64 {
        let extra = place.checked_sub(self.coordinates);
        *extra.and_then(|k| self.units.get(k)).unwrap_or(&self.steps)
    }
}

/// Rows of points only.
pub const POINTS: Form = Form {
    coordinates: usize::MAX,
    dimension: 2,
    steps: STEPS,
    units: &[],
};

/// The text of rows.
pub fn encode(rows: &[Vec<i64>], form: Form) -> String {
    let mut text = String::new();
    let mut last = [0; 3];
    for (index, row) in rows.iter().enumerate() {
        if index > 0 {
            text.push('.');
        }
        for (k, &number) in row.iter().enumerate() {
            let before = if k < form.coordinates {
                last[k % form.dimension]
            } else {
                0
            };
            push(&mut text, number - before);
            if k < form.coordinates {
                last[k % form.dimension] = number;
            }
        }
    }
    text
}

fn push(text: &mut String, value: i64) {
    let mut rest = ((value << 1) ^ (value >> 63)) as u64;
    loop {
        let group = (rest & 31) as usize;
        rest >>= 5;
        let more = rest > 0;
        text.push(ALPHABET[group + if more { 32 } else { 0 }] as char);
        if !more {
            return;
        }
    }
}

/// Reads the output of [`encode`], or decimal numbers.
///
/// # Errors
/// A part of a sentence that explains why the text cannot be read.
pub fn decode(text: &str, form: Form, most_points: usize) -> Result<Vec<Vec<i64>>, Notice> {
    let readable = text.contains(',');
    let mut rows = Vec::new();
    let mut last = [0; 3];
    let mut points = 0;
    for part in text.split(if readable { ';' } else { '.' }) {
        let mut row = if readable {
            decimals(part, form)?
        } else {
            numbers(part)?
        };
        points += row.len().min(form.coordinates) / form.dimension;
        if points > most_points {
            return Err(Notice::new(Code::TooManyPoints).with("most", most_points));
        }
        if row.len().min(form.coordinates) % form.dimension != 0 {
            return Err(lost(form).into());
        }
        for (k, number) in row.iter_mut().enumerate().take(form.coordinates) {
            if !readable {
                *number += last[k % form.dimension];
            }
            last[k % form.dimension] = *number;
        }
        rows.push(row);
    }
    Ok(rows)
}

/// The notice for a place with missing coordinates.
fn lost(form: Form) -> Code {
    match form.dimension {
        2 => Code::LostY,
        _ => Code::LostZ,
    }
}

/// The whole numbers of a row's text.
fn numbers(text: &str) -> Result<Vec<i64>, Notice> {
    let mut numbers = Vec::new();
    let (mut value, mut shift) = (0u64, 0);
    for c in text.chars() {
        let Some(code) = ALPHABET.iter().position(|&a| a as char == c) else {
            let given = quote(c.encode_utf8(&mut [0; 4]));
            return Err(Notice::new(Code::BadCharacter).with("given", given));
        };
        if shift > 25 {
            return Err(Code::TooLarge.into());
        }
        value |= (code as u64 & 31) << shift;
        shift += 5;
        if code < 32 {
            numbers.push((value >> 1) as i64 ^ -((value & 1) as i64));
            (value, shift) = (0, 0);
        }
    }
    if shift > 0 {
        return Err(Code::EndMissing.into());
    }
    Ok(numbers)
}

/// The whole numbers of a row given in decimal numbers.
fn decimals(text: &str, form: Form) -> Result<Vec<i64>, Notice> {
    let mut row = Vec::new();
    for word in text.split(',') {
        let unit = form.unit(row.len());
        match decimal::parse(word.trim()).map(|v| (v * unit).round()) {
            Some(v) if v.abs() < MOST as f64 => row.push(v as i64),
            Some(_) => return Err(Code::TooLarge.into()),
            None => return Err(Code::NotANumber.into()),
        }
    }
    Ok(row)
}
