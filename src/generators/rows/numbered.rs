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

/// Tests that a row has the name, the help, the range and the default of a number. The words of a choice must be all its
/// values, the default first.
#[cfg(test)]
pub(crate) fn check_row(row: &Parameter, number: &ShapeNumber) {
    let key = row.key.0;
    assert_eq!((row.name, row.help), (number.label, number.help), "{key}");
    if row.kind != Kind::Choice {
        let (range, default) = ((row.min, row.max), row.default);
        assert_eq!(range, (number.least, number.most), "{key}");
        assert_eq!(default, number.default, "{key}");
        return;
    }
    let values = row.choices.iter().map(|choice| choice.word.parse::<f64>());
    let mut values: Vec<f64> = values.map(|value| value.expect("a number")).collect();
    assert_eq!(values[0], number.default, "{key}");
    values.sort_by(f64::total_cmp);
    let all = (number.least as u32..=number.most as u32).map(f64::from);
    assert_eq!(values, all.collect::<Vec<_>>(), "{key}");
}
