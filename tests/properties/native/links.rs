//! Links: every recipe is restored from its own link, and no text of a link can break a recipe.

use crate::common::{star, valid};
use bubblestone::domain::Outline;
use bubblestone::generators::pavement::{self, PavementRecipe, SCHEMA, keys};
use bubblestone::notice::text;
use bubblestone::random::{Purpose, Random};
use bubblestone::recipe::{Kind, Recipe};
use glam::DVec2;
use proptest::prelude::*;

/// A link may contain words of the view. They do not enter the recipe, and give no notice.
#[test]
fn the_view_of_a_link_is_nothing_to_the_recipe() {
    for view in [
        "view=mesh+forces&pace=0.25&step=12&zoom=2.5,0.31,0.62&camera=330,38",
        "VIEW=nonsense&Step=&zoom&%70ace=-1&step=12&step=13",
    ] {
        for link in [
            format!("#v=1&cs=18&{view}"),
            format!("{view}&cs=18"),
            format!("https://example.org/?embed#{view}&cs=18"),
        ] {
            let (recipe, notices) = open(&link);
            assert_eq!(
                (recipe.link().as_str(), notices.as_str()),
                ("v=1&cs=18", ""),
                "{link}"
            );
        }
    }
}

pub(super) fn open(link: &str) -> (Recipe, String) {
    let (recipe, notices) = pavement::recipe(link);
    valid(&recipe);
    (recipe, text(&notices))
}

#[test]
fn the_default_has_an_empty_link() {
    assert_eq!(pavement::recipe("").0.link(), "");
    for link in [
        "",
        "#",
        "  ",
        "v=1",
        "#v=1",
        "https://example.org/",
        "https://example.org/#",
        "&&",
    ] {
        assert_eq!(
            pavement::recipe(link),
            (pavement::recipe("").0, vec![]),
            "{link}"
        );
    }
}

#[test]
fn links_may_be_addresses_fragments_or_queries() {
    for link in [
        "https://example.org/stones/?x=1#v=1&cs=18",
        "#v=1&cs=18",
        "v=1&cs=18",
        "cs=18",
        "?cs=18",
        "https://example.org/?cs=18",
        " #CS=18 ",
        "#%63s=%318",
        "cs=1.8e1",
        "cs=+18",
    ] {
        let (recipe, notices) = open(link);
        assert_eq!(
            (recipe.link().as_str(), notices.as_str()),
            ("v=1&cs=18", ""),
            "{link}"
        );
    }
}

#[test]
fn other_words_are_brought_up_to_date() {
    for (link, canonical) in [
        ("outline=ring", ""),
        ("outline=road", "v=1&outline=road_straight"),
        ("outline=s_curve", "v=1&outline=road_s"),
        ("outline=Spiral", "v=1&outline=road_spiral"),
        ("outline=fork", "v=1&outline=y_fork"),
        ("outline=notch", "v=1&outline=road_notch"),
        ("outline=l", "v=1&outline=l_shape"),
        ("br=0.3", "v=1&bh=0.3&bv=0.3"),
    ] {
        let (recipe, notices) = open(link);
        assert_eq!(
            (recipe.link().as_str(), notices.as_str()),
            (canonical, ""),
            "{link}"
        );
    }
}

#[test]
fn golden_links_keep_their_meaning() {
    let lines = include_str!("../../golden/links.txt").lines();
    for line in lines.filter(|line| !line.starts_with('#') && !line.is_empty()) {
        let [notices, canonical, link]: [&str; 3] = line
            .split(' ')
            .collect::<Vec<_>>()
            .try_into()
            .unwrap_or_else(|_| panic!("three words: {line}"));
        let (recipe, told) = pavement::recipe(link);
        assert_eq!(
            recipe.link(),
            canonical.replace('-', ""),
            "{link}: {told:?}"
        );
        assert_eq!(told.len().to_string(), notices, "{link}: {told:?}");
    }
}

#[test]
fn a_hundred_points_make_a_short_link_with_the_same_bits() {
    let radii: Vec<f64> = (0..100)
        .map(|k| 0.6 + 0.3 * f64::from(k * 37 % 100) / 100.0)
        .collect();
    let hole: Vec<DVec2> = star(512.0, &[0.2; 20]).into_iter().rev().collect();
    for side in ["128", "512", "700", "2048"] {
        let mut recipe = pavement::recipe("").0;
        recipe.set("size", side).unwrap();
        let outline = Outline {
            rings: vec![
                star(recipe.side(), &radii),
                hole.iter().map(|p| *p * recipe.side() / 512.0).collect(),
            ],
            ..Outline::default()
        };
        assert_eq!(recipe.set_polygon(&outline), Ok(vec![]));
        let link = recipe.link();
        assert!(link.len() < 1000, "{} characters", link.len());
        assert_eq!(pavement::recipe(&link), (recipe.clone(), vec![]));
        let taken = recipe.outline();
        let moved = outline.rings[0].iter().zip(&taken.rings[0]);
        let most = moved.map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
        assert!(most <= recipe.side() / 32768.0, "moved by {most}");
    }
}

/// Random points in the picture.
fn anywhere(random: &mut Random, count: usize) -> Vec<[f64; 2]> {
    (0..count).map(|_| [random.unit(), random.unit()]).collect()
}

/// A star of `count` points with random radii.
fn jagged(random: &mut Random, side: f64, count: usize) -> Vec<DVec2> {
    let radii: Vec<f64> = (0..count).map(|_| 0.2 + 0.78 * random.unit()).collect();
    star(side, &radii)
}

/// The longest links: a hundred rough points, and a hundred more in lines, strokes and spots.
#[test]
fn links_of_hundreds_of_points_stay_below_two_thousand_characters() {
    let mut random = Random::new(1, Purpose::Noise, 0);
    for side in ["512", "2048"] {
        let mut recipe = pavement::recipe("").0;
        recipe.set("size", side).unwrap();
        let ring = jagged(&mut random, recipe.side(), 100);
        recipe
            .set_polygon(&Outline {
                rings: vec![ring],
                ..Outline::default()
            })
            .unwrap();
        let link = recipe.link();
        assert!(link.len() < 900, "{} characters", link.len());
        let rows = |points: &[[f64; 2]], tail: &str| -> String {
            let rows = points.iter().map(|[x, y]| format!("{x},{y}{tail}"));
            rows.collect::<Vec<_>>()
                .join(if tail.is_empty() { "," } else { ";" })
        };
        for (key, count, tail) in [
            ("lines", 40, ""),
            ("strokes", 40, ""),
            ("spots", 20, ",0.1234,1.371"),
        ] {
            let points = anywhere(&mut random, count);
            recipe.set(key, &rows(&points, tail)).unwrap();
        }
        let link = recipe.link();
        assert!(link.len() < 2000, "{} characters", link.len());
        println!("{side}: {}", link.len());
        assert_eq!(pavement::recipe(&link), (recipe, vec![]));
    }
}

/// Letters give outlines of many rings.
#[test]
fn outlines_of_many_rings_come_back_from_the_link() {
    let mut random = Random::new(2, Purpose::Noise, 0);
    let mut recipe = pavement::recipe("").0;
    let ring = |random: &mut Random, k: usize| {
        let at = DVec2::new((k % 4) as f64, (k / 4) as f64) * 128.0;
        let small = jagged(random, 120.0, 9);
        small.into_iter().map(|p| p + at).collect()
    };
    let rings = (0..16).map(|k| ring(&mut random, k)).collect();
    recipe
        .set_polygon(&Outline {
            rings,
            ..Outline::default()
        })
        .unwrap();
    assert_eq!(recipe.outline().rings.len(), 16);
    let (back, notices) = pavement::recipe(&recipe.link());
    assert_eq!(notices, vec![]);
    assert_eq!(back.outline(), recipe.outline());
}

#[test]
fn numbers_are_written_as_short_as_can_be() {
    let mut recipe = pavement::recipe("").0;
    for (given, text) in [
        ("0.10000000000000000555", "0.1"),
        ("0.30", "0.3"),
        ("5e-324", "5e-324"),
        ("-0", "0"),
        ("1e-7", "1e-7"),
    ] {
        assert_eq!(recipe.set("vs", given), Ok(vec![]));
        assert_eq!(recipe.get("vs"), text);
    }
    assert_eq!(recipe.get("nothing"), "");
    assert_eq!(recipe.get("poly"), "");
    assert_eq!(recipe.get("stone"), "cobble");
}

#[test]
fn lists_are_read_in_decimals_and_written_compactly() {
    let link = "lines=0.25,0.25,0.75,0.5;0,1,1,0&parts=0.5,0.75,3&spots=.5,.5,.25,.2;1,1,.1,3\
                &strokes=0.1,0.1,0.9,0.1,0.9,0.9&stretch=0.5,0.5,0.25,2.5&size=1024";
    let (mut recipe, notices) = open(link);
    assert_eq!(notices, "");
    assert_eq!(
        recipe.lines(),
        [
            vec![DVec2::splat(256.0), DVec2::new(768.0, 512.0)],
            vec![DVec2::new(0.0, 1024.0), DVec2::new(1024.0, 0.0)],
        ]
    );
    assert_eq!(recipe.outline().lines, recipe.lines());
    assert_eq!(
        recipe.seeds(keys::PARTS),
        [(DVec2::new(512.0, 768.0), "ellipse")]
    );
    assert_eq!(recipe.list(keys::PARTS), [[0.5, 0.75, 3.0]]);
    assert_eq!(
        recipe.list(keys::SPOTS)[1],
        [1.0, 1.0, 3277.0 / 32768.0, 3.0]
    );
    assert_eq!(recipe.list(keys::LINES)[0], [0.25, 0.25, 0.75, 0.5]);
    assert!(recipe.list(keys::CS).is_empty());
    assert_eq!(
        recipe.spots(keys::SPOTS)[0],
        [512.0, 512.0, 256.0, 205.0 / 1024.0]
    );
    assert_eq!(recipe.spots(keys::SPOTS)[1][3], 3.0);
    assert_eq!(recipe.spots(keys::STRETCH), [[512.0, 512.0, 256.0, 2.5]]);
    assert_eq!(recipe.polylines(keys::STROKES)[0].len(), 3);
    // The compact form gives the same values again, at any side of the picture.
    let (mut back, notices) = open(&recipe.link());
    assert_eq!((&back, notices.as_str()), (&recipe, ""));
    assert!(recipe.link().len() < 200, "{}", recipe.link());
    back.set("size", "512").unwrap();
    assert_eq!(back.lines()[0][0], DVec2::splat(128.0));
    // An empty text clears a list.
    assert_eq!(recipe.set("strokes", ""), Ok(vec![]));
    assert!(recipe.polylines(keys::STROKES).is_empty());
}

/// A value for a parameter: a number in its range, an end of the range, or a word.
fn value(index: usize, t: f64) -> String {
    let row = &SCHEMA.rows[index];
    match row.kind {
        Kind::Number => format!("{}", row.min + t * (row.max - row.min)),
        Kind::Int => format!("{}", (row.min + t * (row.max - row.min)).round()),
        Kind::Choice => {
            let place = (t * row.choices.len() as f64) as usize;
            row.choices[place.min(row.choices.len() - 1)]
                .word
                .to_owned()
        }
        Kind::Text if row.key == keys::POLY => String::new(),
        Kind::Text => match row.key.0 {
            "parts" => format!("{t},0.5,{}", (t * 3.0).round()),
            "spots" => format!("{t},0.5,0.1,{};0.5,0.5,0.2,0.2", 1.0 + t),
            "stretch" => format!("{t},0.5,0.1,{}", 1.0 + t),
            _ => format!("{t},0.5,0.1,2;0.5,{t},0.25,0.125,0.9,0.1"),
        }
        .replace(",2;", ",0.2;"),
    }
}

proptest! {
    #[test]
    fn recipes_round_trip(
        values in prop::collection::vec((0..SCHEMA.rows.len(), prop_oneof![Just(0.0), Just(1.0), 0.0..1.0f64]), 0..30),
        radii in prop::option::of(prop::collection::vec(0.1..0.95f64, 3..40)),
    ) {
        let mut recipe = pavement::recipe("").0;
        for (index, t) in values {
            let _ = recipe.set(SCHEMA.rows[index].key.0, &value(index, t));
        }
        if let Some(radii) = radii {
            let outer = star(recipe.side(), &radii);
            recipe.set_polygon(&Outline { rings: vec![outer], ..Outline::default() }).unwrap();
        }
        valid(&recipe);
        let link = recipe.link();
        let (back, notices) = pavement::recipe(&link);
        prop_assert_eq!(&notices, &vec![], "{}", link);
        prop_assert_eq!(back.link(), link);
        prop_assert_eq!(back.outline(), recipe.outline());
        for row in SCHEMA.rows.iter().filter(|row| row.key != keys::POLY) {
            prop_assert_eq!(back.get(row.key.0), recipe.get(row.key.0), "{}", row.key.0);
        }
    }

    #[test]
    fn no_text_breaks_a_recipe(link in ".{0,80}") {
        valid(&pavement::recipe(&link).0);
    }

    #[test]
    fn no_value_breaks_a_recipe(index in 0..SCHEMA.rows.len(), text in "[-+.0-9eEinfaNA-Z%_!]{0,24}") {
        let (recipe, _) = pavement::recipe(&format!("{}={text}", SCHEMA.rows[index].key.0));
        valid(&recipe);
        prop_assert_eq!(pavement::recipe(&recipe.link()), (recipe, vec![]));
    }

    #[test]
    fn numbers_keep_their_bits(x in 0.0..0.5f64, y in -0.8..0.8f64) {
        let mut recipe = pavement::recipe("").0;
        recipe.set("vs", &format!("{x:e}")).unwrap();
        recipe.set("gx", &format!("{y:e}")).unwrap();
        let back = pavement::recipe(&recipe.link()).0;
        prop_assert_eq!(back.number(keys::VS).to_bits(), x.to_bits());
        prop_assert_eq!(back.number(keys::GX).to_bits(), (y + 0.0).to_bits());
    }
}
