//! Pavements and hides in the plane: an outline packed with cells, which become stones or scales
//! (Miyata, Itoh, Shimada 2000, A Method of Generating Pavement Textures Using the Square Packing
//! Technique; Itoh, Miyata, Shimada 2003, Generation of Organic Textures with Controlled Anisotropy and
//! Directionality via Packing Rectangular and Elliptical Cells).

mod absence;
mod draft;
mod files;
mod look;
mod outline;
mod over;
mod params;
mod presets;
mod probe;
mod schema;
mod stages;
mod terrain;
mod view;

pub use absence::Absence;
pub use look::{Base, Overlay, View};
pub use outline::PavementRecipe;
pub use probe::{Histogram, Polygon, Probe};
pub use schema::keys;
pub use stages::Stage;

use super::bigger::Bigger;
use super::{Clock, Engine, Generator, MeshSlice, PictureSlice, Progress, Views, common};
use crate::cells::Cell;
use crate::domain::{Domain, Outline};
use crate::export::{Map, MapKind, MeshFormat, Report};
use crate::field::Fields;
use crate::heightfield::Planes;
use crate::mesh::Mesh;
use crate::metrics::Metrics;
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

/// The generator of links that name none.
pub static PAVEMENT: Generator = Generator {
    schema: &SCHEMA,
    title: "Pavements and hides",
    presets: presets::PRESETS,
    stages: &stages::WORDS,
    views: Views {
        bases: &Base::WORDS,
        overlays: &Overlay::WORDS,
    },
    offers: &[
        "outline", "probe", "plots", "layers", "tiles", "compare", "svg", "mesh", "forming",
    ],
    engine: |recipe| Box::new(Pavement::new(recipe)),
};

/// Reads a pavement's link.
pub fn recipe(link: &str) -> (Recipe, Vec<Notice>) {
    Recipe::from_link(&[&SCHEMA], link)
}

/// The machine: what is asked for, what was made of it, and what is looked at.
pub struct Pavement {
    /// The outline used instead of the recipe's, for outlines finer than a link can say.
    exact: Option<Outline>,
    /// Loop steps of skin beyond those that a picture needs.
    finer: i32,
    latest: Wish,
    /// What the stages work by; behind the latest while a short pass is let finish.
    working: Wish,
    /// The first stage of which the latest asks something else.
    stale: Option<Stage>,
    made: Stages,
    /// Counts what a draft and recipes that were taken up changed, for the views.
    changes: u64,
    gallery: Gallery,
    /// Do the cells flow after each change?
    is_live: bool,
    draft: Option<Draft>,
    /// The mesh file in the making.
    saving: Option<files::Saving>,
    /// The bigger picture in the making, or its planes.
    bigger: Option<Bigger>,
    boxes: probe::Boxes,
}

/// A recipe, and what it asks of the stages.
#[derive(Clone)]
struct Wish {
    recipe: Recipe,
    /// Checked.
    outline: Outline,
    params: Params,
}

impl Wish {
    fn new(recipe: &Recipe, exact: Option<&Outline>, finer: i32) -> Self {
        let outline = params::outline(recipe, exact);
        Self {
            params: Params::new(recipe, &outline, finer),
            recipe: recipe.clone(),
            outline,
        }
    }
}

impl Pavement {
    /// With all its work before it.
    pub fn new(recipe: &Recipe) -> Self {
        Self::start(recipe, None, 0)
    }

    /// One that paves exactly this outline, whatever outline a recipe names. Answers with what was
    /// mended.
    ///
    /// # Errors
    /// What is wrong with the outline.
    pub fn with_outline(recipe: &Recipe, outline: &Outline) -> Result<(Self, Vec<Notice>), Notice> {
        let (outline, notices) = outline.check(recipe.side())?;
        Ok((Self::start(recipe, Some(outline), 0), notices))
    }

    /// One whose skin has so many Loop steps more than a picture needs, or below 0 fewer.
    pub fn finer(recipe: &Recipe, steps: i32) -> Self {
        Self::start(recipe, None, steps)
    }

    fn start(recipe: &Recipe, exact: Option<Outline>, finer: i32) -> Self {
        let wish = Wish::new(recipe, exact.as_ref(), finer);
        Self {
            made: Stages::new(wish.params.clone()),
            exact,
            finer,
            working: wish.clone(),
            latest: wish,
            stale: None,
            changes: 0,
            gallery: Gallery::default(),
            is_live: false,
            draft: None,
            saving: None,
            bigger: None,
            boxes: probe::Boxes::default(),
        }
    }

    /// Is the latest picture as large as the one at work?
    fn keeps_side(&self) -> bool {
        self.latest.recipe.side() == self.working.recipe.side()
    }

    /// Is the picture finished?
    fn is_done(&self) -> bool {
        self.made.at().is_none() && !self.is_drafting()
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
        flowing.or(self.made.packing())
    }

    /// What the packing at work has done so far; nothing before its first cells are placed.
    fn step_report(&self) -> StepReport {
        if let Some(draft) = self.flowing() {
            return draft.packing.report();
        }
        let begun = self.made.packing().filter(|_| self.made.is_packing());
        begun.map(Packing::report).unwrap_or_default()
    }

    /// The mesh of the last packing that ended.
    pub fn mesh(&self) -> Option<&Mesh> {
        self.made.mesh()
    }

    /// The cells of the last packing that ended.
    pub fn cells(&self) -> &[Cell] {
        self.made.cells()
    }

    /// The cells that stones are made of: of skin, those in which the axes have one sense.
    pub fn scales(&self) -> &[Cell] {
        self.made.scales()
    }

    /// What the stones are made by.
    pub fn stone_params(&self) -> StoneParams {
        self.working.params.finish.planes.texture.stone
    }

    /// The planes last finished.
    pub fn planes(&self) -> Option<&Planes> {
        self.made.planes()
    }

    /// How good the mesh and the cells of the last packing that ended are, once they are there.
    pub fn metrics(&self) -> Option<Metrics> {
        let made = &self.made;
        let particles = made.packing()?.particles();
        let (domain, fields) = made.terrain.made()?;
        let mesh = made.mesh().filter(|_| !made.cells().is_empty())?;
        Some(Metrics::new(domain, fields, &particles, mesh, made.cells()))
    }
}

impl Engine for Pavement {
    fn ask(&mut self, recipe: &Recipe) {
        self.latest = Wish::new(recipe, self.exact.as_ref(), self.finer);
        self.stale = self.latest.params.first_difference(&self.working.params);
        if !self.is_live || !self.keeps_side() {
            self.draft = None;
        }
    }

    fn stale(&self) -> Option<usize> {
        self.stale.map(|stage| stage as usize)
    }

    fn take_up(&mut self) {
        self.working = self.latest.clone();
        if self.stale.take().is_some() {
            self.made.want(self.working.params.clone());
            self.changes += 1;
        }
    }

    fn forget(&mut self) {
        self.made.forget();
        self.changes += 1;
    }

    fn side(&self) -> usize {
        common::side(&self.working.recipe)
    }

    fn at(&self) -> Option<usize> {
        self.made.at().map(|stage| stage as usize)
    }

    fn failure(&self) -> Option<&Notice> {
        self.made.failure()
    }

    fn advance(&mut self) {
        self.made.advance();
    }

    fn is_step(&self) -> bool {
        self.made.at() == Some(Stage::Packing) && self.made.is_packing()
    }

    fn stepping(&self) -> Option<usize> {
        Some(Stage::Packing as usize)
    }

    fn finisher(&self) -> usize {
        Stage::Planes as usize
    }

    fn is_forming(&self) -> bool {
        self.made.is_forming()
    }

    fn runs(&self) -> Vec<u64> {
        self.made.runs().to_vec()
    }

    fn progress(&self) -> Progress {
        let last = self.step_report();
        Progress {
            cells: last.cells,
            steps: last.step,
            largest_move: last.largest_move,
            added: last.added,
            removed: last.removed,
            converged: last.converged,
            stones: self.made.stones(),
        }
    }

    fn energy(&mut self) -> f64 {
        if self.is_drafting()
            && let Some(draft) = &mut self.draft
        {
            return draft.energy();
        }
        let packing = self.made.packing_mut();
        packing.map_or(0.0, |(packing, domain)| packing.energy(domain))
    }

    fn set_live(&mut self, on: bool) {
        self.is_live = on;
    }

    fn is_drafting(&self) -> bool {
        let is_stale = self.stale.is_some_and(|stage| stage <= Stage::Packing);
        self.is_live && is_stale && self.keeps_side()
    }

    fn shows_draft(&self) -> bool {
        self.draft().is_some()
    }

    fn advance_draft(&mut self, clock: Clock, budget: f64) -> bool {
        self.flow(clock, budget)
    }

    fn drop_draft(&mut self, all: bool) {
        if all || (!self.is_live && self.draft().is_none()) {
            self.draft = None;
        }
    }

    fn view(&mut self, words: &str) -> &[u8] {
        self.look_at(View::of_words(words))
    }

    fn prepare(&mut self, words: &str, clock: Clock, budget: f64) -> bool {
        self.draw_beforehand(View::of_words(words), clock, budget)
    }

    fn absences(&mut self, words: &str) -> Vec<(&'static str, &'static str)> {
        let found = self.missing(View::of_words(words)).into_iter();
        found.map(|(word, why)| (word, why.word())).collect()
    }

    fn picture(&self) -> &[u8] {
        self.made.picture()
    }

    fn digest(&self) -> String {
        self.made.planes().map_or(String::new(), Planes::digest)
    }

    fn map(&self, kind: MapKind) -> Result<Map, Notice> {
        self.map_of_planes(kind)
    }

    fn picture_file(
        &mut self,
        scale: usize,
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice> {
        self.bigger_slice(scale, clock, budget)
    }

    fn bigger_map(&self, kind: MapKind) -> Result<Map, Notice> {
        self.map_of_bigger(kind)
    }

    fn mesh_file(
        &mut self,
        format: MeshFormat,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        self.mesh_slice(format, clock, budget)
    }

    fn stop_file(&mut self) {
        self.saving = None;
        self.bigger = None;
    }

    fn report(&mut self, report: &mut Report) {
        let last = self.step_report();
        report.cells = self.made.cells().len();
        report.steps = last.step;
        report.converged = last.converged;
        report.added = last.added;
        report.removed = last.removed;
        report.largest_move = last.largest_move;
        report.energy = self.energy();
        let range = self.planes().map(Planes::height_range);
        report.height_range = range.unwrap_or_default();
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn data(&self) -> Vec<(&'static str, String)> {
        use crate::export::{cells_json, mesh_json};
        let mesh = self.mesh().map(|mesh| ("mesh.json", mesh_json(mesh)));
        let cells = ("cells.json", cells_json(self.cells()));
        std::iter::once(cells).chain(mesh).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generators::ALL;
    use crate::random::{Purpose, Random};
    use crate::recipe::Kind;
    use crate::studio::Studio;

    /// A recipe in which some values are other ones, of small pictures with few cells.
    fn changed(recipe: &Recipe, random: &mut Random) -> Recipe {
        let mut changed = recipe.clone();
        for _ in 0..=random.below(3) {
            let row = &SCHEMA.rows[random.below(SCHEMA.rows.len())];
            let text = match row.kind {
                Kind::Text => continue,
                Kind::Choice => row.choices[random.below(row.choices.len())].word.to_owned(),
                Kind::Number | Kind::Int => {
                    let value = row.min + (row.max - row.min) * random.unit();
                    format!("{value:.2}")
                }
            };
            let _ = changed.set(row.key.0, &text);
        }
        let _ = changed.set("size", "128");
        if changed.number(keys::CS) < 12.0 {
            let _ = changed.set("cs", "12");
        }
        changed
    }

    /// Which stages must run to go from one recipe to another: those of which something else is asked,
    /// and those that read what they make.
    fn due(from: &Params, to: &Params) -> [bool; 8] {
        let finishes = [&from.finish, &to.finish];
        let [painted, weathered, lit] = [
            finishes[0].planes != finishes[1].planes,
            finishes[0].weather != finishes[1].weather,
            finishes[0].light != finishes[1].light,
        ];
        let dressed = (from.is_skin, from.coats) != (to.is_skin, to.coats);
        let domain = from.terrain.domain != to.terrain.domain;
        let fields = domain || from.terrain.fields != to.terrain.fields;
        let packing = fields || from.packing != to.packing;
        let cells = packing || from.cells != to.cells;
        let planes = cells || dressed || painted;
        let weather = planes || weathered;
        [
            domain,
            fields,
            packing,
            packing,
            cells,
            planes,
            weather,
            weather || lit,
        ]
    }

    fn asked(studio: &Studio) -> Params {
        let engine = studio.engine_as::<Pavement>();
        engine.expect("a pavement").working.params.clone()
    }

    /// Wherever a studio comes from, it gives what the recipe gives, and works on nothing in vain.
    #[test]
    fn exactly_what_differs_runs() {
        let mut random = Random::new(11, Purpose::Placement, 0);
        let mut recipe = super::recipe("size=128&cs=16").0;
        let mut studio = Studio::new(ALL, recipe.clone());
        assert_eq!(studio.finish(&mut || 0.0), Ok(()));
        let mut late = 0;
        for _ in 0..60 {
            let next = changed(&recipe, &mut random);
            let (from, runs) = (asked(&studio), studio.runs());
            studio.set_recipe(next.clone());
            if studio.finish(&mut || 0.0).is_err() {
                studio.set_recipe(recipe.clone());
                assert_eq!(studio.finish(&mut || 0.0), Ok(()));
                continue;
            }
            let due = due(&from, &asked(&studio));
            for (((word, new), (_, old)), due) in studio.runs().into_iter().zip(runs).zip(due) {
                assert_eq!(
                    new - old,
                    u64::from(due),
                    "{word}: {} to {}",
                    recipe.link(),
                    next.link()
                );
            }
            late += usize::from(!due[Stage::Cells as usize]);
            let mut plain = Studio::new(ALL, next.clone());
            assert_eq!(plain.finish(&mut || 0.0), Ok(()));
            assert_eq!(
                studio.digest(),
                plain.digest(),
                "{} to {}",
                recipe.link(),
                next.link()
            );
            assert!(studio.picture() == plain.picture(), "{}", next.link());
            recipe = next;
        }
        assert!(late > 10, "{late}");
    }
}
