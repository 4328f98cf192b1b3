//! `cargo run --release --example slices [-- LINK...]`: the longest slice of each stage, of all
//! presets or of these links, as the best of three runs.

use bubblestone::generators::ALL;
use bubblestone::generators::pavement::{self, PAVEMENT};
use bubblestone::studio::Studio;
use std::collections::BTreeMap;
use std::time::Instant;

#[allow(clippy::disallowed_methods)] // The library has no clock: this measures it.
fn main() {
    let mut links: Vec<String> = std::env::args().skip(1).collect();
    if links.is_empty() {
        links = PAVEMENT.presets.iter().map(|p| p.link.to_owned()).collect();
    }
    for link in links {
        let mut best: BTreeMap<(&str, u32), f64> = BTreeMap::new();
        for _ in 0..3 {
            let (recipe, _) = pavement::recipe(&link);
            let mut studio = Studio::new(ALL, recipe);
            let begin = Instant::now();
            let mut clock = || begin.elapsed().as_secs_f64() * 1e3;
            let mut count = BTreeMap::new();
            while !studio.done() && studio.problem().is_none() {
                let stage = studio.stage();
                let before = Instant::now();
                studio.tick(&mut clock, 0.0, u32::MAX);
                let ms = before.elapsed().as_secs_f64() * 1e3;
                let k = count.entry(stage).or_insert(0);
                let entry = best.entry((stage, *k)).or_insert(f64::INFINITY);
                *entry = entry.min(ms);
                *k += 1;
            }
        }
        let mut worst: BTreeMap<&str, (f64, u32, f64, u32)> = BTreeMap::new();
        for ((stage, k), ms) in best {
            let w = worst.entry(stage).or_insert((0.0, 0, 0.0, 0));
            if ms > w.0 {
                (w.0, w.1) = (ms, k);
            }
            w.2 += ms;
            w.3 += 1;
        }
        println!("{link}");
        for &stage in PAVEMENT.stages {
            if let Some((ms, k, total, n)) = worst.get(stage) {
                print!("  {stage} {ms:.1} (#{k}/{n}, {total:.0})");
            }
        }
        println!();
    }
}
