//! The schema of a generator's recipes: its rows, and rules beyond single rows.

use super::{Key, Parameter, Recipe, Rows};
use crate::notice::Notice;
use std::panic::RefUnwindSafe;

/// A generator's parameters.
pub struct Schema {
    /// The generator's name in a link, the value of `make`.
    pub word: &'static str,
    /// Whether links name it. Pavements alone are not named.
    pub is_named: bool,
    /// Its parameters, in the order in which links are written.
    pub rows: &'static [Parameter],
    /// Rules beyond single rows.
    pub rules: &'static dyn Rules,
}

/// Rules beyond the single rows of a schema.
pub trait Rules: Sync + RefUnwindSafe {
    /// Maps a key and its value, as a link has them, to those of the schema. Links of former versions are
    /// migrated here.
    fn modern(&self, key: String, value: String) -> Vec<(String, String)> {
        vec![(key, value)]
    }

    /// Sets the drawn input for a word of a choice ([`Parameter::drawn_for`]), and chooses the word. Without
    /// rows, the present shape becomes the input. Gives notices about repairs.
    ///
    /// # Errors
    /// The reason for a refusal; the recipe is unchanged.
    fn draw(
        &self,
        recipe: &mut Recipe,
        key: Key,
        rows: Option<Rows>,
    ) -> Result<Vec<Notice>, Notice>;
}

impl Schema {
    /// The index of a key's row.
    pub(super) fn place(&self, key: Key) -> Option<usize> {
        self.rows.iter().position(|row| row.key == key)
    }

    /// The row for a link's word.
    pub fn row(&self, word: &str) -> Option<&'static Parameter> {
        self.rows.iter().find(|row| row.key.0 == word)
    }
}

/// Defines a constant for each row's key, in a module `keys`, and `ROWS`, the list of all rows. A row of its
/// own is `word CONSTANT: "Help." => row;`, a shared one `word CONSTANT => row;`, or with a help text of its
/// own like the others.
macro_rules! rows {
    ($($word:ident $name:ident $(: $help:literal)? => $row:expr;)*) => {
        /// The keys of the rows.
        pub mod keys {
            use crate::recipe::Key;
            $(#[doc = concat!("`", stringify!($word), "`", $(". ", $help)?)]
            pub const $name: Key = Key(stringify!($word));)*
        }

        /// The rows, in the order in which links are written.
        pub const ROWS: &[$crate::recipe::Parameter] =
            &[$($row$(.named(keys::$name, $help))?),*];
    };
}

/// Defines choices from `word: "Label"`.
macro_rules! choices {
    ($($word:ident: $label:literal),* $(,)?) => {
        &[$($crate::recipe::Choice { word: stringify!($word), label: $label }),*]
    };
}

pub(crate) use {choices, rows};
