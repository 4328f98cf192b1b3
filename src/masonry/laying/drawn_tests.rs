//! Every kind of pattern on random drawn plans: right-angled and oblique corners, open and closed lines, up to 20
//! openings.
//!
//! To run more of them: `BUBBLESTONE_RECIPES=1000 cargo test --lib random_plans`.

use super::random_tests::assert_all;
use super::{Laying, LayingParams, Measures};
use crate::building::{Building, DrawnFault, DrawnPlan, Module};
use crate::masonry::module::ASHLAR;
use crate::masonry::plan::{PlanWarning, thicknesses};
use crate::masonry::tree::TreePreset;
use crate::random::{Purpose, Random};
use std::sync::Arc;

/// The trees with their modules, the greatest shared volume, and the greatest share of bed joints that end at an edge.
/// Large stones beside arched heads, narrow piers and oblique corners are cut less well than bricks.
const TREES: [(&str, Module, [f64; 2]); 4] = [
    ("bricks", Module::NORMAL, [1e-3, 0.03]),
    ("ashlar", ASHLAR, [2e-3, 0.05]),
    ("coped", Module::NORMAL, [1e-3, 0.03]),
    ("quoins", Module::NORMAL, [3e-3, 0.03]),
];

/// A whole number from `least` to `most`.
fn whole(random: &mut Random, least: i64, most: i64) -> i64 {
    least + random.below((most - least + 1) as usize) as i64
}

/// An open line of 1 to 7 walls: along the axes, along diagonals, too, or in any direction.
fn open(random: &mut Random) -> Vec<[i64; 2]> {
    let kind = random.below(3);
    let mut corners = vec![[0, 0]];
    for _ in 0..=random.below(7) {
        let length = whole(random, 6, 16);
        let [x, y] = match kind {
            0 => [[1, 0], [0, 1], [-1, 0], [0, -1]][random.below(4)],
            1 => [[1, 0], [1, 1], [0, 1], [-1, 1]][random.below(4)],
            _ => [0; 2].map(|_| whole(random, -8, 8)),
        };
        let by = if kind == 2 {
            [x, y]
        } else {
            [x * length, y * length]
        };
        let [x, y] = corners[corners.len() - 1];
        corners.push([x + by[0], y + by[1]]);
    }
    corners
}

/// A closed line around the origin, of 3 to 8 walls, in either direction.
fn closed(random: &mut Random) -> Vec<[i64; 2]> {
    let count = 3 + random.below(6);
    let corner = |k: usize, radius: f64| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / count as f64);
        [cos, sin].map(|v| (radius * v).round() as i64)
    };
    let mut corners: Vec<[i64; 2]> = (0..count)
        .map(|k| corner(k, whole(random, 16, 30) as f64))
        .collect();
    if random.below(2) == 0 {
        corners.reverse();
    }
    corners.push(corners[0]);
    corners
}

/// The building of a random plan. Plans are drawn until one is not refused; some of its openings may be.
fn building(random: &mut Random, module: &Module) -> Building {
    loop {
        let corners = match random.below(2) {
            0 => open(random),
            _ => closed(random),
        };
        let sill = whole(random, 5, 9);
        let openings = (0..random.below(21)).map(|_| {
            [
                whole(random, 1, corners.len() as i64 - 1),
                whole(random, 2, 20),
                sill * i64::from(random.below(3) > 0),
                whole(random, 3, 7),
                if random.below(3) > 0 { 8 } else { 11 },
                whole(random, 0, 2),
            ]
        });
        let plan = DrawnPlan {
            openings: openings.collect(),
            corners,
        };
        let numbers = [whole(random, 24, 34), whole(random, 2, 4)].map(|n| n as f64);
        let (draft, faults) = plan.draft(module, &numbers);
        if faults
            .iter()
            .all(|fault| matches!(fault, DrawnFault::Opening { .. }))
        {
            return Building::new(&draft)
                .unwrap_or_else(|fault| panic!("{plan:?} {numbers:?}: {fault:?}"));
        }
    }
}

/// The faults of a pattern on a random plan.
fn faults(seed: u64) -> Vec<String> {
    let mut random = Random::new(seed, Purpose::Scatter, 0);
    let (word, module, [shared, courses]) = TREES[(seed % TREES.len() as u64) as usize];
    let building = Arc::new(building(&mut random, &module));
    let thick = thicknesses(&building).expect("a mesh");
    let params = LayingParams {
        module,
        is_by_hand: false,
        seed,
    };
    let tree = TreePreset::of_word(word).expect("a tree").tree();
    let mut laying =
        Laying::new(building, tree, params, |face| thick[face.index()]).expect("a plan");
    while !laying.advance(64) {}
    let (plan, found) = (laying.plan(), Measures::new(&laying));
    let told = |warning: &&PlanWarning| matches!(warning, PlanWarning::Conflict(_));
    let told = plan.warnings.iter().filter(told).count();
    let sound =
        |cell: &&super::MasonryCell| !cell.claimed.is_sound() || !cell.claimed.is_convex(0.01);
    let broken = laying.cells().iter().filter(sound).count();
    let wrong = [
        (
            "conflicts that are not told",
            found.conflicts.abs_diff(told) as f64,
            0.0,
        ),
        ("overlap", found.shared_volume, shared),
        ("gap", found.gap, 3e-3),
        ("courses", 1.0 - found.course, courses),
        ("warnings of the tree", laying.warnings().len() as f64, 0.0),
        ("broken cells", broken as f64, 0.0),
    ];
    let wrong = wrong.iter().filter(|(_, value, most)| value > most);
    wrong
        .map(|(what, value, _)| format!("{seed} {word}: {what} {value}"))
        .collect()
}

#[test]
fn random_plans_are_laid_without_gaps_or_overlaps() {
    assert_all(24, faults);
}
