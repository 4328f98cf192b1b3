//! Values as text: reading one parameter, with a notice if it does not fit, and writing it.

use super::{Key, Kind, Parameter, Recipe, SIZE};
use crate::decimal;
use crate::notice::{Arg, Code, Notice, quote};

/// The result of reading a value; see [`Recipe::set`].
type Taken = Result<Vec<Notice>, Notice>;

impl Recipe {
    /// Sets one parameter from text: `Ok` holds notices about clamped or repaired values. Choosing a word for
    /// drawn input, if there is no input yet, takes the present shape as input.
    ///
    /// # Errors
    /// The text does not fit and the old value stays. Every notice says what was given, what is allowed and
    /// what was kept.
    pub fn set(&mut self, key: &str, text: &str) -> Taken {
        let Some(row) = self.schema().row(key) else {
            return Err(Notice::new(Code::NotAParameter).with("given", quote(key)));
        };
        let text = text.trim();
        let is_list = row.kind == Kind::Text && row.drawn_for.is_none();
        if text.is_empty() && !is_list {
            let notice = Notice::new(Code::NoValue).with("what", row);
            return Err(notice.with("kept", self.shown(row)));
        }
        match row.kind {
            Kind::Number | Kind::Int => self.set_number(row, text),
            Kind::Choice => self.set_choice(row, text),
            Kind::Text if is_list => self.set_list(row, text),
            Kind::Text => self.set_drawn(row, text),
        }
    }

    /// The value as the link writes it; empty for an unknown key or if there are no rows.
    pub fn get(&self, key: &str) -> String {
        let row = self.schema().row(key);
        row.map_or(String::new(), |row| self.text(row))
    }

    /// The value of a row as the link writes it.
    pub(super) fn text(&self, row: &Parameter) -> String {
        match row.kind {
            Kind::Number | Kind::Int => decimal::text(self.number(row.key)),
            Kind::Choice => self.choice(row.key).to_owned(),
            Kind::Text => self.rows_text(row.key),
        }
    }

    /// The value of a row for a notice; for drawn input, the choice it belongs to.
    pub(super) fn shown(&self, row: &'static Parameter) -> Arg {
        let drawn_for = row.drawn_for.and_then(|(key, _)| self.schema().row(key.0));
        match (row.kind, drawn_for) {
            (_, Some(choice)) => {
                let chosen = self.shown(choice);
                let notice = Notice::new(Code::TheChoice).with("choice", choice);
                notice.with("chosen", chosen).into()
            }
            (Kind::Choice, _) => row.word(self.choice(row.key)),
            _ => self.text(row).into(),
        }
    }

    /// The notice for a value that does not fit.
    fn must_be(&self, row: &'static Parameter, given: String, kept: Arg) -> Notice {
        let notice = Notice::new(Code::MustBe).with("what", row);
        let notice = notice.with("allowed", self.allowed(row));
        notice.with("given", given).with("kept", kept)
    }

    fn put(&mut self, key: Key, value: f64) {
        if let Some(place) = self.schema().place(key) {
            // Adding 0 turns -0 into 0, so that the link determines every bit.
            self.values[place].number = value + 0.0;
        }
    }

    /// Chooses a word of the schema.
    pub fn choose(&mut self, key: Key, word: &str) {
        let row = self.schema().row(key.0);
        if let Some(place) = row.and_then(|row| row.choice(word)) {
            self.put(key, place as f64);
        }
    }

    fn set_number(&mut self, row: &'static Parameter, text: &str) -> Taken {
        let Some(given) = decimal::parse(text).filter(|v| v.is_finite()) else {
            return Err(self.must_be(row, quote(text), self.shown(row)));
        };
        let (min, max) = self.limits(row);
        let whole = if row.kind == Kind::Int {
            given.round()
        } else {
            given
        };
        let value = whole.clamp(min, max);
        let kept = decimal::text(value).into();
        let clamped = (value != given).then(|| self.must_be(row, quote(text), kept));
        let mut notices = Vec::from_iter(clamped);
        self.put(row.key, value);
        if row.key == SIZE {
            notices.extend(self.settle());
        }
        Ok(notices)
    }

    /// The allowed values of a row.
    fn allowed(&self, row: &'static Parameter) -> Arg {
        if row.kind == Kind::Choice {
            let all = row.choices.iter();
            return Arg::AnyOf(all.map(|c| row.word(c.word)).collect());
        }
        let code = match row.kind {
            Kind::Int => Code::WholeNumber,
            _ if row.side_limits.is_some() => Code::NumberIn,
            _ => Code::Number,
        };
        let unit = match row.unit {
            "" => String::new(),
            "°" => "°".to_owned(),
            unit => format!(" {unit}"),
        };
        let (min, max) = self.limits(row);
        let allowed = Notice::new(code).with("min", decimal::text(min));
        let allowed = allowed.with("max", decimal::text(max)).with("unit", unit);
        match code {
            Code::NumberIn => allowed.with("side", decimal::text(self.side())).into(),
            _ => allowed.into(),
        }
    }

    /// Clamps values whose limits depend on the picture's side.
    fn settle(&mut self) -> Vec<Notice> {
        let mut notices = Vec::new();
        for row in self
            .schema()
            .rows
            .iter()
            .filter(|r| r.side_limits.is_some())
        {
            let (given, (min, max)) = (self.number(row.key), self.limits(row));
            let value = given.clamp(min, max);
            if value != given {
                let kept = decimal::text(value).into();
                notices.push(self.must_be(row, decimal::text(given), kept));
                self.put(row.key, value);
            }
        }
        notices
    }

    fn set_choice(&mut self, row: &'static Parameter, text: &str) -> Taken {
        let word = text.to_ascii_lowercase();
        let Some(place) = row.choice(&word) else {
            return Err(self.must_be(row, quote(text), self.shown(row)));
        };
        if let Some(drawn) = self.drawn_for(row.key, &word)
            && self.rows(drawn.key).is_empty()
        {
            let rules = self.schema().rules;
            return rules.draw(self, drawn.key, None);
        }
        self.put_choice(row, place);
        Ok(Vec::new())
    }

    /// The drawn input that belongs to a word of a choice.
    pub(super) fn drawn_for(&self, key: Key, word: &str) -> Option<&'static Parameter> {
        let is_drawn = |row: &&Parameter| row.drawn_for.is_some_and(|of| of == (key, word));
        self.schema().rows.iter().find(is_drawn)
    }

    /// Sets a choice. Numbers at a default that depends on the choice change to its new default.
    fn put_choice(&mut self, row: &Parameter, place: usize) {
        let depends = |other: &&Parameter| other.default_while.is_some_and(|(k, ..)| k == row.key);
        let rows = self.schema().rows.iter().filter(depends);
        let untouched = rows.filter(|other| self.number(other.key) == self.default_of(other));
        let untouched: Vec<&Parameter> = untouched.collect();
        self.put(row.key, place as f64);
        for other in untouched {
            self.put(other.key, self.default_of(other));
        }
    }

    fn set_list(&mut self, row: &'static Parameter, text: &str) -> Taken {
        let taken = self.read_rows(row.key, text);
        let taken = taken.and_then(|rows| self.set_rows(row.key, rows));
        taken.map(|()| Vec::new()).map_err(|why| {
            let notice = Notice::new(Code::ListUnreadable).with("what", row);
            notice.with("why", why)
        })
    }

    fn set_drawn(&mut self, row: &'static Parameter, text: &str) -> Taken {
        let kept = self.shown(row);
        let rows = self.read_rows(row.key, text).map_err(|why| {
            let notice = Notice::new(Code::PolygonUnreadable).with("what", row);
            notice.with("why", why).with("kept", kept.clone())
        })?;
        let rules = self.schema().rules;
        rules.draw(self, row.key, Some(rows)).map_err(|why| {
            Notice::new(Code::Refused)
                .with("why", why)
                .with("kept", kept)
        })
    }

    /// Rows whose value differs from the default, in the order of the schema.
    pub(super) fn differing(&self) -> impl Iterator<Item = &'static Parameter> {
        self.schema().rows.iter().filter(|row| match row.drawn_for {
            Some((key, word)) => self.choice(key) == word,
            None if !self.rows(row.key).is_empty() => true,
            None => self.number(row.key) != self.default_of(row),
        })
    }
}

impl From<&'static Parameter> for Arg {
    fn from(row: &'static Parameter) -> Self {
        Arg::Parameter {
            key: row.key.0,
            name: row.name,
        }
    }
}

impl Parameter {
    /// A word of this choice as notices name it; an unknown word is quoted.
    pub fn word(&'static self, word: &str) -> Arg {
        let choice = self.choices.iter().find(|c| c.word == word);
        choice.map_or_else(
            || quote(word).into(),
            |c| Arg::Choice {
                key: self.key.0,
                word: c.word,
                label: c.label,
            },
        )
    }
}
