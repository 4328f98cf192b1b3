//! Values as text: reading one parameter with a sentence where it does not fit, and writing it.

use super::{Key, Kind, POLYGON, Parameter, Recipe, poly};
use crate::decimal;
use crate::domain::Outline;
use crate::order;

/// What became of a text that was meant as a value; see [`Recipe::set`].
type Taken = Result<Option<String>, String>;

/// Characters of a foreign text that a sentence repeats.
const QUOTED: usize = 24;

impl Recipe {
    /// Sets one parameter from text: `Ok(None)` where it was taken as it is, `Ok(Some(sentence))`
    /// where it was clamped to the limits or mended. Choosing `outline=polygon` without a polygon
    /// makes one of the outline that was chosen before.
    ///
    /// # Errors
    /// The text does not fit and the old value stays. Every sentence says what was given, what is
    /// allowed and what was kept.
    pub fn set(&mut self, key: &str, text: &str) -> Result<Option<String>, String> {
        let Some(key) = Key::from_word(key) else {
            return Err(format!(
                "{} is not a parameter; it was dropped.",
                quote(key)
            ));
        };
        let text = text.trim();
        let list = key.parameter().kind == Kind::Text && key != Key::Poly;
        if text.is_empty() && !list {
            let (what, kept) = (name(key.parameter()), self.shown(key));
            return Err(format!("{what} has no value; kept {kept}."));
        }
        match key.parameter().kind {
            Kind::Number | Kind::Int => self.set_number(key, text),
            Kind::Choice => self.set_choice(key, text),
            Kind::Text if list => self.set_list(key, text),
            Kind::Text => self.set_poly(text),
        }
    }

    /// The value as the link writes it; empty for an unknown key, an empty list, or where there is no
    /// polygon.
    pub fn get(&self, key: &str) -> String {
        Key::from_word(key).map_or(String::new(), |key| self.text(key))
    }

    /// Takes the outline as the free polygon and chooses it, and its constraint lines where it has
    /// any. Its points are moved to the nearest
    /// ones that a link can hold (1/32768 of the picture's side).
    ///
    /// # Errors
    /// The sentence of [`Outline::check`]; the recipe stays as it was. `Ok` holds what was mended.
    pub fn set_polygon(&mut self, outline: &Outline) -> Result<Vec<String>, String> {
        let side = self.side();
        let check = |outline: &Outline| outline.check(side).map_err(|error| error.to_string());
        // Before the points are moved, too: a sentence should tell the places that were given.
        let (given, mut notices) = check(outline)?;
        let (mut checked, more) = check(&poly::snap(&given, side))?;
        notices.extend(more);
        let lines = std::mem::take(&mut checked.lines);
        if !lines.is_empty() {
            self.take_lines(&lines)
                .map_err(|why| format!("The lines cannot be taken: {why}."))?;
        }
        self.polygon = Some(checked);
        self.choose(Key::Outline, POLYGON);
        Ok(notices)
    }

    /// The value of a key as the link writes it.
    pub(super) fn text(&self, key: Key) -> String {
        match key.parameter().kind {
            Kind::Number | Kind::Int => decimal::text(self.number(key)),
            Kind::Choice => self.choice(key).to_owned(),
            Kind::Text if key != Key::Poly => self.list_text(key),
            Kind::Text => self
                .polygon
                .as_ref()
                .map_or(String::new(), |p| poly::encode(p, self.side())),
        }
    }

    /// The value of a key for a sentence.
    pub(super) fn shown(&self, key: Key) -> String {
        match key.parameter().kind {
            Kind::Text => format!("the outline {}", self.shown(Key::Outline)),
            Kind::Choice => choice_name(key.parameter(), self.choice(key)),
            _ => self.text(key),
        }
    }

    fn put(&mut self, key: Key, value: f64) {
        // Adding 0 makes of -0 a 0, so that the link tells all that the bits do.
        self.values[key as usize] = value + 0.0;
    }

    fn choose(&mut self, key: Key, word: &str) {
        let place = key.parameter().choice(word);
        self.put(key, place.expect("a word of the schema") as f64);
    }

    fn set_number(&mut self, key: Key, text: &str) -> Taken {
        let row = key.parameter();
        let Some(given) = decimal::parse(text).filter(|v| v.is_finite()) else {
            let (allowed, kept) = (self.allowed(key), self.shown(key));
            let (what, given) = (name(row), quote(text));
            return Err(format!(
                "{what} must be {allowed}; {given} was given, kept {kept}."
            ));
        };
        let (min, max) = self.limits(key);
        let whole = if row.kind == Kind::Int {
            given.round()
        } else {
            given
        };
        let value = order::within(whole, min, max);
        let allowed = self.allowed(key);
        let old_side = self.side();
        self.put(key, value);
        let mut notice = (value != given).then(|| {
            let (what, given, kept) = (name(row), quote(text), decimal::text(value));
            format!("{what} must be {allowed}; {given} was given, kept {kept}.")
        });
        if key == Key::Size {
            self.resize(old_side);
            if let Some(sentence) = self.settle() {
                notice = Some(notice.map_or(sentence.clone(), |n| format!("{n} {sentence}")));
            }
        }
        Ok(notice)
    }

    /// What a number may be, in words.
    fn allowed(&self, key: Key) -> String {
        let (min, max) = self.limits(key);
        let whole = match key.parameter().kind {
            Kind::Int => "whole ",
            _ => "",
        };
        let unit = match key.parameter().unit {
            "" => String::new(),
            "°" => "°".to_owned(),
            unit => format!(" {unit}"),
        };
        let mut words = format!(
            "a {whole}number from {} to {}{unit}",
            decimal::text(min),
            decimal::text(max)
        );
        if key == Key::Cs {
            words += &format!(" in a picture of {} px", decimal::text(self.side()));
        }
        words
    }

    /// The free polygon grows with the picture, as the built-in outlines do. Its points lie on a grid
    /// of the picture's side / 32768, so nothing is rounded, there and back again.
    fn resize(&mut self, old_side: f64) {
        let side = self.side();
        if let Some(polygon) = &mut self.polygon {
            *polygon = poly::resize(polygon, old_side, side);
        }
    }

    /// Brings what depends on the picture's side back into its limits.
    pub(super) fn settle(&mut self) -> Option<String> {
        let (given, (min, max)) = (self.number(Key::Cs), self.limits(Key::Cs));
        let value = order::within(given, min, max);
        (value != given).then(|| {
            let (allowed, what) = (self.allowed(Key::Cs), name(Key::Cs.parameter()));
            self.put(Key::Cs, value);
            let (given, kept) = (decimal::text(given), decimal::text(value));
            format!("{what} must be {allowed}; {given} was given, kept {kept}.")
        })
    }

    fn set_choice(&mut self, key: Key, text: &str) -> Taken {
        let row = key.parameter();
        let word = text.to_ascii_lowercase();
        let Some(place) = row.choice(&word) else {
            let (what, given, kept) = (name(row), quote(text), self.shown(key));
            return Err(format!(
                "{what} must be {}; {given} was given, kept {kept}.",
                one_of(row)
            ));
        };
        if key == Key::Outline && word == POLYGON && self.polygon.is_none() {
            // The shape on the screen becomes the polygon to start from.
            return match self.set_polygon(&self.outline()) {
                Ok(notices) => Ok(notices.into_iter().next()),
                Err(sentence) => Err(sentence),
            };
        }
        if key == Key::Stone {
            self.set_stone(place as f64);
        } else {
            self.put(key, place as f64);
        }
        Ok(None)
    }

    /// Numbers that were at their default stay at it.
    fn set_stone(&mut self, place: f64) {
        let untouched: Vec<Key> = Key::ALL
            .iter()
            .copied()
            .filter(|&key| {
                let own = key.parameter().skin_default.is_some();
                own && self.number(key) == self.default_of(key)
            })
            .collect();
        self.put(Key::Stone, place);
        for key in untouched {
            self.put(key, self.default_of(key));
        }
    }

    fn set_list(&mut self, key: Key, text: &str) -> Taken {
        self.take_list(key, text).map(|()| None).map_err(|why| {
            let what = name(key.parameter());
            format!("{what} cannot be read: {why}; kept what was there.")
        })
    }

    fn set_poly(&mut self, text: &str) -> Taken {
        let kept = self.shown(Key::Poly);
        let what = name(Key::Poly.parameter());
        let outline = poly::decode(text, self.side())
            .map_err(|why| format!("{what} cannot be read: {why}; kept {kept}."))?;
        match self.set_polygon(&outline) {
            Ok(notices) if notices.is_empty() => Ok(None),
            Ok(notices) => Ok(Some(notices.join(" "))),
            Err(sentence) => Err(format!("{sentence} Kept {kept}.")),
        }
    }
}

/// A parameter as sentences name it.
pub(super) fn name(row: &Parameter) -> String {
    format!("{} ({})", row.name, row.key)
}

/// Foreign text made fit for a sentence: short and without control characters.
pub(super) fn quote(text: &str) -> String {
    let mut short: String = text
        .chars()
        .take(QUOTED)
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    if text.chars().nth(QUOTED).is_some() {
        short.push('…');
    }
    format!("\"{short}\"")
}

/// A choice as sentences name it: as the page does, with the link's word where that is another one.
pub(super) fn choice_name(row: &Parameter, word: &str) -> String {
    let choice = row.choices.iter().find(|c| c.word == word);
    choice.map_or_else(
        || quote(word),
        |c| match c.label.eq_ignore_ascii_case(word) {
            true => c.label.to_owned(),
            false => format!("{} ({word})", c.label),
        },
    )
}

fn one_of(row: &Parameter) -> String {
    let all = row.choices.iter();
    let words: Vec<String> = all.map(|c| choice_name(row, c.word)).collect();
    match words.as_slice() {
        [only] => format!("{only} so far"),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
        [] => String::new(),
    }
}

/// Parameters whose value differs from the default, in the order of the schema.
pub(super) fn differing(recipe: &Recipe) -> impl Iterator<Item = Key> {
    Key::ALL.iter().copied().filter(|&key| match key {
        Key::Poly => recipe.choice(Key::Outline) == POLYGON,
        _ if !recipe.rows(key).is_empty() => true,
        _ => recipe.number(key) != recipe.default_of(key),
    })
}
