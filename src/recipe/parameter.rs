//! What a row of the schema tells of a parameter.

use super::Key;

/// What kind of value a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Any finite number between the limits.
    Number,
    /// A whole number between the limits.
    Int,
    /// One of [`Parameter::choices`].
    Choice,
    /// Compact text with a form of its own: the free polygon, or a list.
    Text,
}

impl Kind {
    /// The kind's name for the page.
    pub const fn word(self) -> &'static str {
        match self {
            Kind::Number => "number",
            Kind::Int => "int",
            Kind::Choice => "choice",
            Kind::Text => "text",
        }
    }
}

/// One of the words a choice can take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// As in the link.
    pub word: &'static str,
    /// As on the page.
    pub label: &'static str,
}

/// One row of the schema.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// The key in the link.
    pub key: &'static str,
    /// The papers' symbol, empty where they have none.
    pub symbol: &'static str,
    /// The name on the page.
    pub name: &'static str,
    /// The kind of value.
    pub kind: Kind,
    /// Smallest value (numbers). The limits of `cs` move with the picture: [`super::Recipe::limits`].
    pub min: f64,
    /// Largest value (numbers).
    pub max: f64,
    /// Step of the control; a link may hold values between the steps.
    pub step: f64,
    /// Default of a number; the default of a choice is its first word.
    pub default: f64,
    /// Default of a number while the stones are skin cells (`stone=skin`), where it is another:
    /// [`super::Recipe::default_of`].
    pub skin_default: Option<f64>,
    /// Unit, or empty.
    pub unit: &'static str,
    /// One sentence for the page.
    pub help: &'static str,
    /// The group of controls that it belongs to.
    pub group: &'static str,
    /// The words of a choice, the default first.
    pub choices: &'static [Choice],
    /// Only worth showing while the choice `.0` is one of the words `.1`, or, where there are no
    /// words, while the value of `.0` is not its default.
    pub shown_for: Option<(Key, &'static [&'static str])>,
}

impl Parameter {
    const fn new(key: &'static str, symbol: &'static str, name: &'static str, kind: Kind) -> Self {
        Self {
            key,
            symbol,
            name,
            kind,
            min: 0.0,
            max: 0.0,
            step: 0.0,
            default: 0.0,
            skin_default: None,
            unit: "",
            help: "",
            group: "",
            choices: &[],
            shown_for: None,
        }
    }

    pub(super) const fn range(mut self, min: f64, max: f64, step: f64, default: f64) -> Self {
        (self.min, self.max, self.step, self.default) = (min, max, step, default);
        self
    }

    /// Another default while the stones are skin cells.
    pub(super) const fn for_skin(mut self, default: f64) -> Self {
        self.skin_default = Some(default);
        self
    }

    pub(super) const fn unit(mut self, unit: &'static str) -> Self {
        self.unit = unit;
        self
    }

    pub(super) const fn group(mut self, group: &'static str) -> Self {
        self.group = group;
        self
    }

    pub(super) const fn only_for(mut self, key: Key, words: &'static [&'static str]) -> Self {
        self.shown_for = Some((key, words));
        self
    }

    /// Shown while another value is not its default.
    pub(super) const fn only_with(self, key: Key) -> Self {
        self.only_for(key, &[])
    }

    pub(super) const fn help(mut self, help: &'static str) -> Self {
        self.help = help;
        self
    }

    /// The place of a word among the choices.
    pub fn choice(&self, word: &str) -> Option<usize> {
        self.choices.iter().position(|c| c.word == word)
    }
}

pub(super) const fn number(
    key: &'static str,
    symbol: &'static str,
    name: &'static str,
) -> Parameter {
    Parameter::new(key, symbol, name, Kind::Number)
}

pub(super) const fn int(key: &'static str, symbol: &'static str, name: &'static str) -> Parameter {
    Parameter::new(key, symbol, name, Kind::Int)
}

pub(super) const fn choice(
    key: &'static str,
    name: &'static str,
    choices: &'static [Choice],
) -> Parameter {
    let mut row = Parameter::new(key, "", name, Kind::Choice);
    row.choices = choices;
    row
}

pub(super) const fn text(key: &'static str, name: &'static str) -> Parameter {
    Parameter::new(key, "", name, Kind::Text)
}
