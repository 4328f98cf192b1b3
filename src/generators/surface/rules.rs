//! Rules beyond single rows: naming a file selects the form `file`.

use super::schema::{FILE, keys};
use crate::notice::{Code, Notice};
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
        let rows = rows
            .filter(|rows| rows.len() == 1)
            .ok_or(Code::ModelFirst)?;
        recipe.set_rows(key, rows)?;
        recipe.choose(keys::FORM, FILE);
        Ok(Vec::new())
    }
}
