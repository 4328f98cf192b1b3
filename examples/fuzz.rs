//! Gives broken model files and links to the program for some time, on one thread.
//!
//!     npm run fuzz -- SECONDS [SEED]
//!     cargo run --release --example fuzz -- --case SEED NUMBER
//!     cargo run --release --example fuzz -- --files LINK FILE...
//!
//! The first form damages eight small models and the links of all presets at random. A file must end with a sentence or
//! with a picture in which every number is finite, and its cells must be about as many as were asked for, or a notice
//! must say why not. A link must be mended, and read back alike. A watchdog ends the program when a file takes longer than
//! a minute. Seed and number of a bad case are printed, and its file is written into target/fuzz; the exit code is then
//! not 0.
//!
//! The second form writes the file of a case. The third one covers files by a link, and prints for each its end, its time
//! and its longest slice.

#[cfg(not(target_arch = "wasm32"))]
#[path = "../tests/common/mod.rs"]
mod common;
#[cfg(not(target_arch = "wasm32"))]
mod native;
#[cfg(not(target_arch = "wasm32"))]
#[path = "../tests/strangers/mod.rs"]
mod strangers;

#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    native::end(fuzz::run())
}

#[cfg(not(target_arch = "wasm32"))]
mod fuzz {
    use super::native;
    use super::strangers::{COVERED, Ended, broken, broken_link, file_ends_well, files, mended};
    use bubblestone::random::{Purpose, Random};
    use std::path::Path;
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::time::Duration;

    /// Links for each file.
    const LINKS: u64 = 50;
    /// Milliseconds: from the first on a file counts as slow, after the second the watchdog ends the program.
    const SLOW: f64 = 10_000.0;
    const LOST: u64 = 60_000;
    /// Milliseconds between two reports.
    const REPORT: f64 = 20_000.0;

    /// The case at work: its number, and the time at which it began, in milliseconds.
    static CASE: AtomicU64 = AtomicU64::new(0);
    static BEGAN: AtomicU64 = AtomicU64::new(0);

    /// The counts of all cases.
    #[derive(Default)]
    struct Tally {
        files: u64,
        refused: u64,
        links: u64,
        slow: u64,
        /// The longest file, with its case, and the longest slice, with its stage.
        longest: (f64, u64),
        slice: (f64, &'static str, u64),
    }

    impl Tally {
        fn add(&mut self, case: u64, end: &Ended, took: f64) {
            self.files += 1;
            self.refused += u64::from(end.cells.is_none());
            if took > SLOW {
                self.slow += 1;
                println!("case {case}: slow, {took:.0} ms, {}", end.text);
            }
            if took > self.longest.0 {
                self.longest = (took, case);
            }
            if end.longest.1 > self.slice.0 {
                self.slice = (end.longest.1, end.longest.0, case);
            }
        }

        fn tell(&self) {
            let Self {
                files,
                refused,
                links,
                slow,
                longest,
                slice,
            } = self;
            println!(
                "{files} files ({refused} refused, {slow} slow), {links} links; longest file {:.0} ms (case {}), \
                 longest slice {:.0} ms ({}, case {}); memory peak {}",
                longest.0,
                longest.1,
                slice.0,
                slice.1,
                slice.2,
                memory()
            );
        }
    }

    /// The greatest amount of memory so far, where the system tells it.
    fn memory() -> String {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        peak.map_or("unknown".to_owned(), |peak| peak.trim().to_owned())
    }

    pub fn run() -> Result<(), String> {
        const USAGE: &str =
            "Usage: fuzz SECONDS [SEED], fuzz --case SEED NUMBER, or fuzz --files LINK FILE...";
        let words: Vec<String> = std::env::args_os()
            .skip(1)
            .map(native::text)
            .collect::<Result<_, _>>()?;
        let number = |word: &String| word.parse::<u64>().map_err(|_| USAGE.to_owned());
        match &words[..] {
            [option, link, paths @ ..] if option == "--files" => measure(link, paths),
            [option, seed, case] if option == "--case" => {
                keep(number(seed)?, number(case)?);
                Ok(())
            }
            [seconds] | [seconds, _] => {
                let seed = words.get(1).map_or(Ok(1), number)?;
                try_all(number(seconds)? as f64 * 1e3, seed);
                Ok(())
            }
            _ => Err(USAGE.to_owned()),
        }
    }

    fn measure(link: &str, paths: &[String]) -> Result<(), String> {
        for path in paths {
            let bytes = std::fs::read(path).map_err(|e| format!("Cannot read {path}: {e}."))?;
            let mut clock = native::clock();
            let name = Path::new(path)
                .file_name()
                .unwrap_or_default()
                .to_string_lossy();
            let end = file_ends_well(link, &name, bytes, &mut clock);
            println!(
                "{name}: {:.0} ms, longest slice {:.0} ms ({}), memory peak {}\n  {}",
                clock(),
                end.longest.1,
                end.longest.0,
                memory(),
                end.text
            );
        }
        Ok(())
    }

    fn try_all(milliseconds: f64, seed: u64) {
        let (mut clock, files, mut tally) = (native::clock(), files(), Tally::default());
        tell_panics(seed);
        std::thread::spawn(move || watch(seed));
        let (mut case, mut told) = (0, 0.0);
        while clock() < milliseconds {
            CASE.store(case, Ordering::Relaxed);
            BEGAN.store(clock() as u64, Ordering::Relaxed);
            let (name, how, bytes) = file_of(seed, case, &files);
            let before = clock();
            let end = file_ends_well(&how, name, bytes, &mut clock);
            let took = clock() - before;
            tally.add(case, &end, took);
            if took > SLOW {
                keep(seed, case);
            }
            let mut random = Random::new(seed, Purpose::Placement, case);
            for _ in 0..LINKS {
                mended(&broken_link(&mut random));
            }
            tally.links += LINKS;
            case += 1;
            if clock() > told + REPORT {
                told = clock();
                tally.tell();
            }
        }
        tally.tell();
    }

    /// The file of a case, and the link that covers it.
    fn file_of(
        seed: u64,
        case: u64,
        files: &[(&'static str, Vec<u8>)],
    ) -> (&'static str, String, Vec<u8>) {
        let mut random = Random::new(seed, Purpose::Attribute, case);
        let (name, bytes) = broken(&mut random, files);
        let how = COVERED[random.below(COVERED.len())];
        (name, format!("cn=40&{how}"), bytes)
    }

    /// Writes the file of a case, and says where.
    fn keep(seed: u64, case: u64) {
        let (name, how, bytes) = file_of(seed, case, &files());
        let path = format!("target/fuzz/{seed}-{case}-{name}");
        let kept =
            std::fs::create_dir_all("target/fuzz").and_then(|()| std::fs::write(&path, bytes));
        match kept {
            Ok(()) => println!("seed {seed}, case {case}, {how}: {path}"),
            Err(why) => println!("seed {seed}, case {case}, {how}: {why}"),
        }
    }

    /// A panic prints its case, too. It may come from one of the links of the case.
    fn tell_panics(seed: u64) {
        let plain = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            plain(panic);
            keep(seed, CASE.load(Ordering::Relaxed));
        }));
    }

    fn watch(seed: u64) {
        let mut clock = native::clock();
        loop {
            std::thread::sleep(Duration::from_millis(500));
            if clock() as u64 > BEGAN.load(Ordering::Relaxed) + LOST {
                println!("A file takes longer than a minute.");
                keep(seed, CASE.load(Ordering::Relaxed));
                std::process::exit(1);
            }
        }
    }
}
