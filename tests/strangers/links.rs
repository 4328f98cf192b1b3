//! Links with values from anywhere in their ranges, nonsense, and damage.

use crate::common::number;
use bubblestone::generators::surface::{SCHEMA, keys};
use bubblestone::generators::{ALL, masonry, pile};
use bubblestone::random::Random;
use bubblestone::recipe::{Item, Key, Kind, Parameter, Schema};
use std::fmt::Write;

/// Texts that are not valid for any parameter, or hardly.
const NONSENSE: [&str; 16] = [
    "",
    "NaN",
    "-inf",
    "1e999",
    "-0",
    "0x10",
    "1,,2",
    ";;;",
    "%00%ff",
    "AAAA",
    "gggBgggB",
    "!",
    "0.5,0.5,0.5",
    "0.5,0.5,0.5,-1,NaN",
    "9,9,9,9,9",
    "99999999999999999999",
];

/// Places in the box around the model, or somewhat outside it.
fn places(random: &mut Random, count: usize) -> String {
    let numbers = (0..3 * count).map(|_| (1.2 * random.unit() - 0.1).to_string());
    numbers.collect::<Vec<_>>().join(",")
}

/// Corners of a plan: a line that turns at random, and may cross itself.
fn corners(random: &mut Random) -> String {
    let mut at = [0.0, 0.0];
    let corners = (0..2 + random.below(9)).map(|_| {
        let axis = random.below(2);
        at[axis] += number(random, (-40.0, 40.0)).round();
        at[1 - axis] += [0.0, 0.0, 0.5, 7.0][random.below(4)];
        format!("{},{}", at[0], at[1])
    });
    corners.collect::<Vec<_>>().join(",")
}

/// An opening of one of the first walls, usually within it.
fn opening(random: &mut Random) -> String {
    let (wall, head) = (1 + random.below(5), random.below(4));
    let [along, sill, width, height] =
        [30.0, 12.0, 12.0, 20.0].map(|most| number(random, (0.0, most)).round());
    format!("{wall},{along},{sill},{width},{height},{head}")
}

/// Rows of a list: a few, the most allowed, or one more.
fn rows(random: &mut Random, item: Item) -> String {
    let count = [1, 3, 64, 65][random.below(4)];
    let rows = (0..count).map(|_| match item {
        Item::Patch(min, max) => {
            let radius = number(random, (0.01, 2.0));
            format!(
                "{},{radius},{}",
                places(random, 1),
                number(random, (min, max))
            )
        }
        Item::File => "1,2,3,4,97".to_owned(),
        Item::Feature => format!("{},{}", random.below(3), random.below(100)),
        Item::Plan => corners(random),
        Item::Opening => opening(random),
        _ => {
            let points = [1, 2, 4, 30][random.below(4)];
            places(random, points)
        }
    });
    rows.collect::<Vec<_>>().join(";")
}

/// A value from anywhere in its range, or nonsense.
fn text(random: &mut Random, row: &Parameter) -> String {
    if random.below(12) == 0 {
        return NONSENSE[random.below(NONSENSE.len())].to_owned();
    }
    match (row.kind, row.item) {
        (Kind::Choice, _) => row.choices[random.below(row.choices.len())].word.to_owned(),
        (Kind::Text, Some(item)) => rows(random, item),
        _ => number(random, (row.min, row.max)).to_string(),
    }
}

/// A link with some parameters far from their defaults, and few cells, so that it takes little time.
pub fn wild(random: &mut Random) -> String {
    let fixed = [keys::SIZE, keys::CN, keys::MODEL];
    let mut link = wild_of(random, &SCHEMA, keys::FORM, &fixed);
    write!(link, "&size=128&cn={}", number(random, (30.0, 120.0))).unwrap();
    link
}

/// The same for a pile of few bodies.
pub fn wild_pile(random: &mut Random) -> String {
    let fixed = [
        keys::SIZE,
        pile::keys::PS,
        keys::MODEL,
        pile::keys::VARIANTS,
    ];
    let mut link = wild_of(random, &pile::SCHEMA, pile::keys::C1, &fixed);
    write!(
        link,
        "&size=128&variants=2&ps={}",
        number(random, (3.0, 7.0))
    )
    .unwrap();
    link
}

/// The same for a building.
pub fn wild_building(random: &mut Random) -> String {
    let fixed = [masonry::keys::SIZE, masonry::keys::MODEL];
    let mut link = wild_of(random, &masonry::SCHEMA, masonry::keys::BUILDING, &fixed);
    link += "&size=128";
    link
}

/// A link with some values from anywhere, that of `always` among them, but none of `never`.
fn wild_of(random: &mut Random, schema: &Schema, always: Key, never: &[Key]) -> String {
    let mut link = format!("make={}", schema.word);
    let share = random.unit();
    for row in schema.rows {
        let is_fixed = never.contains(&row.key);
        if !is_fixed && (row.key == always || random.unit() < share) {
            write!(link, "&{}={}", row.key.0, text(random, row)).unwrap();
        }
    }
    link
}

/// A damaged link: that of a preset, or one with values from anywhere, in which letters are changed, taken out, doubled
/// or put elsewhere.
pub fn broken_link(random: &mut Random) -> String {
    let mut link = match random.below(3) {
        0 => wild(random).into_bytes(),
        _ => {
            let presets: Vec<_> = ALL.iter().flat_map(|one| one.presets).collect();
            let preset = presets[random.below(presets.len())];
            preset.link.as_bytes().to_vec()
        }
    };
    for _ in 0..1 + random.below(6) {
        if link.is_empty() {
            break;
        }
        let at = random.below(link.len());
        let end = (at + 1 + random.below(12)).min(link.len());
        match random.below(6) {
            0 => link[at] = random.bits() as u8,
            1 => link[at] = b"0123456789&=,;.-+e%#AZ"[random.below(22)],
            2 => drop(link.drain(at..end)),
            3 => {
                let piece = link[at..end].repeat([1, 2, 40][random.below(3)]);
                link.splice(at..at, piece);
            }
            4 => link.truncate(at),
            _ => {
                let word = NONSENSE[random.below(NONSENSE.len())];
                link.splice(at..end, word.bytes());
            }
        }
    }
    String::from_utf8_lossy(&link).into_owned()
}
