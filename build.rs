//! Writes the codes of notices and their English from the tables of words, and decides whether the full
//! module is built.

use std::fmt::Write;
use std::{env, fs, path::Path};

/// The table of all modules, and that of the full module.
const TABLES: [&str; 2] = ["src/notice/words.txt", "src/notice/house.txt"];

fn main() {
    println!("cargo::rustc-check-cfg=cfg(house)");
    let house = env::var_os("CARGO_FEATURE_HOUSE").is_some();
    if house {
        println!("cargo::rustc-cfg=house");
    }
    let mut table = String::new();
    for path in &TABLES[..1 + usize::from(house)] {
        println!("cargo::rerun-if-changed={path}");
        table += &fs::read_to_string(path).expect("a table of words");
    }
    let (mut codes, mut words, mut english) = (String::new(), String::new(), String::new());
    let mut code = String::new();
    for line in table.lines().filter(|line| !line.starts_with('#')) {
        if let Some(text) = line.strip_prefix("  en ") {
            writeln!(codes, "/// {text}\n{code},").expect("a string");
            writeln!(english, "Code::{code} => {text:?},").expect("a string");
        } else if !line.starts_with(' ') && !line.is_empty() {
            code = camel(line);
            writeln!(words, "Code::{code} => {line:?},").expect("a string");
        }
    }
    // Each code is a 32-bit word: Chromium 156 loses a single byte of a notice that an error carries.
    let made = format!(
        "/// What is said.\n\
         #[derive(Clone, Copy, Debug, PartialEq, Eq)]\n\
         #[repr(u32)]\n\
         pub enum Code {{\n{codes}}}\n\
         impl Code {{\n\
         /// Its name in the table.\n\
         pub fn word(self) -> &'static str {{ match self {{\n{words}}} }}\n\
         fn english(self) -> &'static str {{ match self {{\n{english}}} }}\n\
         }}\n"
    );
    let folder = env::var("OUT_DIR").expect("cargo's folder");
    fs::write(Path::new(&folder).join("notices.rs"), made).expect("a file in cargo's folder");
}

/// `outer_ring` becomes `OuterRing`.
fn camel(word: &str) -> String {
    let parts = word.split('_');
    let upper = |part: &str| part[..1].to_uppercase() + &part[1..];
    parts.map(upper).collect()
}
