//! The measures of a block, and the caption of a view.

use super::MasonryEngine;
use super::colours::type_of;
use super::views::MasonryView;
use crate::masonry::laying::{CellSort, MasonryCell};
use crate::notice::{Code, Notice};
use glam::DVec3;

impl MasonryEngine {
    /// The measures of a block, by their words: its length, height and depth in millimetres, joints not counted; and its
    /// feature's type: 0 a corner, 1 an edge, 2 a face.
    pub(super) fn measures(&self, id: u32) -> Vec<(&'static str, f64)> {
        let cells = self
            .made
            .cells
            .made()
            .map_or(&[][..], |laying| laying.cells());
        let cell = (id as usize).checked_sub(1).and_then(|k| cells.get(k));
        let Some((cell, body)) = cell.and_then(|cell| Some((cell, cell.body.shrunk()?))) else {
            return Vec::new();
        };
        let across = cell.outwards.cross(DVec3::Y).normalize_or(DVec3::X);
        let up = across.cross(-cell.outwards);
        let extent = |axis: DVec3| {
            let along = body.vertices().iter().map(|p| p.dot(axis));
            let ends = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], v| {
                [lo.min(v), hi.max(v)]
            });
            (1e3 * (ends[1] - ends[0])).round()
        };
        vec![
            ("length", extent(across)),
            ("height", extent(up)),
            ("depth", extent(cell.outwards)),
            ("feature", type_of(cell.feature) as f64),
        ]
    }

    /// The caption of a view that is shown.
    pub(super) fn meaning(&self, words: &str) -> Option<Notice> {
        let cells = self.made.cells.made()?.cells();
        let of = |is: &dyn Fn(&MasonryCell) -> bool| cells.iter().filter(|cell| is(cell)).count();
        match MasonryView::of_words(words) {
            MasonryView::Features => {
                let [corners, edges, faces] =
                    [0, 1, 2].map(|k| of(&|cell| type_of(cell.feature) == k));
                Some(
                    Notice::new(Code::MasonryFeatures)
                        .with("corners", corners)
                        .with("edges", edges)
                        .with("faces", faces),
                )
            }
            MasonryView::Sizes => {
                let sorts = [
                    CellSort::Whole,
                    CellSort::Half,
                    CellSort::Cut,
                    CellSort::Raked,
                ];
                let [whole, half, cut, raked] = sorts.map(|sort| of(&|cell| cell.sort == sort));
                let cut = cut + raked;
                Some(
                    Notice::new(Code::MasonrySizes)
                        .with("whole", whole)
                        .with("half", half)
                        .with("cut", cut)
                        .with("other", cells.len() - whole - half - cut),
                )
            }
            _ => None,
        }
    }
}
