//! Values as text: reading one parameter with a sentence where it does not fit, and writing it.

use super::{Key, Kind, POLYGON, Parameter, Recipe, poly};
use crate::decimal;
use crate::domain::Outline;
use crate::notice::{Arg, Code, Notice};
use crate::order;

/// What became of a text that was meant as a value; see [`Recipe::set`].
type Taken = Result<Vec<Notice>, Notice>;

/// Characters of a foreign text that a sentence repeats.
const QUOTED: usize = 24;

impl Recipe {
    /// Sets one parameter from text: `Ok` holds what was clamped to the limits or mended. Choosing `outline=polygon` without a polygon
    /// makes one of the outline that was chosen before.
    ///
    /// # Errors
    /// The text does not fit and the old value stays. Every notice says what was given, what is
    /// allowed and what was kept.
    pub fn set(&mut self, key: &str, text: &str) -> Result<Vec<Notice>, Notice> {
        let Some(key) = Key::from_word(key) else {
            return Err(Notice::new(Code::NotAParameter).with("given", quote(key)));
        };
        let text = text.trim();
        let list = key.parameter().kind == Kind::Text && key != Key::Poly;
        if text.is_empty() && !list {
            let notice = Notice::new(Code::NoValue).with("what", key.parameter());
            return Err(notice.with("kept", self.shown(key)));
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
    /// What [`Outline::check`] says; the recipe stays as it was. `Ok` holds what was mended.
    pub fn set_polygon(&mut self, outline: &Outline) -> Result<Vec<Notice>, Notice> {
        let side = self.side();
        // Before the points are moved, too: a notice should tell the places that were given.
        let (given, mut notices) = outline.check(side)?;
        let (mut checked, more) = poly::snap(&given, side).check(side)?;
        notices.extend(more);
        let lines = std::mem::take(&mut checked.lines);
        if !lines.is_empty() {
            self.take_lines(&lines)
                .map_err(|why| Notice::new(Code::LinesRefused).with("why", why))?;
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

    /// The value of a key for a notice.
    pub(super) fn shown(&self, key: Key) -> Arg {
        match key.parameter().kind {
            Kind::Text => {
                let outline = self.shown(Key::Outline);
                Notice::new(Code::TheOutline)
                    .with("outline", outline)
                    .into()
            }
            Kind::Choice => chosen(key.parameter(), self.choice(key)),
            _ => self.text(key).into(),
        }
    }

    /// What is said of a value that does not fit.
    fn must_be(&self, key: Key, given: String, kept: Arg) -> Notice {
        let notice = Notice::new(Code::MustBe).with("what", key.parameter());
        let notice = notice.with("allowed", self.allowed(key));
        notice.with("given", given).with("kept", kept)
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
            return Err(self.must_be(key, quote(text), self.shown(key)));
        };
        let (min, max) = self.limits(key);
        let whole = if row.kind == Kind::Int {
            given.round()
        } else {
            given
        };
        let value = order::within(whole, min, max);
        let kept = decimal::text(value).into();
        let clamped = (value != given).then(|| self.must_be(key, quote(text), kept));
        let mut notices = Vec::from_iter(clamped);
        let old_side = self.side();
        self.put(key, value);
        if key == Key::Size {
            self.resize(old_side);
            notices.extend(self.settle());
        }
        Ok(notices)
    }

    /// What a value may be.
    fn allowed(&self, key: Key) -> Arg {
        let row = key.parameter();
        if row.kind == Kind::Choice {
            let all = row.choices.iter();
            return Arg::AnyOf(all.map(|c| chosen(row, c.word)).collect());
        }
        let code = match row.kind {
            Kind::Int => Code::WholeNumber,
            _ if key == Key::Cs => Code::NumberIn,
            _ => Code::Number,
        };
        let unit = match row.unit {
            "" => String::new(),
            "°" => "°".to_owned(),
            unit => format!(" {unit}"),
        };
        let (min, max) = self.limits(key);
        let allowed = Notice::new(code).with("min", decimal::text(min));
        let allowed = allowed.with("max", decimal::text(max)).with("unit", unit);
        match code {
            Code::NumberIn => allowed.with("side", decimal::text(self.side())).into(),
            _ => allowed.into(),
        }
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
    pub(super) fn settle(&mut self) -> Option<Notice> {
        let (given, (min, max)) = (self.number(Key::Cs), self.limits(Key::Cs));
        let value = order::within(given, min, max);
        (value != given).then(|| {
            let kept = decimal::text(value).into();
            let notice = self.must_be(Key::Cs, decimal::text(given), kept);
            self.put(Key::Cs, value);
            notice
        })
    }

    fn set_choice(&mut self, key: Key, text: &str) -> Taken {
        let row = key.parameter();
        let word = text.to_ascii_lowercase();
        let Some(place) = row.choice(&word) else {
            return Err(self.must_be(key, quote(text), self.shown(key)));
        };
        if key == Key::Outline && word == POLYGON && self.polygon.is_none() {
            // The shape on the screen becomes the polygon to start from.
            return self.set_polygon(&self.outline());
        }
        if key == Key::Stone {
            self.set_stone(place as f64);
        } else {
            self.put(key, place as f64);
        }
        Ok(Vec::new())
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
        self.take_list(key, text)
            .map(|()| Vec::new())
            .map_err(|why| {
                let notice = Notice::new(Code::ListUnreadable).with("what", key.parameter());
                notice.with("why", why)
            })
    }

    fn set_poly(&mut self, text: &str) -> Taken {
        let kept = self.shown(Key::Poly);
        let outline = poly::decode(text, self.side()).map_err(|why| {
            let notice = Notice::new(Code::PolygonUnreadable).with("what", Key::Poly.parameter());
            notice.with("why", why).with("kept", kept.clone())
        })?;
        self.set_polygon(&outline).map_err(|why| {
            Notice::new(Code::Refused)
                .with("why", why)
                .with("kept", kept)
        })
    }
}

impl From<&'static Parameter> for Arg {
    fn from(row: &'static Parameter) -> Self {
        Arg::Parameter {
            key: row.key,
            name: row.name,
        }
    }
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

/// A word of a choice as notices name it.
pub(super) fn chosen(row: &'static Parameter, word: &str) -> Arg {
    let choice = row.choices.iter().find(|c| c.word == word);
    choice.map_or_else(
        || quote(word).into(),
        |c| Arg::Choice {
            key: row.key,
            word: c.word,
            label: c.label,
        },
    )
}

/// Parameters whose value differs from the default, in the order of the schema.
pub(super) fn differing(recipe: &Recipe) -> impl Iterator<Item = Key> {
    Key::ALL.iter().copied().filter(|&key| match key {
        Key::Poly => recipe.choice(Key::Outline) == POLYGON,
        _ if !recipe.rows(key).is_empty() => true,
        _ => recipe.number(key) != recipe.default_of(key),
    })
}
