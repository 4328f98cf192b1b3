//! The shape of rounded stones, and how fine they are.

use super::colours::STONE_ROW;
use super::params::BlockParams;
use crate::masonry::block::Rough;
use crate::masonry::laying::{CellSort, MasonryCell};

/// Width of the rounded edges of stones, and height of the bumps on them, at roughness 1 (metres).
const BEVEL: f64 = 0.024;
const BUMPS: f64 = 0.014;
/// The most triangles of all rounded stones at their finest levels, in control meshes: a Loop step makes four triangles of
/// one. A stone of ashlar counts 16 and takes about 55 kB at all its levels. So all stones take 300 MB at most, and those
/// of the wall before an edit as much again; the memory of a page has 1 GiB.
const MOST: u64 = 16 * 5_500;

/// Whether the block of a cell is a stone that may be rounded, and no sill or tile.
pub(super) fn is_hewn(cell: &MasonryCell, material: u8) -> bool {
    material == STONE_ROW && !matches!(cell.sort, CellSort::Sill | CellSort::Tile)
}

/// The shape of rounded stones, with some Loop steps fewer than usual.
pub(super) fn stone(params: &BlockParams, fewer: u32) -> Rough {
    Rough {
        bevel: BEVEL * params.rough,
        height: BUMPS * params.rough,
        seed: params.seed,
        steps: Rough::STONE.steps.saturating_sub(fewer),
        ..Rough::STONE
    }
}

/// The shape of cast stones, with some Loop steps fewer than usual.
pub(super) fn cast(params: &BlockParams, fewer: u32) -> Rough {
    Rough {
        seed: params.seed,
        steps: Rough::CAST.steps.saturating_sub(fewer),
        ..Rough::CAST
    }
}

/// The shape of a cell's block if it is rounded, with all Loop steps; `None` if its edges are chamfered.
pub(super) fn rounding(params: &BlockParams, cell: &MasonryCell, material: u8) -> Option<Rough> {
    if cell.body.has_rough_sides() {
        return Some(cast(params, 0));
    }
    (params.rough > 0.0 && is_hewn(cell, material)).then(|| stone(params, 0))
}

/// The number of Loop steps that rounded stones have less than usual, so that all of them find room. Each stone is small
/// in the picture where there are many.
pub(super) fn fewer_steps(params: &BlockParams, cells: &[MasonryCell]) -> u32 {
    let steps = cells.iter().filter_map(|cell| {
        let rough = rounding(params, cell, params.colours.material_of(cell))?;
        Some(rough.steps)
    });
    fewer(&steps.collect::<Vec<u32>>())
}

/// As [`fewer_steps`], for stones with these numbers of Loop steps.
fn fewer(steps: &[u32]) -> u32 {
    let all = |fewer: u32| {
        let each = steps.iter().map(|&steps| steps.saturating_sub(fewer));
        each.map(|steps| 4_u64.pow(steps)).sum::<u64>()
    };
    let most = steps.iter().copied().max().unwrap_or(0);
    let enough = (0..most).find(|&fewer| all(fewer) <= MOST);
    enough.unwrap_or(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_stones_are_fine_and_many_find_room() {
        let [stone, cast] = [Rough::STONE, Rough::CAST].map(|rough| rough.steps);
        assert_eq!(fewer(&[]), 0);
        assert_eq!(fewer(&[stone; 5_500]), 0);
        assert_eq!(fewer(&[stone; 5_501]), 1);
        assert_eq!(fewer(&[cast; 5_500]), 1);
        assert_eq!(fewer(&[stone; 60_000]), 2);
        let mixed = [vec![stone; 5_000], vec![cast; 1_000]].concat();
        assert_eq!(fewer(&mixed), 1);
    }
}
