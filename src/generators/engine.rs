//! The interface of an engine: stages that work in slices, views, and files.

use super::budget::Clock;
#[cfg(house)]
use super::given::{GivenFile, MissingFile};
#[cfg(house)]
use super::turntable::{FrameSlice, SeenBody, TurnOrder};
use crate::export::{Map, MapKind, MeshOrder, MeshSize, Report};
use crate::notice::{Code, Notice};
use crate::recipe::Recipe;
#[cfg(house)]
use crate::scene::Frame;
use std::any::Any;

/// The progress of the work.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Progress {
    /// The number of cells, or bodies.
    pub cells: usize,
    /// The number of steps that they have moved by.
    pub steps: u32,
    /// The largest move of the last step, in cell sizes.
    pub largest_move: f64,
    /// Cells added since the first were placed.
    pub added: u32,
    /// Cells removed since then.
    pub removed: u32,
    /// Whether it came to rest by itself.
    pub converged: bool,
    /// The number of finished stones, or bodies.
    pub stones: usize,
}

/// The result of one slice of work on a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSlice {
    /// Whether a new file begins with these parts; those of earlier calls belong to another one.
    pub begun: bool,
    /// The next parts of the file, in order.
    pub parts: Vec<Vec<u8>>,
    /// Whether the file ends with them.
    pub done: bool,
}

/// The result of one slice of work on a bigger picture, or on its maps.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureSlice {
    /// Whether a new picture begins with these rows; those of earlier calls belong to another one.
    pub begun: bool,
    /// The share of the work that is done, 0..1, a rough estimate.
    pub progress: f64,
    /// The next rows of each requested map, or of the picture, from the top; empty in most slices.
    pub rows: Vec<Map>,
    /// The lowest and the highest value of its bump plane, in picture units, once that is finished.
    pub heights: (f32, f32),
    /// Whether the picture ends with them.
    pub done: bool,
}

/// Makes pictures of one generator's recipes, slice by slice. A stage is given by its index in
/// [`super::Generator::stages`].
pub trait Engine: Any {
    /// Sets the latest recipe. The work continues with the present one until [`Engine::take_up`].
    fn ask(&mut self, recipe: &Recipe);

    /// The first stage in which the latest recipe differs from the present one.
    fn stale(&self) -> Option<usize>;

    /// Makes the latest recipe the present one.
    fn take_up(&mut self);

    /// Marks all stages as stale, so that they run again.
    fn forget(&mut self);

    /// Pixels along the side of the present picture.
    fn side(&self) -> usize;

    /// The first stage that is not fresh; `None` when all is done.
    fn at(&self) -> Option<usize>;

    /// Why the work cannot go on; `None` while it can.
    fn failure(&self) -> Option<&Notice>;

    /// Remarks on the result so far: what was mended, or does not fit well.
    fn remarks(&self) -> Vec<Notice> {
        Vec::new()
    }

    /// The stage of the next slice; `None` if all is done or the work cannot go on.
    fn at_work(&self) -> Option<usize> {
        self.at().filter(|_| self.failure().is_none())
    }

    /// Does one slice of work, on the first stage that is not fresh.
    fn advance(&mut self);

    /// Whether a step begins with the next slice. It waits while the work is held; the rest of a step does not.
    fn is_step(&self) -> bool {
        false
    }

    /// The stage that proceeds in steps, such as the packing.
    fn stepping(&self) -> Option<usize> {
        None
    }

    /// The first stage of the finisher: from there on a short pass is finished before a newer recipe begins.
    fn finisher(&self) -> usize;

    /// Whether the cells or bodies that form differ from those of the present picture.
    fn is_forming(&self) -> bool;

    /// How often each stage has finished.
    fn runs(&self) -> Vec<u64>;

    /// The progress of the work.
    fn progress(&self) -> Progress;

    /// The potential energy of moving cells, in units of the mean cell's spring constant k0; 0 if nothing moves.
    fn energy(&mut self) -> f64 {
        0.0
    }

    /// While live, a draft may show a recipe: it continues from the present state instead of running the stages.
    fn set_live(&mut self, _on: bool) {}

    /// Whether a draft is active instead of the stages.
    fn is_drafting(&self) -> bool {
        false
    }

    /// Whether a draft is shown.
    fn shows_draft(&self) -> bool {
        false
    }

    /// Works on the draft for about `budget` milliseconds; true when it may look different.
    fn advance_draft(&mut self, _clock: Clock, _budget: f64) -> bool {
        false
    }

    /// Drops the draft: always (`all`), or only if the stages have something to show instead.
    fn drop_draft(&mut self, _all: bool) {}

    /// The picture of a view, by its words: opaque RGBA, row after row from the top. While a stage has nothing to
    /// show yet, the last one stays.
    fn view(&mut self, words: &str) -> &[u8];

    /// Draws a part of a view that takes long, for about `budget` milliseconds but at least one piece. True if
    /// [`Engine::view`] has no long work left.
    fn prepare(&mut self, words: &str, clock: Clock, budget: f64) -> bool;

    /// The words of a view that show nothing, each with the word of the reason.
    fn absences(&mut self, words: &str) -> Vec<(&'static str, &'static str)>;

    /// The last finished picture, in the form of [`Engine::view`]; empty before there is one.
    fn picture(&self) -> &[u8];

    /// Digest of the last result, 16 hexadecimal digits: equal for equal planes.
    fn digest(&self) -> String;

    /// A map of the finished picture.
    ///
    /// # Errors
    /// A notice if the picture is not finished, or there is no such map.
    fn map(&self, kind: MapKind) -> Result<Map, Notice>;

    /// Works for about `budget` milliseconds, or until there are some megabytes of rows, on these maps of the
    /// finished picture with `scale` times as many pixels along its side; without maps, on the picture itself. Starts
    /// again if the order or the picture has changed, or the last file was done.
    ///
    /// # Errors
    /// A notice if the picture is not finished, or would be too large.
    fn picture_file(
        &mut self,
        order: (usize, &[MapKind]),
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice>;

    /// Works for about `budget` milliseconds on a mesh file. Starts again if the picture or the order has changed.
    ///
    /// # Errors
    /// A notice if the picture is not finished, or there is no such file.
    fn mesh_file(
        &mut self,
        _order: &MeshOrder,
        _clock: Clock,
        _budget: f64,
    ) -> Result<MeshSlice, Notice> {
        Err(Code::NoSuchFile.into())
    }

    /// The size of such a file; `None` if there is none.
    fn mesh_size(&self, _order: &MeshOrder) -> Option<MeshSize> {
        None
    }

    /// Works for about `budget` milliseconds on a frame of the bodies, seen from a slant. Starts again if the order
    /// has changed, or the last frame was done.
    ///
    /// # Errors
    /// A notice if the picture is not finished, or there are no bodies.
    #[cfg(house)]
    fn turn(
        &mut self,
        _order: &TurnOrder,
        _clock: Clock,
        _budget: f64,
    ) -> Result<FrameSlice, Notice> {
        Err(Code::NoSuchFile.into())
    }

    /// The frame last finished by [`Engine::turn`], until the next one begins.
    #[cfg(house)]
    fn frame(&self) -> Option<&Frame> {
        None
    }

    /// The body at a pixel of that frame.
    #[cfg(house)]
    fn body_at(&self, _x: usize, _y: usize) -> Option<SeenBody> {
        None
    }

    /// The words of the steps in the making of a body, by its id.
    #[cfg(house)]
    fn making(&self, _id: u32) -> Vec<String> {
        Vec::new()
    }

    /// The caption of a view that is shown: the meaning of its colours, or its counts.
    #[cfg(house)]
    fn caption(&self, _words: &str) -> Option<Notice> {
        None
    }

    /// The place of the model at a pixel of that frame, as rows of strokes and spots hold it; `None` beside the
    /// model.
    #[cfg(house)]
    fn place_at(&self, _x: usize, _y: usize) -> Option<[i64; 3]> {
        None
    }

    /// Where such a place is in that frame, in pixels; `None` if it is not visible there.
    #[cfg(house)]
    fn pixel_of(&self, _place: [i64; 3]) -> Option<[f64; 2]> {
        None
    }

    /// Takes a file for recipes that name it, in any role; false if this generator takes no files.
    #[cfg(house)]
    fn give(&mut self, _file: GivenFile) -> bool {
        false
    }

    /// The files that the work waits for.
    #[cfg(house)]
    fn missing(&self) -> Vec<MissingFile> {
        Vec::new()
    }

    /// Drops unfinished files, and the parts of a bigger picture that are kept for its maps.
    fn stop_file(&mut self);

    /// Adds the figures of this generator to a report.
    fn report(&mut self, report: &mut Report);

    /// The results as text files, for measurements: names and contents.
    #[cfg(not(target_arch = "wasm32"))]
    fn data(&self) -> Vec<(&'static str, String)>;
}
