//! A row of a schema: one parameter.

/// The name of a parameter: its word in the link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key(pub &'static str);

impl Key {
    /// Whether two keys are equal, for constants.
    pub(super) const fn is(self, other: Key) -> bool {
        let (one, two) = (self.0.as_bytes(), other.0.as_bytes());
        let mut same = 0;
        while same < one.len() && same < two.len() && one[same] == two[same] {
            same += 1;
        }
        same == one.len() && same == two.len()
    }
}

/// The kind of value of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Any finite number between the limits.
    Number,
    /// A whole number between the limits.
    Int,
    /// One of [`Parameter::choices`].
    Choice,
    /// Rows of numbers as compact text; [`Parameter::item`] describes a row.
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

/// The content of a row of numbers. Places in the plane are x and y in 1/32768 of the picture's side, y down.
/// Places on a surface are x, y and z in 1/4096 of the longest side of the box around its model, from the
/// box's least corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Item {
    /// A closed ring of points; holds the most points in all rings.
    Ring(usize),
    /// A polyline.
    Line,
    /// A place, a radius, and a value between two limits.
    Spot(f64, f64),
    /// A place, and the index of a word among the words of a choice.
    Seed(Key),
    /// A cell at the start of a packing: a place, and 1 if it is held there, else 0.
    Bubble,
    /// A line on a surface: places on it.
    Trace,
    /// A place on a surface, a radius, and a value between two limits.
    Patch(f64, f64),
    /// A file: its digest in four numbers of 16 bits, the highest first, and the characters of its name.
    File,
    /// A feature of a building: 0 for a corner or 1 for an edge, and its number.
    Feature,
    /// The corners of a building's plan, x and y in modules, y to the front.
    Plan,
    /// An opening of a plan's wall: the wall's number from 1, the distance along it, sill, width, height, and head.
    Opening,
}

impl Item {
    /// The content's name for the page.
    pub const fn word(self) -> &'static str {
        match self {
            Item::Ring(_) => "ring",
            Item::Line => "line",
            Item::Spot(..) => "spot",
            Item::Seed(_) => "seed",
            Item::Bubble => "bubble",
            Item::Trace => "trace",
            Item::Patch(..) => "patch",
            Item::File => "file",
            Item::Feature => "feature",
            Item::Plan => "plan",
            Item::Opening => "opening",
        }
    }
}

/// One of the words of a choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The word in the link.
    pub word: &'static str,
    /// The label on the page.
    pub label: &'static str,
}

/// Limits of a length in pixels that depend on the picture's side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideLimits {
    /// The least length is the side divided by this, rounded down to whole pixels, but see `least`.
    pub finest: f64,
    /// The least length is never below this many pixels.
    pub least: f64,
    /// The greatest length is the side divided by this.
    pub coarsest: f64,
}

/// One row of a schema.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// The key in the link.
    pub key: Key,
    /// The papers' symbol, empty where they have none.
    pub symbol: &'static str,
    /// The name on the page.
    pub name: &'static str,
    /// The kind of value.
    pub kind: Kind,
    /// Smallest value (numbers).
    pub min: f64,
    /// Largest value (numbers).
    pub max: f64,
    /// Limits that replace `min` and `max` in pictures whose side is not the default: [`super::Recipe::limits`].
    pub side_limits: Option<SideLimits>,
    /// Step of the control; a link may hold values between the steps.
    pub step: f64,
    /// Default of a number; the default of a choice is its first word.
    pub default: f64,
    /// Another default of a number while a choice has this word: [`super::Recipe::default_of`]. Links omit
    /// the default in force, so the choice is read first.
    pub default_while: Option<(Key, &'static str, f64)>,
    /// Unit, or empty.
    pub unit: &'static str,
    /// One sentence for the page.
    pub help: &'static str,
    /// The group of its control.
    pub group: &'static str,
    /// Whether the parameter is one of the few most important ones, which are shown first.
    pub is_main: bool,
    /// Whether *Randomise* leaves the parameter unchanged.
    pub is_steady: bool,
    /// The words of a choice, the default first.
    pub choices: &'static [Choice],
    /// The content of the text's rows.
    pub item: Option<Item>,
    /// The word of a choice that this text belongs to: setting the text chooses the word, and links hold the
    /// text only with the word.
    pub drawn_for: Option<(Key, &'static str)>,
    /// Shown only while the choice `.0` is one of the words `.1`, or, if there are no words, while the value
    /// of `.0` is not its default.
    pub shown_for: Option<(Key, &'static [&'static str])>,
}

impl Parameter {
    const fn new(symbol: &'static str, name: &'static str, kind: Kind) -> Self {
        Self {
            key: Key(""),
            symbol,
            name,
            kind,
            min: 0.0,
            max: 0.0,
            side_limits: None,
            step: 0.0,
            default: 0.0,
            default_while: None,
            unit: "",
            help: "",
            group: "",
            is_main: false,
            is_steady: false,
            choices: &[],
            item: None,
            drawn_for: None,
            shown_for: None,
        }
    }

    /// With this key.
    pub const fn keyed(mut self, key: Key) -> Self {
        self.key = key;
        self
    }

    /// With this help text.
    pub const fn helped(mut self, help: &'static str) -> Self {
        self.help = help;
        self
    }

    /// As a choice instead of a number, the default first.
    pub const fn as_choice(mut self, choices: &'static [Choice]) -> Self {
        (self.kind, self.choices) = (Kind::Choice, choices);
        self.range(0.0, 0.0, 0.0, 0.0)
    }

    /// Limits, the control's step, and the default of a number.
    pub const fn range(mut self, min: f64, max: f64, step: f64, default: f64) -> Self {
        (self.min, self.max, self.step, self.default) = (min, max, step, default);
        self
    }

    /// With limits that depend on the picture's side.
    pub const fn per_side(mut self, limits: SideLimits) -> Self {
        self.side_limits = Some(limits);
        self
    }

    /// With another default while a choice has this word.
    pub const fn default_while(mut self, key: Key, word: &'static str, default: f64) -> Self {
        self.default_while = Some((key, word, default));
        self
    }

    /// With this unit.
    pub const fn unit(mut self, unit: &'static str) -> Self {
        self.unit = unit;
        self
    }

    /// With another name.
    pub const fn called(mut self, name: &'static str) -> Self {
        self.name = name;
        self
    }

    /// In this group of controls.
    pub const fn group(mut self, group: &'static str) -> Self {
        self.group = group;
        self
    }

    /// Marked as one of the most important ones.
    pub const fn main(mut self) -> Self {
        self.is_main = true;
        self
    }

    /// Not changed by *Randomise*.
    pub const fn steady(mut self) -> Self {
        self.is_steady = true;
        self
    }

    /// Belongs to this word of a choice.
    pub const fn drawn_for(mut self, key: Key, word: &'static str) -> Self {
        self.drawn_for = Some((key, word));
        self
    }

    /// Shown while a choice has one of these words.
    pub const fn only_for(mut self, key: Key, words: &'static [&'static str]) -> Self {
        self.shown_for = Some((key, words));
        self
    }

    /// Shown while another value is not its default.
    pub const fn only_with(self, key: Key) -> Self {
        self.only_for(key, &[])
    }

    /// The index of a word among the choices.
    pub fn choice(&self, word: &str) -> Option<usize> {
        self.choices.iter().position(|c| c.word == word)
    }
}

/// A number, with the papers' symbol or an empty one.
pub const fn number(symbol: &'static str, name: &'static str) -> Parameter {
    Parameter::new(symbol, name, Kind::Number)
}

/// A whole number.
pub const fn int(symbol: &'static str, name: &'static str) -> Parameter {
    Parameter::new(symbol, name, Kind::Int)
}

/// A choice of these words, the default first.
pub const fn choice(name: &'static str, choices: &'static [Choice]) -> Parameter {
    let mut row = Parameter::new("", name, Kind::Choice);
    row.choices = choices;
    row
}

/// Rows of numbers.
pub const fn text(name: &'static str, item: Item) -> Parameter {
    let mut row = Parameter::new("", name, Kind::Text);
    row.item = Some(item);
    row
}
