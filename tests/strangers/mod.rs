//! Links and model files from strangers, as test data, and what must be true of the work on them: it ends, with a
//! sentence or with a picture in which every number is finite.

// Each program uses a part of these.
#![allow(dead_code, unused_imports)]

mod files;
mod links;

pub use files::{broken, buildings, files};
pub use links::{broken_link, wild, wild_building, wild_pile};

use crate::common::wished;
use bubblestone::generators::surface::{SCHEMA, keys};
use bubblestone::generators::{ALL, GivenFile, TurnOrder};
use bubblestone::notice::{Code, Notice};
use bubblestone::random::{Purpose, Random};
use bubblestone::recipe::Recipe;
use bubblestone::scene::Camera;
use bubblestone::studio::Studio;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Tries cases from a start, and lists those that fail.
pub fn try_all(count: u64, case: impl Fn(&mut Random) -> String) {
    let seed = wished("BUBBLESTONE_SEED", 1);
    let mut bad = Vec::new();
    for index in 0..wished("BUBBLESTONE_RECIPES", count) {
        let mut random = Random::new(seed, Purpose::Attribute, index);
        // The output is printed only if the test fails.
        match catch_unwind(AssertUnwindSafe(|| case(&mut random))) {
            Ok(end) => println!("{index}: {end}"),
            Err(_) => bad.push(index),
        }
    }
    assert!(bad.is_empty(), "cases {bad:?} from start {seed}");
}

/// Slices of work after which a recipe counts as hanging: about ten times as many as the slowest one took.
const MOST_SLICES: usize = 130_000;

/// Asserts that a notice is a sentence.
pub fn assert_sentence(notice: &Notice) {
    let text = notice.to_string();
    assert!(text.ends_with('.') && text.len() > 20, "{text}");
}

/// How the work on a recipe ended.
pub struct Ended {
    /// The sentence of a refusal, or what was made.
    pub text: String,
    /// The number of cells; nothing if the recipe or the file was refused.
    pub cells: Option<usize>,
    /// How many slices the work took.
    pub slices: usize,
    /// The longest slice: its stage, and its time by the caller's clock.
    pub longest: (&'static str, f64),
}

impl Ended {
    fn refused(why: &Notice, slices: usize, longest: (&'static str, f64)) -> Self {
        assert_sentence(why);
        Self {
            text: why.to_string(),
            cells: None,
            slices,
            longest,
        }
    }
}

/// Works slice by slice up to the end, and checks what was made.
fn ends_well(mut studio: Studio, clock: &mut dyn FnMut() -> f64) -> Ended {
    let (mut slices, mut longest) = (0, ("", 0.0));
    while studio.at_work().is_some() {
        let (stage, before) = (studio.stage(), clock());
        studio.tick(&mut || 0.0, 0.0, u32::MAX);
        let took = clock() - before;
        if took > longest.1 {
            longest = (stage, took);
        }
        slices += 1;
        assert!(slices < MOST_SLICES, "no end: {}", studio.stage());
    }
    let remarks = studio.engine().remarks();
    remarks.iter().for_each(assert_sentence);
    if let Some(why) = studio.problem() {
        return Ended::refused(why, slices, longest);
    }
    assert_finite(&mut studio);
    let cells = studio.engine().progress().cells;
    if studio.recipe().is_of(&SCHEMA) {
        let share = cells as f64 / studio.recipe().number(keys::CN);
        let is_told = remarks.iter().any(|one| one.code == Code::SurfaceCount);
        assert!(
            cells > 0 && ((0.25..=4.0).contains(&share) || is_told),
            "{cells} cells"
        );
    }
    Ended {
        text: format!("{slices} slices, {cells} cells, {remarks:?}"),
        cells: Some(cells),
        slices,
        longest,
    }
}

/// Works on a link with any faults.
pub fn link_ends_well(link: &str) -> Ended {
    ends_well(Studio::new(ALL, mended(link)), &mut || 0.0)
}

/// Asserts that the picture, a frame of the bodies, and the numbers of cells and mesh are finite.
fn assert_finite(studio: &mut Studio) {
    let picture = studio.picture().expect("a picture");
    assert_eq!(picture.len(), 4 * studio.side() * studio.side());
    assert!(studio.engine_mut().energy().is_finite());
    let order = TurnOrder {
        subject: String::new(),
        camera: Camera::default(),
        size: [48, 32],
        how: "moving+nothing".to_owned(),
    };
    let frame = studio.finish_frame(&order, &mut || 0.0).expect("a frame");
    assert!(frame.depths().iter().all(|depth| depth.is_finite()));
    assert!(frame.normals().iter().all(|normal| normal.is_finite()));
    for (name, text) in studio.engine().data() {
        assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
    }
}

/// The recipe of a link with any faults. Asserts that its own link gives the same recipe.
pub fn mended(link: &str) -> Recipe {
    let (recipe, notices) = ALL.recipe(link);
    notices.iter().for_each(assert_sentence);
    let (again, notices) = ALL.recipe(&recipe.link());
    assert!(notices.is_empty(), "{notices:?}");
    assert!(again == recipe, "{}", recipe.link());
    recipe
}

/// Options for covering a file: each kind of cells, and each option that only models have.
pub const COVERED: [&str; 4] = [
    "kind=square&on=simple",
    "kind=rectangle&crease=cut&dir=border",
    "kind=circle&open=block&stone=skin&up=z",
    "kind=ellipse&open=capped&cc=20&dir=curvature&on=whole",
];

/// Covers a file with cells, by one of the options of [`COVERED`].
pub fn file_ends_well(
    link: &str,
    name: &str,
    bytes: Vec<u8>,
    clock: &mut dyn FnMut() -> f64,
) -> Ended {
    given_ends_well(&format!("make=surface&size=128&{link}"), name, bytes, clock)
}

/// Gives a link a file in its first role.
pub fn given_ends_well(
    link: &str,
    name: &str,
    bytes: Vec<u8>,
    clock: &mut dyn FnMut() -> f64,
) -> Ended {
    let recipe = mended(link);
    let mut studio = Studio::new(ALL, recipe);
    match studio.open_file(None, GivenFile::whole(name, bytes)) {
        Ok(notices) => notices.iter().for_each(assert_sentence),
        Err(why) => {
            return Ended::refused(&why, 0, ("", 0.0));
        }
    }
    ends_well(studio, clock)
}
