//! Several generators: their links, a studio that goes from one to another, and the native program, which writes
//! files of each.

#[path = "../../../examples/native/mod.rs"]
mod native;

use crate::common::{finished, recipe};
use bubblestone::generators::masonry::MASONRY;
use bubblestone::generators::{ALL, Viewing, surface};
use bubblestone::notice::Code;
use serde_json::Value;
use std::collections::BTreeSet;

const BALL: &str = "v=1&make=surface&form=sphere&size=128&cn=60";
const PAVEMENT: &str = "v=1&size=128&cs=24";

#[test]
fn links_name_their_generator() {
    for link in ["v=1&make=surface", "v=1&make=surface&moss=0.5&el=30", BALL] {
        let recipe = recipe(link);
        assert!(recipe.is_of(&surface::SCHEMA));
        assert!(recipe.link().starts_with("v=1&make=surface"));
        assert_eq!(ALL.recipe(&recipe.link()).0, recipe);
    }
    assert_eq!(recipe(" #MAKE=Surface ").link(), "v=1&make=surface");
    assert_eq!(recipe("make=pavement&cs=30").link(), "v=1&cs=30");
}

#[test]
fn an_unknown_generator_gets_a_sentence_and_a_pavement() {
    let (recipe, notices) = ALL.recipe("make=castle&cs=30");
    assert_eq!(recipe.link(), "v=1&cs=30");
    assert_eq!(
        notices[0].to_string(),
        "Make must be pavement, surface, pile or masonry; \"castle\" was given, kept pavement."
    );
    // A word of another generator is as unknown as any other.
    let (recipe, notices) = ALL.recipe("make=surface&cn=80&cs=30");
    assert_eq!(recipe.link(), "v=1&make=surface&cn=80");
    assert_eq!(notices[0].code, Code::NotAParameter);
}

#[test]
fn a_studio_goes_from_one_generator_to_another_and_back() {
    let mut studio = finished(PAVEMENT);
    let pavement = studio.digest();
    studio.set_recipe(recipe(BALL));
    assert_eq!((studio.stage(), studio.progress().cells), ("surface", 0));
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    assert_eq!(studio.digest(), finished(BALL).digest());
    studio.set_recipe(recipe(PAVEMENT));
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    assert_eq!(studio.digest(), pavement);
}

#[test]
fn the_native_program_writes_files_of_each() {
    let out = std::env::temp_dir().join(format!("bubblestone-files-{}", std::process::id()));
    for (link, stage) in [(PAVEMENT, "domain"), (BALL, "surface")] {
        let out = out.join(stage);
        let mut studio = finished(link);
        native::write_all(&mut studio, Vec::new(), None, &out).unwrap();
        native::write_meshes(&mut studio, 100, false, &out).unwrap();
        let text = std::fs::read_to_string(out.join("report.json")).unwrap();
        let report: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(report["link"], studio.recipe().link());
        assert_eq!(report["hash"], studio.digest());
        assert!(report["milliseconds"][stage].is_number());
        assert!(out.join("surface.glb").is_file() && out.join("surface.obj").is_file());
    }
    let (flat, round) = (out.join("domain"), out.join("surface"));
    let mut pavement = finished(PAVEMENT);
    native::write_views(&mut pavement, &flat).unwrap();
    native::write_bigger(&mut pavement, 2, true, &flat).unwrap();
    native::write_svg(&mut pavement, &flat).unwrap();
    for name in ["picture", "view-albedo", "picture-2x", "ao-2x", "id"] {
        assert!(flat.join(format!("{name}.png")).is_file(), "{name}");
    }
    let mut ball = finished(BALL);
    assert!(native::write_svg(&mut ball, &round).is_err());
    assert!(native::write_bigger(&mut ball, 2, true, &round).is_err());
    std::fs::remove_dir_all(&out).unwrap();
}

#[test]
fn views_of_presets_are_read_without_a_fault() {
    let mut viewed = 0;
    for generator in ALL.iter() {
        for preset in generator.presets {
            let (viewing, faults) = Viewing::read(preset.view, generator);
            assert!(faults.is_empty(), "{}: {faults:?}", preset.name);
            assert_eq!(
                viewing.is_some(),
                !preset.view.is_empty(),
                "{}",
                preset.name
            );
            viewed += usize::from(viewing.is_some());
        }
    }
    assert!(viewed > 4);
}

#[test]
fn words_of_a_view_that_cannot_be_used_are_told() {
    let read = |words: &str| Viewing::read(words, &MASONRY);
    let all = "https://example.org/#v=1&make=masonry&view=seams&step=12&camera=10,20&cut=0,1,0,0.1";
    let (viewing, faults) = read(all);
    let viewing = viewing.expect("a view");
    assert_eq!((viewing.view.as_str(), viewing.step), ("seams", Some(12)));
    assert_eq!(
        viewing.camera.expect("a camera").numbers()[..2],
        [10.0, 20.0]
    );
    assert_eq!((viewing.cut.as_str(), faults.len()), ("whole=0,1,0,0.1", 0));
    for words in [
        "view=moon",
        "step=-1",
        "step=all",
        "camera=here",
        "cut=0,0,0,1",
        "cut=1",
        "body=2",
    ] {
        let (viewing, faults) = read(words);
        assert_eq!(faults.len(), 1, "{words}");
        assert_eq!(viewing.expect("a view").step, None);
    }
    assert_eq!(read("v=1&make=masonry&views=1&pace=3"), (None, Vec::new()));
}

/// The view stops before faces have their blocks, so it differs from the finished picture.
#[test]
fn the_native_program_draws_the_view_of_a_link() {
    let out = std::env::temp_dir().join(format!("bubblestone-seen-{}", std::process::id()));
    let link = "v=1&make=masonry&building=block&pattern=rgb&module=cube&walls=parts&size=128";
    let drawn = |words: &str| {
        let mut studio = finished(link);
        let viewing = Viewing::read(words, &MASONRY).0.expect("a view");
        let pixels = native::seen::write_seen(&mut studio, &viewing, &mut || 0.0, &out);
        (pixels.expect("pixels"), studio.progress().steps)
    };
    let (whole, all) = drawn("view=auto");
    let (held, steps) = drawn("step=40");
    assert!((40..50).contains(&steps), "{steps}");
    assert!(all > 100 && whole.len() == held.len());
    let others = [
        held,
        drawn("camera=150,40").0,
        drawn("view=seams").0,
        drawn("cut=0,1,0,0").0,
    ];
    assert!(others.iter().all(|pixels| *pixels != whole));
    assert!(out.join("seen.png").exists());
    std::fs::remove_dir_all(&out).expect("a folder");
}

/// Objects whose keys are words of the generator, or numbers.
const COUNTS: [&str; 5] = ["milliseconds", "sides", "valence", "features", "kinds"];

/// Collects the names of all fields of a JSON value.
fn fields(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Array(items) => items.iter().for_each(|item| fields(item, found)),
        Value::Object(object) => {
            for (name, value) in object {
                found.insert(name.clone());
                if !COUNTS.contains(&&name[..]) {
                    fields(value, found);
                }
            }
        }
        _ => (),
    }
}

/// The words in code signs of a text.
fn coded(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

#[test]
fn the_documentation_has_each_field_of_a_file_and_no_other() {
    let out = std::env::temp_dir().join(format!("bubblestone-fields-{}", std::process::id()));
    let mut written = BTreeSet::from(["frame".to_owned()]);
    for link in [
        PAVEMENT,
        BALL,
        "v=1&make=pile&form=bowl&ps=3&size=128",
        "v=1&make=pile&form=openbox&ps=3&size=128",
        "v=1&make=masonry&building=block&size=128",
    ] {
        native::write_all(&mut finished(link), Vec::new(), None, &out).unwrap();
        for name in ["report", "cells", "mesh", "bodies", "blocks", "measures"] {
            let Ok(text) = std::fs::read_to_string(out.join(format!("{name}.json"))) else {
                continue;
            };
            fields(&serde_json::from_str(&text).unwrap(), &mut written);
        }
        std::fs::remove_dir_all(&out).unwrap();
    }
    let text = include_str!("../../../docs/native.md");
    let (_, text) = text.split_once("## The report").expect("a heading");
    let told: BTreeSet<&str> = coded(text).collect();
    for name in &written {
        assert!(told.contains(&name[..]), "{name} is not in docs/native.md");
    }
    let rows = text.lines().filter_map(|line| line.strip_prefix("| "));
    let rows = rows.filter(|row| !row.starts_with("field"));
    for name in rows.flat_map(|row| coded(row.split(" | ").next().unwrap_or(row))) {
        assert!(written.contains(name), "{name} is in no file");
    }
}
