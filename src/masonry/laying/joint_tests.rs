//! Bricks beside arches and under gables of random spans, heights and shapes: hardly any piece is thin.
//!
//! To run more of them: `BUBBLESTONE_RECIPES=1000 cargo test --lib beside_random_arches`.

use super::random_tests::assert_all;
use super::tests::laid;
use super::{Feature, Laying, MasonryCell};
use crate::building::{Module, Rule};
use crate::masonry::footprint::Footprint;
use crate::masonry::plan::is_wall;
use crate::masonry::tree::PatternGenerator;
use crate::random::{Purpose, Random};

const MODULE: Module = Module::NORMAL;
/// The least width of a piece, in half bricks, and the least share of its row's height if that is less.
const LEAST: [f64; 2] = [1.0 / 3.0, 0.6];
/// A slip fills what is left of a row over a crown, over a threshold or below an apex, where no joint helps. Its least
/// width and area, in half bricks.
const SLIP: [f64; 2] = [0.2, 0.3];
/// The greatest height of a slip, in widths: it lies along its row.
const FLAT: f64 = 1.3;
/// The greatest number of slips on a building.
const SLIPS: usize = 10;

/// A building with arches, its numbers random. Arches stand for straight heads.
fn numbers(random: &mut Random, rule: Rule) -> Vec<f64> {
    let any = rule.numbers().iter().map(|number| {
        let below = 1 + (number.most - number.least) as usize;
        match number.word {
            "head" => (1 + random.below(2)) as f64,
            _ => number.least + random.below(below.min(16)) as f64,
        }
    });
    any.collect()
}

/// The part of a wall that a piece of a brick claims, and the height of its row (metres); none for other cells.
fn piece<'a>(laying: &Laying, cell: &'a MasonryCell) -> Option<(&'a Footprint, f64)> {
    let Feature::Face(face) = cell.feature else {
        return None;
    };
    let is_piece =
        cell.generator == PatternGenerator::Bricks && is_wall(laying.building().face(face));
    let own = cell.claims.iter().find(|(id, _)| *id == face);
    let (_, claim) = own.filter(|_| is_piece)?;
    let t = claim.centre().y;
    let rows = laying.plan().grid(face).t.windows(2);
    let row = rows
        .map(|w| [w[0], w[1]])
        .find(|row| (row[0]..row[1]).contains(&t))?;
    Some((claim, row[1] - row[0]))
}

/// Whether a piece lies along its row, and is large enough for a slip.
fn is_slip(claim: &Footprint) -> bool {
    let ([low, high], width) = (claim.bounds(), claim.least_width());
    let [least, area] = SLIP;
    high.y - low.y < FLAT * width
        && width >= least * MODULE.half
        && claim.area() >= area * MODULE.half * MODULE.course
}

/// The thin pieces on a random building with arches that are no slips, and all of them if there are too many slips.
fn thin(seed: u64) -> Vec<String> {
    let mut random = Random::new(seed, Purpose::Scatter, 0);
    let rules = [Rule::Gate, Rule::Wall, Rule::Gabled, Rule::LHouse];
    let rule = rules[(seed % 4) as usize];
    let tree = [1, 3, 5][(seed / 4 % 3) as usize];
    let numbers = numbers(&mut random, rule);
    let laying = laid(&rule.draft(&MODULE, &numbers), (tree, MODULE), seed);
    let pieces = laying
        .cells()
        .iter()
        .filter_map(|cell| piece(&laying, cell));
    let [width, share] = LEAST;
    let is_thin = |&(claim, row): &(&Footprint, f64)| {
        claim.least_width() < (width * MODULE.half).min(share * row)
    };
    let (slips, mut wrong): (Vec<_>, Vec<_>) = pieces
        .filter(is_thin)
        .partition(|(claim, _)| is_slip(claim));
    if slips.len() > SLIPS {
        wrong.extend(slips);
    }
    let told = wrong.into_iter().map(|(claim, row)| {
        let [width, row] = [claim.least_width(), row].map(|v| (1e3 * v).round());
        let at = claim.centre();
        format!(
            "{seed}: {rule:?} {numbers:?} tree {tree}: {width} mm in a row of {row} mm at {at:.2}"
        )
    });
    told.collect()
}

#[test]
fn no_piece_of_a_brick_is_thin_beside_random_arches() {
    assert_all(48, thin);
}
