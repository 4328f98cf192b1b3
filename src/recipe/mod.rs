//! All parameters of a picture in one checked value, and its link.
//!
//! All outside input passes here: a [`Recipe`] only ever holds values that fit its generator's [`Schema`].
//! Notices report everything that did not fit. The codec knows no generator: it receives the schemas.

mod link;
mod lists;
mod named_file;
pub mod parameter;
mod rows;
pub mod schema;
mod value;

pub use link::{VERSION, VIEW};
pub use lists::{MAX_NAME, MAX_ROW_POINTS, MAX_ROWS, points, row};
pub use named_file::NamedFile;
pub use parameter::{Choice, Item, Key, Kind, Parameter, SideLimits};
pub use rows::{BOX_STEPS, Rows, STEPS};
pub use schema::{Rules, Schema};

/// The key of the picture's side in pixels, a row of every schema.
const SIZE: Key = Key("size");

/// A value for every parameter of a schema.
#[derive(Clone)]
pub struct Recipe {
    schema: &'static Schema,
    /// In the order of the schema's rows.
    values: Vec<Value>,
}

/// A number or the index of a word among the choices; for a text, rows of whole numbers.
#[derive(Clone, PartialEq)]
struct Value {
    number: f64,
    rows: Rows,
}

impl PartialEq for Recipe {
    fn eq(&self, other: &Self) -> bool {
        self.is_of(other.schema) && self.values == other.values
    }
}

/// Written as its link.
impl std::fmt::Debug for Recipe {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.link())
    }
}

impl Recipe {
    /// The defaults of a schema.
    pub fn new(schema: &'static Schema) -> Self {
        let value = |row: &Parameter| Value {
            number: row.default,
            rows: Rows::new(),
        };
        Self {
            schema,
            values: schema.rows.iter().map(value).collect(),
        }
    }

    /// The schema of its parameters.
    pub fn schema(&self) -> &'static Schema {
        self.schema
    }

    /// Whether it has this schema.
    pub fn is_of(&self, schema: &Schema) -> bool {
        self.schema.word == schema.word
    }

    fn value(&self, key: Key) -> Option<&Value> {
        self.values.get(self.schema.place(key)?)
    }

    /// The value of a number or whole number; for a choice, the index of its word. The schema must have such
    /// a row, which debug builds check.
    #[inline(never)]
    pub fn number(&self, key: Key) -> f64 {
        let value = self.value(key);
        debug_assert!(value.is_some(), "no row {}", key.0);
        value.map_or(0.0, |value| value.number)
    }

    /// The word of a choice; empty for other kinds. The schema must have such a row, which debug builds
    /// check.
    #[inline(never)]
    pub fn choice(&self, key: Key) -> &'static str {
        let row = self.schema.row(key.0);
        debug_assert!(row.is_some(), "no row {}", key.0);
        let choice = row.and_then(|row| row.choices.get(self.number(key) as usize));
        choice.map_or("", |choice| choice.word)
    }

    /// The rows of a text; empty for the keys of other values.
    #[inline(never)]
    pub fn rows(&self, key: Key) -> &[Vec<i64>] {
        self.value(key).map_or(&[], |value| &value.rows)
    }

    /// The picture's side in pixels, which are the picture units.
    pub fn side(&self) -> f64 {
        self.number(SIZE)
    }

    /// The limits of a number in this recipe: those of its row, or those that depend on the picture's side.
    pub fn limits(&self, row: &Parameter) -> (f64, f64) {
        row.side_limits.map_or((row.min, row.max), |limits| {
            let least = (self.side() / limits.finest).floor().max(limits.least);
            (least, self.side() / limits.coarsest)
        })
    }

    /// The default of a number in this recipe; for a choice 0, its first word.
    pub fn default_of(&self, row: &Parameter) -> f64 {
        match row.default_while {
            Some((key, word, own)) if self.choice(key) == word => own,
            _ => row.default,
        }
    }
}
