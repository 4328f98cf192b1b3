//! All cells in plain colours, by their features or by their sorts.

use super::super::blocks::plain;
use super::super::colours::{FEATURES, type_of};
use super::super::parts::add_plain;
use super::super::views::MasonryView;
use super::SATIN;
use crate::masonry::laying::{CellSort, Laying, MasonryCell};
use crate::scene::Scene;
use crate::surface_stones::Fit;
use std::ops::Range;

/// The colour of a sort of cells. Raked bricks are cut along a slope.
pub(super) fn colour_of(sort: CellSort) -> [u8; 3] {
    match sort {
        CellSort::Whole => [188, 180, 166],
        CellSort::Half => [86, 146, 206],
        CellSort::Cut => [214, 92, 64],
        CellSort::Sill => [150, 122, 196],
        CellSort::Stone => [148, 168, 120],
        CellSort::Special => [222, 176, 84],
        CellSort::Raked => [226, 152, 72],
        CellSort::Tile => [112, 128, 144],
    }
}

/// Adds the cells of a range; ids count from 1.
pub(super) fn add(
    scene: &mut Scene,
    view: MasonryView,
    laying: &Laying,
    (fit, cells): (Fit, Range<usize>),
) {
    let colour = |cell: &MasonryCell| match view {
        MasonryView::Features => FEATURES[type_of(cell.feature)],
        _ => colour_of(cell.sort),
    };
    add_coloured(scene, laying, (fit, cells), colour);
}

/// Adds the cells of a range, each in the colour that `colour` gives; ids count from 1.
pub(super) fn add_coloured(
    scene: &mut Scene,
    laying: &Laying,
    (fit, cells): (Fit, Range<usize>),
    colour: impl Fn(&MasonryCell) -> [u8; 3],
) {
    let first = cells.start as u32 + 1;
    for (id, cell) in (first..).zip(&laying.cells()[cells]) {
        if let Some(body) = cell.body.shrunk() {
            add_plain(
                scene,
                plain(&body, |p| fit.place(p)),
                (id, colour(cell), SATIN),
            );
        }
    }
}
