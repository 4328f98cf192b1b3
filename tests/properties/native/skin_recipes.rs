//! Recipes of skin: some numbers have another default while the stones are skin cells.

use bubblestone::generators::pavement::{self, SCHEMA};
use bubblestone::recipe::{Parameter, Recipe};

/// The parameters whose default differs for skin: the default for stones, the default for skin.
const OWN: [(&str, f64, f64); 4] = [
    ("sv", 1.0, 1.4),
    ("dr", 0.3, 0.05),
    ("fd", 1.5, 1.1),
    ("af", 2.0, 0.1),
];

fn open(link: &str) -> Recipe {
    let (recipe, notices) = pavement::recipe(link);
    assert!(notices.is_empty(), "{link}: {notices:?}");
    recipe
}

fn number(recipe: &Recipe, word: &str) -> f64 {
    recipe.number(SCHEMA.row(word).expect(word).key)
}

#[test]
fn the_schema_has_these_defaults_of_skin_and_no_others() {
    let is_own = |row: &&Parameter| row.default_while.is_some_and(|(key, ..)| key.0 == "stone");
    let own = SCHEMA.rows.iter().filter(is_own);
    assert_eq!(own.count(), OWN.len());
    let (stone, skin) = (pavement::recipe("").0, open("stone=skin"));
    for row in SCHEMA.rows {
        let key = row.key.0;
        let (plain, other) = OWN
            .iter()
            .find(|(word, ..)| *word == key)
            .map_or((row.default, row.default), |&(_, plain, other)| {
                (plain, other)
            });
        assert_eq!(stone.default_of(row), plain, "{key}");
        assert_eq!(skin.default_of(row), other, "{key}");
        assert!(row.min <= other && other <= row.max, "{key}");
        if key != "stone" {
            assert_eq!(skin.number(row.key), other, "{key}");
        }
    }
}

#[test]
fn a_link_of_skin_says_what_differs_from_the_defaults_of_skin() {
    for (link, canonical) in [
        ("stone=skin", "v=1&stone=skin"),
        ("stone=skin&sv=1.4&dr=0.05&fd=1.1&af=0.1", "v=1&stone=skin"),
        ("stone=skin&sv=1", "v=1&stone=skin&sv=1"),
        ("sv=1&stone=skin", "v=1&stone=skin&sv=1"),
        (
            "af=2&fd=1.5&stone=skin&dr=0.3",
            "v=1&stone=skin&dr=0.3&fd=1.5&af=2",
        ),
        ("sv=1.4", "v=1&sv=1.4"),
        ("sv=1.4&stone=flag&dr=0.05", "v=1&stone=flag&sv=1.4&dr=0.05"),
        ("sv=1&stone=cobble&af=2", ""),
    ] {
        let recipe = open(link);
        assert_eq!(recipe.link(), canonical, "{link}");
        assert_eq!(open(canonical), recipe, "{link}");
    }
}

#[test]
fn the_order_of_a_links_pairs_does_not_matter() {
    let pairs = [
        "cs=17",
        "sv=1",
        "af=0.3",
        "stone=skin",
        "tc=0.5",
        "size=384",
    ];
    let straight = open(&pairs.join("&"));
    assert_eq!(number(&straight, "sv"), 1.0);
    assert_eq!(number(&straight, "dr"), 0.05);
    for turn in 1..pairs.len() {
        let mut turned = pairs;
        turned.rotate_left(turn);
        assert_eq!(open(&turned.join("&")), straight, "{turned:?}");
        turned.reverse();
        assert_eq!(open(&turned.join("&")), straight, "{turned:?}");
    }
}

#[test]
fn a_stone_named_twice_leaves_the_defaults_of_the_last() {
    for (link, canonical) in [
        ("stone=skin&stone=flag&cs=18", "v=1&cs=18&stone=flag"),
        ("stone=flag&sv=1&stone=skin", "v=1&stone=skin&sv=1"),
        ("stone=skin&stone=brick", "v=1&stone=skin"),
    ] {
        let (recipe, notices) = pavement::recipe(link);
        assert!(!notices.is_empty(), "{link}");
        assert_eq!(recipe.link(), canonical, "{link}");
    }
}

#[test]
fn untouched_numbers_go_over_to_the_other_defaults_and_back() {
    let mut recipe = pavement::recipe("").0;
    for stone in ["skin", "flag", "skin", "skin", "cobble"] {
        assert_eq!(recipe.set("stone", stone), Ok(vec![]));
        for (word, plain, own) in OWN {
            let wanted = if stone == "skin" { own } else { plain };
            assert_eq!(number(&recipe, word), wanted, "{word} of {stone}");
        }
    }
    assert_eq!(recipe, pavement::recipe("").0);
}

#[test]
fn numbers_that_were_changed_stay_whatever_the_stone() {
    let mut recipe = pavement::recipe("").0;
    recipe.set("dr", "0.2").unwrap();
    recipe.set("stone", "skin").unwrap();
    assert_eq!(recipe.link(), "v=1&stone=skin&dr=0.2");
    recipe.set("af", "2").unwrap();
    assert_eq!(recipe.link(), "v=1&stone=skin&dr=0.2&af=2");
    recipe.set("stone", "flag").unwrap();
    assert_eq!(recipe.link(), "v=1&stone=flag&dr=0.2");
    assert_eq!(number(&recipe, "sv"), 1.0);
}
