//! The generators, each with its schema, presets, stages, views, and engine. To add one, add a folder here, its
//! libraries, and one line in [`ALL`]. Put the line and the libraries under the cargo feature `house`, because the
//! module of a first visit does not contain them.

mod bigger;
mod budget;
mod engine;
#[cfg(house)]
mod given;
mod height_field;
mod held;
#[cfg(house)]
mod in_space;
mod inspection;
mod lighting;
#[cfg(house)]
pub mod masonry;
mod offers;
mod packs;
pub mod pavement;
#[cfg(house)]
pub mod pile;
mod preset;
pub(crate) mod rows;
#[cfg(house)]
mod scene_picture;
#[cfg(house)]
pub mod surface;
#[cfg(house)]
mod turntable;
#[cfg(all(house, not(target_arch = "wasm32")))]
mod viewing;

pub use bigger::MOST_PIXELS;
pub use budget::Clock;
pub(crate) use budget::{Budget, until};
pub use engine::{Engine, Progress};
#[cfg(house)]
pub use given::{FileDigest, GivenFile, MissingFile};
#[cfg(house)]
pub use in_space::{Files, Frames, ModelFacts};
pub use inspection::{Histogram, JoinedCells, JoinedTriangle, Polygon, Probe, Products};
pub use offers::{Drafts, Inspect, Maps, MeshSlice, Meshes, Outlines, PictureSlice, Rewind, Steps};
pub use preset::{MeasuredPart, Preset, Timing};
#[cfg(house)]
pub use turntable::{FrameSlice, SeenBody, SeenLabel, TurnOrder};
#[cfg(all(house, not(target_arch = "wasm32")))]
pub use viewing::Viewing;

use crate::notice::Notice;
use crate::recipe::{Recipe, Schema};

/// A generator as data: its properties for the page, links and the studio.
pub struct Generator {
    /// Its parameters. The word of the schema also names the generator, as in `make=` of a link.
    pub schema: &'static Schema,
    /// Its name on the page.
    pub title: &'static str,
    /// Its presets, in the order of the page.
    pub presets: &'static [Preset],
    /// Words of the stages in the order of the work, as used in scripts and reports.
    pub stages: &'static [&'static str],
    /// How the stages proceed, for showing the progress.
    pub course: Course,
    /// The views that the page can show.
    pub views: Views,
    /// Words of the page's parts that it needs. A picture in a plane has `outline` (the editor), `probe`, `plots`,
    /// `tiles`, `svg`, `maps` (with larger pictures), `slab` (its relief for printing), and `turn` (its bodies seen from
    /// a slant). A generator without such a picture has `frames`: only frames of its bodies are
    /// shown, `paint` paints on these, and `cut` cuts their bodies away beyond a plane. `models` opens files. All may
    /// have `compare`, `mesh` and `forming`; with `places`, the places of bodies that share meshes are saved; with
    /// `moves`, cells move, come and go while they form, which is counted; with `bodies`, bodies are counted instead of
    /// cells.
    pub offers: &'static [&'static str],
    /// Keys of the parameters that best describe a recipe without a name.
    pub names: &'static [&'static str],
    /// Rules for the small pictures that the page shows for the words of choices.
    pub samples: &'static [SampleRule],
    /// The word that selects the ranges for random parameters (the page's dice).
    pub chance: &'static str,
    /// The first camera for its bodies: angle, height, distance, lens and target, with commas between. Numbers at the
    /// end may be missing.
    pub home: &'static str,
    /// The lowest elevation of a camera, in degrees above the ground.
    pub lowest: f64,
    /// Makes an engine for a recipe; no stage is done yet.
    pub engine: fn(&Recipe) -> Box<dyn Engine>,
}

/// A rule for small pictures of the words of choices. A word gets the picture of the first rule that fits it.
#[derive(Clone, Copy)]
pub struct SampleRule {
    /// The keys of the choices. All show the pictures made for the first key.
    pub keys: &'static [&'static str],
    /// The words with a picture. If the list is empty, all words have one except those in `without`.
    pub words: &'static [&'static str],
    /// Words that the rule gives no picture.
    pub without: &'static [&'static str],
    /// The values of the other parameters in the pictures' recipes, as in a link.
    pub link: &'static str,
    /// The view in the pictures; empty for the finished picture. A diagram is drawn as soon as its stage is done.
    pub view: &'static str,
}

/// How the stages of a generator proceed. A word is empty if there is no such stage. A list has one entry for each
/// stage, and is empty if nothing is known.
#[derive(Clone, Copy)]
pub struct Course {
    /// When each stage begins, as a share (0..1) of the total time; for common recipes.
    pub begins: &'static [f64],
    /// The stage that proceeds in steps, such as the packing.
    pub stepping: &'static str,
    /// The stage that makes one body after the other.
    pub placing: &'static str,
    /// The first stage of the finisher. From this stage on, a short pass is finished before a newer recipe begins.
    pub finisher: &'static str,
    /// The first stage that no longer changes the bodies.
    pub settled: &'static str,
    /// For each stage, the view that shows it while it forms; empty for the bodies themselves.
    pub seen: &'static [&'static str],
}

impl Course {
    /// A course about which nothing is known.
    pub const UNKNOWN: Course = Course {
        begins: &[],
        stepping: "",
        placing: "",
        finisher: "",
        settled: "",
        seen: &[],
    };
}

/// The words of views. A view joins words by '+': at most one base, and any overlays.
#[derive(Clone, Copy)]
pub struct Views {
    /// Words of bases: pictures and diagrams.
    pub bases: &'static [&'static str],
    /// Words of overlays: drawings over a base.
    pub overlays: &'static [&'static str],
}

/// A list of generators. A link that names no generator gets the first.
#[derive(Clone, Copy)]
pub struct Registry(&'static [&'static Generator]);

/// All generators of this build.
pub const ALL: Registry = Registry(&[
    &pavement::PAVEMENT,
    #[cfg(house)]
    &surface::SURFACE,
    #[cfg(house)]
    &pile::PILE,
    #[cfg(house)]
    &masonry::MASONRY,
]);

#[cfg(house)]
impl Generator {
    /// The first camera for its bodies.
    pub fn camera(&self) -> crate::scene::Camera {
        crate::scene::Camera::default().read(self.home).0
    }
}

impl Registry {
    /// All generators of the list, in the order of the page.
    pub fn iter(self) -> impl Iterator<Item = &'static Generator> {
        self.0.iter().copied()
    }

    /// Reads a link of any generator of the list; see [`Recipe::from_link`].
    pub fn recipe(self, link: &str) -> (Recipe, Vec<Notice>) {
        let schemas: Vec<&Schema> = self.iter().map(|generator| generator.schema).collect();
        Recipe::from_link(&schemas, link)
    }

    /// The generator that a recipe is for.
    pub fn of(self, recipe: &Recipe) -> &'static Generator {
        let mut all = self.iter();
        let found = all.find(|generator| recipe.is_of(generator.schema));
        found.unwrap_or(self.0[0])
    }

    /// The generator with this word (`make=` of a link); `None` if no generator has it.
    pub fn named(self, word: &str) -> Option<&'static Generator> {
        self.iter().find(|generator| generator.schema.word == word)
    }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use crate::recipe::{Item, Parameter};

    /// A generator offers exactly the parts for which its engine has the capabilities.
    #[test]
    fn offers_follow_from_the_engine() {
        for generator in ALL.iter() {
            let mut engine = (generator.engine)(&Recipe::new(generator.schema));
            let is_plane = engine.inspect().is_some();
            let has_frames = engine.frames().is_some();
            let is_painted = |row: &Parameter| {
                let item = row.item;
                item.is_some_and(|item| matches!(item, Item::Trace | Item::Patch(..)))
            };
            let offered = [
                ("outline", engine.outlines().is_some()),
                ("probe", is_plane),
                ("plots", is_plane),
                ("svg", is_plane),
                ("maps", engine.maps().is_some()),
                ("rewind", engine.rewind().is_some()),
                ("steps", engine.steps().is_some()),
                ("mesh", engine.meshes().is_some()),
                (
                    "places",
                    engine.meshes().is_some_and(|m| m.places().is_some()),
                ),
                (
                    "building",
                    engine.meshes().is_some_and(|m| m.building().is_some()),
                ),
                ("turn", has_frames && is_plane),
                ("frames", has_frames && !is_plane),
                ("models", engine.files().is_some()),
                ("paint", generator.schema.rows.iter().any(is_painted)),
                ("forming", !generator.course.stepping.is_empty()),
            ];
            for (word, is_offered) in offered {
                let told = generator.offers.contains(&word);
                assert_eq!(told, is_offered, "{}: {word}", generator.schema.word);
            }
            for stage in [generator.course.stepping, generator.course.finisher] {
                assert!(
                    stage.is_empty() || generator.stages.contains(&stage),
                    "{stage}"
                );
            }
        }
    }
}
