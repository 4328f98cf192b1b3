//! The pipeline as a whole: slices, stale stages, the latest recipe, and views at any time.

use crate::common::{finished, finished_recipe, recipe};
use crate::paving::OfPavement;
use bubblestone::domain::Outline;
use bubblestone::field::CellKind;
use bubblestone::generators::ALL;
use bubblestone::generators::pavement::Pavement;
use bubblestone::generators::pavement::{Base, Overlay};
use bubblestone::random::{Purpose, Random};
use bubblestone::recipe::Recipe;
use bubblestone::studio::Studio;
use glam::DVec2;
use std::cell::Cell;

/// A small recipe that uses every stage.
const LINK: &str = "size=160&outline=annulus&cs=14&vs=0.1&gx=0.3";

fn with(recipe: &Recipe, key: &str, text: &str) -> Recipe {
    let mut changed = recipe.clone();
    assert_eq!(changed.set(key, text), Ok(vec![]), "{key}={text}");
    changed
}

/// A clock that advances by one at each reading.
fn counting_clock() -> impl FnMut() -> f64 {
    let mut time = 0.0;
    move || {
        time += 1.0;
        time
    }
}

fn run_on(studio: &mut Studio) {
    assert_eq!(studio.finish(&mut counting_clock()), Ok(()));
}

#[test]
fn slices_do_not_matter() {
    let whole = finished(LINK);
    let mut clock = counting_clock();
    for (budget, most_steps) in [(0.0, 1), (2.0, 1), (7.0, 3), (50.0, 1000)] {
        let mut studio = Studio::new(ALL, recipe(LINK));
        let mut ticks = 0;
        while !studio.done() {
            assert!(studio.tick(&mut clock, budget, most_steps));
            ticks += 1;
            // Views and metrics do not change the result either.
            if ticks % 5 == 0 {
                studio.engine_mut().view("auto");
                assert!(studio.engine_mut().energy().is_finite());
            }
        }
        assert!(ticks > 3);
        assert!(!studio.tick(&mut clock, budget, most_steps));
        assert_eq!(studio.digest(), whole.digest(), "budget {budget}");
        assert_eq!(studio.picture(), whole.picture(), "budget {budget}");
    }
}

#[test]
fn steps_are_made_one_by_one() {
    let mut studio = Studio::new(ALL, recipe(LINK));
    let mut clock = counting_clock();
    for wanted in 1..=3 {
        studio.step(&mut clock);
        assert_eq!(
            studio.pavement().packing.map(|p| p.report().step),
            Some(wanted)
        );
    }
    // With no steps allowed, the packing pauses, whatever the time.
    assert!(!studio.tick(&mut clock, f64::INFINITY, 0));
    assert_eq!(studio.stage(), "packing");
    run_on(&mut studio);
    let steps = studio.pavement().packing.map(|p| p.report().step);
    studio.step(&mut clock);
    assert_eq!(studio.pavement().packing.map(|p| p.report().step), steps);
    assert_eq!(studio.digest(), finished(LINK).digest());
}

#[test]
fn only_stale_stages_run_again() {
    let base = recipe(LINK);
    for (key, text, stage) in [
        ("az", "10", "shading"),
        ("gloss", "glossy", "shading"),
        ("moss", "0.5", "weather"),
        ("wet", "0.5", "weather"),
        ("af", "5", "planes"),
        ("palette", "basalt", "planes"),
        ("pattern", "spots", "planes"),
        ("stone", "skin", "planes"),
        ("dr", "0.9", "planes"),
        ("cells", "packed", "cells"),
        ("cells", "lloyd", "cells"),
        ("seed", "77", "packing"),
        ("cs", "20", "fields"),
        ("ow", "0.8", "domain"),
    ] {
        let mut studio = finished_recipe(&base);
        let steps = studio.pavement().packing.map(|p| p.particles());
        let (cells, planes) = (
            studio.pavement().cells.to_vec(),
            studio.pavement().planes.cloned(),
        );
        let before = studio.runs();
        let changed = with(&base, key, text);
        studio.set_recipe(changed.clone());
        assert_eq!(studio.stage(), stage, "{key}");
        assert_eq!(studio.digest(), "", "{key}");
        run_on(&mut studio);
        let kept = |same: bool, from: &str| assert_eq!(same, rank(stage) > rank(from), "{key}");
        kept(
            studio.pavement().packing.map(|p| p.particles()) == steps,
            "packing",
        );
        kept(studio.pavement().cells == cells, "cells");
        kept(studio.pavement().planes == planes.as_ref(), "weather");
        for ((word, runs), (_, old)) in studio.runs().into_iter().zip(before) {
            // The mesh depends on the packing, not on the choice of cells.
            let is_due = rank(word) >= rank(stage) && (word, stage) != ("mesh", "cells");
            assert_eq!(runs - old, u64::from(is_due), "{key}: {word}");
        }
        assert_eq!(studio.digest(), finished_recipe(&changed).digest(), "{key}");
    }
}

fn rank(stage: &str) -> usize {
    let words = [
        "domain", "fields", "packing", "mesh", "cells", "planes", "weather", "shading",
    ];
    words.iter().position(|w| *w == stage).unwrap()
}

#[test]
fn the_same_recipe_makes_no_work() {
    let mut studio = finished(LINK);
    studio.set_recipe(recipe(LINK));
    assert!(studio.done());
}

/// Whatever changes and whenever, the result is that of the last recipe.
#[test]
fn the_latest_recipe_wins() {
    let mut random = Random::new(3, Purpose::Placement, 0);
    let mut clock = counting_clock();
    let changes = [
        ("az", ["30", "200"]),
        ("af", ["0", "4"]),
        ("moss", ["0.3", "0"]),
        ("vary", ["0.5", "1.5"]),
        ("hs", ["9", "22"]),
        ("cells", ["lloyd", "fitted"]),
        ("cs", ["13", "17"]),
        ("size", ["160", "128"]),
        ("outline", ["star", "l_shape"]),
    ];
    for _ in 0..12 {
        let mut wanted = recipe(LINK);
        let mut studio = Studio::new(ALL, wanted.clone());
        for _ in 0..6 {
            for _ in 0..random.below(400) {
                studio.tick(&mut clock, 0.0, 1);
            }
            let (key, texts) = changes[random.below(changes.len())];
            wanted = with(&wanted, key, texts[random.below(2)]);
            studio.set_recipe(wanted.clone());
            let length = 4 * studio.side() * studio.side();
            assert_eq!(studio.engine_mut().view("auto").len(), length);
        }
        run_on(&mut studio);
        assert_eq!(
            studio.digest(),
            finished_recipe(&wanted).digest(),
            "{}",
            wanted.link()
        );
        assert_eq!(studio.picture(), finished_recipe(&wanted).picture());
        assert_eq!(studio.recipe(), &wanted);
    }
}

/// While a weather slider is dragged, the weather finishes now and then, even after slow stones.
#[test]
fn weather_is_let_finish_after_slow_stones() {
    let pace = Cell::new(100.0);
    let mut time = 0.0;
    let mut clock = || {
        time += pace.get();
        time
    };
    let mut wanted = recipe(LINK);
    let mut studio = Studio::new(ALL, wanted.clone());
    assert_eq!(studio.finish(&mut clock), Ok(()));
    pace.set(1.0);
    for by in 0..200 {
        let wet = (0.1 + 0.002 * f64::from(by)).to_string();
        wanted = with(&wanted, "wet", &wet);
        studio.set_recipe(wanted.clone());
        studio.tick(&mut clock, 0.0, 1);
    }
    let runs = studio.runs()[rank("weather")].1;
    assert!(runs > 3, "{runs}");
    run_on(&mut studio);
    assert_eq!(studio.digest(), finished_recipe(&wanted).digest());
}

/// Going back to a recipe whose results still exist needs no work and keeps their times.
#[test]
fn times_stay_with_what_they_made() {
    let milliseconds = |studio: &Studio| {
        let times = studio.milliseconds().into_iter();
        times.map(|time| time.ms).collect::<Vec<f64>>()
    };
    let mut studio = Studio::new(ALL, recipe(LINK));
    run_on(&mut studio);
    let made = milliseconds(&studio);
    assert!(made.iter().all(|&ms| ms > 0.0), "{made:?}");
    let mut clock = counting_clock();
    studio.set_recipe(with(&recipe(LINK), "cs", "16"));
    studio.tick(&mut clock, 0.0, 1);
    studio.set_recipe(recipe(LINK));
    assert!(studio.done());
    let domain_and_fields = 2;
    let back = milliseconds(&studio);
    assert_eq!(back[domain_and_fields..], made[domain_and_fields..]);
    // Work that continues keeps its time; work that starts again does not.
    studio.set_recipe(with(&recipe(LINK), "hs", "9"));
    while studio.stage() != "planes" || milliseconds(&studio)[rank("planes")] < 5.0 {
        studio.tick(&mut clock, 0.0, 1);
    }
    let last = with(&with(&recipe(LINK), "hs", "9"), "moss", "0.5");
    studio.set_recipe(last.clone());
    assert!(milliseconds(&studio)[rank("planes")] >= 5.0);
    run_on(&mut studio);
    let mut plain = Studio::new(ALL, last);
    run_on(&mut plain);
    let weather = rank("weather");
    assert_eq!(
        milliseconds(&studio)[weather..],
        milliseconds(&plain)[weather..]
    );
}

#[test]
fn every_view_is_whole_at_every_moment() {
    let mut studio = Studio::new(ALL, recipe(LINK));
    let mut clock = counting_clock();
    let mut last = String::new();
    loop {
        if studio.stage() != last {
            last = studio.stage().to_string();
            let overlays = Overlay::ALL.map(|(_, word)| word);
            let all = format!("auto+{}", overlays.join("+"));
            let bases = Base::ALL.iter().map(|(_, word)| *word);
            for word in bases.chain(overlays).chain([&all[..]]) {
                let frame = studio.engine_mut().view(word);
                assert_eq!(frame.len(), 4 * 160 * 160, "{word} at {last}");
                assert!(frame.chunks(4).all(|p| p[3] == 255), "{word} at {last}");
            }
        }
        if !studio.tick(&mut clock, 0.0, 1) {
            break;
        }
    }
    assert_eq!(last, "done");
    let picture = studio.picture().unwrap().to_vec();
    assert_eq!(studio.engine_mut().view("auto"), picture);
}

#[test]
fn the_old_picture_stays_until_the_new_one_is_there() {
    let mut clock = counting_clock();
    for (key, text) in [("az", "20"), ("af", "6"), ("cells", "packed")] {
        let mut studio = finished(LINK);
        let old = studio.picture().unwrap().to_vec();
        studio.set_recipe(with(&recipe(LINK), key, text));
        while !studio.done() {
            assert!(studio.engine_mut().view("auto") == old, "{key}");
            studio.tick(&mut clock, 0.0, 1);
        }
        assert!(studio.engine_mut().view("auto") != old, "{key}");
    }
}

#[test]
fn an_exact_outline_is_used_as_it_is() {
    let p = |x: f64, y: f64| DVec2::new(x, y);
    let outline = Outline {
        rings: vec![vec![
            p(10.1, 10.2),
            p(140.3, 12.4),
            p(120.5, 149.6),
            p(15.7, 130.8),
        ]],
        ..Outline::default()
    };
    let recipe = recipe("size=160&cs=14");
    let made = Pavement::with_outline(&recipe, &outline);
    let (engine, notices) = made.map_err(|e| panic!("{e}")).unwrap();
    assert!(notices.is_empty());
    let mut studio = Studio::with_engine(ALL, recipe, Box::new(engine));
    run_on(&mut studio);
    let drawn = studio.engine_mut().outlines().unwrap();
    assert_eq!(drawn.rings(), [&outline.rings[0][..]]);
}

#[test]
fn bad_outlines_get_a_sentence() {
    let p = |x: f64, y: f64| DVec2::new(x, y);
    let bow_tie = vec![p(10., 10.), p(100., 100.), p(100., 10.), p(10., 100.)];
    let nan = vec![p(10., 10.), p(f64::NAN, 10.), p(100., 100.)];
    for outer in [bow_tie, nan, vec![], vec![p(1., 1.), p(2., 2.)]] {
        let outline = Outline {
            rings: vec![outer],
            ..Outline::default()
        };
        let refused = Pavement::with_outline(&recipe(""), &outline);
        let sentence = refused.err().unwrap().to_string();
        assert!(sentence.ends_with('.') && sentence.len() > 20, "{sentence}");
    }
}

#[test]
fn coarse_cells_in_small_outlines_do_no_harm() {
    let p = |x: f64, y: f64| DVec2::new(x, y);
    for reach in [12.0, 40.0, 150.0] {
        let outline = Outline {
            rings: vec![vec![p(4., 4.), p(4. + reach, 5.), p(5., 4. + reach)]],
            ..Outline::default()
        };
        for link in ["size=160&cs=80", "size=160&cs=80&edge=on", "size=160&cs=2"] {
            let recipe = recipe(link);
            let Ok((engine, _)) = Pavement::with_outline(&recipe, &outline) else {
                continue;
            };
            let mut studio = Studio::with_engine(ALL, recipe, Box::new(engine));
            match studio.finish(&mut || 0.0) {
                Ok(()) => assert!(!studio.pavement().cells.is_empty()),
                Err(why) => {
                    assert!(why.to_string().ends_with('.'), "{why}");
                    assert_eq!((studio.stage(), studio.problem()), ("error", Some(&why)));
                    studio.engine_mut().view("auto");
                    studio.set_recipe(self::recipe("size=160&cs=4"));
                    assert_ne!(studio.stage(), "error");
                }
            }
        }
    }
}

/// A paused studio works up to the first cells of a new packing, and no further.
#[test]
fn a_held_packing_begins_anew_with_its_first_cells() {
    let mut studio = Studio::new(ALL, recipe(LINK));
    let mut clock = counting_clock();
    (0..3).for_each(|_| studio.step(&mut clock));
    let before = studio.pavement().packing.map(|p| p.particles());
    studio.set_recipe(with(&recipe(LINK), "kind", "circle"));
    while studio.tick(&mut clock, 0.0, 0) {}
    assert_eq!((studio.stage(), studio.progress().steps), ("packing", 0));
    let now = studio.pavement().packing.map(|p| p.particles()).unwrap();
    assert!(now.iter().all(|p| p.kind == CellKind::Circle));
    assert_ne!(Some(now), before);
}
