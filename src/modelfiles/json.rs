//! A JSON parser for the heads of GLB files, which are small.

use crate::decimal;

/// The deepest nesting.
const DEPTH: usize = 64;

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Json {
    /// `null` or `false`.
    No,
    /// `true`.
    Yes,
    Number(f64),
    Text(String),
    List(Vec<Json>),
    Object(Vec<(String, Json)>),
}

impl Json {
    /// Parses a value; nothing if the text is not valid JSON.
    pub fn parse(text: &[u8]) -> Option<Self> {
        let mut parser = Parser {
            text: std::str::from_utf8(text).ok()?.as_bytes(),
            at: 0,
        };
        let value = parser.value(DEPTH)?;
        parser.skip();
        // Chunks are padded with spaces; some programs pad with zeros.
        let rest = &parser.text[parser.at..];
        rest.iter().all(|&b| b == 0).then_some(value)
    }

    /// The value of a name in an object.
    pub fn get(&self, name: &str) -> Option<&Json> {
        match self {
            Json::Object(all) => all.iter().find(|(own, _)| own == name).map(|(_, v)| v),
            _ => None,
        }
    }

    /// The values of a list; empty for anything else.
    pub fn list(&self) -> &[Json] {
        match self {
            Json::List(all) => all,
            _ => &[],
        }
    }

    /// The list under a name in an object; empty if there is none.
    pub fn list_of(&self, name: &str) -> &[Json] {
        self.get(name).map_or(&[], Json::list)
    }

    pub fn number(&self) -> Option<f64> {
        match self {
            Json::Number(x) => Some(*x),
            _ => None,
        }
    }

    pub fn text(&self) -> Option<&str> {
        match self {
            Json::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The value as an integer from 0 to 2^32 - 1.
    pub fn index(&self) -> Option<usize> {
        let x = self.number()?;
        let index = x as u32;
        (f64::from(index) == x).then_some(index as usize)
    }

    /// The integer under a name in an object.
    pub fn index_of(&self, name: &str) -> Option<usize> {
        self.get(name)?.index()
    }
}

struct Parser<'a> {
    text: &'a [u8],
    at: usize,
}

impl Parser<'_> {
    fn peek(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    fn skip(&mut self) {
        while self.peek().is_some_and(|b| b" \t\r\n".contains(&b)) {
            self.at += 1;
        }
    }

    /// Skips white space, then the given character if it comes next; true if it did.
    fn takes(&mut self, sign: u8) -> bool {
        self.skip();
        let found = self.peek() == Some(sign);
        self.at += usize::from(found);
        found
    }

    fn value(&mut self, depth: usize) -> Option<Json> {
        self.skip();
        let depth = depth.checked_sub(1)?;
        match self.peek()? {
            b'{' => self.object(depth),
            b'[' => self.list(depth),
            b'"' => self.string().map(Json::Text),
            b'n' => self.word("null", Json::No),
            b't' => self.word("true", Json::Yes),
            b'f' => self.word("false", Json::No),
            _ => self.number(),
        }
    }

    fn word(&mut self, word: &str, value: Json) -> Option<Json> {
        let found = self.text[self.at..].starts_with(word.as_bytes());
        self.at += word.len();
        found.then_some(value)
    }

    fn number(&mut self) -> Option<Json> {
        let start = self.at;
        let goes_on = |b: u8| b.is_ascii_digit() || b"+-.eE".contains(&b);
        while self.peek().is_some_and(goes_on) {
            self.at += 1;
        }
        let word = std::str::from_utf8(&self.text[start..self.at]).ok()?;
        decimal::parse(word).map(Json::Number)
    }

    fn list(&mut self, depth: usize) -> Option<Json> {
        self.at += 1;
        let mut all = Vec::new();
        if self.takes(b']') {
            return Some(Json::List(all));
        }
        loop {
            all.push(self.value(depth)?);
            if self.takes(b']') {
                return Some(Json::List(all));
            }
            if !self.takes(b',') {
                return None;
            }
        }
    }

    fn object(&mut self, depth: usize) -> Option<Json> {
        self.at += 1;
        let mut all = Vec::new();
        if self.takes(b'}') {
            return Some(Json::Object(all));
        }
        loop {
            self.skip();
            let name = self.string()?;
            if !self.takes(b':') {
                return None;
            }
            all.push((name, self.value(depth)?));
            if self.takes(b'}') {
                return Some(Json::Object(all));
            }
            if !self.takes(b',') {
                return None;
            }
        }
    }

    fn string(&mut self) -> Option<String> {
        if self.peek() != Some(b'"') {
            return None;
        }
        self.at += 1;
        let mut bytes = Vec::new();
        loop {
            let byte = self.peek()?;
            self.at += 1;
            match byte {
                b'"' => return String::from_utf8(bytes).ok(),
                b'\\' => {
                    let sign = self.escaped()?;
                    bytes.extend_from_slice(sign.encode_utf8(&mut [0; 4]).as_bytes());
                }
                byte => bytes.push(byte),
            }
        }
    }

    fn escaped(&mut self) -> Option<char> {
        let byte = self.peek()?;
        self.at += 1;
        Some(match byte {
            b'n' => '\n',
            b't' => '\t',
            b'r' => '\r',
            b'b' => '\u{8}',
            b'f' => '\u{C}',
            b'"' | b'\\' | b'/' => byte.into(),
            b'u' => {
                let digits = self.text.get(self.at..self.at + 4)?;
                self.at += 4;
                let code = u32::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()?;
                // Surrogate pairs are not decoded: such names are never compared with anything.
                char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER)
            }
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_read() {
        let json = br#" {"a": [1, -2.5e1, {"b":"c\"\u0041\n"}], "d": null, "e": [], "f": {}, "g": true } "#;
        let json = Json::parse(json).unwrap();
        assert_eq!(json.list_of("a")[1].number(), Some(-25.0));
        assert_eq!(json.list_of("a")[0].index(), Some(1));
        let text = json.list_of("a")[2].get("b").and_then(Json::text);
        assert_eq!(text, Some("c\"A\n"));
        assert_eq!(json.get("d"), Some(&Json::No));
        assert_eq!(json.get("x").or(json.get("d").unwrap().get("y")), None);
        for index in ["-1", "0.5", "4294967296", "1e300"] {
            assert_eq!(Json::parse(index.as_bytes()).unwrap().index(), None);
        }
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
            "\"\\u12\"",
            "\"\\x\"",
            "-",
            "{\"a\":}",
        ] {
            assert_eq!(Json::parse(bad.as_bytes()), None, "{bad}");
        }
        assert_eq!(Json::parse("[".repeat(100_000).as_bytes()), None);
        assert_eq!(Json::parse(&[b'"', 0xFF, b'"']), None);
    }
}
