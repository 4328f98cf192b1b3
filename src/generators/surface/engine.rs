//! The engine of surfaces, for the studio.

use super::SurfaceEngine;
use crate::generators::scene_picture::SceneFacts;
use crate::generators::{ModelFacts, Progress};
use crate::notice::Notice;

impl SceneFacts for SurfaceEngine {
    fn work_done(&self) -> Progress {
        Progress::of_packing(self.made.report(), self.made.stones())
    }

    fn work_energy(&mut self) -> f64 {
        let packing = self.made.packing_mut();
        packing.map_or(0.0, |(packing, site)| packing.energy(site))
    }

    fn body_count(&self) -> usize {
        self.made.paved().map_or(0, |paved| paved.cells.len())
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn texts(&self) -> Vec<(&'static str, String)> {
        self.data_files()
    }

    fn figures(&self, id: u32) -> Vec<(&'static str, f64)> {
        self.measures(id)
    }

    fn caption_of(&self, words: &str) -> Option<Notice> {
        self.meaning(words)
    }

    fn steps_of(&self, id: u32) -> Vec<String> {
        self.making_steps(id)
    }

    fn place_seen_at(&self, x: usize, y: usize) -> Option<[i64; 3]> {
        self.traced_place(x, y)
    }

    fn pixel_of_place(&self, place: [i64; 3]) -> Option<[f64; 2]> {
        self.traced_pixel(place)
    }

    fn model_facts(&self) -> Option<ModelFacts> {
        self.made.model()
    }
}
