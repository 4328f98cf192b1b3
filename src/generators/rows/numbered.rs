//! Rows of the numbers by which shapes and buildings are made.

use crate::recipe::parameter::{Parameter, int, number};
use crate::shapes::ShapeNumber;

/// The row of a number, with its range and its default, in a group.
pub(super) const fn rule_row(of: &ShapeNumber, group: &'static str) -> Parameter {
    let row = match of.is_count() {
        true => int("", of.label),
        false => number("", of.label),
    };
    row.range(of.least, of.most, of.step, of.default)
        .unit(of.unit)
        .group(group)
}
