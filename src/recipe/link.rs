//! The link: `v=1&cs=18&stone=flag`, in the page's fragment. It holds what differs from the default,
//! in the order of the schema. Reading never fails: what does not fit is clamped or dropped, and a
//! notice says so.

use super::value::{chosen, differing, quote};
use super::{Key, POLYGON, Recipe};
use crate::notice::{Code, Notice};

/// The version that links are written in.
pub const VERSION: u32 = 1;

/// At most so many notices are told one by one.
const TOLD: usize = 12;

/// At most so many pairs of a link are read; a link of this program has one for each parameter.
const PAIRS: usize = 200;

impl Recipe {
    /// Reads a whole address, a fragment with its `#`, or a bare fragment; with what was
    /// clamped or dropped.
    pub fn from_link(link: &str) -> (Recipe, Vec<Notice>) {
        let mut notices = Vec::new();
        let mut pieces = fragment(link).split('&').filter(|p| !p.trim().is_empty());
        let mut pairs: Vec<(String, String)> = pieces
            .by_ref()
            .take(PAIRS)
            .map(|piece| piece.split_once('=').unwrap_or((piece, "")))
            .map(|(key, value)| (decode(key).trim().to_ascii_lowercase(), decode(value)))
            .collect();
        if pieces.next().is_some() {
            notices.push(Notice::new(Code::FirstValues).with("n", PAIRS));
        }
        notices.extend(take_version(&mut pairs));
        let pairs: Vec<(String, String)> = pairs.into_iter().flat_map(modern).collect();

        let mut recipe = Recipe::default();
        // The limits of the cell size and the polygon's units hang on the picture's size, some
        // defaults on the kind of stone.
        let first = [Key::Size, Key::Stone].map(|key| key.parameter().key);
        for early in [true, false] {
            for (index, (key, value)) in pairs.iter().enumerate() {
                if first.contains(&key.as_str()) == early {
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

    /// The fragment without `#`; empty for the default recipe.
    pub fn link(&self) -> String {
        let mut link = String::new();
        for key in differing(self) {
            if link.is_empty() {
                link = format!("v={VERSION}");
            }
            link += &format!("&{}={}", key.parameter().key, self.text(key));
        }
        link
    }

    /// Takes one pair of a link.
    fn read(
        &mut self,
        key: &str,
        value: &str,
        repeated: bool,
        pairs: &[(String, String)],
    ) -> Vec<Notice> {
        let known = Key::from_word(key);
        let mut notices = Vec::new();
        if let (Some(known), true) = (known, repeated) {
            notices.push(Notice::new(Code::Repeated).with("what", known.parameter()));
        }
        let outline = pairs.iter().rfind(|(key, _)| key == "outline");
        match (known, outline) {
            // The points themselves choose the polygon.
            (Some(Key::Outline), _) if value.trim().eq_ignore_ascii_case(POLYGON) => {
                if !pairs.iter().any(|(key, _)| key == "poly") {
                    let what = Key::Outline.parameter();
                    let notice = Notice::new(Code::PointsMissing).with("what", what);
                    let notice = notice.with("is", chosen(what, POLYGON));
                    let notice = notice.with("points", Key::Poly.parameter());
                    notices.push(notice.with("kept", self.shown(Key::Outline)));
                }
            }
            (Some(Key::Poly), Some((_, word))) if !word.trim().eq_ignore_ascii_case(POLYGON) => {
                let what = Key::Outline.parameter();
                let notice = Notice::new(Code::PointsDropped).with("what", what);
                let notice = notice.with("points", Key::Poly.parameter());
                let notice = notice.with("needed", chosen(what, POLYGON));
                notices.push(notice.with("is", chosen(what, &word.trim().to_ascii_lowercase())));
            }
            _ => match self.set(key, value) {
                Ok(mended) => notices.extend(mended),
                Err(why) => notices.push(why),
            },
        }
        notices
    }
}

/// The part of an address that holds the recipe: after `#`, or after `?` where there is no `#`.
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

/// Undoes percent-encoding; what is not encoded well stays as it is.
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

/// Takes the version out of the pairs; a notice where it is not one that this program writes.
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

/// Other words for outlines, in links only.
const OUTLINE_WORDS: [(&str, &str); 8] = [
    ("road", "road_straight"),
    ("s_curve", "road_s"),
    ("spiral", "road_spiral"),
    ("ring", "annulus"),
    ("fork", "y_fork"),
    ("notch", "road_notch"),
    ("l", "l_shape"),
    ("free", "polygon"),
];

/// Old and other words become those of the schema: the place where links of former versions are
/// brought up to date. The one bevel ratio Br of the 2001 paper is both of ours.
fn modern((key, value): (String, String)) -> Vec<(String, String)> {
    match key.as_str() {
        "br" => ["bh", "bv"].map(|k| (k.to_owned(), value.clone())).to_vec(),
        "outline" => {
            let word = value.trim().to_ascii_lowercase();
            let modern = OUTLINE_WORDS.iter().find(|(old, _)| *old == word);
            vec![(key, modern.map_or(value, |(_, new)| (*new).to_owned()))]
        }
        _ => vec![(key, value)],
    }
}
