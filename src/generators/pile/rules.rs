//! Rules beyond single rows: naming a file selects the word `file` of its choice.

use super::schema::{FILE, TYPE_KEYS, keys};
use crate::notice::{Code, Notice};
use crate::recipe::{Key, Recipe, Rows, Rules};

/// The rules of a pile.
pub(super) struct PileRules;

impl Rules for PileRules {
    fn draw(
        &self,
        recipe: &mut Recipe,
        key: Key,
        rows: Option<Rows>,
    ) -> Result<Vec<Notice>, Notice> {
        let rows = rows
            .filter(|rows| rows.len() == 1)
            .ok_or(Code::ModelFirst)?;
        recipe.set_rows(key, rows)?;
        let of_type = TYPE_KEYS.iter().find(|own| own.file == key);
        recipe.choose(of_type.map_or(keys::FORM, |own| own.component), FILE);
        Ok(Vec::new())
    }
}
