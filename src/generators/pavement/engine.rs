//! The engine of pavements, for the studio.

use super::look::PavementView;
use super::params::Params;
use super::{Pavement, PavementRecipe, Stage};
use crate::domain::Outline;
use crate::export::Report;
#[cfg(house)]
use crate::generators::Frames;
use crate::generators::{
    Clock, Drafts, Engine, Inspect, Maps, Meshes, Outlines, Products, Progress, Rewind, Steps,
};
use crate::graph::Wiring;
use crate::heightfield::Planes;
use crate::notice::{Code, Notice};
use crate::packing::Packing;
use crate::recipe::Recipe;
use glam::DVec2;

impl Engine for Pavement {
    fn ask(&mut self, recipe: &Recipe) {
        let params = Params::new(recipe, self.exact.as_ref(), self.finer);
        if let Some(draft) = &mut self.draft {
            draft.stages.ask(params.clone());
        }
        self.made.ask(params);
        if !self.is_live || !self.keeps_side() {
            self.draft = None;
        }
    }

    fn stale(&self) -> Option<usize> {
        self.made.stale().map(|stage| stage as usize)
    }

    fn take_up(&mut self) {
        self.made.take_up();
    }

    fn forget_steps(&mut self) {
        self.forget_packing();
    }

    fn side(&self) -> usize {
        self.texture().side
    }

    fn at(&self) -> Option<usize> {
        self.made.at().map(|stage| stage as usize)
    }

    fn failure(&self) -> Option<&Notice> {
        self.made.failure()
    }

    fn remarks(&self) -> Vec<Notice> {
        let packing = self.made.shown_packing();
        let packing = packing.filter(|_| self.made.is_packing());
        let left_out = packing.map_or(0, Packing::left_out);
        let flown_at = self.step_report().flown_at;
        let outside = Notice::new(Code::GivenOutside).with("n", left_out);
        let flew = Notice::new(Code::FlewApart).with("step", flown_at as usize);
        let outside = (left_out > 0).then_some(outside);
        outside
            .into_iter()
            .chain((flown_at > 0).then_some(flew))
            .collect()
    }

    fn advance(&mut self) {
        self.made.advance();
    }

    fn is_step(&self) -> bool {
        self.made.at() == Some(Stage::Packing) && self.made.is_packing()
    }

    fn is_forming(&self) -> bool {
        self.made.is_forming()
    }

    fn is_drafting(&self) -> bool {
        let stale = self.made.stale();
        let is_stale = stale.is_some_and(|stage| stage <= Stage::Packing);
        self.is_live && is_stale && self.keeps_side()
    }

    fn runs(&self) -> Vec<u64> {
        self.made.runs()
    }

    fn progress(&self) -> Progress {
        Progress::of_packing(self.step_report(), self.made.stones())
    }

    fn energy(&mut self) -> f64 {
        if self.is_drafting()
            && let Some(draft) = &mut self.draft
        {
            return draft.energy();
        }
        let packing = self.packing_mut();
        packing.map_or(0.0, |(packing, domain)| packing.energy(domain))
    }

    fn view(&mut self, words: &str) -> &[u8] {
        self.look_at(PavementView::of_words(words))
    }

    fn prepare(&mut self, words: &str, clock: Clock, budget: f64) -> bool {
        self.draw_beforehand(PavementView::of_words(words), clock, budget)
    }

    fn picture(&self) -> &[u8] {
        self.made.picture()
    }

    fn digest(&self) -> String {
        self.made.planes().map_or(String::new(), Planes::digest)
    }

    fn report(&mut self, report: &mut Report) {
        report.cells = self.made.cells().len();
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

    fn drafts(&mut self) -> Option<&mut dyn Drafts> {
        Some(self)
    }

    fn maps(&mut self) -> Option<&mut dyn Maps> {
        Some(self)
    }

    fn meshes(&mut self) -> Option<&mut dyn Meshes> {
        Some(self)
    }

    fn inspect(&mut self) -> Option<&mut dyn Inspect> {
        Some(self)
    }

    fn rewind(&mut self) -> Option<&mut dyn Rewind> {
        Some(self)
    }

    fn steps(&mut self) -> Option<&mut dyn Steps> {
        Some(self)
    }

    fn outlines(&mut self) -> Option<&mut dyn Outlines> {
        Some(self)
    }

    #[cfg(house)]
    fn frames(&mut self) -> Option<&mut dyn Frames> {
        Some(self)
    }

    fn products(&self) -> Option<Products<'_>> {
        let (shown, flowing) = (self.shown(), self.flowing());
        let ended = self.made.ground().zip(self.made.packing.made());
        Some(Products {
            domain: shown.domain,
            fields: shown.fields,
            packing: match flowing {
                Some(draft) => Some(&draft.packing),
                None => self.made.shown_packing(),
            },
            ended: ended.map(|((domain, fields), packing)| (domain, fields, packing)),
            mesh: self.mesh(),
            cells: self.cells(),
            scales: self.scales(),
            stones: self.stone_params(),
            planes: self.planes(),
        })
    }
}

impl Drafts for Pavement {
    fn set_live(&mut self, on: bool) {
        self.is_live = on;
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
}

impl Outlines for Pavement {
    fn rings(&self) -> Vec<&[DVec2]> {
        self.shown().rings
    }

    fn part(&self, place: DVec2) -> Option<usize> {
        let domain = self.shown().domain?;
        domain.contains(place).then(|| domain.part(place))
    }

    fn draw(&self, recipe: &mut Recipe, outline: &Outline) -> Result<Vec<Notice>, Notice> {
        recipe.set_polygon(outline)
    }
}
