//! The schema of a generator's recipes: its rows, and rules beyond single rows.

use super::{Key, Parameter, Recipe, Rows};
use crate::notice::Notice;
use std::panic::RefUnwindSafe;

/// A generator's parameters.
pub struct Schema {
    /// The generator's name in a link, the value of `make`.
    pub word: &'static str,
    /// Whether links name the generator. Only pavements are not named.
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

/// A limit of the number of rows, larger than any generator needs.
const MOST_ROWS: usize = 256;

/// Lists of rows, which are joined in order.
pub(crate) struct Joined {
    rows: [Parameter; MOST_ROWS],
    pub count: usize,
}

impl Joined {
    /// Joins lists. A row replaces an earlier row with the same key, at the place of that row.
    pub const fn of(lists: &[&[Parameter]]) -> Self {
        let (mut rows, mut count) = ([lists[0][0]; MOST_ROWS], 0);
        let mut list = 0;
        while list < lists.len() {
            let mut at = 0;
            while at < lists[list].len() {
                let row = lists[list][at];
                let mut place = 0;
                while place < count && !rows[place].key.is(row.key) {
                    place += 1;
                }
                rows[place] = row;
                if place == count {
                    count += 1;
                }
                at += 1;
            }
            list += 1;
        }
        Self { rows, count }
    }

    /// The first `COUNT` rows as an array.
    pub const fn rows<const COUNT: usize>(&self) -> [Parameter; COUNT] {
        *self.rows.first_chunk().expect("fewer rows")
    }
}

/// Defines choices from `word: "Label"`. A word is a name or a whole number.
macro_rules! choices {
    ($($word:tt: $label:literal),* $(,)?) => {
        &[$($crate::recipe::Choice { word: stringify!($word), label: $label }),*]
    };
}

pub(crate) use choices;
