//! Surfaces from files: from a link that names a file to stones on it, and the notices of failures.

use bubblestone::generators::{ALL, GivenFile, MissingFile};
use bubblestone::notice::Notice;
use bubblestone::studio::Studio;

const LINK: &str = "v=1&make=surface&size=128&cn=60";

/// A cube as text. Files of other tests differ in its side.
fn cube(side: f64) -> Vec<u8> {
    let mut text = String::from("# a cube\n");
    for k in 0..8 {
        let [x, y, z] = [1, 2, 4].map(|bit| if k & bit == 0 { 0.0 } else { side });
        text += &format!("v {x} {y} {z}\n");
    }
    for face in [
        "1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6",
    ] {
        text += &format!("f {face}\n");
    }
    text.into_bytes()
}

fn file(name: &str, bytes: &[u8]) -> GivenFile {
    GivenFile::whole(name, bytes.to_vec())
}

fn studio(link: &str) -> (Studio, Vec<Notice>) {
    let (recipe, notices) = ALL.recipe(link);
    (Studio::new(ALL, recipe), notices)
}

fn failure(studio: &mut Studio) -> String {
    let why = studio.finish(&mut || 0.0);
    why.expect_err("no picture").to_string()
}

#[test]
fn a_link_without_a_file_says_so_and_keeps_a_surface_by_rule() {
    let (mut studio, notices) = studio(&format!("{LINK}&form=file"));
    let said: Vec<String> = notices.iter().map(Notice::to_string).collect();
    assert!(
        matches!(&said[..], [one] if one.contains("From a file")),
        "{said:?}"
    );
    assert_eq!(studio.recipe().link(), LINK);
    assert_eq!(studio.files().unwrap().missing(), []);
}

#[test]
fn a_recipe_alone_does_not_choose_a_file_that_it_does_not_name() {
    let (studio, _) = studio(LINK);
    let mut recipe = studio.recipe().clone();
    assert!(recipe.set("form", "file").is_err());
    assert!(recipe.set("model", "").is_err());
}

#[test]
fn a_file_becomes_stones_and_a_link_that_finds_it_again() {
    let (mut first, _) = studio(LINK);
    let said = first.open_file(None, file("cube.obj", &cube(2.0)));
    assert_eq!(said, Ok(vec![]));
    first.finish(&mut || 0.0).expect("a picture");
    assert!(first.progress().stones > 40, "{:?}", first.progress());
    let link = first.recipe().link();
    // On another machine the file is missing, and its name is known, until it is given.
    let (mut other, notices) = studio(&link);
    assert_eq!(notices, []);
    let digest = file("", &cube(2.0)).named().digest_text();
    let missing = [MissingFile {
        role: "model",
        digest,
        name: "cube.obj".to_owned(),
    }];
    assert_eq!(other.files().unwrap().missing(), missing);
    assert!(failure(&mut other).contains("needs the file \"cube.obj\""));
    assert_eq!(other.files().unwrap().missing(), missing);
    other.files().unwrap().give(file("another.obj", &cube(1.0)));
    assert_eq!(other.files().unwrap().missing(), missing);
    other.files().unwrap().give(file("renamed.obj", &cube(2.0)));
    assert_eq!(other.files().unwrap().missing(), []);
    other.finish(&mut || 0.0).expect("a picture");
    assert_eq!(other.digest(), first.digest());
    assert_eq!(other.recipe().link(), link);
}

#[test]
fn what_was_mended_is_said() {
    let (mut studio, _) = studio(LINK);
    // One face is reversed, and one is there twice.
    let text = String::from_utf8(cube(2.0)).unwrap();
    let text = text.replace("f 1 2 6 5", "f 5 6 2 1") + "f 2 4 8 6\n";
    studio
        .open_file(None, file("mended.obj", text.as_bytes()))
        .expect("nothing to say yet");
    studio.finish(&mut || 0.0).expect("a picture");
    let remarks: Vec<String> = studio
        .engine()
        .remarks()
        .iter()
        .map(Notice::to_string)
        .collect();
    for words in ["left out: 2", "turned: 2"] {
        assert!(
            remarks.iter().any(|said| said.contains(words)),
            "{remarks:?}"
        );
    }
}

#[test]
fn files_that_are_none_say_why() {
    for (name, bytes, words) in [
        (
            "poem.txt",
            &b"no model at all"[..],
            "no model that can be read",
        ),
        (
            "half.obj",
            b"v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 3\n",
            "Line 3 of the OBJ file",
        ),
        (
            "far.obj",
            b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n",
            "corner that is not there",
        ),
        ("empty.obj", b"v 0 0 0\n", "no triangles"),
        ("", b"", "no model that can be read"),
    ] {
        let (mut studio, _) = studio(LINK);
        // The result does not depend on the file before it.
        studio
            .open_file(None, file("box.obj", &cube(2.0)))
            .expect("it is taken");
        studio.finish(&mut || 0.0).expect("a picture");
        studio
            .open_file(None, file(name, bytes))
            .expect("it is taken");
        let said = failure(&mut studio);
        assert!(said.contains(words), "{name}: {said}");
        // The file is not missing: it is broken.
        assert_eq!(studio.files().unwrap().missing(), [], "{name}");
    }
}

#[test]
fn broken_rows_of_models_are_refused_with_a_sentence() {
    for row in [
        "1,2,3",
        "1,2,3,4,1114112",
        "65536,0,0,0",
        "-1,0,0,0",
        "1,2,3,4;1,2,3,4",
        "%%%",
        "....",
        "A",
    ] {
        let (studio, notices) = studio(&format!("{LINK}&model={row}"));
        assert!(!notices.is_empty(), "{row}");
        assert_eq!(studio.recipe().link(), LINK, "{row}");
    }
    let long = "A".repeat(400);
    let (_, notices) = studio(&format!("{LINK}&model={long}"));
    assert_eq!(notices.len(), 1);
}

#[test]
fn a_generator_without_models_takes_no_file() {
    let (mut studio, _) = studio("v=1&size=128");
    let said = studio.open_file(None, file("cube.obj", &cube(1.0)));
    assert!(said.is_err());
    assert!(studio.files().is_err());
}
