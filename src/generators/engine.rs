//! What an engine is to those who run it: stages that work in slices, views, and files.

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

/// How far the work has come.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Progress {
    /// Cells, or bodies, that are there.
    pub cells: usize,
    /// Steps that they have moved by.
    pub steps: u32,
    /// The largest move of the last step, in cell sizes.
    pub largest_move: f64,
    /// Cells added since the first were placed.
    pub added: u32,
    /// Cells removed since then.
    pub removed: u32,
    /// Did it come to rest by itself?
    pub converged: bool,
    /// Stones, or bodies, that are finished.
    pub stones: usize,
}

/// What one slice of work has made of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSlice {
    /// A new file begins with these parts; those of calls before belong to another one.
    pub begun: bool,
    /// The next parts of the file, one after the other.
    pub parts: Vec<Vec<u8>>,
    /// The file ends with them.
    pub done: bool,
}

/// What one slice of work has made of a bigger picture, or of its maps.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureSlice {
    /// A new picture begins with these rows; those of calls before belong to another one.
    pub begun: bool,
    /// How much of the work is done, 0..1, by a rough estimate.
    pub progress: f64,
    /// The next rows of each map that was asked for, or of the picture, from the top; none in most slices.
    pub rows: Vec<Map>,
    /// The lowest and the highest value of its bump plane, in picture units, once that is finished.
    pub heights: (f32, f32),
    /// The picture ends with them.
    pub done: bool,
}

/// Makes pictures of one generator's recipes, slice by slice. A stage is named by its place in
/// [`super::Generator::stages`].
pub trait Engine: Any {
    /// Gives it the latest recipe. The work goes on by the one before until [`Engine::take_up`].
    fn ask(&mut self, recipe: &Recipe);

    /// The first stage that the latest recipe wants otherwise than the recipe at work does.
    fn stale(&self) -> Option<usize>;

    /// Makes the latest recipe the one at work.
    fn take_up(&mut self);

    /// Marks all stages as stale, so that they run again.
    fn forget(&mut self);

    /// Pixels along the side of the picture at work.
    fn side(&self) -> usize;

    /// The first stage that is not fresh; none where all is done.
    fn at(&self) -> Option<usize>;

    /// Why the work cannot go on; `None` while it can.
    fn failure(&self) -> Option<&Notice>;

    /// What is to be said of what was made so far: what was mended, or does not fit well.
    fn remarks(&self) -> Vec<Notice> {
        Vec::new()
    }

    /// The stage that the next slice works on; `None` where all is done or the work cannot go on.
    fn at_work(&self) -> Option<usize> {
        self.at().filter(|_| self.failure().is_none())
    }

    /// Does one slice of the work, on the first stage that is not fresh.
    fn advance(&mut self);

    /// Does a step begin with the next slice? It waits while the work is held; the rest of a step does not.
    fn is_step(&self) -> bool {
        false
    }

    /// The stage that goes in steps, such as the packing.
    fn stepping(&self) -> Option<usize> {
        None
    }

    /// The first stage of the finisher: from there on a short pass is let finish.
    fn finisher(&self) -> usize;

    /// Do other cells or bodies form than those of the picture that is there?
    fn is_forming(&self) -> bool;

    /// How often each stage has finished.
    fn runs(&self) -> Vec<u64>;

    /// How far the work is.
    fn progress(&self) -> Progress;

    /// The potential energy of what moves, in units of the mean cell's spring constant
    /// k0; 0 where nothing moves.
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

    /// Drops the draft: in any case (`all`), or only where the stages have something to show instead.
    fn drop_draft(&mut self, _all: bool) {}

    /// The picture of a view, by its words: opaque RGBA, row after row from the top. While a stage has
    /// nothing to show yet, what was there before.
    fn view(&mut self, words: &str) -> &[u8];

    /// Draws some of a view that takes long to draw, for about `budget` milliseconds but at least one
    /// piece. True when [`Engine::view`] has nothing left to do that takes long.
    fn prepare(&mut self, words: &str, clock: Clock, budget: f64) -> bool;

    /// The words of a view that show nothing, each with the word of the reason.
    fn absences(&mut self, words: &str) -> Vec<(&'static str, &'static str)>;

    /// The picture last finished, in the form of [`Engine::view`]; empty before there is one.
    fn picture(&self) -> &[u8];

    /// Digest of what was made last, 16 hexadecimal digits: equal for equal planes.
    fn digest(&self) -> String;

    /// A map of the finished picture.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or there is no such map.
    fn map(&self, kind: MapKind) -> Result<Map, Notice>;

    /// Works for about `budget` milliseconds, or until there are some megabytes of rows, on these maps of the finished picture with `scale` times as many pixels
    /// along its side, or where there are none on the picture itself. Begins anew where the order or the picture
    /// is another one than the last time, or the last one was done.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or would be too large.
    fn picture_file(
        &mut self,
        order: (usize, &[MapKind]),
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice>;

    /// Works for about `budget` milliseconds on a mesh file. Begins anew where the picture or the order is
    /// another one than the last time.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or there is no such file.
    fn mesh_file(
        &mut self,
        _order: &MeshOrder,
        _clock: Clock,
        _budget: f64,
    ) -> Result<MeshSlice, Notice> {
        Err(Code::NoSuchFile.into())
    }

    /// How large such a file is; nothing where there is none.
    fn mesh_size(&self, _order: &MeshOrder) -> Option<MeshSize> {
        None
    }

    /// Works for about `budget` milliseconds on a frame of the bodies, seen from a slant. Begins anew where it is
    /// another one than the last time, or was done.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or there are no bodies.
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

    /// The words of the steps in which a body is made, of its id.
    #[cfg(house)]
    fn making(&self, _id: u32) -> Vec<String> {
        Vec::new()
    }

    /// What is to be read beside a view, once it is shown: what its colours stand for, or what it counts.
    #[cfg(house)]
    fn caption(&self, _words: &str) -> Option<Notice> {
        None
    }

    /// The place of the model at a pixel of that frame, as rows of strokes and spots on it have it; nothing beside it.
    #[cfg(house)]
    fn place_at(&self, _x: usize, _y: usize) -> Option<[i64; 3]> {
        None
    }

    /// Where such a place is in that frame, in pixels; nothing where it is not seen there.
    #[cfg(house)]
    fn pixel_of(&self, _place: [i64; 3]) -> Option<[f64; 2]> {
        None
    }

    /// Takes a file that recipes may ask for, in any role; false where this generator has no use for files.
    #[cfg(house)]
    fn give(&mut self, _file: GivenFile) -> bool {
        false
    }

    /// The files that the work waits for.
    #[cfg(house)]
    fn missing(&self) -> Vec<MissingFile> {
        Vec::new()
    }

    /// Lets go of files in the making, and of what was kept of a bigger picture for its maps.
    fn stop_file(&mut self);

    /// Adds the figures that only this generator has to a report.
    fn report(&mut self, report: &mut Report);

    /// Files of what was made, as text, for whoever measures: names and contents.
    #[cfg(not(target_arch = "wasm32"))]
    fn data(&self) -> Vec<(&'static str, String)>;
}
