//! The drawing of the house (docs/house.svg) is true to the code: what a folder uses, its arrows lead to,
//! each arrow stands for a use, and there is no way round in a circle.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Names of two folders, of which the first uses the second.
type Uses = BTreeSet<(String, String)>;

/// The ground, which any folder of src may use: no arrows are drawn to it.
const GROUND: [&str; 5] = ["notice", "order", "random", "decimal", "hash"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All files below a folder but those of unit tests, or the file itself.
fn files(path: &Path) -> Vec<String> {
    if path.ends_with("tests.rs") {
        return Vec::new();
    }
    if path.is_file() {
        return vec![fs::read_to_string(path).unwrap()];
    }
    let entries = fs::read_dir(path).unwrap();
    entries
        .flat_map(|entry| files(&entry.unwrap().path()))
        .collect()
}

/// The folders and files at the top of `src` or `www`, without endings.
fn rooms(top: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(root().join(top)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let stem = |path: std::path::PathBuf| path.file_stem().unwrap().to_str().unwrap().to_owned();
    paths.map(stem).collect()
}

/// The code of a Rust file: without comments, and without the tests at its end.
fn code(file: &str) -> String {
    let shipped = file.split("#[cfg(test)]\nmod tests").next().unwrap();
    let lines = shipped
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    lines.collect()
}

/// The first names behind each `crate::`: one, or those in braces.
fn names(code: &str) -> Vec<String> {
    let mut names = Vec::new();
    for behind in code.split("crate::").skip(1) {
        let list = behind
            .strip_prefix('{')
            .and_then(|list| list.split('}').next());
        for item in list.map_or(vec![behind], |list| list.split(',').collect()) {
            let end = |c: char| !c.is_alphanumeric() && c != '_';
            names.push(item.trim().split(end).next().unwrap().to_owned());
        }
    }
    names
}

/// Uses between the folders of `src`.
fn uses_of_src() -> Uses {
    let rooms = rooms("src");
    let mut uses = Uses::new();
    for room in rooms.iter().filter(|room| *room != "lib") {
        for path in [format!("src/{room}"), format!("src/{room}.rs")] {
            let path = root().join(path);
            let files = if path.exists() {
                files(&path)
            } else {
                Vec::new()
            };
            for name in files.iter().flat_map(|file| names(&code(file))) {
                if name != *room && rooms.contains(&name) && !GROUND.contains(&name.as_str()) {
                    uses.insert((room.clone(), name));
                }
            }
        }
    }
    uses
}

/// Uses between the folders of `www`: what is imported, now or later.
fn uses_of_www() -> Uses {
    let drawn: BTreeSet<String> = arrows().into_iter().flat_map(|(a, b)| [a, b]).collect();
    let mut uses = Uses::new();
    for room in rooms("www").intersection(&drawn) {
        for file in files(&root().join("www").join(room)) {
            for behind in file.split("'../").skip(1) {
                let name = behind.trim_start_matches("../").split(['/', '\'']);
                let name = name.into_iter().next().unwrap();
                if name != room && drawn.contains(name) {
                    uses.insert((room.clone(), name.to_owned()));
                }
            }
        }
    }
    uses
}

/// The arrows of the drawing.
fn arrows() -> Uses {
    let svg = fs::read_to_string(root().join("docs/house.svg")).unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let arrows = document
        .descendants()
        .filter_map(|path| path.attribute("data-uses"));
    arrows
        .map(|words| words.split_once(' ').unwrap())
        .map(|(a, b)| (a.to_owned(), b.to_owned()))
        .collect()
}

/// What the arrows lead to from a folder, over one or more of them.
fn reached<'a>(arrows: &'a Uses, from: &str) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::new();
    let mut ends = vec![from];
    while let Some(end) = ends.pop() {
        for (_, next) in arrows.iter().filter(|(a, _)| a == end) {
            if reached.insert(next.as_str()) {
                ends.push(next);
            }
        }
    }
    reached
}

#[test]
fn the_drawing_shows_what_uses_what() {
    let arrows = arrows();
    let uses: Uses = &uses_of_src() | &uses_of_www();
    for (a, b) in &uses {
        assert!(
            reached(&arrows, a).contains(b.as_str()),
            "{a} uses {b}, and no arrow of docs/house.svg says so"
        );
    }
    // Between page, crate and programs nothing imports by these names.
    let joints = [("module", "web"), ("examples", "studio")];
    for (a, b) in &arrows {
        let known =
            joints.contains(&(a.as_str(), b.as_str())) || uses.contains(&(a.clone(), b.clone()));
        assert!(
            known,
            "docs/house.svg has an arrow from {a} to {b}, which does not use it"
        );
        assert!(
            !reached(&arrows, b).contains(a.as_str()),
            "{a} and {b} use each other in docs/house.svg"
        );
    }
    assert!(uses.len() > 60, "{uses:?}");
}
