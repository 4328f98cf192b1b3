//! Pavements and hides in the plane: an outline packed with cells, which become stones or scales
//! (Miyata, Itoh, Shimada 2000, A Method of Generating Pavement Textures Using the Square Packing
//! Technique; Itoh, Miyata, Shimada 2003, Generation of Organic Textures with Controlled Anisotropy and
//! Directionality via Packing Rectangular and Elliptical Cells).

mod absence;
mod draft;
mod engine;
mod files;
mod joining;
mod look;
mod made;
mod outline;
mod over;
mod params;
mod presets;
mod preview;
mod probe;
mod schema;
mod shaping;
#[cfg(house)]
mod slant;
mod stage;
mod stages;
mod stepping;
#[cfg(test)]
mod tests;
mod view;

pub use absence::Absence;
pub use look::{Base, Overlay, PavementView};
pub use outline::PavementRecipe;
pub use schema::keys;
pub use stage::Stage;

use super::bigger::Bigger;
use super::lighting::LightParams;
use super::{Course, Engine, Generator, Views};
use crate::cells::Cell;
use crate::domain::Outline;
use crate::graph::Wiring;
use crate::heightfield::{Planes, TextureParams};
use crate::mesh::Mesh;
use crate::notice::Notice;
use crate::packing::{Packing, StepReport};
use crate::recipe::{Recipe, Schema};
use crate::solid::StoneParams;
use draft::Draft;
use params::Params;
use stages::Stages;
use view::Gallery;

/// The parameters of a pavement.
pub static SCHEMA: Schema = Schema {
    word: "pavement",
    is_named: false,
    rows: schema::ROWS,
    rules: &outline::PavementRules,
};

/// The generator for links that name none.
pub static PAVEMENT: Generator = Generator {
    schema: &SCHEMA,
    title: "Pavements and hides",
    presets: presets::PRESETS,
    stages: &stage::WORDS,
    course: Course {
        begins: &[0.0, 0.02, 0.1, 0.6, 0.62, 0.66, 0.92, 0.95],
        stepping: "packing",
        placing: "planes",
        finisher: "planes",
        ..Course::UNKNOWN
    },
    views: Views {
        bases: &Base::WORDS,
        overlays: &Overlay::WORDS,
    },
    offers: &[
        "outline", "probe", "plots", "tiles", "compare", "turn", "svg", "maps", "slab", "mesh",
        "forming", "moves", "rewind", "steps",
    ],
    names: &["tile", "outline", "kind", "stone", "palette"],
    samples: &[],
    chance: "plane",
    home: "330,40,2.95,28",
    lowest: 5.0,
    engine: |recipe| Box::new(Pavement::new(recipe)),
};

/// Reads a pavement's link.
pub fn recipe(link: &str) -> (Recipe, Vec<Notice>) {
    Recipe::from_link(&[&SCHEMA], link)
}

/// The engine of pavements: its stages, a draft, a held packing, and the data of views and files.
pub struct Pavement {
    /// An outline used instead of the recipe's, if it is finer than a link can hold.
    exact: Option<Outline>,
    /// Loop steps of skin beyond those that a picture needs.
    finer: i32,
    made: Stages,
    /// The number of changes by drafts and held steps; if it rises, views are drawn again.
    changes: u64,
    gallery: Gallery,
    /// Whether the cells flow after each change.
    is_live: bool,
    draft: Option<Draft>,
    /// The packing, held at one of its steps.
    held: Option<stepping::Held>,
    /// The mesh and the polygons of the packing that is shown.
    joining: Option<joining::Joining>,
    /// The unfinished mesh file.
    #[cfg(house)]
    saving: Option<files::Saving>,
    /// The unfinished bigger picture.
    bigger: Option<Bigger>,
    boxes: probe::Boxes,
    #[cfg(house)]
    slant: slant::TurntableScene,
}

impl Pavement {
    /// An engine for a recipe; no stage is done yet.
    pub fn new(recipe: &Recipe) -> Self {
        Self::start(recipe, None, 0)
    }

    /// An engine that paves exactly this outline, whatever outline a recipe names. Also returns notices of the
    /// repairs.
    ///
    /// # Errors
    /// The fault of the outline.
    pub fn with_outline(recipe: &Recipe, outline: &Outline) -> Result<(Self, Vec<Notice>), Notice> {
        let (outline, notices) = outline.check(recipe.side())?;
        Ok((Self::start(recipe, Some(outline), 0), notices))
    }

    /// An engine whose skin has `steps` Loop steps more than a picture needs, or fewer if negative.
    pub fn finer(recipe: &Recipe, steps: i32) -> Self {
        Self::start(recipe, None, steps)
    }

    fn start(recipe: &Recipe, exact: Option<Outline>, finer: i32) -> Self {
        Self {
            made: Stages::new(Params::new(recipe, exact.as_ref(), finer)),
            exact,
            finer,
            changes: 0,
            gallery: Gallery::default(),
            is_live: false,
            draft: None,
            held: None,
            joining: None,
            #[cfg(house)]
            saving: None,
            bigger: None,
            boxes: probe::Boxes::default(),
            #[cfg(house)]
            slant: slant::TurntableScene::default(),
        }
    }

    /// Whether the latest recipe's picture is as large as the present one.
    fn keeps_side(&self) -> bool {
        let planes = &self.made.finish.planes;
        planes.latest().texture.side == planes.params().texture.side
    }

    /// Whether the picture is finished.
    fn is_done(&self) -> bool {
        self.made.at().is_none() && !self.is_drafting()
    }

    /// The report of the packing in progress; empty before its first cells are placed.
    fn step_report(&self) -> StepReport {
        if let Some(draft) = self.flowing() {
            return draft.packing.report();
        }
        if let Some(held) = self.held() {
            return held.report();
        }
        let begun = self.made.shown_packing().filter(|_| self.made.is_packing());
        begun.map(Packing::report).unwrap_or_default()
    }

    /// The mesh of the last packing that ended.
    fn mesh(&self) -> Option<&Mesh> {
        self.made.mesh()
    }

    /// The cells of the last packing that ended.
    fn cells(&self) -> &[Cell] {
        self.made.cells()
    }

    /// The cells of the stones. For skin, these are cells whose axes agree in sense.
    fn scales(&self) -> &[Cell] {
        self.made.scales()
    }

    /// The present parameters of the stones.
    fn stone_params(&self) -> StoneParams {
        self.texture().stone
    }

    /// The present parameters of the planes.
    fn texture(&self) -> &TextureParams {
        &self.made.finish.planes.params().texture
    }

    /// The present light.
    fn light(&self) -> &LightParams {
        self.made.finish.light.params()
    }

    /// The last finished planes.
    fn planes(&self) -> Option<&Planes> {
        self.made.planes()
    }
}
