//! Capabilities of engines in the full module: frames of bodies in space, and files that recipes name. The module of
//! a first visit does not contain them.

use super::Clock;
use super::given::{GivenFile, MissingFile};
use super::turntable::{FrameSlice, SeenBody, SeenLabel, TurnOrder};
use crate::notice::Notice;
use crate::scene::Frame;

/// Frames of the bodies in space.
pub trait Frames {
    /// Works for about `budget` milliseconds on a frame of the bodies. Starts again if the order has changed, or the
    /// last frame was done.
    ///
    /// # Errors
    /// A notice if the picture is not finished, or there is no such body.
    fn turn(&mut self, order: &TurnOrder, clock: Clock, budget: f64) -> Result<FrameSlice, Notice>;

    /// The last frame finished by [`Frames::turn`], until the next one begins.
    fn frame(&self) -> Option<&Frame>;

    /// The body at a pixel of the last frame; `None` beside the bodies.
    fn body_at(&mut self, x: usize, y: usize) -> Option<SeenBody>;

    /// The words of the steps in which the body with this id is made.
    fn making(&self, _id: u32) -> Vec<String> {
        Vec::new()
    }

    /// The caption of the shown view: what its colours mean, or counts.
    fn caption(&self, _words: &str) -> Option<Notice> {
        None
    }

    /// The labels that the shown view has in the last frame, the most important one first.
    fn labels(&self) -> Vec<SeenLabel> {
        Vec::new()
    }

    /// The place on the model at a pixel of the last frame, as rows of strokes and spots hold places; `None` beside the
    /// model.
    fn place_at(&self, _x: usize, _y: usize) -> Option<[i64; 3]> {
        None
    }

    /// The pixel at which the last frame shows a place on the model; `None` if the place is not visible.
    fn pixel_of(&self, _place: [i64; 3]) -> Option<[f64; 2]> {
        None
    }
}

/// Measures of a model from a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelFacts {
    /// Width, height and depth of its bounding box, in sizes of its cells.
    pub cells: [f64; 3],
    /// Whether it has open parts. An open part has two sides, so one side must be chosen as the outside.
    pub is_open: bool,
}

/// The files that recipes name.
pub trait Files {
    /// Takes a file for recipes that name it, in any role.
    fn give(&mut self, file: GivenFile);

    /// The files that the work waits for.
    fn missing(&self) -> Vec<MissingFile>;

    /// Measures of the model that a file gives, once it is read and mended.
    fn model(&self) -> Option<ModelFacts> {
        None
    }
}
