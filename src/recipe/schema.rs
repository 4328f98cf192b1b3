//! All that a generator's recipes hold: its rows, and rules that go beyond them.

use super::{Key, Parameter, Recipe, Rows};
use crate::notice::{Code, Notice, quote};
use std::panic::RefUnwindSafe;

/// A generator's parameters.
pub struct Schema {
    /// The generator's name in a link, the value of `make`.
    pub word: &'static str,
    /// Do links name it? One of all generators, pavements, goes without a name.
    pub is_named: bool,
    /// Its parameters, in the order in which links are written.
    pub rows: &'static [Parameter],
    /// What goes beyond single rows.
    pub rules: &'static dyn Rules,
}

/// What goes beyond the single rows of a schema.
pub trait Rules: Sync + RefUnwindSafe {
    /// Turns a key and its value, as a link has them, into those of the schema. Links of former versions
    /// are brought up to date here.
    fn modern(&self, key: String, value: String) -> Vec<(String, String)> {
        vec![(key, value)]
    }

    /// Takes what was drawn for a word of a choice ([`Parameter::drawn_for`]), and chooses the word;
    /// without rows, what is there before is to be drawn anew. Answers with what was mended.
    ///
    /// # Errors
    /// Why it cannot be taken; the recipe stays as it was.
    fn draw(
        &self,
        recipe: &mut Recipe,
        key: Key,
        rows: Option<Rows>,
    ) -> Result<Vec<Notice>, Notice>;
}

/// The rules of a schema whose rows say all: nothing is drawn.
pub struct NoRules;

impl Rules for NoRules {
    fn draw(&self, _: &mut Recipe, key: Key, _: Option<Rows>) -> Result<Vec<Notice>, Notice> {
        Err(Notice::new(Code::NotAParameter).with("given", quote(key.0)))
    }
}

impl Schema {
    /// The place of a key's row.
    pub(super) fn place(&self, key: Key) -> Option<usize> {
        self.rows.iter().position(|row| row.key == key)
    }

    /// The row of a link's word.
    pub fn row(&self, word: &str) -> Option<&'static Parameter> {
        self.rows.iter().find(|row| row.key.0 == word)
    }
}

/// Makes a constant of each row's key, in a module `keys`, and `ROWS`, the list of all rows. A row of
/// its own is `word CONSTANT: "Help." => row;`, a common one `word CONSTANT => row;`, or with a sentence of
/// its own as the others.
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

/// Choices of `word: "Label"`.
macro_rules! choices {
    ($($word:ident: $label:literal),* $(,)?) => {
        &[$($crate::recipe::Choice { word: stringify!($word), label: $label }),*]
    };
}

pub(crate) use {choices, rows};
