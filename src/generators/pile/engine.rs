//! The engine of piles, for the studio.

use super::PileEngine;
use super::stages::BODIES;
use crate::generators::Progress;
use crate::generators::scene_picture::SceneFacts;
use crate::graph::Wiring;
use crate::notice::Notice;
use crate::pile::Fate;

impl SceneFacts for PileEngine {
    fn work_done(&self) -> Progress {
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

    fn body_count(&self) -> usize {
        self.made.count(Fate::Kept)
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn texts(&self) -> Vec<(&'static str, String)> {
        self.data_files()
    }

    fn figures(&self, id: u32) -> Vec<(&'static str, f64)> {
        self.measures(id)
    }

    fn words_of(&self, id: u32) -> Vec<(&'static str, String)> {
        self.named(id)
    }

    fn caption_of(&self, words: &str) -> Option<Notice> {
        self.meaning(words)
    }
}
