//! Renders every preset and a contact sheet of them all.
//!
//!     cargo run --release --example figures -- --out DIR
//!
//! Prints the seconds of the papers' table beside those of this machine.

#[cfg(not(target_arch = "wasm32"))]
mod native;

#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    native::end(figures::run())
}

#[cfg(not(target_arch = "wasm32"))]
mod figures {
    use super::native;
    use bubblestone::export::StageTime;
    use bubblestone::generators::ALL;
    use bubblestone::generators::Preset;
    use bubblestone::generators::pavement::{self, PAVEMENT};

    use bubblestone::studio::Studio;
    use std::path::Path;

    /// Pixels of a picture on the sheet, and of the gap around it.
    const SMALL: usize = 256;
    const GAP: usize = 8;
    const COLUMNS: usize = 4;
    /// How the work is divided where no paper does.
    const PARTS: [&[&str]; 2] = [PAVEMENT.stages.split_at(3).0, PAVEMENT.stages.split_at(3).1];
    const PAPER: [u8; 3] = [38, 34, 30];

    pub fn run() -> Result<(), String> {
        let words: Vec<String> = std::env::args().skip(1).collect();
        let [option, out] = &words[..] else {
            return Err("Usage: figures --out DIR.".into());
        };
        if option != "--out" {
            return Err(format!(
                "There is no option {option}. Usage: figures --out DIR."
            ));
        }
        let out = Path::new(out);
        println!(
            "{:<12}{:>7}{:>7}{:>16}{:>9}{:>16}{:>9}  figure",
            "preset", "cells", "steps", "cells: paper", "ours s", "texture: paper", "ours s"
        );
        let mut sheet = Sheet::new(PAVEMENT.presets.len());
        for (k, preset) in PAVEMENT.presets.iter().enumerate() {
            let picture = render(preset, &out.join(preset.name))?;
            sheet.put(k, &picture);
        }
        let Sheet { width, pixels } = sheet;
        native::write_rgb(out, "sheet.png", width, pixels.into_iter())
    }

    fn render(preset: &Preset, dir: &Path) -> Result<Vec<u8>, String> {
        let (recipe, notices) = pavement::recipe(preset.link);
        let mut studio = Studio::new(ALL, recipe);
        let mut clock = native::clock();
        let finished = studio.finish(&mut clock);
        finished.map_err(|e| format!("{}: {e}", preset.name))?;
        print_row(preset, &mut studio);
        native::write_all(&mut studio, notices, dir)?;
        Ok(studio.picture().unwrap_or_default().to_vec())
    }

    /// The work is divided as the paper divides it, as on the page.
    fn print_row(preset: &Preset, studio: &mut Studio) {
        let report = studio.report();
        print!("{:<12}{:>7}{:>7}", preset.name, report.cells, report.steps);
        for (k, &plain) in PARTS.iter().enumerate() {
            let part = preset.timing.map(|timing| timing.parts[k]);
            let stages = part.map_or(plain, |part| part.stages);
            let is_of = |t: &&StageTime| stages.contains(&t.stage);
            let ours: f64 = report.milliseconds.iter().filter(is_of).map(|t| t.ms).sum();
            let paper = part.map_or("-".into(), |part| part.seconds.to_string());
            print!("{paper:>16}{:>9.3}", ours / 1e3);
        }
        println!("  {}", preset.figure);
    }

    /// All pictures side by side.
    struct Sheet {
        width: usize,
        pixels: Vec<[u8; 3]>,
    }

    impl Sheet {
        fn new(count: usize) -> Self {
            let width = COLUMNS * (SMALL + GAP) + GAP;
            let height = count.div_ceil(COLUMNS) * (SMALL + GAP) + GAP;
            Self {
                width,
                pixels: vec![PAPER; width * height],
            }
        }

        /// Puts a square RGBA picture into its place, each pixel the mean of those it stands for.
        fn put(&mut self, place: usize, rgba: &[u8]) {
            let side = ((rgba.len() / 4) as f64).sqrt() as usize;
            let (left, top) = (place % COLUMNS, place / COLUMNS);
            let (left, top) = (left * (SMALL + GAP) + GAP, top * (SMALL + GAP) + GAP);
            let span =
                |k: usize| k * side / SMALL..((k + 1) * side / SMALL).max(k * side / SMALL + 1);
            for y in 0..SMALL {
                for x in 0..SMALL {
                    let mut sum = [0usize; 3];
                    let (rows, columns) = (span(y), span(x));
                    let count = rows.len() * columns.len();
                    for at in rows.flat_map(|v| columns.clone().map(move |u| 4 * (v * side + u))) {
                        (0..3).for_each(|c| sum[c] += usize::from(rgba[at + c]));
                    }
                    let mean = sum.map(|s| (s / count) as u8);
                    self.pixels[(top + y) * self.width + left + x] = mean;
                }
            }
        }
    }
}
