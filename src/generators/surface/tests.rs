//! Properties of the generator's table and stages.

use super::params::Params;
use super::schema::ROWS;
use super::{SCHEMA, SURFACE, keys};
use crate::generators::rows::numbered::check_row;
use crate::generators::{ALL, MissingFile, TurnOrder};
use crate::notice::{Arg, Code};
use crate::recipe::{MAX_NAME, NamedFile, Recipe};
use crate::scene::Camera;
use crate::shapes::Shape;
use crate::studio::Studio;

const SMALL: &str = "make=surface&size=128&cn=60&form=";

fn studio(link: &str) -> Studio {
    let (recipe, notices) = ALL.recipe(link);
    assert!(notices.is_empty(), "{notices:?}");
    Studio::new(ALL, recipe)
}

fn finished(link: &str) -> Studio {
    let mut studio = studio(link);
    let ended = studio.finish(&mut || 0.0);
    assert!(ended.is_ok(), "{link}: {ended:?}");
    studio
}

fn set(studio: &mut Studio, key: &str, value: &str) {
    let mut recipe = studio.recipe().clone();
    assert_eq!(recipe.set(key, value), Ok(vec![]));
    studio.set_recipe(recipe);
}

#[test]
fn there_is_a_row_for_each_number_of_each_shape() {
    let words = |shape: Shape| [shape.word()];
    for shape in Shape::ALL {
        let own = |row: &&crate::recipe::Parameter| {
            row.shown_for
                .is_some_and(|(key, of)| key == keys::FORM && of == words(shape))
        };
        let rows: Vec<_> = ROWS.iter().filter(own).collect();
        assert_eq!(rows.len(), shape.numbers().len(), "{}", shape.word());
        for (row, number) in rows.iter().zip(shape.numbers()) {
            assert_eq!(row.key.0, format!("{}_{}", shape.word(), number.word));
            check_row(row, number);
        }
    }
    let form = SCHEMA.row("form").expect("a row");
    let shapes = Shape::ALL.map(|shape| (shape.word(), shape.label()));
    let choices: Vec<_> = form.choices.iter().map(|c| (c.word, c.label)).collect();
    assert_eq!(choices[..15], shapes);
}

#[test]
fn presets_are_canonical() {
    for preset in SURFACE.presets {
        let (recipe, notices) = ALL.recipe(preset.link);
        assert!(notices.is_empty(), "{}: {notices:?}", preset.name);
        assert_eq!(recipe.link(), preset.link, "{}", preset.name);
    }
}

#[test]
fn only_what_is_asked_otherwise_is_made_anew() {
    let mut studio = finished(&format!("{SMALL}egg"));
    for (key, value, first) in [
        ("az", "200", 6),
        ("yaw", "40", 6),
        ("hs", "0.3", 5),
        ("open", "capped", 5),
        ("pattern", "spots", 4),
        ("flip", "1", 4),
        ("seed", "2", 2),
        ("dir", "axis", 1),
        ("egg_height", "1.2", 0),
        ("cn", "70", 0),
    ] {
        let before = studio.runs();
        set(&mut studio, key, value);
        studio.finish(&mut || 0.0).expect("a picture");
        for (k, (old, new)) in before.iter().zip(studio.runs()).enumerate() {
            assert_eq!(old.1 < new.1, k >= first, "{key}: {}", old.0);
        }
    }
    // Earlier recipes leave no trace.
    let again = finished(&studio.recipe().link());
    assert_eq!(studio.digest(), again.digest());
}

#[test]
fn too_few_cells_are_refused_with_a_number_that_fits() {
    for link in [
        "v=1&make=surface&form=knot&cn=30",
        "v=1&make=surface&form=vase&cn=30&kind=circle",
    ] {
        let mut studio = studio(link);
        let told = studio.finish(&mut || 0.0).expect_err(link);
        assert_eq!(told.code, Code::SurfaceTooTight, "{link}: {told}");
        let fits = told.args.iter().find(|(name, _)| *name == "fits");
        let Some((_, Arg::Text(fits))) = fits else {
            panic!("{told:?}")
        };
        set(&mut studio, "cn", fits);
        let ended = studio.finish(&mut || 0.0);
        assert!(ended.is_ok(), "{link} with {fits}: {ended:?}");
    }
}

#[test]
fn a_step_back_to_what_is_there_makes_nothing() {
    let mut studio = finished(&format!("{SMALL}egg"));
    let runs = studio.runs();
    set(&mut studio, "cn", "90");
    set(&mut studio, "cn", "60");
    assert!(studio.done());
    assert_eq!(studio.runs(), runs);
}

/// A run that goes on from a held step has the same result. After the first held step, others are
/// reached sooner.
#[test]
fn the_steps_go_back_and_on_with_the_same_bits() {
    let clock = &mut || 0.0;
    let mut studio = finished(&format!("{SMALL}egg"));
    let (digest, end) = (studio.digest(), studio.progress());
    let mut first = 0;
    // The first way back makes the states, and later ones take them up.
    for step in [17, 12, 13, 3] {
        let rewind = studio.engine_mut().rewind().expect("steps");
        rewind.hold(Some(step));
        let mut slices = 0;
        while !rewind.reach(clock, 0.0) {
            slices += 1;
        }
        first = first.max(slices);
        assert!(step == 17 || 2 * slices < first, "{slices} of {first}");
        studio.restart();
        assert_eq!((studio.stage(), studio.progress().steps), ("packing", step));
        studio.step(clock);
        assert_eq!(studio.progress().steps, step + 1);
    }
    assert_eq!(studio.finish(clock), Ok(()));
    assert_eq!((studio.digest(), studio.progress()), (digest, end));
    // Another surface does not go on from these steps.
    set(&mut studio, "cn", "70");
    assert_eq!(studio.finish(clock), Ok(()));
    let (digest, end) = (studio.digest(), studio.progress());
    studio.restart();
    assert_eq!(studio.finish(clock), Ok(()));
    assert_eq!((studio.digest(), studio.progress()), (digest, end));
}

fn read_back(file: &NamedFile) -> NamedFile {
    let mut recipe = Recipe::new(&SCHEMA);
    let rows = Some(vec![file.row()]);
    SCHEMA.rules.draw(&mut recipe, keys::MODEL, rows).unwrap();
    let (again, notices) = Recipe::from_link(&[&SCHEMA], &recipe.link());
    assert_eq!(notices, []);
    again.files(keys::MODEL).remove(0)
}

#[test]
fn a_row_names_the_file_again() {
    let names = ["a.obj", "", "wal fisch.glb", "鯨🐋.ply", "..,;&=%.stl"];
    for (k, name) in names.into_iter().enumerate() {
        let file = NamedFile::new(0xFEDC_BA98_7654_3210 >> (7 * k), name);
        assert_eq!(read_back(&file), file);
    }
    let last = NamedFile::new(u64::MAX, "x");
    assert_eq!(read_back(&last).digest_text(), "ffffffffffffffff");
}

#[test]
fn a_long_name_keeps_its_ending() {
    let file = NamedFile::new(1, &format!("{}.obj", "é".repeat(500)));
    assert_eq!(file.name.chars().count(), MAX_NAME);
    assert!(file.name.ends_with("é.obj"));
    assert_eq!(read_back(&file), file);
}

#[test]
fn a_file_is_asked_for() {
    let mut recipe = Recipe::new(&SCHEMA);
    let refused = recipe.set("form", "file").expect_err("there is none");
    assert_eq!(refused.code, Code::ModelFirst);
    assert_eq!(Params::new(&recipe), Params::new(&Recipe::new(&SCHEMA)));
    recipe
        .set("model", "1,2,3,4,97,46,111,98,106")
        .expect("a digest and a name");
    assert_eq!(recipe.choice(keys::FORM), "file");
    let mut studio = Studio::new(ALL, recipe);
    let failure = studio
        .finish(&mut || 0.0)
        .expect_err("there is no such file");
    assert_eq!(failure.code, Code::ModelMissing);
    assert!(failure.to_string().contains("a.obj"), "{failure}");
    let missing = studio.files().expect("files").missing();
    assert_eq!(
        missing,
        [MissingFile {
            role: "model",
            digest: "0001000200030004".to_owned(),
            name: "a.obj".to_owned(),
        }]
    );
}

/// The largest id of a body in a frame of the work as it is, and whether the frame shows anything.
fn seen(studio: &mut Studio) -> Option<(u32, bool)> {
    let order = TurnOrder {
        subject: String::new(),
        camera: Camera::default(),
        size: [48, 32],
        how: "moving+nothing".to_owned(),
    };
    let frames = studio.engine_mut().frames()?;
    while !frames.turn(&order, &mut || 0.0, 0.0).ok()?.done {}
    let frame = frames.frame()?;
    let is_empty = frame.depths().iter().all(|depth| *depth == 0.0);
    Some((frame.ids().iter().copied().max()?, !is_empty))
}

#[test]
fn the_bare_surface_is_seen_until_there_are_cells() {
    let mut studio = studio(&format!("{SMALL}egg"));
    let mut told = Vec::new();
    while studio.stage() != "mesh" {
        let stage = studio.stage();
        if told.last().is_none_or(|(last, _)| *last != stage) {
            told.push((stage, seen(&mut studio)));
        }
        studio.tick(&mut || 0.0, 0.0, 1);
    }
    let [surface, fields, packing] = told[..] else {
        panic!("{told:?}");
    };
    assert_eq!(surface, ("surface", None));
    assert_eq!(fields, ("fields", Some((0, true))));
    assert_eq!(packing, ("packing", Some((0, true))));
    assert!(seen(&mut studio).is_some_and(|(id, _)| id > 0));
}

#[test]
fn each_step_in_the_making_of_a_scale_has_a_frame_and_each_cell_its_measures() {
    let mut studio = studio(&format!("{SMALL}sphere&stone=skin"));
    let order = |subject: &str| TurnOrder {
        subject: subject.to_owned(),
        camera: Camera::default(),
        size: [48, 48],
        how: "still".to_owned(),
    };
    let turn = |studio: &mut Studio, subject: &str| {
        let frames = studio.engine_mut().frames().expect("frames");
        loop {
            let slice = frames.turn(&order(subject), &mut || 0.0, f64::INFINITY);
            match slice {
                Ok(slice) if !slice.done => {}
                Ok(_) => return Ok(frames.frame().expect("a frame").hash()),
                Err(notice) => return Err(notice.code),
            }
        }
    };
    assert_eq!(turn(&mut studio, "7:0"), Err(Code::NotYet));
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    let frames = studio.engine_mut().frames().expect("frames");
    let steps = frames.making(7);
    assert_eq!(frames.making(0), frames.making(100_000));
    assert_eq!(steps.first().map(String::as_str), Some("cell"));
    let mut seen: Vec<String> = (0..steps.len())
        .map(|at| turn(&mut studio, &format!("7:{at}")).expect("a frame"))
        .collect();
    for bad in ["7:40", "0:0", "100000:0"] {
        assert_eq!(turn(&mut studio, bad), Err(Code::NoSuchBody), "{bad}");
    }
    seen.sort();
    seen.dedup();
    // Without noise, the step of noise shows the same as the step before it.
    assert!(seen.len() + 2 > steps.len(), "{} of {steps:?}", seen.len());
    turn(&mut studio, "").expect("a frame");
    let frames = studio.engine_mut().frames().expect("frames");
    let body = frames.body_at(24, 24).expect("a body");
    let words: Vec<&str> = body.figures.iter().map(|&(word, _)| word).collect();
    let known = ["size", "wanted", "aspect", "sides", "neighbours", "area"];
    assert!(known.iter().all(|word| words.contains(word)), "{words:?}");
    let value = |word| {
        body.figures
            .iter()
            .find(|(own, _)| *own == word)
            .map_or(0.0, |f| f.1)
    };
    assert!((value("size") / value("wanted") - 1.0).abs() < 0.5);
    assert!((3.0..9.0).contains(&value("neighbours")));
}
