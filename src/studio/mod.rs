//! Runs any generator: from a recipe to its picture in slices, redoing only stale stages.
//!
//! A studio holds the latest recipe and one live engine, which is replaced when the recipe is of another
//! generator. [`Studio::tick`] works on the first stale stage for about the given time. The result of a stage
//! stays until its successor is finished, too. No result depends on the slicing of the work or on the clock.
//!
//! Stages divide their work by amount (places looked at, points inserted, rows of weights, triangles of a
//! stone), never by time. `cargo run --release --example slices` prints the longest slice of each stage.

mod running;

use crate::export::{Report, StageTime};
use crate::generators::{Engine, Generator, Maps, Meshes, Progress, Registry};
use crate::notice::{Code, Notice};
use crate::recipe::Recipe;
#[cfg(house)]
use crate::{
    generators::{Files, Frames, GivenFile},
    recipe::{Item, Parameter},
};

/// A pass over the finisher shorter than this many milliseconds may finish before a newer recipe begins, so
/// that the picture follows a slider while it is dragged.
const SHORT_PASS: f64 = 400.0;
/// The recipe, the engine that works on it, and the times.
pub struct Studio {
    registry: Registry,
    generator: &'static Generator,
    recipe: Recipe,
    engine: Box<dyn Engine>,
    is_live: bool,
    /// Milliseconds by stage of the latest pass through it.
    spent: Vec<f64>,
    /// The first stage that the present recipe has changed.
    first: usize,
    /// The stage of the last slice, unless it has to start again.
    last: Option<usize>,
    /// Milliseconds of the last finished shading; infinite before there is one.
    last_shading: f64,
}

impl Studio {
    /// A studio for one of these generators, before any work.
    pub fn new(registry: Registry, recipe: Recipe) -> Self {
        let engine = (registry.of(&recipe).engine)(&recipe);
        Self::with_engine(registry, recipe, engine)
    }

    /// A studio with an engine that was made for this recipe in a special way.
    pub fn with_engine(registry: Registry, recipe: Recipe, engine: Box<dyn Engine>) -> Self {
        let generator = registry.of(&recipe);
        Self {
            registry,
            generator,
            recipe,
            engine,
            is_live: false,
            spent: vec![0.0; generator.stages.len()],
            first: 0,
            last: None,
            last_shading: f64::INFINITY,
        }
    }

    /// The generators whose recipes it accepts.
    pub fn registry(&self) -> Registry {
        self.registry
    }

    /// The present generator.
    pub fn generator(&self) -> &'static Generator {
        self.generator
    }

    /// The present engine.
    pub fn engine(&self) -> &dyn Engine {
        &*self.engine
    }

    /// The present engine, to draw views and for its capabilities.
    pub fn engine_mut(&mut self) -> &mut dyn Engine {
        &mut *self.engine
    }

    /// The maps of the picture.
    ///
    /// # Errors
    /// If the generator has none.
    pub fn maps(&mut self) -> Result<&mut dyn Maps, Notice> {
        self.engine.maps().ok_or(Code::NoSuchFile.into())
    }

    /// The mesh files of the bodies.
    ///
    /// # Errors
    /// If the generator has none.
    pub fn meshes(&mut self) -> Result<&mut dyn Meshes, Notice> {
        self.engine.meshes().ok_or(Code::NoSuchFile.into())
    }

    /// The frames of the bodies.
    ///
    /// # Errors
    /// If the generator has none.
    #[cfg(house)]
    pub fn frames(&mut self) -> Result<&mut dyn Frames, Notice> {
        self.engine.frames().ok_or(Code::NoSuchFile.into())
    }

    /// The files that recipes name.
    ///
    /// # Errors
    /// If the generator uses no files.
    #[cfg(house)]
    pub fn files(&mut self) -> Result<&mut dyn Files, Notice> {
        self.engine.files().ok_or(Code::NoSuchFile.into())
    }

    /// The latest recipe.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// Pixels along the picture's side.
    pub fn side(&self) -> usize {
        self.engine.side()
    }

    /// The word of the stage at work, or "done", or "error" if no picture can be made of the recipe
    /// ([`Studio::problem`] has the reason).
    pub fn stage(&self) -> &'static str {
        match self.engine.at() {
            _ if self.engine.is_drafting() => self.generator.course.stepping,
            _ if self.engine.failure().is_some() => "error",
            Some(at) => self.generator.stages[at],
            None => "done",
        }
    }

    /// The stage of the next slice; `None` if all is done or the work cannot go on.
    pub fn at_work(&self) -> Option<usize> {
        let at = self.engine.at();
        at.filter(|_| self.engine.failure().is_none())
    }

    /// The index of a stage among those of the generator.
    fn place_of(&self, stage: &str) -> Option<usize> {
        let mut stages = self.generator.stages.iter();
        stages.position(|word| *word == stage)
    }

    /// Whether the picture is finished.
    pub fn done(&self) -> bool {
        self.engine.at().is_none() && !self.engine.is_drafting()
    }

    /// Why the work stopped; `None` without a problem.
    pub fn problem(&self) -> Option<&Notice> {
        let failure = self.engine.failure();
        failure.filter(|_| !self.engine.is_drafting())
    }

    /// The progress of the work.
    pub fn progress(&self) -> Progress {
        self.engine.progress()
    }

    /// The last finished picture: opaque RGBA, row after row from the top.
    pub fn picture(&self) -> Option<&[u8]> {
        Some(self.engine.picture()).filter(|picture| !picture.is_empty())
    }

    /// Digest of the result, 16 hexadecimal digits; empty until the work is done.
    pub fn digest(&self) -> String {
        match self.done() {
            true => self.engine.digest(),
            false => String::new(),
        }
    }

    /// The number of times that each stage has finished, by its word, in the stages' order.
    pub fn runs(&self) -> Vec<(&'static str, u64)> {
        let words = self.generator.stages.iter().copied();
        words.zip(self.engine.runs()).collect()
    }

    /// Milliseconds spent by stage in the latest pass through it, in the stages' order.
    pub fn milliseconds(&self) -> Vec<StageTime> {
        let times = self.generator.stages.iter().zip(&self.spent);
        times.map(|(&stage, &ms)| StageTime { stage, ms }).collect()
    }

    /// The report of the run so far.
    pub fn report(&mut self) -> Report {
        let last = self.progress();
        let mut report = Report {
            link: self.recipe.link(),
            size: self.side(),
            cells: last.cells,
            steps: last.steps,
            converged: last.converged,
            largest_move: last.largest_move,
            added: last.added,
            removed: last.removed,
            energy: self.engine.energy(),
            milliseconds: self.milliseconds(),
            hash: self.digest(),
            ..Report::default()
        };
        self.engine.report(&mut report);
        report
    }

    /// Takes a new recipe; the stages that it makes stale run again in the next ticks. The latest recipe
    /// replaces one still at work. A recipe of another generator ends the engine.
    pub fn set_recipe(&mut self, recipe: Recipe) {
        if !recipe.is_of(self.recipe.schema()) {
            let is_live = self.is_live;
            *self = Self::new(self.registry, recipe);
            self.set_live(is_live);
            return;
        }
        self.engine.ask(&recipe);
        self.recipe = recipe;
        if !self.engine.is_drafting() && !self.lets_finish() {
            self.take_up();
        }
    }

    /// Takes a file and adds it to the recipe in a role, which is the key of a file parameter; without a role,
    /// in the first one. Returns notices for the user.
    ///
    /// # Errors
    ///
    /// If the generator uses no files, or has no such role.
    #[cfg(house)]
    pub fn open_file(
        &mut self,
        role: Option<&str>,
        file: GivenFile,
    ) -> Result<Vec<Notice>, Notice> {
        let schema = self.recipe.schema();
        let has_role = |row: &&Parameter| {
            row.item == Some(Item::File) && role.is_none_or(|role| row.key.0 == role)
        };
        let row = schema.rows.iter().find(has_role).ok_or(Code::NoSuchFile)?;
        let named = file.named().row();
        self.files()?.give(file);
        let mut recipe = self.recipe.clone();
        let said = schema.rules.draw(&mut recipe, row.key, Some(vec![named]))?;
        self.set_recipe(recipe);
        Ok(said)
    }

    /// Makes the steps again, from the held one if there is one, and all stages after them, from the same recipe.
    /// Earlier stages keep their results.
    pub fn restart(&mut self) {
        self.drop_draft(true);
        self.take_up();
        self.engine.forget_steps();
        let stepping = self.place_of(self.generator.course.stepping);
        self.begin(stepping.unwrap_or(0));
    }

    /// While live, a draft may be shown instead of the stages' results. The draft continues from the present result,
    /// and nothing else is worked on. The result of the previous recipe stays until live ends. Then the work goes on as
    /// if the latest recipe had just been set, but the draft is shown until the stages have something to show.
    pub fn set_live(&mut self, on: bool) {
        let ends = self.is_live && !on;
        self.is_live = on;
        if let Some(drafts) = self.engine.drafts() {
            drafts.set_live(on);
        }
        if ends {
            if !self.lets_finish() {
                self.take_up();
            }
            self.drop_draft(false);
        }
    }

    fn drop_draft(&mut self, all: bool) {
        if let Some(drafts) = self.engine.drafts() {
            drafts.drop_draft(all);
        }
    }

    fn last_stage(&self) -> usize {
        self.spent.len() - 1
    }

    /// Whether the work is so near its end that it should finish before the new recipe begins. If the new
    /// recipe changes only later stages, it can begin at once, because nothing is dropped.
    fn lets_finish(&self) -> bool {
        let finisher = self.place_of(self.generator.course.finisher);
        let (Some(at), Some(stale), Some(finisher)) =
            (self.at_work(), self.engine.stale(), finisher)
        else {
            return false;
        };
        let late = at >= stale && stale >= finisher;
        late && (at == self.last_stage() || self.pass(finisher) < SHORT_PASS)
    }

    /// Milliseconds of the present pass from this stage on.
    fn pass(&self, from: usize) -> f64 {
        let begun = self.last.map_or(0, |last| last + 1);
        let skipped = from.max(self.first);
        self.spent[..begun].iter().skip(skipped).sum()
    }

    /// Makes the latest recipe the present one.
    fn take_up(&mut self) {
        let stale = self.engine.stale();
        self.engine.take_up();
        if let Some(stale) = stale {
            self.begin(stale);
        }
    }

    /// Notes that a stage has new work.
    fn begin(&mut self, stage: usize) {
        self.first = stage;
        // Earlier stages go on with their work.
        if self.engine.at().is_some_and(|at| at >= stage) {
            self.last = None;
        }
    }
}
