//! Capabilities of engines besides their picture. Each trait is one capability; an engine that has it returns itself
//! from the method of [`super::Engine`] for that trait.

use super::Clock;
use super::inspection::{Histogram, JoinedCells, Probe};
use crate::domain::Outline;
use crate::export::{Map, MapKind, MeshOrder, MeshSize};
use crate::notice::Notice;
use crate::packing::{CellNumbers, EnergyParts, PopulationChange, Sample};
use crate::recipe::Recipe;
use glam::DVec2;

/// The result of one slice of work on a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSlice {
    /// Whether a new file begins with these parts. If so, parts of earlier calls belong to another file.
    pub begun: bool,
    /// The next parts of the file, in order.
    pub parts: Vec<Vec<u8>>,
    /// Whether the file ends with these parts.
    pub done: bool,
}

/// The result of one slice of work on a bigger picture, or on its maps.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureSlice {
    /// Whether a new picture begins with these rows. If so, rows of earlier calls belong to another picture.
    pub begun: bool,
    /// The share of the work that is done, 0..1, a rough estimate.
    pub progress: f64,
    /// The next rows of each requested map, or of the picture, from the top; empty in most slices.
    pub rows: Vec<Map>,
    /// The lowest and the highest value of the bump plane, in picture units. Both are 0 until maps are made from it.
    pub heights: (f32, f32),
    /// Whether the picture ends with these rows.
    pub done: bool,
}

/// Drafts: in the live mode, a draft may show a recipe. A draft continues from the present state instead of running the
/// stages. [`super::Engine::is_drafting`] tells whether a draft is active.
pub trait Drafts {
    /// Starts or ends the live mode.
    fn set_live(&mut self, on: bool);

    /// Whether a draft is shown.
    fn shows_draft(&self) -> bool;

    /// Works on the draft for about `budget` milliseconds; true when it may look different.
    fn advance_draft(&mut self, clock: Clock, budget: f64) -> bool;

    /// Drops the draft. If `all` is false, this is done only if the stages have something to show instead.
    fn drop_draft(&mut self, all: bool);
}

/// Maps of the finished picture, and the picture with more pixels.
pub trait Maps {
    /// A map of the finished picture.
    ///
    /// # Errors
    /// A notice if the picture is not finished, or there is no such map.
    fn map(&self, kind: MapKind) -> Result<Map, Notice>;

    /// Works on maps of the finished picture, or on the picture itself if the list is empty, with `scale` times as many
    /// pixels along the side. `order` is `(scale, maps)`. The call takes about `budget` milliseconds, or less if there
    /// are some megabytes of rows. Starts again if the order or the picture has changed, or the last file was done.
    ///
    /// # Errors
    /// A notice if the picture is not finished, or the bigger one would be too large.
    fn picture_file(
        &mut self,
        order: (usize, &[MapKind]),
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice>;

    /// Drops the work on a bigger picture or its maps, finished or not.
    fn stop_picture(&mut self);
}

/// Mesh files of the bodies.
pub trait Meshes {
    /// Works for about `budget` milliseconds on a mesh file. Starts again if the picture or the order has changed.
    ///
    /// # Errors
    /// A notice if the picture is not finished.
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice>;

    /// The size of the mesh file for this order; `None` before there are bodies.
    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize>;

    /// The places of the finished bodies as a table in CSV; empty before there are any, and `None` if each body has a
    /// mesh of its own.
    fn places(&self) -> Option<String> {
        None
    }

    /// The building as JSON, as its file has it; empty before there is one, and `None` if the generator has none.
    fn building(&self) -> Option<String> {
        None
    }

    /// Drops an unfinished mesh file.
    fn stop_mesh(&mut self);
}

/// Measures of cells in a plane.
pub trait Inspect {
    /// The cell at a place of the picture; `None` if no cell is there.
    fn probe(&mut self, place: DVec2) -> Option<Probe>;

    /// The measures recorded during the packing, by rising steps.
    fn samples(&self) -> &[Sample];

    /// Two histograms of all cells: size divided by wanted size, and the angle to the direction field in degrees.
    fn histograms(&mut self) -> [Histogram; 2];

    /// The highest minus the lowest value of the shown bump plane, in picture units; 0 before there is one.
    fn height_range(&self) -> f64;

    /// The words of those parts of a view that show nothing, each with the word of the reason.
    fn absences(&mut self, words: &str) -> Vec<(&'static str, &'static str)>;

    /// The last finished cells as an SVG file; empty before there are any.
    fn svg(&self) -> String;
}

/// The steps of a packing, forward and back. States are kept on the way, so that a step is soon reached again.
pub trait Rewind {
    /// Holds the packing at a step, or at its last step if that comes earlier; `None` releases it. [`Rewind::reach`]
    /// does the work. If the stages make their steps again, the steps go on from the held one.
    fn hold(&mut self, step: Option<u32>);

    /// Works for about `budget` milliseconds towards the held step; true when it is reached, or no step is held.
    fn reach(&mut self, clock: Clock, budget: f64) -> bool;
}

/// A packing in a plane in numbers, at the shown step: the held step, or the last step of the stages.
pub trait Steps {
    /// Works for about `budget` milliseconds on the mesh and the polygons of the packing that is shown; true when no
    /// work is left. Nothing is made without a packing, or for more than 400 cells.
    fn join(&mut self, clock: Clock, budget: f64) -> bool;

    /// The mesh and the polygons that [`Steps::join`] has made.
    fn joined(&self) -> Option<&JoinedCells>;

    /// All packed cells in numbers, by rising ids.
    fn numbers(&mut self) -> Vec<CellNumbers>;

    /// The energy of the packed cells by parts.
    fn energy_parts(&mut self) -> EnergyParts;

    /// When and where cells came and went.
    fn population_changes(&self) -> &[PopulationChange];

    /// 16 hex digits that change with any bit of the packing's state; empty before there is one.
    fn state_hash(&self) -> String;
}

/// The outline of an area that is filled with cells.
pub trait Outlines {
    /// The present outline: the outer ring first, then the holes.
    fn rings(&self) -> Vec<&[DVec2]>;

    /// The index of the part of the outline that contains this place; `None` outside.
    fn part(&self, place: DVec2) -> Option<usize>;

    /// Puts this outline into the recipe. Returns notices about repairs.
    ///
    /// # Errors
    /// The fault of the outline; the recipe is unchanged then.
    fn draw(&self, recipe: &mut Recipe, outline: &Outline) -> Result<Vec<Notice>, Notice>;
}
