//! Renders every preset of every generator, and a contact sheet for each generator.
//!
//!     cargo run --release --example figures -- --out DIR
//!
//! Writes into DIR a folder for each preset, with the files that `render` writes for its link and its view, and
//! sheet-GENERATOR.png. Prints the times printed in the papers beside those of this machine.

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
    use super::native::sheet::Sheet;
    use bubblestone::export::Report;
    use bubblestone::generators::{ALL, Generator, MeasuredPart, Preset, Viewing};
    use bubblestone::studio::Studio;
    use std::path::Path;

    pub fn run() -> Result<(), String> {
        const USAGE: &str = "Usage: figures --out DIR.";
        let words: Vec<String> = std::env::args().skip(1).collect();
        match &words[..] {
            [option, out] if option == "--out" => {
                ALL.iter().try_for_each(|one| generator(one, out.as_ref()))
            }
            [option, ..] if option != "--out" => {
                Err(format!("There is no option {option}. {USAGE}"))
            }
            _ => Err(format!("Say where the files go. {USAGE}")),
        }
    }

    fn generator(generator: &Generator, out: &Path) -> Result<(), String> {
        let word = generator.schema.word;
        println!("{word:<18}  cells  steps  seconds  of them, for a figure of a paper");
        let mut sheet = Sheet::new(generator.presets.len());
        for preset in generator.presets {
            let mut studio = finished(preset)?;
            let notices = ALL.recipe(preset.link).1;
            let dir = out.join(preset.name);
            native::write_all(&mut studio, notices, None, &dir)?;
            print_row(preset, &studio.report());
            let picture = match Viewing::read(preset.view, generator).0 {
                None => studio.picture().unwrap_or_default().to_vec(),
                Some(viewing) => {
                    native::seen::write_seen(&mut studio, &viewing, &mut native::clock(), &dir)?
                }
            };
            sheet.add(preset.name, studio.side(), &picture);
        }
        let name = format!("sheet-{word}.png");
        native::write_rgb(out, &name, sheet.width, sheet.pixels.into_iter())
    }

    fn finished(preset: &Preset) -> Result<Studio, String> {
        let mut studio = Studio::new(ALL, ALL.recipe(preset.link).0);
        let finished = studio.finish(&mut native::clock());
        finished.map_err(|e| format!("{}: {e}", preset.name))?;
        Ok(studio)
    }

    /// Divides the time into the same parts as the paper, like the page.
    fn print_row(preset: &Preset, report: &Report) {
        let Report { cells, steps, .. } = report;
        let whole = seconds(report, |_| true);
        print!("{:<18}{cells:>7}{steps:>7}{whole:>9.3}", preset.name);
        for MeasuredPart {
            name,
            stages,
            seconds: paper,
        } in preset.timing.iter().flat_map(|timing| timing.parts())
        {
            let ours = seconds(report, |stage| stages.contains(&stage));
            print!("  {name} {ours:.3} ({paper} in the paper)");
        }
        println!("  {}", preset.figure);
    }

    fn seconds(report: &Report, is_of: impl Fn(&str) -> bool) -> f64 {
        let times = report.milliseconds.iter();
        let ms: f64 = times.filter(|t| is_of(t.stage)).map(|t| t.ms).sum();
        ms / 1e3
    }
}
