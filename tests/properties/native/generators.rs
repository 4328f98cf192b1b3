//! Several generators: their links, a studio that goes from one to another, and the native program, which writes files of each.

#[path = "../../../examples/native/mod.rs"]
mod native;

use crate::common::{finished, recipe};
use bubblestone::generators::{ALL, surface};
use bubblestone::notice::Code;

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
