//! What a generator's machine is to those who run it: stages that work in slices, views, and files.

use crate::export::{Map, MapKind, MeshFormat, Report};
use crate::notice::{Code, Notice};
use crate::recipe::Recipe;
use std::any::Any;

/// A clock: milliseconds, which may stand still but do not count for any result.
pub type Clock<'a> = &'a mut dyn FnMut() -> f64;

/// How far the work is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Progress {
    /// Cells, or bodies, so far.
    pub cells: usize,
    /// Steps of what moves.
    pub steps: u32,
    /// The largest move of the last step, in cell sizes.
    pub largest_move: f64,
    /// Added and removed since the first were placed.
    pub added: u32,
    /// See `added`.
    pub removed: u32,
    /// Did it come to rest by itself?
    pub converged: bool,
    /// Stones, or bodies, that are finished.
    pub stones: usize,
}

/// What one slice of work gave of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSlice {
    /// The file begins with these parts: those of calls before are of another one.
    pub begun: bool,
    /// The next parts of the file, one after the other.
    pub parts: Vec<Vec<u8>>,
    /// The file ends with them.
    pub done: bool,
}

/// What one slice of work gave of a bigger picture.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureSlice {
    /// The picture begins with these rows: those of calls before are of another one.
    pub begun: bool,
    /// How much of the work is done, about, 0..1.
    pub progress: f64,
    /// Pixels along the picture's side.
    pub side: usize,
    /// Red, green, blue of the next pixels, whole rows from the top; mostly none yet.
    pub rows: Vec<u8>,
    /// The picture ends with them.
    pub done: bool,
}

/// A machine that makes pictures of one generator's recipes. Stages are told by their places among the
/// generator's stage words.
pub trait Engine: Any {
    /// From now on this recipe is the latest.
    fn ask(&mut self, recipe: &Recipe);

    /// The first stage of which the latest recipe asks something else than the one at work.
    fn stale(&self) -> Option<usize>;

    /// Makes the latest recipe the one at work.
    fn take_up(&mut self);

    /// All stages are to run again.
    fn forget(&mut self);

    /// Pixels along the side of the picture at work.
    fn side(&self) -> usize;

    /// The first stage that is not fresh; none where all is done.
    fn at(&self) -> Option<usize>;

    /// Why the work cannot go on.
    fn failure(&self) -> Option<&Notice>;

    /// The stage that has work to do.
    fn at_work(&self) -> Option<usize> {
        self.at().filter(|_| self.failure().is_none())
    }

    /// One slice of the work.
    fn advance(&mut self);

    /// Is the next slice a step, which waits while the work is held?
    fn is_step(&self) -> bool {
        false
    }

    /// The stage that goes in steps.
    fn stepping(&self) -> Option<usize> {
        None
    }

    /// The first stage of the finisher: from there on a short pass is let finish.
    fn finisher(&self) -> usize;

    /// Is the picture that is there of an earlier recipe, whose bodies are other ones?
    fn is_forming(&self) -> bool;

    /// How often each stage has finished.
    fn runs(&self) -> Vec<u64>;

    /// How far the work is.
    fn progress(&self) -> Progress;

    /// The potential energy of what moves, in units of a cell's; 0 where nothing does.
    fn energy(&mut self) -> f64 {
        0.0
    }

    /// While live, a recipe may be shown by a draft that goes on from what is there, instead of the
    /// stages.
    fn set_live(&mut self, _on: bool) {}

    /// Is a draft at work, and not the stages?
    fn is_drafting(&self) -> bool {
        false
    }

    /// Is a draft to be seen?
    fn shows_draft(&self) -> bool {
        false
    }

    /// Works on the draft for about `budget` milliseconds; true when it may look different.
    fn advance_draft(&mut self, _clock: Clock, _budget: f64) -> bool {
        false
    }

    /// Drops the draft: all of them, or only one that is not needed any more.
    fn drop_draft(&mut self, _all: bool) {}

    /// The picture of a view, by its words: opaque RGBA, row after row from the top. While a stage has
    /// nothing to show yet, what was there before.
    fn view(&mut self, words: &str) -> &[u8];

    /// Works for about `budget` milliseconds on what is much to draw of a view, at least one piece;
    /// true when nothing of it is left for [`Engine::view`].
    fn prepare(&mut self, words: &str, clock: Clock, budget: f64) -> bool;

    /// What of a view shows nothing, by its word, and why, in a word.
    fn absences(&mut self, words: &str) -> Vec<(&'static str, &'static str)>;

    /// The picture last finished, as [`Engine::view`]; empty before there is one.
    fn picture(&self) -> &[u8];

    /// Hex digest of what was made last.
    fn digest(&self) -> String;

    /// A map of the finished picture.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or there is no such map.
    fn map(&self, kind: MapKind) -> Result<Map, Notice>;

    /// Works for about `budget` milliseconds on the finished picture with `scale` times as many pixels
    /// along its side. Begins anew where the picture or the scale is another one than the last time, or
    /// the last one was done.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or would be too large.
    fn picture_file(
        &mut self,
        scale: usize,
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice>;

    /// A map of the bigger picture that was finished last.
    ///
    /// # Errors
    /// A notice where there is none, or of another picture.
    fn bigger_map(&self, kind: MapKind) -> Result<Map, Notice>;

    /// Works for about `budget` milliseconds on the file of all surfaces. Begins anew where the picture or
    /// the format is another one than the last time.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or there is no such file.
    fn mesh_file(
        &mut self,
        _format: MeshFormat,
        _clock: Clock,
        _budget: f64,
    ) -> Result<MeshSlice, Notice> {
        Err(Code::NoSuchFile.into())
    }

    /// Lets go of files in the making, and of what was kept of a bigger picture for its maps.
    fn stop_file(&mut self);

    /// Adds what only this generator can tell to the figures of the run.
    fn report(&mut self, report: &mut Report);

    /// Files of what was made, as text, for whoever measures: names and contents.
    #[cfg(not(target_arch = "wasm32"))]
    fn data(&self) -> Vec<(&'static str, String)>;
}
