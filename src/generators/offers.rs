//! Abilities that engines may offer beside their picture. Each trait is a capability; an engine that has it returns itself from the
//! method of [`super::Engine`] by which it is asked for.

use super::Clock;
use super::inspection::{Histogram, Probe};
use crate::domain::Outline;
use crate::export::{Map, MapKind, MeshOrder, MeshSize};
use crate::notice::Notice;
use crate::packing::Sample;
use crate::recipe::Recipe;
use glam::DVec2;

/// The part of a mesh file that one slice of work has made.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSlice {
    /// A new file begins with these parts; those of calls before belong to another one.
    pub begun: bool,
    /// The next parts of the file, one after the other.
    pub parts: Vec<Vec<u8>>,
    /// The file ends with them.
    pub done: bool,
}

/// The part of a bigger picture, or of its maps, that one slice of work has made.
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

/// Drafts: while live, a recipe may be shown by a draft that goes on from what is there, instead of the stages. Whether
/// one is at work tells [`super::Engine::is_drafting`].
pub trait Drafts {
    /// Begins or ends to be live.
    fn set_live(&mut self, on: bool);

    /// Is a draft to be seen?
    fn shows_draft(&self) -> bool;

    /// Works on the draft for about `budget` milliseconds; true when it may look different.
    fn advance_draft(&mut self, clock: Clock, budget: f64) -> bool;

    /// Drops the draft: in any case (`all`), or only where the stages have something to show instead.
    fn drop_draft(&mut self, all: bool);
}

/// Maps of the finished picture, and the picture with more pixels.
pub trait Maps {
    /// A map of the finished picture.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or there is no such map.
    fn map(&self, kind: MapKind) -> Result<Map, Notice>;

    /// Works for about `budget` milliseconds, or until there are some megabytes of rows. It makes these maps of the
    /// finished picture with `scale` times as many pixels along its side; without maps in the order it makes the
    /// picture itself. Begins anew where the order or the picture differs from the last time, or the last one was done.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or would be too large.
    fn picture_file(
        &mut self,
        order: (usize, &[MapKind]),
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice>;

    /// Drops a bigger picture in the making, and the data that it keeps for its maps.
    fn stop_picture(&mut self);
}

/// Mesh files of the bodies.
pub trait Meshes {
    /// Works for about `budget` milliseconds on a mesh file. Begins anew where the picture or the order differs from
    /// the last time.
    ///
    /// # Errors
    /// A notice where the picture is not finished.
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice>;

    /// How large such a file is; `None` before there are bodies.
    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize>;

    /// Drops a mesh file in the making.
    fn stop_mesh(&mut self);
}

/// Questions about cells in a plane.
pub trait Inspect {
    /// The cell at a place of the picture.
    fn probe(&mut self, place: DVec2) -> Option<Probe>;

    /// The course of the packing, by rising steps.
    fn samples(&self) -> &[Sample];

    /// The sizes of all cells over the wanted ones, and their angles to the direction field in degrees.
    fn histograms(&mut self) -> [Histogram; 2];

    /// From the lowest place of the bump plane that is shown to the highest, in picture units; 0 before there is one.
    fn height_range(&self) -> f64;

    /// The words of a view that show nothing, each with the word of the reason.
    fn absences(&mut self, words: &str) -> Vec<(&'static str, &'static str)>;

    /// The cells last finished as an SVG file; empty before there are any.
    fn svg(&self) -> String;
}

/// The outline of an area that is filled with cells.
pub trait Outlines {
    /// The outline in use: the outer ring first, then the holes.
    fn rings(&self) -> Vec<&[DVec2]>;

    /// Which of the parts that lines cut the outline into holds this place; `None` outside.
    fn part(&self, place: DVec2) -> Option<usize>;

    /// Makes this outline the recipe's. Returns notices about repairs.
    ///
    /// # Errors
    /// What is wrong with the outline; the recipe is unchanged then.
    fn draw(&self, recipe: &mut Recipe, outline: &Outline) -> Result<Vec<Notice>, Notice>;
}
