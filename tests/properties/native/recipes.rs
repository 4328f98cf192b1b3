//! Recipes: the schema, the presets, the polygon, and the stages that a change makes stale.

use crate::common::{star, valid};
use crate::paving::row;
use bubblestone::domain::Outline;
use bubblestone::generators::pavement::{self, PAVEMENT, PavementRecipe, SCHEMA, keys};
use bubblestone::generators::{ALL, Preset};
use bubblestone::recipe::{Key, Kind, Parameter, Recipe, VIEW};
use glam::DVec2;

#[test]
fn schemas_are_consistent() {
    for generator in ALL.iter() {
        let schema = generator.schema;
        let has = |key: Key, word: &str| {
            let choice = schema.row(key.0).expect(key.0);
            word.is_empty() || choice.choice(word).is_some()
        };
        for row in schema.rows {
            let key = row.key.0;
            assert!(
                std::ptr::eq(row, schema.row(key).expect(key)),
                "{key} twice"
            );
            let is_taken = ["v", "make"].contains(&key) || VIEW.contains(&key);
            assert!(!is_taken, "{key} is a word of the link");
            assert!(!row.name.is_empty() && !row.group.is_empty() && row.help.ends_with('.'));
            match row.kind {
                Kind::Number | Kind::Int => {
                    assert!(row.min <= row.default && row.default <= row.max && row.step > 0.0);
                }
                Kind::Choice => assert!(!row.choices.is_empty()),
                Kind::Text => assert!(row.item.is_some()),
            }
            if let Some((other, words)) = row.shown_for {
                assert!(schema.row(other.0).is_some(), "{key}: no {}", other.0);
                assert!(words.iter().all(|word| has(other, word)), "{key}");
            }
            assert!(
                row.drawn_for.is_none_or(|(other, word)| has(other, word)),
                "{key}"
            );
            assert!(
                row.default_while
                    .is_none_or(|(other, word, _)| has(other, word)),
                "{key}"
            );
        }
        assert_eq!(Recipe::new(schema).side(), 512.0);
    }
    let default = pavement::recipe("").0;
    valid(&default);
    let size = row(keys::CS);
    assert_eq!(default.limits(size), (size.min, size.max));
}

/// A link leaves out values equal to the defaults. If a default changes, every shared link shows another
/// picture. So an intended change needs a new version of links, and a change of the golden file.
#[test]
fn defaults_are_those_that_links_rely_on() {
    let recipe = pavement::recipe("").0;
    let line = |row: &Parameter| format!("{}={}", row.key.0, recipe.get(row.key.0));
    let found: Vec<String> = SCHEMA.rows.iter().map(line).collect();
    let golden = include_str!("../../golden/defaults.txt").lines();
    let golden: Vec<&str> = golden.filter(|line| !line.starts_with('#')).collect();
    assert_eq!(found, golden);
}

/// A row of the table of all keys.
fn described(row: &Parameter) -> String {
    let words = |row: &Parameter| {
        let words: Vec<String> = row
            .choices
            .iter()
            .map(|c| match c.word.parse::<f64>() {
                // A number says nothing without its label.
                Ok(_) => format!("`{}` {}", c.word, c.label),
                Err(_) => format!("`{}`", c.word),
            })
            .collect();
        words.join(", ")
    };
    let unit = match row.unit {
        "" | "°" => row.unit.to_owned(),
        unit => format!(" {unit}"),
    };
    let (values, default) = match row.kind {
        Kind::Choice => (words(row), format!("`{}`", row.choices[0].word)),
        Kind::Text => ("compact text".into(), String::new()),
        _ => (
            format!("{} to {}{unit}", row.min, row.max),
            match row.default_while {
                None => row.default.to_string(),
                Some((key, word, own)) => {
                    format!("{}; {own} while `{}={word}`", row.default, key.0)
                }
            },
        ),
    };
    let name = match row.symbol {
        "" => row.name.to_owned(),
        symbol => format!("{}, {symbol}", row.name),
    };
    format!(
        "| `{}` | {name} | {values} | {default} | {} |\n",
        row.key.0, row.help
    )
}

/// The table is generated from the schemas: `BUBBLESTONE_UPDATE=1 cargo test recipes`. The text after it is
/// written by hand.
#[test]
fn the_table_of_keys_is_that_of_the_schemas() {
    let mut table = "# The keys of a link\n".to_owned();
    for generator in ALL.iter() {
        let schema = generator.schema;
        let make = match schema.is_named {
            true => format!("`make={}`", schema.word),
            false => "links without `make`".to_owned(),
        };
        table += &format!("\n## {}\n\nIn {make}:\n", generator.title);
        let mut group = "";
        for row in schema.rows {
            if row.group != group {
                group = row.group;
                table += &format!(
                    "\n### {group}\n\n| key | name | values | default | what it does |\n|---|---|---|---|---|\n"
                );
            }
            table += &described(row);
        }
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/parameters.md");
    let found = std::fs::read_to_string(path).unwrap_or_default();
    let (found, view) = found.split_once("\n## The view\n").unwrap();
    if std::env::var_os("BUBBLESTONE_UPDATE").is_some() {
        std::fs::write(path, format!("{table}\n## The view\n{view}")).unwrap();
        return;
    }
    for line in table.lines() {
        assert!(
            found.lines().any(|other| other == line),
            "not in docs/parameters.md: {line}"
        );
    }
    for key in VIEW {
        assert!(view.contains(&format!("\n| `{key}` |")), "{key}");
    }
    assert_eq!(found.lines().count(), table.lines().count());
}

#[test]
fn presets_are_canonical() {
    let mut names: Vec<&str> = PAVEMENT.presets.iter().map(|p| p.name).collect();
    names.sort_unstable();
    assert!(names.windows(2).all(|w| w[0] != w[1]));
    assert_eq!(
        PAVEMENT
            .presets
            .iter()
            .filter(|p| !p.figure.is_empty())
            .count(),
        27
    );
    for preset in PAVEMENT.presets {
        let (recipe, notices) = pavement::recipe(preset.link);
        valid(&recipe);
        assert_eq!(notices, [], "{}", preset.name);
        assert!(preset.timing.is_none() || !preset.figure.is_empty());
    }
    let links = |p: &Preset| (p.name, p.link.to_owned(), pavement::recipe(p.link).0.link());
    let mut wrong: Vec<_> = PAVEMENT.presets.iter().map(links).collect();
    wrong.retain(|(_, link, canonical)| link != canonical);
    assert_eq!(wrong, []);
    let timed = PAVEMENT
        .presets
        .iter()
        .filter(|p| p.timing.is_some())
        .count();
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
        keys::CS,
        keys::VS,
        keys::HS,
        keys::SV,
        keys::DR,
        keys::FD,
        keys::AF,
    ];
    for (name, row, flag) in table {
        let preset = PAVEMENT
            .presets
            .iter()
            .find(|p| p.name == name)
            .expect(name);
        let recipe = pavement::recipe(preset.link).0;
        assert_eq!(keys.map(|key| recipe.number(key)), row, "{name}");
        assert_eq!(recipe.choice(keys::STONE) == "flag", flag, "{name}");
        assert_eq!(
            (recipe.number(keys::BH), recipe.number(keys::BV)),
            (0.2, 0.2),
            "{name}"
        );
        assert_eq!(recipe.number(keys::SIZE), 512.0, "{name}");
    }
}

/// Table 1 of the paper on skins, in the order Ca, Sv, Sr, Sc, Tc, Dr, Fd, Af, and the seconds of its Table 2.
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
        keys::CA,
        keys::SV,
        keys::SR,
        keys::SC,
        keys::TC,
        keys::DR,
        keys::FD,
        keys::AF,
    ];
    for (row, numbers, seconds) in table {
        let name = format!("skin{row}");
        let preset = PAVEMENT.presets.iter().find(|p| p.name == name).expect(row);
        let recipe = pavement::recipe(preset.link).0;
        assert_eq!(keys.map(|key| recipe.number(key)), numbers, "{name}");
        assert!(recipe.is_skin(), "{name}");
        assert_eq!(recipe.number(keys::SIZE), 512.0, "{name}");
        let timed = preset
            .timing
            .map(|timing| timing.parts().map(|part| part.seconds).collect::<Vec<_>>());
        assert_eq!(timed, seconds.map(|pair| pair.to_vec()), "{name}");
        let kind = recipe.choice(keys::KIND);
        assert!(
            ["ellipse", "rectangle"].contains(&kind),
            "{name}: Ca has no effect on {kind}"
        );
        // All of figure 17 has restriction lines; (a) to (c) have both arrangements in one texture.
        let seventeenth = row.starts_with("17");
        assert_eq!(!recipe.lines().is_empty(), seventeenth, "{name}");
        let mixed = recipe
            .seeds(keys::PARTS)
            .iter()
            .any(|&(_, other)| other != kind);
        assert_eq!(mixed, seventeenth && row != "17-d", "{name}");
    }
}

#[test]
fn the_polygon_scales_with_the_picture_there_and_back() {
    let mut recipe = pavement::recipe("").0;
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
        assert_eq!(pavement::recipe(&recipe.link()).0, recipe);
    }
    recipe.set("size", "512").unwrap();
    assert_eq!(recipe.polygon(), first.polygon());
}

#[test]
fn choosing_polygon_starts_from_the_shape_shown() {
    for choice in row(keys::OUTLINE).choices {
        let mut recipe = pavement::recipe("").0;
        assert_eq!(recipe.set("outline", choice.word), Ok(vec![]));
        let shown = recipe.outline();
        assert_eq!(recipe.set("outline", "polygon"), Ok(vec![]));
        assert_eq!(
            recipe.outline().rings[0].len(),
            shown.rings[0].len(),
            "{}",
            choice.word
        );
        assert_eq!(pavement::recipe(&recipe.link()), (recipe, vec![]));
    }
}

#[test]
fn a_bad_polygon_leaves_the_recipe_as_it_was() {
    let mut recipe = pavement::recipe("").0;
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
