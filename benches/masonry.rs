//! Masonry: a house laid without geometry, with few and with many bricks; its frames, and the way to them.

use super::frames::{self, frame, place};
use super::{Clock, Timing, shortest};
use bubblestone::building::{Building, Draft, Module, Rule};
use bubblestone::generators::ALL;
use bubblestone::masonry::laying::{Laying, LayingParams};
use bubblestone::masonry::plan::thicknesses;
use bubblestone::masonry::tree::TreePreset;
use bubblestone::studio::Studio;
use std::sync::Arc;

/// How much smaller bricks are, so that the same house has about 50,000.
const SMALLER: f64 = 11.0 / 3.0;
/// Parts of the work in a slice.
const PARTS: usize = 64;

/// The house.
fn house() -> Draft {
    Rule::LHouse.draft(&Module::NORMAL, &[]).sorted()
}

/// Lays all bricks of a building and returns their number; `None` if it cannot be laid.
fn laid(building: &Arc<Building>, smaller: f64) -> Option<usize> {
    let tree = TreePreset::of_word("bricks")?.tree();
    let normal = Module::NORMAL;
    let params = LayingParams {
        module: Module {
            half: normal.half / smaller,
            course: normal.course / smaller,
            joint: normal.joint / smaller,
        },
        is_by_hand: false,
        seed: 1,
    };
    let thickness = thicknesses(building).ok()?;
    let mut laying = Laying::new(building.clone(), tree, params, |face| {
        thickness[face.index()]
    })
    .ok()?;
    while !laying.advance(PARTS) {}
    Some(laying.cells().len())
}

/// The house, and the same house with small bricks, as recipes.
const HOUSE: &str = "make=masonry&building=lhouse&pattern=bricks";
const SMALL: &str = "&module=own&w=34.1&h=22.7&joint=2.7";

/// Walls round a yard with about as many bricks as the house, and all openings but the first window.
const YARD: &str =
    "make=masonry&building=plan&pattern=bricks&plan=0,0,60,0,60,-40,0,-40,0,0&plan_height=48";
const OTHERS: &str = ";1,40,10,6,12,1;2,10,10,6,12,1;2,25,10,6,12,1;3,10,10,6,12,0;3,40,10,6,12,2;4,10,10,6,12,1;4,25,10,6,12,1";

/// Times everything about masonry.
pub fn timings(clock: Clock) -> Vec<Timing> {
    let mut timings = laying(clock);
    timings.push(moved_window(clock));
    for (name, small) in [("house", ""), ("house of small bricks", SMALL)] {
        let studio_of =
            |light: &str| Studio::new(ALL, ALL.recipe(&format!("{HOUSE}{small}{light}")).0);
        let with =
            |studio: &mut Studio, light: &str| studio.set_recipe(studio_of(light).recipe().clone());
        timings.extend(frames::timings(name, studio_of(""), with, clock));
    }
    timings
}

/// Times the way from a window that is moved by a module to the first frame of the walls.
fn moved_window(clock: Clock) -> Timing {
    let recipe = |left: usize| {
        ALL.recipe(&format!("{YARD}&openings=1,{left},10,6,12,1{OTHERS}"))
            .0
    };
    let mut studio = Studio::new(ALL, recipe(12));
    place(&mut studio, clock);
    let times = (0..6).map(|k| {
        let start = clock();
        studio.set_recipe(recipe(13 - k % 2));
        place(&mut studio, clock);
        frame(&mut studio, 0.0, 256, "moving", clock);
        clock() - start
    });
    Timing {
        name: "from a moved window to the first frame".to_owned(),
        ms: shortest(times),
    }
}

/// Times the laying of the house, and of the same house with small bricks; and a thousand bricks of each.
fn laying(clock: Clock) -> Vec<Timing> {
    let Ok(building) = Building::new(&house()).map(Arc::new) else {
        return Vec::new();
    };
    let mut timings = Vec::new();
    for (name, smaller, runs) in [
        ("the house", 1.0, 9),
        ("the house of small bricks", SMALLER, 3),
    ] {
        let mut bricks = 0;
        let times = (0..runs).map(|_| {
            let start = clock();
            bricks = laid(&building, smaller).unwrap_or(0);
            clock() - start
        });
        let ms = shortest(times);
        timings.push(Timing {
            name: format!("{name}, laid: {bricks} bricks"),
            ms,
        });
        timings.push(Timing {
            name: format!("a thousand bricks of {name}"),
            ms: 1e3 * ms / bricks.max(1) as f64,
        });
    }
    timings
}
