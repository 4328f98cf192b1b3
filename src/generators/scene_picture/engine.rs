//! The engine of any generator of bodies in space. A generator implements [`SceneStages`] and [`SceneFacts`]; the
//! interfaces for the studio follow from these two.

use super::picture::{ScenePicture, SceneSource};
use super::shared::SharedNodes;
use super::view::first_known;
use crate::export::Report;
use crate::generators::{
    Clock, Engine, Files, FrameSlice, Frames, GivenFile, Meshes, MissingFile, ModelFacts, Progress,
    Rewind, SeenBody, SeenLabel, TurnOrder,
};
use crate::graph::{Node, Wiring};
use crate::notice::Notice;
use crate::recipe::Recipe;
use crate::scene::Frame;

/// The stages of a generator of bodies in space. A stage is its index.
pub(crate) trait SceneStages: Wiring<Stage = usize> + SceneSource {
    /// The parameters of the finished bodies.
    type Look: Clone + PartialEq;
    /// The unfinished work on the bodies.
    type Finishing;
    /// The unfinished mesh file, with what is kept for it.
    type Saving: Default;

    /// The index of the stage that makes the bodies; the stages before it form them.
    const FINISHER: usize;
    /// The words of the views, in the order of the page. The first two show the picture once it is finished.
    const VIEWS: &'static [&'static str];

    /// The stages of a recipe, with nothing made.
    fn new(recipe: &Recipe) -> Self;

    /// The nodes that all generators of bodies in space have.
    fn shared(&self) -> &SharedNodes<Self::Look, Self::Finishing>;

    /// The nodes of [`Self::shared`], mutable.
    fn shared_mut(&mut self) -> &mut SharedNodes<Self::Look, Self::Finishing>;

    /// Notes the parameters of the latest recipe.
    fn ask(&mut self, recipe: &Recipe);

    /// Marks the stage with the steps as stale, and all stages after it.
    fn forget_steps(&mut self);

    /// The steps forward and back, if the states of steps are kept.
    fn rewind(&mut self) -> Option<&mut dyn Rewind> {
        None
    }

    /// Remarks on mended files, and on parts that do not fit well.
    fn remarks(&self) -> Vec<Notice>;

    /// Whether the next slice begins a step that a viewer sees.
    fn is_moving(&self) -> bool;

    /// Whether the last scene shows the present value of this node, even if another look is wanted.
    fn has_scene_of<P: Clone + PartialEq, W, T>(&self, node: &Node<P, W, T>) -> bool {
        let bodies = self.shared().bodies.made();
        let bodies = bodies.filter(|_| self.is_fresh(node));
        bodies.is_some_and(|bodies| bodies.shows == node.revision())
    }

    /// The finished picture, if the words of a view ask for it.
    fn finished_picture(&self, words: &str) -> Option<&[u8]> {
        let is_picture = first_known(words, Self::VIEWS).is_none_or(|place| place < 2);
        (is_picture && self.at().is_none()).then(|| self.shared().picture())
    }
}

/// The engine of a generator of bodies in space.
pub(crate) struct SceneEngine<S: SceneStages> {
    pub made: S,
    /// The pictures of its scenes.
    pub picture: ScenePicture<S>,
    pub saving: S::Saving,
}

impl<S: SceneStages> SceneEngine<S> {
    /// An engine for a recipe; no stage is done yet.
    pub fn new(recipe: &Recipe) -> Self {
        Self {
            made: S::new(recipe),
            picture: ScenePicture::default(),
            saving: S::Saving::default(),
        }
    }
}

/// Facts about the work of one generator's engine.
pub(crate) trait SceneFacts: Meshes {
    /// The progress of the work.
    fn work_done(&self) -> Progress;

    /// The potential energy of bodies that move by forces; 0 if none do.
    fn work_energy(&mut self) -> f64 {
        0.0
    }

    /// The number of finished bodies.
    fn body_count(&self) -> usize;

    /// The results as text files: names and contents.
    #[cfg(not(target_arch = "wasm32"))]
    fn texts(&self) -> Vec<(&'static str, String)>;

    /// The measures of a body, by their words.
    fn figures(&self, id: u32) -> Vec<(&'static str, f64)>;

    /// Properties of a body that are words instead of numbers, each with the word of its kind.
    fn words_of(&self, _id: u32) -> Vec<(&'static str, String)> {
        Vec::new()
    }

    /// The caption of a view that is shown.
    fn caption_of(&self, words: &str) -> Option<Notice>;

    /// The labels that the shown view has in the last frame, the most important one first.
    fn labels_seen(&self) -> Vec<SeenLabel> {
        Vec::new()
    }

    /// The words of the steps in the making of a body.
    fn steps_of(&self, _id: u32) -> Vec<String> {
        Vec::new()
    }

    /// The place on the model at a pixel of the last frame, in the whole numbers of painted rows
    /// ([`crate::recipe::Item`]); `None` if the pixel is beside the model.
    fn place_seen_at(&self, _x: usize, _y: usize) -> Option<[i64; 3]> {
        None
    }

    /// The pixel of a place on the model in the last frame; `None` if the place is not visible.
    fn pixel_of_place(&self, _place: [i64; 3]) -> Option<[f64; 2]> {
        None
    }

    /// Measures of the model that a file gives.
    fn model_facts(&self) -> Option<ModelFacts> {
        None
    }
}

impl<S: SceneStages> Engine for SceneEngine<S>
where
    Self: SceneFacts,
{
    fn ask(&mut self, recipe: &Recipe) {
        self.made.ask(recipe);
    }

    fn stale(&self) -> Option<usize> {
        self.made.stale()
    }

    fn take_up(&mut self) {
        self.made.take_up();
    }

    fn forget_steps(&mut self) {
        self.made.forget_steps();
    }

    fn side(&self) -> usize {
        self.made.shared().still.params().side
    }

    fn at(&self) -> Option<usize> {
        self.made.at()
    }

    fn failure(&self) -> Option<&Notice> {
        self.made.failure()
    }

    fn remarks(&self) -> Vec<Notice> {
        self.made.remarks()
    }

    fn advance(&mut self) {
        self.made.advance();
    }

    fn is_step(&self) -> bool {
        self.made.is_moving()
    }

    fn is_forming(&self) -> bool {
        self.made.at().is_some_and(|at| at < S::FINISHER)
    }

    fn runs(&self) -> Vec<u64> {
        self.made.runs()
    }

    fn progress(&self) -> Progress {
        self.work_done()
    }

    fn energy(&mut self) -> f64 {
        self.work_energy()
    }

    fn view(&mut self, words: &str) -> &[u8] {
        let still = self.made.shared().still.params().clone();
        let finished = self.made.finished_picture(words).map(<[u8]>::to_vec);
        let of = (&mut self.made, &still);
        self.picture.view(of, words, finished)
    }

    fn prepare(&mut self, words: &str, clock: Clock, budget: f64) -> bool {
        if self.made.finished_picture(words).is_some() {
            return true;
        }
        let still = self.made.shared().still.params().clone();
        let of = (&mut self.made, &still);
        self.picture.prepare(of, words, clock, budget)
    }

    fn picture(&self) -> &[u8] {
        self.made.shared().picture()
    }

    fn digest(&self) -> String {
        self.made.shared().digest()
    }

    fn report(&mut self, report: &mut Report) {
        report.cells = self.body_count();
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn data(&self) -> Vec<(&'static str, String)> {
        self.texts()
    }

    fn rewind(&mut self) -> Option<&mut dyn Rewind> {
        self.made.rewind()
    }

    fn meshes(&mut self) -> Option<&mut dyn Meshes> {
        Some(self)
    }

    fn frames(&mut self) -> Option<&mut dyn Frames> {
        Some(self)
    }

    fn files(&mut self) -> Option<&mut dyn Files> {
        Some(self)
    }
}

impl<S: SceneStages> Frames for SceneEngine<S>
where
    Self: SceneFacts,
{
    fn turn(&mut self, order: &TurnOrder, clock: Clock, budget: f64) -> Result<FrameSlice, Notice> {
        let still = self.made.shared().still.params().clone();
        let of = (&mut self.made, &still);
        self.picture.turn(of, order, clock, budget)
    }

    fn frame(&self) -> Option<&Frame> {
        self.picture.frame()
    }

    fn body_at(&mut self, x: usize, y: usize) -> Option<SeenBody> {
        let yaw = self.made.shared().still.params().yaw;
        let body = self.picture.body_at(yaw, x, y)?;
        let (figures, words) = (self.figures(body.id), self.words_of(body.id));
        Some(SeenBody {
            figures,
            words,
            ..body
        })
    }

    fn making(&self, id: u32) -> Vec<String> {
        self.steps_of(id)
    }

    fn caption(&self, words: &str) -> Option<Notice> {
        self.caption_of(words)
    }

    fn labels(&self) -> Vec<SeenLabel> {
        self.labels_seen()
    }

    fn place_at(&self, x: usize, y: usize) -> Option<[i64; 3]> {
        self.place_seen_at(x, y)
    }

    fn pixel_of(&self, place: [i64; 3]) -> Option<[f64; 2]> {
        self.pixel_of_place(place)
    }
}

impl<S: SceneStages> Files for SceneEngine<S>
where
    Self: SceneFacts,
{
    fn give(&mut self, file: GivenFile) {
        let digest = file.digest();
        let files = &mut self.made.shared_mut().files;
        files.give(digest, file.into_bytes());
    }

    fn missing(&self) -> Vec<MissingFile> {
        self.made.shared().files.missing()
    }

    fn model(&self) -> Option<ModelFacts> {
        self.model_facts()
    }
}
