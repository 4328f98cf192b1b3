//! Rules beyond single rows: naming a file selects the word `file` of the choice of a building.

use super::schema::keys;
use crate::generators::given::name_file;
use crate::notice::Notice;
use crate::recipe::{Key, Recipe, Rows, Rules};

/// The rules of masonry.
pub(super) struct MasonryRules;

impl Rules for MasonryRules {
    fn draw(
        &self,
        recipe: &mut Recipe,
        key: Key,
        rows: Option<Rows>,
    ) -> Result<Vec<Notice>, Notice> {
        name_file(recipe, key, rows, keys::BUILDING)
    }
}
