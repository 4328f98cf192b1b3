//! Rows of the numbers by which shapes and buildings are made.

use crate::recipe::parameter::{Parameter, int, number};
use crate::recipe::{Key, Kind, Recipe};
use crate::shapes::ShapeNumber;

/// The row of a number, with its range and its default, in a group.
pub(super) const fn rule_row(of: &ShapeNumber, group: &'static str) -> Parameter {
    let row = match of.is_count() {
        true => int("", of.label),
        false => number("", of.label),
    };
    row.range(of.least, of.most, of.step, of.default)
        .helped(of.help)
        .unit(of.unit)
        .group(group)
}

/// The values of the rows that are shown for one word of a choice only, in the order of the table. Words of choices
/// among them are numbers.
pub(crate) fn numbers_of(recipe: &Recipe, choice: Key, word: &str) -> Vec<f64> {
    let is_own = |row: &&Parameter| {
        let of = row.shown_for.filter(|of| of.0 == choice);
        row.kind != Kind::Text && of.is_some_and(|(_, words)| words == [word])
    };
    let number = |row: &Parameter| match row.kind {
        Kind::Choice => recipe.choice(row.key).parse().unwrap_or(row.default),
        _ => recipe.number(row.key),
    };
    let rows = recipe.schema().rows.iter().filter(is_own);
    rows.map(number).collect()
}
