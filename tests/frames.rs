//! Frames of bodies: the still of a link and a camera is the same, bit for bit, on every machine, whatever its
//! slices are and whatever was made before it. Each line of `frames.txt` has a hash, a camera (as in links of
//! the page; `-` for the usual one) and a link. `node/shipped.test.mjs` and the browser tests compare with it,
//! too.
//!
//! After an intended change of frames: `BUBBLESTONE_UPDATE=1 cargo test --test frames`.

// The tests under Node compare the frames in WebAssembly.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use bubblestone::generators::{ALL, TurnOrder};
use bubblestone::studio::Studio;
use common::finished;

const GOLDEN: &str = include_str!("frames.txt");

/// The order for a still of all bodies, as large as the picture.
fn still(studio: &Studio, camera: &str) -> TurnOrder {
    let (camera, notices) = studio.generator().camera().read(camera);
    assert!(notices.is_empty(), "{notices:?}");
    TurnOrder {
        subject: String::new(),
        camera,
        size: [studio.side(); 2],
        how: "still".into(),
    }
}

/// The hash of a frame made in the shortest slices.
fn in_slices(studio: &mut Studio, order: &TurnOrder) -> String {
    let mut now = 0.0;
    let mut clock = || {
        now += 1.0;
        now
    };
    let mut slices = 0;
    loop {
        let slice = studio.frames().unwrap().turn(order, &mut clock, 0.5);
        let slice = slice.expect("a slice");
        slices += 1;
        if slice.done {
            assert!(slices > 5, "{slices} slices");
            return studio.frames().unwrap().frame().expect("a frame").hash();
        }
    }
}

fn at_once(studio: &mut Studio, order: &TurnOrder) -> String {
    let frame = studio.finish_frame(order, &mut || 0.0);
    frame.expect("a frame").hash()
}

#[test]
fn frames_are_the_same_everywhere() {
    let made = |line: &str| {
        let mut parts = line.splitn(3, ' ');
        let mut next = || parts.next().expect("three parts");
        let (_, camera, link) = (next(), next(), next());
        let mut studio = finished(link);
        let from = if camera == "-" { "" } else { camera };
        let order = still(&studio, from);
        format!("{} {camera} {link}\n", at_once(&mut studio, &order))
    };
    let found: String = GOLDEN.lines().map(made).collect();
    if std::env::var_os("BUBBLESTONE_UPDATE").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/frames.txt");
        std::fs::write(path, found).unwrap();
        return;
    }
    assert_eq!(found, GOLDEN);
}

/// Light, scene and surfaces that are kept between frames do not change a frame.
#[test]
fn what_was_made_before_changes_no_frame() {
    let mut studio = finished("size=128&cs=16&stone=skin&light=point");
    let order = still(&studio, "20,30,2");
    let first = in_slices(&mut studio, &order);
    assert_eq!(at_once(&mut studio, &order), first);
    for (how, camera, size) in [
        ("moving", "90,40,2", [64, 48]),
        ("fine+sky", "20,30,2", [200, 20]),
        ("still", "20,30,1.9", [128, 128]),
    ] {
        let mut other = still(&studio, camera);
        (other.how, other.size) = (how.into(), size);
        assert_ne!(at_once(&mut studio, &other), first);
    }
    assert_eq!(at_once(&mut studio, &order), first);
    // The light moves and returns; while it moves, its shadows are coarse.
    let recipe = studio.recipe().clone();
    let mut lit = recipe.clone();
    lit.set("lz", "0.9").expect("a number");
    studio.set_recipe(lit);
    let _ = studio.finish(&mut || 0.0);
    let mut moving = order.clone();
    moving.how = "moving".into();
    at_once(&mut studio, &moving);
    assert_ne!(at_once(&mut studio, &order), first);
    studio.set_recipe(recipe);
    let _ = studio.finish(&mut || 0.0);
    assert_eq!(in_slices(&mut studio, &order), first);
    // The bodies of a new picture give the same frame.
    assert_eq!(
        at_once(&mut finished(&studio.recipe().link()), &order),
        first
    );
}

/// Each step in the making of a stone is visible, and the steps differ.
#[test]
fn steps_are_frames_of_their_own() {
    for (form, least) in [("cobble", 8), ("flag", 9), ("skin", 10)] {
        let mut studio = finished(&format!("size=128&cs=26&outline=square&stone={form}"));
        let cells = studio.progress().cells as u32;
        let steps = studio.frames().unwrap().making(cells / 2);
        assert!(steps.len() >= least, "{form}: {steps:?}");
        assert_eq!(studio.frames().unwrap().making(0).len(), 0);
        let mut hashes = Vec::new();
        for (step, word) in steps.iter().enumerate() {
            let mut order = still(&studio, "80,30,4.4,35");
            order.subject = format!("{}:{step}", cells / 2);
            hashes.push(at_once(&mut studio, &order));
            let frame = studio.frames().unwrap().frame().expect("a frame");
            let seen = frame.ids().iter().filter(|&&id| id > 0).count();
            assert!(seen > 500, "{form}, {word}: {seen} pixels");
        }
        let mut different = hashes.clone();
        different.sort();
        different.dedup();
        // A step whose parameter is 0 changes nothing.
        assert!(different.len() + 3 >= hashes.len(), "{form}: {hashes:?}");
    }
}

#[test]
fn what_is_no_frame_gets_a_sentence() {
    let mut studio = Studio::new(ALL, common::recipe("size=128&cs=26"));
    let order = still(&studio, "");
    let mut refused = |change: &dyn Fn(&mut TurnOrder)| {
        let mut order = order.clone();
        change(&mut order);
        let slice = studio.frames().unwrap().turn(&order, &mut || 0.0, 1.0);
        let why = slice.expect_err("a sentence").to_string();
        studio.finish(&mut || 0.0).expect("a picture");
        why
    };
    assert!(refused(&|_| {}).contains("finished picture"));
    for size in [[0, 9], [9, 0], [9000, 9], [usize::MAX; 2]] {
        let why = refused(&|order| order.size = size);
        assert!(why.contains("1 to 8192 pixels"), "{why}");
    }
    for subject in [
        "nonsense", "1", "1:", ":1", "0:0", "999999:0", "1:99", "-1:0",
    ] {
        let why = refused(&|order| order.subject = subject.into());
        assert!(
            why.contains("no such body") && why.contains(subject),
            "{why}"
        );
    }
    // Unknown words are ignored and have no later effect.
    let mut order = order;
    let first = at_once(&mut studio, &order);
    order.how = "still+nonsense++".into();
    assert_eq!(at_once(&mut studio, &order), first);
    assert_eq!(studio.frames().unwrap().body_at(5000, 5000), None);
}
