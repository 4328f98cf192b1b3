//! The interface of every engine: stages that work in slices, a picture, and views. Further capabilities, which only
//! some engines have, are traits of their own; the methods from [`Engine::drafts`] on return them.

use super::Clock;
#[cfg(house)]
use super::in_space::{Files, Frames};
use super::inspection::Products;
use super::offers::{Drafts, Inspect, Maps, Meshes, Outlines, Rewind, Steps};
use crate::export::Report;
use crate::notice::Notice;
use crate::packing::StepReport;
use crate::recipe::Recipe;

/// The progress of the work.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Progress {
    /// The number of cells, or bodies.
    pub cells: usize,
    /// The number of steps in which cells or bodies have moved so far.
    pub steps: u32,
    /// The largest move of the last step, in cell sizes.
    pub largest_move: f64,
    /// Cells added after the first cells were placed.
    pub added: u32,
    /// Cells removed after the first cells were placed.
    pub removed: u32,
    /// Whether the cells or bodies came to rest by themselves.
    pub converged: bool,
    /// The number of finished stones, or bodies.
    pub stones: usize,
}

impl Progress {
    /// The progress after a step of a packing, with this number of finished stones.
    pub(super) fn of_packing(last: StepReport, stones: usize) -> Self {
        Self {
            cells: last.cells,
            steps: last.step,
            largest_move: last.largest_move,
            added: last.added,
            removed: last.removed,
            converged: last.converged,
            stones,
        }
    }
}

/// Makes pictures of one generator's recipes, slice by slice. A stage is given by its index in
/// [`super::Generator::stages`].
pub trait Engine {
    /// Sets the latest recipe. The work continues with the present one until [`Engine::take_up`].
    fn ask(&mut self, recipe: &Recipe);

    /// The first stage in which the latest recipe differs from the present one; `None` if no stage does.
    fn stale(&self) -> Option<usize>;

    /// Makes the latest recipe the present one.
    fn take_up(&mut self);

    /// Marks the stage that makes steps as stale, so that it and all stages after it run again. If a step is held, the
    /// new run goes on from that step.
    fn forget_steps(&mut self);

    /// Pixels along the side of the present picture.
    fn side(&self) -> usize;

    /// The first stage that is not fresh; `None` when all is done.
    fn at(&self) -> Option<usize>;

    /// Why the work cannot go on; `None` while it can.
    fn failure(&self) -> Option<&Notice>;

    /// Remarks on the result so far: repairs, and parts that do not fit well.
    fn remarks(&self) -> Vec<Notice> {
        Vec::new()
    }

    /// Does one slice of work, on the first stage that is not fresh.
    fn advance(&mut self);

    /// Whether the next slice begins a step. While the work is held, no step begins, but a step that has begun is
    /// finished.
    fn is_step(&self) -> bool {
        false
    }

    /// Whether the cells or bodies that form differ from those of the present picture.
    fn is_forming(&self) -> bool;

    /// Whether a draft is active instead of the stages.
    fn is_drafting(&self) -> bool {
        false
    }

    /// How often each stage has finished.
    fn runs(&self) -> Vec<u64>;

    /// The progress of the work.
    fn progress(&self) -> Progress;

    /// The potential energy of the cells or bodies that move or have moved last, in units of the mean cell's spring
    /// constant k0; 0 before any has moved.
    fn energy(&mut self) -> f64 {
        0.0
    }

    /// The picture of a view, by its words: opaque RGBA, row after row from the top. While a stage has nothing to show
    /// yet, the last picture stays.
    fn view(&mut self, words: &str) -> &[u8];

    /// Draws a part of a slow view in advance: for about `budget` milliseconds, but at least one piece. True if
    /// [`Engine::view`] has no long work left.
    fn prepare(&mut self, words: &str, clock: Clock, budget: f64) -> bool;

    /// The last finished picture, in the form of [`Engine::view`]; empty before there is one.
    fn picture(&self) -> &[u8];

    /// Digest of the planes or bodies made last, as 16 hexadecimal digits. Equal results have equal digests.
    fn digest(&self) -> String;

    /// Adds the figures of this generator to a report.
    fn report(&mut self, report: &mut Report);

    /// The results as text files, for measurements: names and contents.
    #[cfg(not(target_arch = "wasm32"))]
    fn data(&self) -> Vec<(&'static str, String)>;

    /// Drafts, which show a recipe while it is being changed.
    fn drafts(&mut self) -> Option<&mut dyn Drafts> {
        None
    }

    /// Maps of the finished picture, and larger pictures.
    fn maps(&mut self) -> Option<&mut dyn Maps> {
        None
    }

    /// Mesh files of the bodies.
    fn meshes(&mut self) -> Option<&mut dyn Meshes> {
        None
    }

    /// Measures of cells in a plane.
    fn inspect(&mut self) -> Option<&mut dyn Inspect> {
        None
    }

    /// The steps of a packing, forward and back.
    fn rewind(&mut self) -> Option<&mut dyn Rewind> {
        None
    }

    /// A packing in a plane, step by step in numbers.
    fn steps(&mut self) -> Option<&mut dyn Steps> {
        None
    }

    /// The results of the stages of a picture in a plane, for measurements.
    fn products(&self) -> Option<Products<'_>> {
        None
    }

    /// The outline that is filled with cells.
    fn outlines(&mut self) -> Option<&mut dyn Outlines> {
        None
    }

    /// Frames of the bodies in space.
    #[cfg(house)]
    fn frames(&mut self) -> Option<&mut dyn Frames> {
        None
    }

    /// The files that recipes name.
    #[cfg(house)]
    fn files(&mut self) -> Option<&mut dyn Files> {
        None
    }
}
