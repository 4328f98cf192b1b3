//! `cargo run --release --example slices [-- [--model [ROLE=]FILE] [--runs N] [--stages] LINK...]`
//!
//! Prints the longest slice of each stage, for all presets or for these links, as the best of N runs (3 by default).
//! Then those of the turntable: the bodies and the first frame, for a moving, a still and a fine frame, at the size of
//! a phone's or a desktop's screen. Each link gets the model file, if there is one; a refusal is printed. With
//! `--stages`, the turntable is left out.

#[path = "native/model.rs"]
mod model;

use bubblestone::generators::{ALL, TurnOrder};
use bubblestone::studio::Studio;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::time::Instant;

/// Frames of the turntable: name, quality, and side in pixels.
const FRAMES: [(&str, &str, usize); 3] = [
    ("turn moving", "moving", 800),
    ("turn still", "still", 1600),
    ("turn fine", "fine", 1600),
];

/// The shortest time of each slice, by its stage and its number in the stage.
type Best = BTreeMap<(&'static str, u32), f64>;

/// The words of the command line.
struct Options {
    links: Vec<String>,
    file: Option<OsString>,
    runs: u32,
    has_frames: bool,
}

fn read(mut words: impl Iterator<Item = OsString>) -> Result<Options, String> {
    let mut options = Options {
        links: Vec::new(),
        file: None,
        runs: 3,
        has_frames: true,
    };
    while let Some(word) = words.next() {
        let word = word
            .into_string()
            .map_err(|word| format!("{} is not text.", word.display()))?;
        let mut value = || words.next().ok_or_else(|| format!("{word} needs a value."));
        match word.as_str() {
            "--model" => options.file = Some(value()?),
            "--runs" => {
                let runs = value()?.to_str().and_then(|runs| runs.parse().ok());
                options.runs = runs.ok_or("--runs needs a whole number.")?;
            }
            "--stages" => options.has_frames = false,
            _ => options.links.push(word),
        }
    }
    Ok(options)
}

fn main() -> Result<(), String> {
    let Options {
        mut links,
        file,
        runs,
        has_frames,
    } = read(std::env::args_os().skip(1))?;
    if links.is_empty() {
        links = ALL
            .iter()
            .flat_map(|one| one.presets)
            .map(|p| p.link.to_owned())
            .collect();
    }
    for link in links {
        let (mut best, mut stages): (_, &[&str]) = (Best::new(), &[]);
        for _ in 0..runs {
            let (recipe, _) = ALL.recipe(&link);
            let mut studio = Studio::new(ALL, recipe);
            if let Some(file) = &file {
                model::open_model(&mut studio, file)?;
            }
            stages = studio.generator().stages;
            let mut count = BTreeMap::new();
            let mut timed = |stage: &'static str, slice: &mut dyn FnMut() -> bool| {
                let (goes_on, ms) = timed(slice);
                let k = count.entry(stage).or_insert(0);
                let entry = best.entry((stage, *k)).or_insert(f64::INFINITY);
                *entry = entry.min(ms);
                *k += 1;
                goes_on
            };
            while !studio.done() && studio.problem().is_none() {
                timed(studio.stage(), &mut || {
                    studio.tick(&mut || 0.0, 0.0, u32::MAX);
                    true
                });
            }
            if let Some(why) = studio.problem() {
                eprintln!("{why}");
                break;
            }
            for (stage, how, side) in FRAMES.into_iter().filter(|_| has_frames) {
                let order = TurnOrder {
                    subject: String::new(),
                    camera: studio.generator().camera(),
                    size: [side; 2],
                    how: how.to_owned(),
                };
                let mut turn = || {
                    let frames = studio.frames();
                    let slice = frames.and_then(|frames| frames.turn(&order, &mut || 0.0, 0.0));
                    slice.is_ok_and(|slice| !slice.done)
                };
                while timed(stage, &mut turn) {}
            }
        }
        println!("{link}");
        tell(stages, &best);
    }
    Ok(())
}

/// The result of a slice, and its milliseconds.
#[allow(clippy::disallowed_methods)] // The library has no clock of its own; this measures it.
fn timed(slice: &mut dyn FnMut() -> bool) -> (bool, f64) {
    let before = Instant::now();
    let goes_on = slice();
    (goes_on, before.elapsed().as_secs_f64() * 1e3)
}

fn tell(stages: &[&str], best: &Best) {
    let mut worst: BTreeMap<&str, (f64, u32, f64, u32)> = BTreeMap::new();
    for (&(stage, k), &ms) in best {
        let w = worst.entry(stage).or_insert((0.0, 0, 0.0, 0));
        if ms > w.0 {
            (w.0, w.1) = (ms, k);
        }
        w.2 += ms;
        w.3 += 1;
    }
    let frames = FRAMES.map(|(stage, ..)| stage);
    for stage in stages.iter().chain(&frames) {
        if let Some((ms, k, total, n)) = worst.get(stage) {
            print!("  {stage} {ms:.1} (#{k}/{n}, {total:.0})");
        }
    }
    println!();
}
