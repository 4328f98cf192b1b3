//! The engine of any generator of bodies in space. A generator says what is its own in [`SceneEngine`] and
//! [`SceneStages`]; the interfaces for the studio follow from these.

use super::picture::{ScenePicture, SceneSource, turn};
use super::shared::SharedNodes;
use super::view::{prepare, view};
use crate::export::Report;
use crate::generators::{
    Clock, Engine, Files, FrameSlice, Frames, GivenFile, Meshes, MissingFile, ModelFacts, Progress,
    Rewind, SeenBody, TurnOrder,
};
use crate::graph::{Node, Wiring};
use crate::notice::Notice;
use crate::recipe::Recipe;
use crate::scene::Frame;

/// The stages of a generator of bodies in space. A stage is its index.
pub(crate) trait SceneStages: Wiring<Stage = usize> {
    /// The parameters of the finished bodies.
    type Look: Clone + PartialEq;
    /// The work on them.
    type Finishing;

    /// The index of the stage that makes the bodies; the stages before it form them.
    const FINISHER: usize;

    /// The nodes that all such generators have.
    fn shared(&self) -> &SharedNodes<Self::Look, Self::Finishing>;

    /// The same, mutable.
    fn shared_mut(&mut self) -> &mut SharedNodes<Self::Look, Self::Finishing>;

    /// Notes the parameters of the latest recipe.
    fn ask(&mut self, recipe: &Recipe);

    /// Makes the stage that makes steps stale, and all stages after it.
    fn forget_steps(&mut self);

    /// The steps forward and back, if states of them are kept.
    fn rewind(&mut self) -> Option<&mut dyn Rewind> {
        None
    }

    /// Remarks on mended files, and on parts that do not fit well.
    fn remarks(&self) -> Vec<Notice>;

    /// Whether the next slice begins a step that a viewer sees.
    fn is_moving(&self) -> bool;

    /// Whether there is a scene of the present value of a node, even if another look is wanted.
    fn has_scene_of<P: Clone + PartialEq, W, T>(&self, node: &Node<P, W, T>) -> bool {
        let bodies = self.shared().bodies.made();
        let bodies = bodies.filter(|_| self.is_fresh(node));
        bodies.is_some_and(|bodies| bodies.shows == node.revision())
    }
}

/// A generator of bodies in space: its stages, and what it tells of them.
pub(crate) trait SceneEngine: SceneSource + Meshes {
    /// Its stages.
    type Stages: SceneStages;

    /// Its stages.
    fn made(&self) -> &Self::Stages;

    /// The same, mutable.
    fn made_mut(&mut self) -> &mut Self::Stages;

    /// The pictures of its scenes.
    fn pictures(&self) -> &ScenePicture<Self>;

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

    /// The words that tell of a body what numbers cannot, each by the word of its kind.
    fn words_of(&self, _id: u32) -> Vec<(&'static str, String)> {
        Vec::new()
    }

    /// The caption of a view that is shown.
    fn caption_of(&self, words: &str) -> Option<Notice>;

    /// The words of the steps in the making of a body.
    fn steps_of(&self, _id: u32) -> Vec<String> {
        Vec::new()
    }

    /// The place on the model at a pixel of the last frame, in the whole numbers of painted rows
    /// ([`crate::recipe::Item`]); `None` if the pixel is beside the model.
    fn place_seen_at(&self, _x: usize, _y: usize) -> Option<[i64; 3]> {
        None
    }

    /// The pixel of such a place in the last frame; `None` if the place is not visible.
    fn pixel_of_place(&self, _place: [i64; 3]) -> Option<[f64; 2]> {
        None
    }

    /// Measures of the model that a file gives.
    fn model_facts(&self) -> Option<ModelFacts> {
        None
    }
}

impl<E: SceneEngine> Engine for E {
    fn ask(&mut self, recipe: &Recipe) {
        self.made_mut().ask(recipe);
    }

    fn stale(&self) -> Option<usize> {
        self.made().stale()
    }

    fn take_up(&mut self) {
        self.made_mut().take_up();
    }

    fn forget_steps(&mut self) {
        self.made_mut().forget_steps();
    }

    fn side(&self) -> usize {
        self.made().shared().still.params().side
    }

    fn at(&self) -> Option<usize> {
        self.made().at()
    }

    fn failure(&self) -> Option<&Notice> {
        self.made().failure()
    }

    fn remarks(&self) -> Vec<Notice> {
        self.made().remarks()
    }

    fn advance(&mut self) {
        self.made_mut().advance();
    }

    fn is_step(&self) -> bool {
        self.made().is_moving()
    }

    fn is_forming(&self) -> bool {
        self.made().at().is_some_and(|at| at < E::Stages::FINISHER)
    }

    fn runs(&self) -> Vec<u64> {
        self.made().runs()
    }

    fn progress(&self) -> Progress {
        self.work_done()
    }

    fn energy(&mut self) -> f64 {
        self.work_energy()
    }

    fn view(&mut self, words: &str) -> &[u8] {
        view(self, words)
    }

    fn prepare(&mut self, words: &str, clock: Clock, budget: f64) -> bool {
        prepare(self, words, clock, budget)
    }

    fn picture(&self) -> &[u8] {
        self.made().shared().picture()
    }

    fn digest(&self) -> String {
        self.made().shared().digest()
    }

    fn report(&mut self, report: &mut Report) {
        report.cells = self.body_count();
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn data(&self) -> Vec<(&'static str, String)> {
        self.texts()
    }

    fn rewind(&mut self) -> Option<&mut dyn Rewind> {
        self.made_mut().rewind()
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

impl<E: SceneEngine> Frames for E {
    fn turn(&mut self, order: &TurnOrder, clock: Clock, budget: f64) -> Result<FrameSlice, Notice> {
        turn(self, order, clock, budget)
    }

    fn frame(&self) -> Option<&Frame> {
        self.pictures().frame()
    }

    fn body_at(&mut self, x: usize, y: usize) -> Option<SeenBody> {
        let yaw = self.made().shared().still.params().yaw;
        let body = self.scene_picture().body_at(yaw, x, y)?;
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

    fn place_at(&self, x: usize, y: usize) -> Option<[i64; 3]> {
        self.place_seen_at(x, y)
    }

    fn pixel_of(&self, place: [i64; 3]) -> Option<[f64; 2]> {
        self.pixel_of_place(place)
    }
}

impl<E: SceneEngine> Files for E {
    fn give(&mut self, file: GivenFile) {
        let digest = file.digest();
        let files = &mut self.made_mut().shared_mut().files;
        files.give(digest, file.into_bytes());
    }

    fn missing(&self) -> Vec<MissingFile> {
        self.made().shared().files.missing()
    }

    fn model(&self) -> Option<ModelFacts> {
        self.model_facts()
    }
}
