//! The studio's own rules, with an engine whose slices take a known time.

use crate::common::recipe;
use bubblestone::export::Report;
use bubblestone::generators::{ALL, Clock, Engine, Progress};
use bubblestone::notice::Notice;
use bubblestone::recipe::Recipe;
use bubblestone::studio::Studio;
use std::cell::Cell;
use std::rc::Rc;

/// The key that each stage of a pavement works by here. The third stage goes in steps.
const KEYS: [&str; 8] = ["ow", "cs", "seed", "edge", "cells", "af", "moss", "az"];
const PACKING: usize = 2;
const PLANES: usize = 5;
const SHADING: usize = 7;

/// The time, and the milliseconds of a slice of each stage.
#[derive(Default)]
struct Pace {
    now: Cell<f64>,
    slice: [Cell<f64>; 8],
}

/// A pavement's stages with three slices each, which make nothing but take their time.
struct Toy {
    pace: Rc<Pace>,
    latest: [String; 8],
    working: [String; 8],
    at: usize,
    slices: u32,
    runs: [u64; 8],
}

impl Engine for Toy {
    fn ask(&mut self, recipe: &Recipe) {
        self.latest = words(recipe);
    }

    fn stale(&self) -> Option<usize> {
        (0..8).find(|&k| self.latest[k] != self.working[k])
    }

    fn take_up(&mut self) {
        if let Some(stale) = self.stale().filter(|&stale| stale <= self.at) {
            (self.at, self.slices) = (stale, 0);
        }
        self.working = self.latest.clone();
    }

    fn forget_steps(&mut self) {
        (self.at, self.slices) = (PACKING, 0);
    }

    fn side(&self) -> usize {
        1
    }

    fn at(&self) -> Option<usize> {
        Some(self.at).filter(|&at| at < 8)
    }

    fn failure(&self) -> Option<&Notice> {
        None
    }

    fn advance(&mut self) {
        let Pace { now, slice } = &*self.pace;
        now.set(now.get() + slice[self.at].get());
        self.slices += 1;
        if self.slices == 3 {
            self.runs[self.at] += 1;
            (self.at, self.slices) = (self.at + 1, 0);
        }
    }

    fn is_step(&self) -> bool {
        self.at == PACKING
    }

    fn is_forming(&self) -> bool {
        self.at < PLANES
    }

    fn runs(&self) -> Vec<u64> {
        self.runs.to_vec()
    }

    fn progress(&self) -> Progress {
        Progress::default()
    }

    fn view(&mut self, _: &str) -> &[u8] {
        &[]
    }

    fn prepare(&mut self, _: &str, _: Clock, _: f64) -> bool {
        true
    }

    fn picture(&self) -> &[u8] {
        &[]
    }

    fn digest(&self) -> String {
        self.working.concat()
    }

    fn report(&mut self, _: &mut Report) {}

    fn data(&self) -> Vec<(&'static str, String)> {
        Vec::new()
    }
}

/// The values by which the stages work.
fn words(recipe: &Recipe) -> [String; 8] {
    KEYS.map(|key| recipe.get(key))
}

/// A studio with such an engine, whose slices take 10 ms each.
fn toy() -> (Studio, Rc<Pace>) {
    let pace = Rc::new(Pace::default());
    pace.slice.iter().for_each(|slice| slice.set(10.0));
    let recipe = recipe("");
    let engine = Toy {
        pace: pace.clone(),
        latest: words(&recipe),
        working: words(&recipe),
        at: 0,
        slices: 0,
        runs: [0; 8],
    };
    (Studio::with_engine(ALL, recipe, Box::new(engine)), pace)
}

/// Works for this time, and answers with the time that it took.
fn tick(studio: &mut Studio, pace: &Pace, budget: f64, most_steps: u32) -> f64 {
    let before = pace.now.get();
    studio.tick(&mut || pace.now.get(), budget, most_steps);
    pace.now.get() - before
}

/// Runs of the stages, in their order.
fn runs(studio: &Studio) -> Vec<u64> {
    studio.runs().iter().map(|&(_, runs)| runs).collect()
}

#[test]
fn a_tick_ends_with_the_slice_that_spends_its_budget() {
    let (mut studio, pace) = toy();
    assert_eq!(tick(&mut studio, &pace, 0.0, 1), 10.0);
    assert_eq!(tick(&mut studio, &pace, 25.0, 1), 30.0);
    assert_eq!(studio.stage(), "fields");
    let times = studio.milliseconds();
    assert_eq!([times[0].ms, times[1].ms, times[2].ms], [30.0, 10.0, 0.0]);
    assert_eq!(tick(&mut studio, &pace, f64::INFINITY, 9), 200.0);
    assert!(studio.done() && !studio.digest().is_empty());
    assert_eq!(tick(&mut studio, &pace, f64::INFINITY, 9), 0.0);
    assert_eq!(runs(&studio), [1; 8]);
}

#[test]
fn a_tick_makes_no_more_steps_than_it_may() {
    let (mut studio, pace) = toy();
    assert_eq!(tick(&mut studio, &pace, f64::INFINITY, 2), 80.0);
    assert_eq!(tick(&mut studio, &pace, f64::INFINITY, 0), 0.0);
    assert_eq!(studio.stage(), "packing");
    studio.step(&mut || pace.now.get());
    assert_eq!(studio.stage(), "mesh");
    studio.step(&mut || pace.now.get());
    assert_eq!((studio.stage(), pace.now.get()), ("mesh", 90.0));
    // Other stages go on without steps.
    assert_eq!(tick(&mut studio, &pace, f64::INFINITY, 0), 150.0);
    assert!(studio.done());
}

#[test]
fn stages_before_the_first_stale_one_do_not_run() {
    let (mut studio, _) = toy();
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    let mut wanted = [1; 8];
    let changes = ["az=30", "moss=0.5", "af=4", "cells=packed", "seed=7"];
    for (change, stage) in changes.into_iter().zip([7, 6, 5, 4, 2]) {
        studio.set_recipe(recipe(change));
        assert_eq!(studio.finish(&mut || 0.0), Ok(()));
        // The change before is undone by the same recipe. It was of a later stage.
        wanted[stage..].iter_mut().for_each(|runs| *runs += 1);
        assert_eq!(runs(&studio), wanted, "{change}");
    }
    studio.restart();
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    wanted[2..].iter_mut().for_each(|runs| *runs += 1);
    assert_eq!(runs(&studio), wanted);
}

/// The finisher's work in a pass under 400 ms is not dropped for a newer recipe. Longer work is, and so is work of stages
/// before the finisher.
#[test]
fn only_a_short_pass_of_the_finisher_is_let_finish() {
    for (link, newer, slice, kept) in [
        ("af=4", "af=5", 10.0, true),
        ("af=4", "af=5", 250.0, false),
        ("cells=packed", "cells=lloyd", 10.0, false),
    ] {
        let (mut studio, pace) = toy();
        assert_eq!(studio.finish(&mut || 0.0), Ok(()));
        pace.slice.iter().for_each(|each| each.set(slice));
        studio.set_recipe(recipe(link));
        tick(&mut studio, &pace, 1.5 * slice, 1);
        studio.set_recipe(recipe(newer));
        let stage = studio.stage();
        tick(&mut studio, &pace, 0.0, 1);
        assert_eq!(studio.stage() != stage, kept, "{newer} after {slice} ms");
        assert_eq!(studio.finish(&mut || pace.now.get()), Ok(()));
        assert_eq!(runs(&studio)[PLANES], 2 + u64::from(kept), "{newer}");
        assert_eq!(studio.recipe().link(), format!("v=1&{newer}"));
        assert_eq!(studio.digest(), words(&recipe(newer)).concat());
    }
}

#[test]
fn light_that_takes_one_frame_is_changed_in_one_tick() {
    for (slice, time) in [(10.0, 30.0), (20.0, 20.0)] {
        let (mut studio, pace) = toy();
        pace.slice[SHADING].set(slice);
        assert_eq!(studio.finish(&mut || pace.now.get()), Ok(()));
        studio.set_recipe(recipe("az=30"));
        assert_eq!(tick(&mut studio, &pace, 0.0, 1), time);
        assert_eq!(studio.done(), time == 30.0);
    }
}
