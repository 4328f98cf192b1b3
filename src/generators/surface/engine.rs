//! The engine of surfaces, for the studio.

use super::SurfaceEngine;
use super::params::Params;
use super::stages::STONES;
use crate::export::{MeshOrder, MeshSize, Report};
use crate::generators::scene_picture;
use crate::generators::{
    Clock, Engine, Files, FrameSlice, Frames, GivenFile, MeshSlice, Meshes, MissingFile,
    ModelFacts, Progress, SeenBody, TurnOrder,
};
use crate::graph::Wiring;
use crate::notice::Notice;
use crate::recipe::Recipe;
use crate::scene::Frame;

impl Engine for SurfaceEngine {
    fn ask(&mut self, recipe: &Recipe) {
        self.made.ask(Params::new(recipe));
    }

    fn stale(&self) -> Option<usize> {
        self.made.stale()
    }

    fn take_up(&mut self) {
        self.made.take_up();
    }

    fn forget(&mut self) {
        self.made.forget();
    }

    fn side(&self) -> usize {
        self.made.still.params().side
    }

    fn at(&self) -> Option<usize> {
        self.made.at()
    }

    fn failure(&self) -> Option<&Notice> {
        self.made.failure()
    }

    fn remarks(&self) -> Vec<Notice> {
        self.made.remarks()
    }

    fn advance(&mut self) {
        self.made.advance();
    }

    fn is_step(&self) -> bool {
        self.made.is_moving()
    }

    fn is_forming(&self) -> bool {
        self.made.at().is_some_and(|at| at < STONES)
    }

    fn runs(&self) -> Vec<u64> {
        self.made.runs()
    }

    fn progress(&self) -> Progress {
        let last = self.made.report();
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
        let packing = self.made.packing_mut();
        packing.map_or(0.0, |(packing, site)| packing.energy(site))
    }

    fn view(&mut self, words: &str) -> &[u8] {
        scene_picture::view(self, words)
    }

    fn prepare(&mut self, words: &str, clock: Clock, budget: f64) -> bool {
        scene_picture::prepare(self, words, clock, budget)
    }

    fn picture(&self) -> &[u8] {
        self.made.picture()
    }

    fn digest(&self) -> String {
        self.made.digest()
    }

    fn report(&mut self, report: &mut Report) {
        report.cells = self.made.paved().map_or(0, |paved| paved.cells.len());
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn data(&self) -> Vec<(&'static str, String)> {
        self.texts()
    }

    fn meshes(&mut self) -> Option<&mut dyn Meshes> {
        Some(self)
    }

    fn frames(&mut self) -> Option<&mut dyn Frames> {
        Some(self)
    }

    fn files(&mut self) -> Option<&mut dyn Files> {
        Some(self)
    }
}

impl Meshes for SurfaceEngine {
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        self.mesh_slice(order, clock, budget)
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        let (paved, built) = (self.made.paved()?, self.made.last_built()?);
        let ground = built.whole.triangles().len();
        Some(order.model_size(paved.cells.len(), ground))
    }

    fn stop_mesh(&mut self) {
        self.saving = None;
    }
}

impl Frames for SurfaceEngine {
    fn turn(&mut self, order: &TurnOrder, clock: Clock, budget: f64) -> Result<FrameSlice, Notice> {
        scene_picture::turn(self, order, clock, budget)
    }

    fn frame(&self) -> Option<&Frame> {
        self.picture.frame()
    }

    fn body_at(&mut self, x: usize, y: usize) -> Option<SeenBody> {
        let yaw = self.made.still.params().yaw;
        let body = self.picture.body_at(yaw, x, y)?;
        let figures = self.figures(body.id);
        Some(SeenBody { figures, ..body })
    }

    fn making(&self, id: u32) -> Vec<String> {
        self.steps_of(id)
    }

    fn caption(&self, words: &str) -> Option<Notice> {
        self.caption_of(words)
    }

    fn place_at(&self, x: usize, y: usize) -> Option<[i64; 3]> {
        self.place_seen_at(x, y)
    }

    fn pixel_of(&self, place: [i64; 3]) -> Option<[f64; 2]> {
        self.pixel_of_place(place)
    }
}

impl Files for SurfaceEngine {
    fn give(&mut self, file: GivenFile) {
        self.made.give(file.digest(), file.into_bytes());
    }

    fn missing(&self) -> Vec<MissingFile> {
        self.made.missing()
    }

    fn model(&self) -> Option<ModelFacts> {
        self.made.model()
    }
}
