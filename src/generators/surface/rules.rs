//! Rules beyond single rows: naming a file selects the form `file`.

use super::schema::keys;
use crate::generators::given::name_file;
use crate::notice::Notice;
use crate::recipe::{Key, Recipe, Rows, Rules};

/// The rules of a surface.
pub(super) struct SurfaceRules;

impl Rules for SurfaceRules {
    fn draw(
        &self,
        recipe: &mut Recipe,
        key: Key,
        rows: Option<Rows>,
    ) -> Result<Vec<Notice>, Notice> {
        name_file(recipe, key, rows, keys::FORM)
    }
}
