//! Messages for people, as data: a code and its arguments. `words.txt` has the sentences in all languages, and
//! `house.txt` those that only the full module has. English is compiled into the program.

use std::fmt;

include!(concat!(env!("OUT_DIR"), "/notices.rs"));

/// A sentence, or a part of one.
#[derive(Clone, PartialEq)]
pub struct Notice {
    /// The sentence in the table.
    pub code: Code,
    /// The arguments by their names in the table.
    pub args: Vec<(&'static str, Arg)>,
}

/// An argument.
#[derive(Clone, PartialEq)]
pub enum Arg {
    /// Text that is the same in all languages: numbers, places, user input.
    Text(String),
    /// A parameter, by its key in the link, with its English name.
    Parameter {
        /// The key in the link.
        key: &'static str,
        /// The name on the page.
        name: &'static str,
    },
    /// A word of a choice.
    Choice {
        /// The choice's key.
        key: &'static str,
        /// The word in the link.
        word: &'static str,
        /// The label on the page, in English.
        label: &'static str,
    },
    /// A part of the sentence.
    Part(Notice),
    /// A list of alternatives.
    AnyOf(Vec<Arg>),
}

impl Notice {
    /// A notice without arguments.
    pub fn new(code: Code) -> Self {
        let args = Vec::new();
        Self { code, args }
    }

    /// Adds an argument.
    pub fn with(mut self, name: &'static str, arg: impl Into<Arg>) -> Self {
        self.args.push((name, arg.into()));
        self
    }
}

impl From<Code> for Notice {
    fn from(code: Code) -> Self {
        Self::new(code)
    }
}

impl From<String> for Arg {
    fn from(text: String) -> Self {
        Arg::Text(text)
    }
}

impl From<usize> for Arg {
    fn from(number: usize) -> Self {
        Arg::Text(number.to_string())
    }
}

impl From<Notice> for Arg {
    fn from(part: Notice) -> Self {
        Arg::Part(part)
    }
}

/// The English text.
impl From<Notice> for String {
    fn from(notice: Notice) -> Self {
        english(&notice)
    }
}

/// Most characters of foreign text quoted in a sentence.
const QUOTED: usize = 24;

/// The most characters that are quoted of a name that a reader will search for.
const QUOTED_LONG: usize = 80;

/// Makes foreign text fit for a sentence: short and without control characters.
pub fn quote(text: &str) -> String {
    quote_up_to(text, QUOTED)
}

/// Like [`quote`], for a name that a reader will search for, such as that of an extension.
pub fn quote_long(text: &str) -> String {
    quote_up_to(text, QUOTED_LONG)
}

fn quote_up_to(text: &str, most: usize) -> String {
    let mut short: String = text
        .chars()
        .take(most)
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    if text.chars().nth(most).is_some() {
        short.push('…');
    }
    format!("\"{short}\"")
}

/// The texts of several notices, joined.
pub fn text(notices: &[Notice]) -> String {
    let texts: Vec<String> = notices.iter().map(english).collect();
    texts.join(" ")
}

/// The English text.
impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&english(self))
    }
}

/// The same as `Display`, for readable test output.
impl fmt::Debug for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

fn english(notice: &Notice) -> String {
    let template = notice.code.english();
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('{') {
        let (name, after) = after.split_once('}').unwrap_or((after, ""));
        text += before;
        let arg = notice.args.iter().find(|(own, _)| *own == name);
        debug_assert!(arg.is_some(), "no {name}: {template}");
        text += &arg.map_or(String::new(), |(_, arg)| arg.english());
        rest = after;
    }
    text += rest;
    // Sentences begin with a capital, whatever the first word is.
    match template.ends_with('.') {
        true => {
            let mut letters = text.chars();
            let first = letters.next().into_iter().flat_map(char::to_uppercase);
            first.collect::<String>() + letters.as_str()
        }
        false => text,
    }
}

impl Arg {
    fn english(&self) -> String {
        match self {
            Arg::Text(text) => text.clone(),
            Arg::Parameter { key, name } => format!("{name} ({key})"),
            Arg::Choice { word, label, .. } if label.eq_ignore_ascii_case(word) => {
                (*label).to_owned()
            }
            Arg::Choice { word, label, .. } => format!("{label} ({word})"),
            Arg::Part(notice) => english(notice),
            Arg::AnyOf(all) => {
                let words: Vec<String> = all.iter().map(Arg::english).collect();
                match words.split_last() {
                    Some((last, most)) if !most.is_empty() => {
                        format!("{} or {last}", most.join(", "))
                    }
                    _ => words.concat(),
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Codes with their English and Japanese sentences.
    fn table() -> Vec<[&'static str; 3]> {
        let tables = [include_str!("words.txt"), include_str!("house.txt")];
        let lines = tables.into_iter().flat_map(str::lines);
        let lines: Vec<&str> = lines
            .filter(|line| !line.is_empty() && !line.starts_with('#'))
            .collect();
        let entry = |lines: &[&'static str]| {
            let [code, english, japanese] = *lines else {
                panic!("{lines:?}");
            };
            let of = |line: &'static str, language| {
                line.strip_prefix(language)
                    .unwrap_or_else(|| panic!("{line}"))
            };
            [code, of(english, "  en "), of(japanese, "  ja ")]
        };
        lines.chunks(3).map(entry).collect()
    }

    fn arguments(text: &str) -> Vec<&str> {
        let pieces = text.split('{').skip(1);
        let mut names: Vec<&str> = pieces.map(|p| p.split('}').next().unwrap()).collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    #[test]
    fn all_languages_say_the_same_of_every_code() {
        let table = table();
        assert!(table.len() > 50);
        for [code, english, japanese] in &table {
            assert_eq!(arguments(english), arguments(japanese), "{code}");
            assert_eq!(english.ends_with('.'), japanese.ends_with('。'), "{code}");
        }
    }

    #[test]
    fn sentences_are_put_together() {
        let ring = Notice::new(Code::Island).with("n", 3);
        let notice = Notice::new(Code::FoldsBack)
            .with("ring", ring)
            .with("place", "(1, 2)".to_owned());
        assert_eq!(
            notice.to_string(),
            "Island 3 turns back on itself at (1, 2)."
        );
        let choice = |word, label| Arg::Choice {
            key: "stone",
            word,
            label,
        };
        let any = Arg::AnyOf(vec![
            choice("cobble", "Cobblestone"),
            choice("skin", "Skin"),
        ]);
        let what = Arg::Parameter {
            key: "stone",
            name: "Form",
        };
        let notice = Notice::new(Code::MustBe)
            .with("what", what)
            .with("allowed", any)
            .with("given", "\"brick\"".to_owned())
            .with("kept", choice("skin", "Skin"));
        assert_eq!(
            notice.to_string(),
            "Form (stone) must be Cobblestone (cobble) or Skin; \"brick\" was given, kept Skin."
        );
    }
}
