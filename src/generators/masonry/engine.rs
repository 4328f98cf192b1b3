//! The engine of masonry, for the studio.

use super::MasonryEngine;
use super::stages::BLOCKS;
use crate::generators::scene_picture::SceneFacts;
use crate::generators::{Progress, SeenLabel};
use crate::graph::Wiring;
use crate::notice::Notice;

impl SceneFacts for MasonryEngine {
    fn work_done(&self) -> Progress {
        let laid = self.made.finished();
        Progress {
            cells: laid,
            steps: laid as u32,
            converged: self.made.at().is_none_or(|at| at >= BLOCKS),
            stones: laid,
            ..Progress::default()
        }
    }

    fn body_count(&self) -> usize {
        self.made.finished()
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

    fn labels_seen(&self) -> Vec<SeenLabel> {
        self.labels_in_frame()
    }

    fn steps_of(&self, id: u32) -> Vec<String> {
        self.states(id)
    }

    fn caption_of(&self, words: &str) -> Option<Notice> {
        self.meaning(words)
    }
}
