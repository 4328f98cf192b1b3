//! The link: `v=1&cs=18&stone=flag`, in the page's fragment. It holds the values that differ from the
//! default, in the order of the schema. Reading never fails: values that do not fit are clamped or dropped,
//! with a notice.

use super::{Kind, Parameter, Recipe, SIZE, Schema};
use crate::notice::{Arg, Code, Notice, quote};

/// The version that links are written in.
pub const VERSION: u32 = 1;

/// At most this many notices are listed; further ones are only counted.
const TOLD: usize = 12;

/// Most pairs read from a link; a link of this program has at most one for each parameter.
const PAIRS: usize = 200;

/// The key that names the generator.
const MAKE: &str = "make";

/// The keys of the view: how the page shows the picture, which is not part of a recipe. Every link may have
/// them, and they have no effect here (docs/parameters.md); no schema has a row with these names.
pub const VIEW: [&str; 6] = ["view", "pace", "step", "zoom", "camera", "body"];

impl Recipe {
    /// Reads a whole address, a fragment with its `#`, or a bare fragment. The generator is one of those with
    /// these schemas (at least one), the first if the link names none. Also gives notices about clamped or
    /// dropped values.
    pub fn from_link(schemas: &[&'static Schema], link: &str) -> (Recipe, Vec<Notice>) {
        let mut notices = Vec::new();
        let mut pieces = fragment(link).split('&').filter(|p| !p.trim().is_empty());
        let mut pairs: Vec<(String, String)> = pieces
            .by_ref()
            .take(PAIRS)
            .map(|piece| piece.split_once('=').unwrap_or((piece, "")))
            .map(|(key, value)| (decode(key).trim().to_ascii_lowercase(), decode(value)))
            .filter(|(key, _)| !VIEW.contains(&key.as_str()))
            .collect();
        if pieces.next().is_some() {
            notices.push(Notice::new(Code::FirstValues).with("n", PAIRS));
        }
        notices.extend(take_version(&mut pairs));
        let (schema, unknown) = take_schema(schemas, &mut pairs);
        notices.extend(unknown);
        let modern = |(key, value)| schema.rules.modern(key, value);
        let pairs: Vec<(String, String)> = pairs.into_iter().flat_map(modern).collect();

        let mut recipe = Recipe::new(schema);
        for early in [true, false] {
            for (index, (key, value)) in pairs.iter().enumerate() {
                if is_early(schema, key) == early {
                    let earlier = pairs[..index].iter().any(|(k, _)| k == key);
                    notices.extend(recipe.read(key, value, earlier, &pairs));
                }
            }
        }
        let mut told = Vec::new();
        notices.retain(|notice| !told.contains(notice) && (told.push(notice.clone()), true).1);
        if notices.len() > TOLD {
            let more = notices.len() - TOLD;
            notices.truncate(TOLD);
            notices.push(Notice::new(Code::MoreNotices).with("n", more));
        }
        (recipe, notices)
    }

    /// The fragment without `#`; empty for the default recipe of the generator that links do not name.
    pub fn link(&self) -> String {
        let mut link = String::new();
        let mut add = |key: &str, value: &str| {
            if link.is_empty() {
                link = format!("v={VERSION}");
            }
            link += &format!("&{key}={value}");
        };
        if self.schema().is_named {
            add(MAKE, self.schema().word);
        }
        for row in self.differing() {
            add(row.key.0, &self.text(row));
        }
        link
    }

    /// Reads one pair of a link.
    fn read(
        &mut self,
        key: &str,
        value: &str,
        is_repeated: bool,
        pairs: &[(String, String)],
    ) -> Vec<Notice> {
        let row = self.schema().row(key);
        let mut notices = Vec::new();
        if let (Some(row), true) = (row, is_repeated) {
            notices.push(Notice::new(Code::Repeated).with("what", row));
        }
        let word = value.trim().to_ascii_lowercase();
        let mismatch = row.and_then(|row| match row.kind {
            Kind::Choice => self.chooses_drawn(row, &word, pairs),
            _ => self.is_drawn_in_vain(row, pairs),
        });
        match mismatch {
            Some(told) => notices.extend(told),
            None => match self.set(key, value) {
                Ok(mended) => notices.extend(mended),
                Err(why) => notices.push(why),
            },
        }
        notices
    }

    /// For a word that belongs to drawn input: nothing if the link has the input, which chooses the word by itself, or
    /// else a notice that the input is missing. `None` for other words.
    fn chooses_drawn(
        &self,
        row: &'static Parameter,
        word: &str,
        pairs: &[(String, String)],
    ) -> Option<Option<Notice>> {
        let drawn = self.drawn_for(row.key, word)?;
        let is_given = pairs.iter().any(|(key, _)| key == drawn.key.0);
        Some((!is_given).then(|| {
            let notice = Notice::new(Code::PointsMissing).with("what", row);
            let notice = notice.with("is", row.word(word)).with("points", drawn);
            notice.with("kept", self.shown(row))
        }))
    }

    /// For drawn input: a notice that it is dropped, if the link chooses another word; else `None`.
    fn is_drawn_in_vain(
        &self,
        row: &'static Parameter,
        pairs: &[(String, String)],
    ) -> Option<Option<Notice>> {
        let (key, word) = row.drawn_for?;
        let choice = self.schema().row(key.0)?;
        let (_, given) = pairs.iter().rfind(|(other, _)| other == key.0)?;
        let given = given.trim().to_ascii_lowercase();
        if given == word {
            return None;
        }
        let notice = Notice::new(Code::PointsDropped).with("what", choice);
        let notice = notice.with("points", row);
        let notice = notice.with("needed", choice.word(word));
        Some(Some(notice.with("is", choice.word(&given))))
    }
}

/// Whether limits or defaults of other parameters depend on this one.
fn is_early(schema: &Schema, key: &str) -> bool {
    let hangs = |row: &Parameter| row.default_while.is_some_and(|(k, ..)| k.0 == key);
    key == SIZE.0 || schema.rows.iter().any(hangs)
}

/// The part of an address with the recipe: after `#`, or after `?` if there is no `#`.
fn fragment(link: &str) -> &str {
    let link = link.trim();
    match link.split_once('#') {
        Some((_, fragment)) => fragment,
        None => match link.split_once('?') {
            Some((_, query)) => query,
            None if link.split(':').skip(1).any(|rest| rest.starts_with("//")) => "",
            None => link,
        },
    }
}

/// Undoes percent-encoding; invalid codes stay unchanged.
fn decode(text: &str) -> String {
    let bytes = text.as_bytes();
    let digit = |at: usize| bytes.get(at).and_then(|&b| (b as char).to_digit(16));
    let mut plain = Vec::with_capacity(bytes.len());
    let mut at = 0;
    while at < bytes.len() {
        match (bytes[at], digit(at + 1), digit(at + 2)) {
            (b'%', Some(high), Some(low)) => {
                plain.push((16 * high + low) as u8);
                at += 3;
            }
            (byte, ..) => {
                plain.push(byte);
                at += 1;
            }
        }
    }
    String::from_utf8_lossy(&plain).into_owned()
}

/// Removes the version from the pairs; a notice if this program does not write it.
fn take_version(pairs: &mut Vec<(String, String)>) -> Option<Notice> {
    let about = |code| Notice::new(code).with("known", VERSION.to_string());
    let mut notice = None;
    pairs.retain(|(key, value)| {
        if key == "v" {
            notice = match value.trim().parse::<u32>() {
                Ok(1..=VERSION) => None,
                Ok(newer @ VERSION..) => {
                    Some(about(Code::NewerVersion).with("newer", newer.to_string()))
                }
                _ => Some(about(Code::BadVersion).with("given", quote(value))),
            };
        }
        key != "v"
    });
    notice
}

/// Removes the generator from the pairs: its schema, and a notice if the word is unknown.
fn take_schema(
    schemas: &[&'static Schema],
    pairs: &mut Vec<(String, String)>,
) -> (&'static Schema, Option<Notice>) {
    let mut schema = schemas[0];
    let mut notice = None;
    pairs.retain(|(key, value)| {
        if key == MAKE {
            let word = value.trim().to_ascii_lowercase();
            match schemas.iter().find(|schema| schema.word == word) {
                Some(found) => (schema, notice) = (found, None),
                None => {
                    let known = schemas.iter().map(|s| Arg::from(s.word.to_owned()));
                    let about = Notice::new(Code::BadMake).with("given", quote(value));
                    let about = about.with("known", Arg::AnyOf(known.collect()));
                    notice = Some(about.with("kept", schema.word.to_owned()));
                }
            }
        }
        key != MAKE
    });
    (schema, notice)
}
