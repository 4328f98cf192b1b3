//! Rules beyond single rows: naming a file selects the word `file` of its choice.

use super::schema::{TYPE_KEYS, keys};
use crate::generators::given::name_file;
use crate::notice::Notice;
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
        let of_type = TYPE_KEYS.iter().find(|own| own.file == key);
        let choice = of_type.map_or(keys::FORM, |own| own.component);
        name_file(recipe, key, rows, choice)
    }
}
