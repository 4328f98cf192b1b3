//! The incremental pipeline: from a recipe to its picture in slices, only what is stale.
//!
//! A studio holds the latest recipe and what each stage has made of it. [`Studio::tick`] works on
//! the first stale stage for about the time given; what is finished stays until its successor is
//! finished, too. No result depends on how the work was cut into slices or on the clock.

mod absence;
mod bigger;
mod draft;
mod files;
mod flow;
mod look;
mod over;
mod probe;
mod products;
mod translate;
mod view;

pub use absence::Absence;
pub use bigger::{MOST_PIXELS, PictureSlice};
pub use files::MeshSlice;
pub use look::{Base, Overlay, View};
pub use probe::{Histogram, Polygon, Probe};

use crate::cells::Cell;
use crate::domain::{Domain, Outline};
use crate::export::{Report, StageTime};
use crate::field::Fields;
use crate::mesh::Mesh;
use crate::metrics::Metrics;
use crate::packing::{Packing, StepReport};
use crate::recipe::{Recipe, Stage};
use crate::solid::{Quarry, StoneParams};
use crate::texture::Planes;
use draft::Draft;
use products::Products;
use view::Gallery;

const STAGES: usize = Stage::ALL.len();

/// The recipe, the work done for it, and where the work stands.
pub struct Studio {
    /// The latest recipe asked for.
    recipe: Recipe,
    /// The recipe the stages work by; behind `recipe` while a short pass is let finish.
    working: Recipe,
    /// The outline used instead of the recipe's, for outlines finer than a link can say.
    exact: Option<Outline>,
    at: Position,
    made: Products,
    /// Milliseconds by stage of the latest pass through it.
    spent: [f64; STAGES],
    /// Milliseconds of the last shading that was finished; infinite before there is one.
    last_shading: f64,
    /// Counts changes by stage, for the views.
    changes: [u64; STAGES],
    gallery: Gallery,
    /// Do the cells flow after each change?
    live: bool,
    draft: Option<Draft>,
    /// The mesh file in the making.
    saving: Option<files::Saving>,
    /// The bigger picture in the making, or its planes.
    bigger: Option<bigger::Bigger>,
    boxes: probe::Boxes,
}

/// Where the work stands.
#[derive(Clone, Debug, PartialEq)]
enum Position {
    At(Stage),
    Done,
    Failed(Stage, String),
}

impl Studio {
    /// A studio with all its work before it.
    pub fn new(recipe: Recipe) -> Self {
        Self::start(recipe, None)
    }

    /// A studio that paves exactly this outline, whatever outline the recipe names. Answers with
    /// what was mended.
    ///
    /// # Errors
    /// The sentence that says what is wrong with the outline.
    pub fn with_outline(recipe: Recipe, outline: &Outline) -> Result<(Self, Vec<String>), String> {
        let (outline, notices) = translate::checked(outline, &recipe)?;
        Ok((Self::start(recipe, Some(outline)), notices))
    }

    fn start(recipe: Recipe, exact: Option<Outline>) -> Self {
        Self {
            made: Products::new(translate::outline(&recipe, exact.as_ref())),
            working: recipe.clone(),
            recipe,
            exact,
            at: Position::At(Stage::Domain),
            spent: [0.0; STAGES],
            last_shading: f64::INFINITY,
            changes: [0; STAGES],
            gallery: Gallery::default(),
            live: false,
            draft: None,
            saving: None,
            bigger: None,
            boxes: probe::Boxes::default(),
        }
    }

    /// From the next pass on, skin has so many Loop steps more than a picture needs, or
    /// below 0 fewer.
    pub fn refine(&mut self, steps: i32) {
        self.made.quarry = Quarry::finer(steps);
    }

    /// The latest recipe asked for.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// Pixels along the picture's side.
    pub fn side(&self) -> usize {
        translate::side(&self.working)
    }

    /// The stage at work: its word, or "done", or "error" where no pavement can be made of the
    /// recipe ([`Studio::problem`] says why).
    pub fn stage(&self) -> &'static str {
        match &self.at {
            _ if self.flows() => Stage::Packing.word(),
            Position::At(stage) => stage.word(),
            Position::Done => "done",
            Position::Failed(..) => "error",
        }
    }

    /// Is the picture finished?
    pub fn done(&self) -> bool {
        self.at == Position::Done && !self.flows()
    }

    /// Why the work stopped, in a sentence; `None` while all is well.
    pub fn problem(&self) -> Option<&str> {
        match &self.at {
            Position::Failed(_, sentence) if !self.flows() => Some(sentence),
            _ => None,
        }
    }

    /// The outline in use, checked and mended: the outer ring first, then the holes.
    pub fn rings(&self) -> Vec<&[glam::DVec2]> {
        self.shown().rings
    }

    /// The domain, once it is there.
    pub fn domain(&self) -> Option<&Domain> {
        self.shown().domain
    }

    /// The fields, once they are there.
    pub fn fields(&self) -> Option<&Fields> {
        self.shown().fields
    }

    /// The packing at work, or the last one; while live, the one that flows.
    pub fn packing(&self) -> Option<&Packing> {
        let flowing = self.flowing().map(|draft| &draft.packing);
        flowing.or(self.made.packing.as_ref())
    }

    /// What the packing at work has done so far; nothing before its first cells are placed.
    pub fn progress(&self) -> StepReport {
        if let Some(draft) = self.flowing() {
            return draft.packing.report();
        }
        let begun = self
            .made
            .packing
            .as_ref()
            .filter(|_| self.made.packing_begun);
        begun.map(Packing::report).unwrap_or_default()
    }

    /// The mesh of the last packing that ended.
    pub fn mesh(&self) -> Option<&Mesh> {
        self.made.mesh.as_ref()
    }

    /// The cells of the last packing that ended.
    pub fn cells(&self) -> &[Cell] {
        &self.made.cells
    }

    /// The cells that stones are made of: of skin, those in which the axes have one sense.
    pub fn scales(&self) -> &[Cell] {
        if self.made.scales.is_empty() {
            &self.made.cells
        } else {
            &self.made.scales
        }
    }

    /// What the stones are made by.
    pub fn stone_params(&self) -> StoneParams {
        translate::stone(&self.working)
    }

    /// Stones painted so far in the pass at work, or in the last one.
    pub fn stones(&self) -> usize {
        self.made.stones
    }

    /// The planes last finished.
    pub fn planes(&self) -> Option<&Planes> {
        self.made.planes.as_ref()
    }

    /// The picture last finished: opaque RGBA, row after row from the top.
    pub fn picture(&self) -> Option<&[u8]> {
        (!self.made.picture.is_empty()).then_some(&self.made.picture[..])
    }

    /// Hex digest of the planes, empty until the work is done.
    pub fn digest(&self) -> String {
        match &self.made.planes {
            Some(planes) if self.done() => planes.digest(),
            _ => String::new(),
        }
    }

    /// The packing's potential energy, in units of a cell's; 0 before there is a packing.
    pub fn energy(&mut self) -> f64 {
        if self.flows()
            && let Some(draft) = &mut self.draft
        {
            return draft.packing.energy(&draft.domain);
        }
        match (&mut self.made.packing, &self.made.domain) {
            (Some(packing), Some(domain)) => packing.energy(domain),
            _ => 0.0,
        }
    }

    /// Milliseconds spent by stage, in the stages' order.
    pub fn milliseconds(&self) -> Vec<StageTime> {
        let times = Stage::ALL.iter().zip(self.spent);
        times
            .map(|(stage, ms)| StageTime {
                stage: stage.word(),
                ms,
            })
            .collect()
    }

    /// How good the mesh and the cells of the last packing that ended are, once they are there.
    pub fn metrics(&self) -> Option<Metrics> {
        let made = &self.made;
        let particles = made.packing.as_ref()?.particles();
        let (domain, fields) = (made.domain.as_ref()?, made.fields.as_ref()?);
        let mesh = made.mesh.as_ref().filter(|_| !made.cells.is_empty())?;
        Some(Metrics::new(domain, fields, &particles, mesh, &made.cells))
    }

    /// The figures of the run so far.
    pub fn report(&mut self) -> Report {
        let energy = self.energy();
        let last = self.progress();
        Report {
            link: self.recipe.link(),
            size: self.side(),
            cells: self.made.cells.len(),
            steps: last.step,
            converged: last.converged,
            added: last.added,
            removed: last.removed,
            largest_move: last.largest_move,
            energy,
            milliseconds: self.milliseconds(),
            height_range: self
                .planes()
                .map_or((0.0, 0.0), crate::render::overlay_planes::height_range),
            metrics: None,
            notices: Vec::new(),
            hash: self.digest(),
        }
    }
}
