//! The engine of piles, for the studio.

use super::PileEngine;
use super::params::PileParams;
use super::stages::BODIES;
use crate::export::{MeshOrder, MeshSize, Report};
use crate::generators::scene_picture;
use crate::generators::{
    Clock, Engine, Files, FrameSlice, Frames, GivenFile, MeshSlice, Meshes, MissingFile, Progress,
    SeenBody, TurnOrder,
};
use crate::graph::Wiring;
use crate::notice::Notice;
use crate::pile::Fate;
use crate::recipe::Recipe;
use crate::scene::Frame;

impl Engine for PileEngine {
    fn ask(&mut self, recipe: &Recipe) {
        self.made.ask(PileParams::new(recipe));
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
        self.made.at().is_some_and(|at| at < BODIES)
    }

    fn runs(&self) -> Vec<u64> {
        self.made.runs()
    }

    fn progress(&self) -> Progress {
        let refining = self.made.refining();
        let settled = refining.map_or(0, |refining| refining.history().len());
        Progress {
            cells: self.made.count(Fate::Kept),
            steps: settled as u32,
            removed: (self.made.count(Fate::Removed) + self.made.count(Fate::Walls)) as u32,
            converged: self.made.at().is_none_or(|at| at >= BODIES),
            stones: self.made.finished(),
            ..Progress::default()
        }
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
        report.cells = self.made.count(Fate::Kept);
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

impl Meshes for PileEngine {
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        self.mesh_slice(order, clock, budget)
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        self.size_of_mesh(order)
    }

    fn stop_mesh(&mut self) {
        self.saving = None;
    }
}

impl Frames for PileEngine {
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

    fn caption(&self, words: &str) -> Option<Notice> {
        self.caption_of(words)
    }
}

impl Files for PileEngine {
    fn give(&mut self, file: GivenFile) {
        self.made.give(file.digest(), file.into_bytes());
    }

    fn missing(&self) -> Vec<MissingFile> {
        self.made.missing()
    }
}
