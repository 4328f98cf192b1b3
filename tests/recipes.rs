//! Recipes: the schema, the presets, the polygon, and what a change makes stale.

mod common;

use bubblestone::domain::Outline;
use bubblestone::recipe::{Key, Kind, PRESETS, Parameter, Recipe, SCHEMA};
use common::{star, valid};
use glam::DVec2;

#[test]
fn the_schema_is_consistent() {
    for (&key, row) in Key::ALL.iter().zip(SCHEMA) {
        assert_eq!(key.parameter(), row);
        assert_eq!(Key::from_word(row.key), Some(key));
        assert!(!row.name.is_empty() && !row.group.is_empty() && row.help.ends_with('.'));
        match row.kind {
            Kind::Number | Kind::Int => {
                assert!(row.min <= row.default && row.default <= row.max && row.step > 0.0);
            }
            Kind::Choice => assert!(!row.choices.is_empty()),
            Kind::Text => {}
        }
        if let Some((other, words)) = row.shown_for {
            assert!(
                words.iter().all(|w| other.parameter().choice(w).is_some()),
                "{}",
                row.key
            );
        }
    }
    let mut keys: Vec<&str> = SCHEMA.iter().map(|row| row.key).collect();
    keys.push("v");
    keys.sort_unstable();
    assert!(keys.windows(2).all(|w| w[0] != w[1]), "a key twice");
    let default = Recipe::default();
    valid(&default);
    assert_eq!(
        default.limits(Key::Cs),
        (Key::Cs.parameter().min, Key::Cs.parameter().max)
    );
}

/// A link leaves out what has its default: with another default, every link that was ever shared
/// shows another pavement. Where that is meant, links need a new version, and this file its line.
#[test]
fn defaults_are_those_that_links_rely_on() {
    let recipe = Recipe::default();
    let line = |row: &Parameter| format!("{}={}", row.key, recipe.get(row.key));
    let found: Vec<String> = SCHEMA.iter().map(line).collect();
    let golden = include_str!("golden/defaults.txt").lines();
    let golden: Vec<&str> = golden.filter(|line| !line.starts_with('#')).collect();
    assert_eq!(found, golden);
}

#[test]
fn presets_are_canonical() {
    let mut names: Vec<&str> = PRESETS.iter().map(|p| p.name).collect();
    names.sort_unstable();
    assert!(names.windows(2).all(|w| w[0] != w[1]));
    assert_eq!(PRESETS.iter().filter(|p| !p.figure.is_empty()).count(), 27);
    for preset in PRESETS {
        let (recipe, notices) = Recipe::from_link(preset.link);
        valid(&recipe);
        assert_eq!((recipe.link().as_str(), notices), (preset.link, vec![]));
        assert!(preset.timing.is_none() || !preset.figure.is_empty());
    }
    let timed = PRESETS.iter().filter(|p| p.timing.is_some()).count();
    assert_eq!(timed, 14 + 6);
}

/// Table 1 of the papers, in the order Cs, Vs, Hs, Sv, Dr, Fd, Af.
#[test]
fn presets_of_the_papers_have_the_parameters_of_table_1() {
    let table = [
        ("fig13-1b", [23.0, 0.0, 18.0, 1.0, 0.3, 1.5, 2.0], false),
        ("fig13-2b", [18.0, 0.1, 18.0, 1.0, 0.3, 1.5, 2.0], false),
        ("fig13-3b", [23.0, 0.3, 18.0, 1.0, 0.3, 1.5, 2.0], false),
        ("fig14-b", [20.0, 0.0, 20.0, 1.0, 0.3, 1.5, 2.0], false),
        ("fig14-c", [20.0, 0.0, 12.0, 1.0, 0.2, 1.4, 1.4], true),
        ("fig15-a", [23.0, 0.0, 20.0, 1.1, 0.3, 1.5, 2.0], false),
        ("fig15-b", [23.0, 0.0, 20.0, 1.1, 0.0, 1.5, 2.0], false),
        ("fig15-c", [23.0, 0.0, 20.0, 1.1, 0.6, 1.5, 2.0], false),
        ("fig16-a", [21.0, 0.0, 18.0, 1.0, 0.3, 1.5, 2.0], false),
        ("fig16-b", [25.0, 0.0, 20.0, 1.0, 0.5, 1.5, 2.0], false),
        ("fig16-c", [15.0, 0.0, 8.0, 1.0, 0.2, 1.3, 1.0], true),
        ("fig16-d", [23.0, 0.0, 14.0, 1.1, 0.3, 1.5, 2.0], true),
        ("fig16-e", [20.0, 0.0, 12.0, 1.0, 0.2, 1.3, 1.2], true),
        ("fig16-f", [20.0, 0.0, 18.0, 0.8, 0.3, 1.5, 2.0], false),
    ];
    let keys = [
        Key::Cs,
        Key::Vs,
        Key::Hs,
        Key::Sv,
        Key::Dr,
        Key::Fd,
        Key::Af,
    ];
    for (name, row, flag) in table {
        let preset = PRESETS.iter().find(|p| p.name == name).expect(name);
        let recipe = preset.recipe();
        assert_eq!(keys.map(|key| recipe.number(key)), row, "{name}");
        assert_eq!(recipe.choice(Key::Stone) == "flag", flag, "{name}");
        assert_eq!(
            (recipe.number(Key::Bh), recipe.number(Key::Bv)),
            (0.2, 0.2),
            "{name}"
        );
        assert_eq!(recipe.number(Key::Size), 512.0, "{name}");
    }
}

/// Table 1 of the paper on skins, in the order Ca, Sv, Sr, Sc, Tc, Dr, Fd, Af, and the seconds of its
/// Table 2.
#[test]
fn presets_of_the_skins_have_the_parameters_of_table_1() {
    let table = [
        (
            "14-a",
            [1.5, 1.4, 1.0, 0.0, 0.2, 0.0, 1.1, 0.1],
            Some([31.0, 5.3]),
        ),
        (
            "14-b",
            [2.0, 1.4, 1.0, 0.0, 0.2, 0.0, 1.1, 0.1],
            Some([34.0, 4.2]),
        ),
        (
            "14-c",
            [3.0, 1.4, 1.0, 0.0, 0.2, 0.0, 1.1, 0.1],
            Some([32.0, 3.8]),
        ),
        ("15-a", [2.0, 1.4, 2.0, 0.0, 0.8, 0.05, 1.1, 0.2], None),
        ("15-b", [2.0, 1.4, 2.0, 2.0, 0.8, 0.05, 1.1, 0.2], None),
        ("15-c", [2.0, 1.4, 2.0, 3.0, 0.8, 0.05, 1.1, 0.2], None),
        ("16-a", [2.0, 1.3, 1.0, 0.0, 0.0, 0.05, 1.1, 0.1], None),
        ("16-b", [2.0, 1.3, 1.0, 0.0, 0.2, 0.05, 1.1, 0.1], None),
        ("16-c", [2.0, 1.3, 1.0, 0.0, 0.5, 0.05, 1.1, 0.1], None),
        ("17-a", [2.0, 3.0, 1.0, 2.0, 0.7, 0.05, 1.1, 0.1], None),
        (
            "17-b",
            [2.0, 1.4, 0.8, 0.0, 0.2, 0.05, 1.1, 0.1],
            Some([32.0, 4.8]),
        ),
        (
            "17-c",
            [2.0, 1.6, 2.0, 0.0, 0.2, 0.1, 1.1, 0.1],
            Some([16.0, 4.0]),
        ),
        (
            "17-d",
            [2.0, 1.4, 1.0, 0.0, 0.1, 0.0, 1.1, 0.1],
            Some([10.0, 3.9]),
        ),
    ];
    let keys = [
        Key::Ca,
        Key::Sv,
        Key::Sr,
        Key::Sc,
        Key::Tc,
        Key::Dr,
        Key::Fd,
        Key::Af,
    ];
    for (row, numbers, seconds) in table {
        let name = format!("skin{row}");
        let preset = PRESETS.iter().find(|p| p.name == name).expect(row);
        let recipe = preset.recipe();
        assert_eq!(keys.map(|key| recipe.number(key)), numbers, "{name}");
        assert!(recipe.is_skin(), "{name}");
        assert_eq!(recipe.number(Key::Size), 512.0, "{name}");
        let timed = preset
            .timing
            .map(|timing| timing.parts.map(|part| part.seconds));
        assert_eq!(timed, seconds, "{name}");
        let kind = recipe.choice(Key::Kind);
        assert!(
            ["ellipse", "rectangle"].contains(&kind),
            "{name}: Ca has no effect on {kind}"
        );
        // Restriction lines in all of figure 17, both arrangements in one texture in (a) to (c).
        let seventeenth = row.starts_with("17");
        assert_eq!(!recipe.lines().is_empty(), seventeenth, "{name}");
        let mixed = recipe.part_kinds().iter().any(|&(_, other)| other != kind);
        assert_eq!(mixed, seventeenth && row != "17-d", "{name}");
    }
}

#[test]
fn the_polygon_scales_with_the_picture_there_and_back() {
    let mut recipe = Recipe::default();
    let outer = star(512.0, &[0.9, 0.4, 0.77, 0.33, 0.812, 0.5]);
    recipe
        .set_polygon(&Outline {
            rings: vec![outer],
            ..Outline::default()
        })
        .unwrap();
    let first = recipe.clone();
    for side in ["128", "777", "2048", "1023"] {
        recipe.set("size", side).unwrap();
        valid(&recipe);
        assert_eq!(Recipe::from_link(&recipe.link()).0, recipe);
    }
    recipe.set("size", "512").unwrap();
    assert_eq!(recipe.polygon(), first.polygon());
}

#[test]
fn choosing_polygon_starts_from_the_shape_shown() {
    for choice in Key::Outline.parameter().choices {
        let mut recipe = Recipe::default();
        assert_eq!(recipe.set("outline", choice.word), Ok(vec![]));
        let shown = recipe.outline();
        assert_eq!(recipe.set("outline", "polygon"), Ok(vec![]));
        assert_eq!(
            recipe.outline().rings[0].len(),
            shown.rings[0].len(),
            "{}",
            choice.word
        );
        assert_eq!(Recipe::from_link(&recipe.link()), (recipe, vec![]));
    }
}

#[test]
fn a_bad_polygon_leaves_the_recipe_as_it_was() {
    let mut recipe = Recipe::default();
    let outer = star(512.0, &[0.9, 0.4, 0.77]);
    recipe
        .set_polygon(&Outline {
            rings: vec![outer],
            ..Outline::default()
        })
        .unwrap();
    let before = recipe.clone();
    let p = |x: f64, y: f64| DVec2::new(x, y);
    let bow = vec![p(100., 100.), p(400., 400.), p(400., 100.), p(100., 300.)];
    let error = recipe
        .set_polygon(&Outline {
            rings: vec![bow],
            ..Outline::default()
        })
        .unwrap_err();
    assert!(error.to_string().contains("outer ring crosses"), "{error}");
    assert_eq!(recipe, before);
    assert!(recipe.set("poly", "junk!").is_err());
    assert_eq!(recipe, before);
}
