//! The units of OBJ files, which do not tell their unit.

use super::sentences::sized;
use super::{SCHEMA, keys};
use crate::building::obj::FileSpace;
use crate::notice::{Code, Notice};

/// The words of units in links, each with a unit in metres as a numerator and a denominator.
const UNITS: [(&str, [f64; 2]); 5] = [
    ("m", [1.0, 1.0]),
    ("cm", [1.0, 100.0]),
    ("mm", [1.0, 1000.0]),
    ("ft", [381.0, 1250.0]),
    ("in", [127.0, 5000.0]),
];

/// Units that a file may be in without saying so, the likeliest first.
const LIKELY: [&str; 3] = ["mm", "cm", "m"];

/// The longest side of a building, from a garden wall to a row of houses (metres).
const USUAL: [f64; 2] = [1.5, 100.0];

/// A unit in metres, as a numerator and a denominator, by its word.
pub(super) fn unit_of_word(word: &str) -> [f64; 2] {
    let found = UNITS.iter().find(|(known, _)| *known == word);
    found.map_or(FileSpace::METRES.unit, |&(_, unit)| unit)
}

/// The sentence about another unit in which a building would have a usual size; `None` if there is no such unit. The size
/// is in metres, as read with the unit of `space`.
pub(super) fn other_unit(size: [f64; 3], space: &FileSpace) -> Option<Notice> {
    let metres = |[over, under]: [f64; 2]| over / under;
    let longest = size.into_iter().fold(0.0, f64::max) / metres(space.unit);
    let is_usual = |word: &&&str| {
        let unit = unit_of_word(word);
        let length = longest * metres(unit);
        unit != space.unit && (USUAL[0]..=USUAL[1]).contains(&length)
    };
    let word = LIKELY.iter().find(is_usual)?;
    let unit = SCHEMA.row(keys::UNIT.0)?.word(word);
    Some(sized(Code::MasonryUnits, size).with("unit", unit))
}
