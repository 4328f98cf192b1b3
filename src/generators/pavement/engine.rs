//! The engine of pavements, for the studio.

use super::look::View;
use super::params::Params;
use super::{Pavement, Stage};
use crate::export::{Map, MapKind, MeshOrder, MeshSize, Report};
use crate::generators::{Clock, Engine, MeshSlice, PictureSlice, Progress};
#[cfg(house)]
use crate::generators::{FrameSlice, SeenBody, TurnOrder};
use crate::graph::Wiring;
use crate::heightfield::Planes;
use crate::notice::Notice;
use crate::recipe::Recipe;
#[cfg(house)]
use crate::scene::Frame;

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

    fn forget(&mut self) {
        self.made.forget();
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
        self.made.runs()
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
        let packing = self.made.shown_packing_mut();
        packing.map_or(0.0, |(packing, domain)| packing.energy(domain))
    }

    fn set_live(&mut self, on: bool) {
        self.is_live = on;
    }

    fn is_drafting(&self) -> bool {
        let is_stale = self
            .made
            .stale()
            .is_some_and(|stage| stage <= Stage::Packing);
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
        order: (usize, &[MapKind]),
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice> {
        self.bigger_slice(order, clock, budget)
    }

    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        self.mesh_slice(order, clock, budget)
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        Some(order.size(self.scales().len(), self.side()))
    }

    #[cfg(house)]
    fn turn(&mut self, order: &TurnOrder, clock: Clock, budget: f64) -> Result<FrameSlice, Notice> {
        self.turn_slice(order, clock, budget)
    }

    #[cfg(house)]
    fn frame(&self) -> Option<&Frame> {
        self.slant.frame()
    }

    #[cfg(house)]
    fn body_at(&self, x: usize, y: usize) -> Option<SeenBody> {
        self.seen_at(x, y)
    }

    #[cfg(house)]
    fn making(&self, id: u32) -> Vec<String> {
        self.steps_of(id)
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
