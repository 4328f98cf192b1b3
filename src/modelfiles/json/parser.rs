//! The parser: reads JSON in slices.

use super::value::Json;
use crate::decimal;

/// The names whose values are kept.
const NAMES: [&str; 33] = [
    "scene",
    "scenes",
    "nodes",
    "children",
    "mesh",
    "meshes",
    "primitives",
    "mode",
    "attributes",
    "POSITION",
    "indices",
    "extensions",
    "extensionsRequired",
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "accessors",
    "bufferView",
    "bufferViews",
    "buffers",
    "buffer",
    "uri",
    "byteOffset",
    "byteLength",
    "byteStride",
    "componentType",
    "normalized",
    "count",
    "type",
    "sparse",
    "matrix",
    "translation",
    "rotation",
    "scale",
];
/// Names of short lists of numbers. A matrix has 16; a 17th number is kept, so that a longer list is no matrix.
const FEW: [&str; 4] = ["matrix", "translation", "rotation", "scale"];
const MOST_NUMBERS: usize = 17;
/// The most values that are kept: a hundred thousand nodes have about as many.
const MOST_VALUES: usize = 1 << 22;
/// The deepest nesting that is allowed, and the deepest at which values are kept.
const DEPTH: usize = 1 << 16;
const KEPT_DEPTH: usize = 16;
/// The longest kept text and the longest number, in bytes; longer text is cut.
const LONGEST: usize = 256;

/// The text is not valid JSON, or it is nested too deeply, or holds too many values.
#[derive(Debug, PartialEq)]
pub struct Unreadable;

/// A list or an object whose end has not come yet.
enum Open {
    List(Vec<Json>, usize),
    /// With the name of the next value; `None` if that value is not kept.
    Object(Vec<(&'static str, Json)>, Option<&'static str>),
    /// A list or an object that is not kept.
    Skipped {
        is_object: bool,
    },
}

impl Open {
    fn is_object(&self) -> bool {
        match self {
            Open::List(..) => false,
            Open::Object(..) => true,
            Open::Skipped { is_object } => *is_object,
        }
    }
}

/// The next piece of the text.
#[derive(Clone, Copy, PartialEq)]
enum Next {
    Value,
    /// A value, or the end of the list.
    ValueOrEnd,
    Name,
    /// A name, or the end of the object.
    NameOrEnd,
    Colon,
    CommaOrEnd,
    /// The rest of a string: of a name, or of a value.
    NameText,
    ValueText,
    Nothing,
}

/// Parses a value.
pub struct Parser {
    at: usize,
    next: Next,
    open: Vec<Open>,
    /// The current string, as far as it has been read.
    text: Vec<u8>,
    /// The number of values that have been kept.
    kept: usize,
    done: Option<Json>,
}

impl Parser {
    /// Starts at the beginning of a text.
    pub fn new() -> Self {
        Self {
            at: 0,
            next: Next::Value,
            open: Vec::new(),
            text: Vec::new(),
            kept: 0,
            done: None,
        }
    }

    /// Parses about `amount` more bytes; returns the value at the end of the text.
    pub fn advance(&mut self, bytes: &[u8], amount: usize) -> Option<Result<Json, Unreadable>> {
        let end = bytes.len().min(self.at.saturating_add(amount));
        while self.at < end {
            if self.step(bytes, end).is_none() {
                return Some(Err(Unreadable));
            }
        }
        (self.at >= bytes.len()).then(|| self.done.take().ok_or(Unreadable))
    }

    /// Parses the next piece, but a string only up to `end`. `None` if the text is invalid.
    fn step(&mut self, bytes: &[u8], end: usize) -> Option<()> {
        if matches!(self.next, Next::NameText | Next::ValueText) {
            return self.go_on(bytes, end);
        }
        let byte = bytes[self.at];
        if b" \t\r\n".contains(&byte) {
            self.at += 1;
            return Some(());
        }
        match (self.next, byte) {
            (Next::Value | Next::ValueOrEnd, b'{' | b'[') => self.begin(byte == b'{')?,
            (Next::ValueOrEnd | Next::CommaOrEnd, b']') => self.end(false)?,
            (Next::NameOrEnd | Next::CommaOrEnd, b'}') => self.end(true)?,
            (Next::Value | Next::ValueOrEnd, b'"') => self.next = Next::ValueText,
            (Next::Name | Next::NameOrEnd, b'"') => self.next = Next::NameText,
            (Next::Colon, b':') => self.next = Next::Value,
            (Next::CommaOrEnd, b',') => {
                let is_object = self.open.last()?.is_object();
                self.next = if is_object { Next::Name } else { Next::Value };
            }
            (Next::Value | Next::ValueOrEnd, _) => return self.word(bytes),
            // Chunks are padded with spaces; some programs pad with zeros.
            (Next::Nothing, 0) => {}
            _ => return None,
        }
        self.at += 1;
        Some(())
    }

    /// Whether the next value is kept.
    fn keeps(&self) -> bool {
        match self.open.last() {
            None => true,
            Some(Open::List(all, most)) => all.len() < *most,
            Some(Open::Object(_, name)) => name.is_some(),
            Some(Open::Skipped { .. }) => false,
        }
    }

    fn begin(&mut self, is_object: bool) -> Option<()> {
        let most = match self.open.last() {
            Some(Open::Object(_, Some(name))) if FEW.contains(name) => MOST_NUMBERS,
            _ => usize::MAX,
        };
        let keeps = self.keeps() && self.open.len() < KEPT_DEPTH;
        self.open.push(match (keeps, is_object) {
            (false, _) => Open::Skipped { is_object },
            (true, true) => Open::Object(Vec::new(), None),
            (true, false) => Open::List(Vec::new(), most),
        });
        self.next = match is_object {
            true => Next::NameOrEnd,
            false => Next::ValueOrEnd,
        };
        (self.open.len() <= DEPTH).then_some(())
    }

    fn end(&mut self, is_object: bool) -> Option<()> {
        let open = self.open.pop()?;
        if open.is_object() != is_object {
            return None;
        }
        match open {
            Open::List(all, _) => self.put(Json::List(all)),
            Open::Object(all, _) => self.put(Json::Object(all)),
            Open::Skipped { .. } => self.put(Json::No),
        }
    }

    /// Adds a complete value to the list or object that it belongs to.
    fn put(&mut self, value: Json) -> Option<()> {
        self.kept += usize::from(self.keeps());
        self.next = Next::CommaOrEnd;
        match self.open.last_mut() {
            None => (self.done, self.next) = (Some(value), Next::Nothing),
            Some(Open::List(all, most)) if all.len() < *most => all.push(value),
            Some(Open::Object(all, name)) => {
                if let Some(name) = name.take() {
                    all.push((name, value));
                }
            }
            _ => {}
        }
        (self.kept <= MOST_VALUES).then_some(())
    }

    /// Reads a number, `null`, `true` or `false`.
    fn word(&mut self, bytes: &[u8]) -> Option<()> {
        let near = &bytes[self.at..bytes.len().min(self.at + LONGEST)];
        let goes_on = |b: &u8| b.is_ascii_alphanumeric() || b"+-.".contains(b);
        let length = near.iter().position(|b| !goes_on(b));
        let word = &near[..length.unwrap_or(near.len())];
        self.at += word.len();
        let value = match word {
            b"null" | b"false" => Json::No,
            b"true" => Json::Yes,
            // Numbers that nobody reads need no value.
            _ if !self.keeps() && !word.is_empty() => Json::No,
            _ => Json::Number(decimal::parse(std::str::from_utf8(word).ok()?)?),
        };
        self.put(value)
    }

    /// Reads on in a string, up to its closing quote or to `end`.
    fn go_on(&mut self, bytes: &[u8], end: usize) -> Option<()> {
        while self.at < end {
            let byte = bytes[self.at];
            self.at += 1;
            match byte {
                b'"' => return self.end_text(),
                b'\\' => {
                    let sign = escaped(bytes, &mut self.at)?;
                    self.keep(sign.encode_utf8(&mut [0; 4]).as_bytes());
                }
                byte => self.keep(&[byte]),
            }
        }
        Some(())
    }

    fn keep(&mut self, bytes: &[u8]) {
        if self.text.len() < LONGEST {
            self.text.extend_from_slice(bytes);
        }
    }

    fn end_text(&mut self) -> Option<()> {
        let text = std::mem::take(&mut self.text);
        if self.next == Next::ValueText {
            if !self.keeps() {
                return self.put(Json::No);
            }
            // The string may have been cut within a character.
            let text = match text.len() < LONGEST {
                true => String::from_utf8(text).ok()?,
                false => String::from_utf8_lossy(&text).into_owned(),
            };
            return self.put(Json::Text(text));
        }
        self.next = Next::Colon;
        if let Some(Open::Object(all, name)) = self.open.last_mut() {
            let known = NAMES.iter().find(|known| known.as_bytes() == text);
            // If a name occurs twice, keep its first value.
            *name = known
                .copied()
                .filter(|known| all.iter().all(|(own, _)| own != known));
        }
        Some(())
    }
}

/// The character of an escape, whose backslash is before `at`; moves `at` behind it.
fn escaped(bytes: &[u8], at: &mut usize) -> Option<char> {
    let byte = *bytes.get(*at)?;
    *at += 1;
    Some(match byte {
        b'n' => '\n',
        b't' => '\t',
        b'r' => '\r',
        b'b' => '\u{8}',
        b'f' => '\u{C}',
        b'"' | b'\\' | b'/' => byte.into(),
        b'u' => {
            let digits = bytes.get(*at..*at + 4)?;
            *at += 4;
            let code = u32::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()?;
            // Surrogate pairs are not decoded: such names are never compared with anything.
            char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER)
        }
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &[u8], amount: usize) -> Result<Json, Unreadable> {
        let mut parser = Parser::new();
        if text.is_empty() {
            return parser.advance(text, amount).unwrap();
        }
        std::iter::repeat_with(|| parser.advance(text, amount))
            .find_map(|done| done)
            .unwrap()
    }

    #[test]
    fn values_are_read() {
        let json = br#" {"nodes": [1, -2.5e1, {"uri":"c\"\u0041\n"}], "mode": null, "mesh": [], "indices": {},
            "count": true, "count": 7, "other": [{"nodes": "\u00e4"}, [-, 1.2.3]], "sparse": false } "#;
        for amount in [1, 2, 7, 1000] {
            let json = parsed(json, amount).unwrap();
            assert_eq!(json.list_of("nodes")[1].number(), Some(-25.0));
            assert_eq!(json.list_of("nodes")[0].index(), Some(1));
            let text = json.list_of("nodes")[2].get("uri").and_then(Json::text);
            assert_eq!(text, Some("c\"A\n"));
            assert_eq!(json.get("mode"), Some(&Json::No));
            assert_eq!(json.get("count"), Some(&Json::Yes));
            let all = [json.get("other"), json.get("mode").unwrap().get("mesh")];
            assert_eq!(all, [None, None]);
            assert_eq!(json.get("indices"), Some(&Json::Object(vec![])));
        }
        for index in ["-1", "0.5", "4294967296", "1e300"] {
            assert_eq!(parsed(index.as_bytes(), 9).unwrap().index(), None);
        }
        assert_eq!(parsed(b"[]\0\0", 9), Ok(Json::List(vec![])));
    }

    #[test]
    fn what_is_none_is_refused() {
        for bad in [
            "",
            "{",
            "[1,",
            "[1 2]",
            "{\"a\"}",
            "{a:1}",
            "\"a",
            "tru",
            "1 2",
            "[1,]",
            "[1}",
            "{\"a\":1]",
            "{\"a\":1,}",
            "\"\\u12\"",
            "\"\\x\"",
            "-",
            "{\"a\":}",
        ] {
            for amount in [1, 100] {
                assert_eq!(parsed(bad.as_bytes(), amount), Err(Unreadable), "{bad}");
            }
        }
        assert_eq!(parsed("[".repeat(100_000).as_bytes(), 999), Err(Unreadable));
        assert_eq!(parsed(&[b'"', 0xFF, b'"'], 9), Err(Unreadable));
        let many = format!("[{}1]", "1,".repeat(MOST_VALUES));
        assert_eq!(parsed(many.as_bytes(), 1 << 20), Err(Unreadable));
    }

    #[test]
    fn only_what_is_needed_is_kept() {
        let deep = format!(
            "{{\"extras\":{}{},\"mode\":1}}",
            "[".repeat(900),
            "]".repeat(900)
        );
        let json = parsed(deep.as_bytes(), 100).unwrap();
        assert_eq!(json, Json::Object(vec![("mode", Json::Number(1.0))]));
        let long = format!(
            "{{\"matrix\":[{}0],\"uri\":\"{}\"}}",
            "0,".repeat(999),
            "ä".repeat(999)
        );
        let json = parsed(long.as_bytes(), 100).unwrap();
        assert_eq!(json.list_of("matrix").len(), MOST_NUMBERS);
        assert!(json.get("uri").and_then(Json::text).unwrap().len() <= LONGEST + 3);
        // Kept values are not nested deeply, either.
        let deep = format!("{}1{}", "{\"nodes\":".repeat(900), "}".repeat(900));
        assert!(parsed(deep.as_bytes(), 100).is_ok());
    }
}
