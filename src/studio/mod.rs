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
mod height_field;
mod look;
mod over;
mod params;
mod pavement;
mod probe;
mod terrain;
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
use crate::heightfield::Planes;
use crate::mesh::Mesh;
use crate::metrics::Metrics;
use crate::notice::Notice;
use crate::packing::{Packing, StepReport};
use crate::recipe::{Recipe, Stage};
use crate::solid::StoneParams;
use draft::Draft;
use params::Params;
use pavement::Pavement;
use view::Gallery;

const STAGES: usize = Stage::ALL.len();

/// The recipe, the work done for it, and where the work stands.
pub struct Studio {
    /// The outline used instead of the recipe's, for outlines finer than a link can say.
    exact: Option<Outline>,
    /// Loop steps of skin beyond those that a picture needs.
    finer: i32,
    latest: Wish,
    /// What the stages work by; behind the latest while a short pass is let finish.
    working: Wish,
    /// The first stage of which the latest asks something else.
    stale: Option<Stage>,
    made: Pavement,
    /// Milliseconds by stage of the latest pass through it.
    spent: [f64; STAGES],
    /// Milliseconds of the last shading that was finished; infinite before there is one.
    last_shading: f64,
    /// Counts what a draft and recipes that were taken up changed, for the views.
    changes: u64,
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

/// A recipe, and what it asks of the stages.
#[derive(Clone)]
struct Wish {
    recipe: Recipe,
    /// Checked.
    outline: Outline,
    params: Params,
}

impl Wish {
    fn new(recipe: Recipe, exact: Option<&Outline>, finer: i32) -> Self {
        let outline = params::outline(&recipe, exact);
        Self {
            params: Params::new(&recipe, &outline, finer),
            recipe,
            outline,
        }
    }
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
    /// What is wrong with the outline.
    pub fn with_outline(recipe: Recipe, outline: &Outline) -> Result<(Self, Vec<Notice>), Notice> {
        let (outline, notices) = params::checked(outline, &recipe)?;
        Ok((Self::start(recipe, Some(outline)), notices))
    }

    fn start(recipe: Recipe, exact: Option<Outline>) -> Self {
        let wish = Wish::new(recipe, exact.as_ref(), 0);
        Self {
            made: Pavement::new(wish.params.clone()),
            exact,
            finer: 0,
            working: wish.clone(),
            latest: wish,
            stale: None,
            spent: [0.0; STAGES],
            last_shading: f64::INFINITY,
            changes: 0,
            gallery: Gallery::default(),
            live: false,
            draft: None,
            saving: None,
            bigger: None,
            boxes: probe::Boxes::default(),
        }
    }

    /// From now on, skin has so many Loop steps more than a picture needs, or below 0 fewer.
    pub fn refine(&mut self, steps: i32) {
        self.finer = steps;
        self.ask(self.latest.recipe.clone());
        self.take_up();
    }

    /// The latest recipe asked for.
    pub fn recipe(&self) -> &Recipe {
        &self.latest.recipe
    }

    /// Pixels along the picture's side.
    pub fn side(&self) -> usize {
        params::side(&self.working.recipe)
    }

    /// The stage at work: its word, or "done", or "error" where no pavement can be made of the
    /// recipe ([`Studio::problem`] says why).
    pub fn stage(&self) -> &'static str {
        match self.made.at() {
            _ if self.flows() => Stage::Packing.word(),
            _ if self.made.failure().is_some() => "error",
            Some(stage) => stage.word(),
            None => "done",
        }
    }

    /// Is the picture finished?
    pub fn done(&self) -> bool {
        self.made.at().is_none() && !self.flows()
    }

    /// Why the work stopped; `None` while all is well.
    pub fn problem(&self) -> Option<&Notice> {
        self.made.failure().filter(|_| !self.flows())
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
    pub fn progress(&self) -> StepReport {
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

    /// Stones painted so far in the pass at work.
    pub fn stones(&self) -> usize {
        self.made.stones()
    }

    /// The planes last finished.
    pub fn planes(&self) -> Option<&Planes> {
        self.made.planes()
    }

    /// The picture last finished: opaque RGBA, row after row from the top.
    pub fn picture(&self) -> Option<&[u8]> {
        Some(self.made.picture()).filter(|picture| !picture.is_empty())
    }

    /// Hex digest of the planes, empty until the work is done.
    pub fn digest(&self) -> String {
        match self.made.planes() {
            Some(planes) if self.done() => planes.digest(),
            _ => String::new(),
        }
    }

    /// The packing's potential energy, in units of a cell's; 0 before there is a packing.
    pub fn energy(&mut self) -> f64 {
        if self.flows()
            && let Some(draft) = &mut self.draft
        {
            return draft.energy();
        }
        let packing = self.made.packing_mut();
        packing.map_or(0.0, |(packing, domain)| packing.energy(domain))
    }

    /// How often each stage has finished, by its word, in the stages' order.
    pub fn runs(&self) -> Vec<(&'static str, u64)> {
        let runs = self.made.runs().into_iter();
        runs.map(|(stage, runs)| (stage.word(), runs)).collect()
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
        let particles = made.packing()?.particles();
        let (domain, fields) = made.terrain.made()?;
        let mesh = made.mesh().filter(|_| !made.cells().is_empty())?;
        Some(Metrics::new(domain, fields, &particles, mesh, made.cells()))
    }

    /// The figures of the run so far.
    pub fn report(&mut self) -> Report {
        let energy = self.energy();
        let last = self.progress();
        Report {
            link: self.latest.recipe.link(),
            size: self.side(),
            cells: self.made.cells().len(),
            steps: last.step,
            converged: last.converged,
            added: last.added,
            removed: last.removed,
            largest_move: last.largest_move,
            energy,
            milliseconds: self.milliseconds(),
            height_range: self.planes().map_or((0.0, 0.0), Planes::height_range),
            metrics: None,
            notices: Vec::new(),
            hash: self.digest(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};
    use crate::recipe::{Kind, SCHEMA};
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// A recipe in which some values are other ones, of small pictures with few cells.
    fn changed(recipe: &Recipe, random: &mut Random) -> Recipe {
        let mut changed = recipe.clone();
        for _ in 0..=random.below(3) {
            let row = &SCHEMA[random.below(SCHEMA.len())];
            let text = match row.kind {
                Kind::Text => continue,
                Kind::Choice => row.choices[random.below(row.choices.len())].word.to_owned(),
                Kind::Number | Kind::Int => {
                    let value = row.min + (row.max - row.min) * random.unit();
                    format!("{value:.2}")
                }
            };
            let _ = changed.set(row.key, &text);
        }
        let _ = changed.set("size", "128");
        if changed.number(crate::recipe::Key::Cs) < 12.0 {
            let _ = changed.set("cs", "12");
        }
        changed
    }

    /// Which stages must run to go from one recipe to another: those of which something else is asked,
    /// and those that read what they make.
    fn due(from: &Params, to: &Params) -> [bool; STAGES] {
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

    /// Wherever a studio comes from, it gives what the recipe gives, and works on nothing in vain.
    #[test]
    fn exactly_what_differs_runs() {
        let mut random = Random::new(11, Purpose::Placement, 0);
        let mut recipe = Recipe::from_link("size=128&cs=16").0;
        let mut studio = Studio::new(recipe.clone());
        assert_eq!(studio.finish(&mut || 0.0), Ok(()));
        let mut late = 0;
        for _ in 0..60 {
            let next = changed(&recipe, &mut random);
            let (from, runs) = (studio.working.params.clone(), studio.runs());
            studio.set_recipe(next.clone());
            if studio.finish(&mut || 0.0).is_err() {
                studio.set_recipe(recipe.clone());
                assert_eq!(studio.finish(&mut || 0.0), Ok(()));
                continue;
            }
            let due = due(&from, &studio.working.params);
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
            let mut plain = Studio::new(next.clone());
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
