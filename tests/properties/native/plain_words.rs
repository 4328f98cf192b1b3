//! Comments and the texts of parameters are plain English: a reader from outside understands a sentence the
//! first time.
//!
//! Grammar cannot be checked, but some habits that made comments hard to read can: sentences that begin with
//! the words in [`FIRST_WORDS`], and the phrases in [`PHRASES`], which hide who does something.

use bubblestone::generators::ALL;
use std::fs;
use std::path::{Path, PathBuf};

/// The folders and files whose comments are read.
const READ: [&str; 9] = [
    "src",
    "examples",
    "benches",
    "build.rs",
    "tests",
    "www",
    "scripts",
    "package",
    "vite.config.mjs",
];

/// Words that may not begin a sentence.
const FIRST_WORDS: [&str; 2] = ["of", "what"];

/// Phrases that may not occur in comments, in lower case.
const PHRASES: [&str; 12] = [
    "so many",
    "is told",
    "are told",
    "is said",
    "are said",
    "is heard",
    "that of which",
    "of what",
    "of all that",
    "by what",
    "than which",
    "or none",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All source files at or below a path.
fn sources(path: &Path) -> Vec<PathBuf> {
    if path.is_dir() {
        let entries = fs::read_dir(path).unwrap();
        return entries
            .flat_map(|entry| sources(&entry.unwrap().path()))
            .collect();
    }
    let ending = path.extension().and_then(|ending| ending.to_str());
    let read = matches!(ending, Some("rs" | "ts" | "mjs"));
    read.then(|| path.to_owned()).into_iter().collect()
}

/// The comment in a line, without its marks, if there is one. `block` is whether a block comment is open,
/// before and after the line.
fn comment<'a>(line: &'a str, block: &mut bool) -> Option<&'a str> {
    let trimmed = line.trim();
    if *block || trimmed.starts_with("/*") {
        *block = !trimmed.contains("*/");
        let end = trimmed.find("*/").unwrap_or(trimmed.len());
        return Some(trimmed[..end].trim_start_matches(['/', '*']).trim());
    }
    let text = match trimmed.strip_prefix("//") {
        Some(text) => text.trim_start_matches(['/', '!']),
        None => line.split_once(" // ")?.1,
    };
    Some(text.trim())
}

/// The paragraphs of all comments in a file. Examples between fences are code and left out.
fn paragraphs(source: &str) -> Vec<String> {
    let mut paragraphs = vec![String::new()];
    let (mut block, mut fenced) = (false, false);
    for line in source.lines() {
        let text = comment(line, &mut block).unwrap_or("");
        fenced ^= text.starts_with("```");
        let separate = text.is_empty() || text.starts_with(['-', '*', '|', '`', '#']);
        let continued = line.trim().starts_with(['/', '*']) && !line.trim().starts_with("/*");
        if separate || !continued {
            paragraphs.push(String::new());
        }
        if !fenced {
            let paragraph = paragraphs.last_mut().unwrap();
            paragraph.push_str(text);
            paragraph.push(' ');
        }
    }
    paragraphs
}

/// The sentences of a paragraph, in lower case and with single spaces.
fn sentences(paragraph: &str) -> Vec<String> {
    let words: Vec<String> = paragraph
        .split_whitespace()
        .map(str::to_lowercase)
        .collect();
    let ends = |word: &String| word.ends_with(['.', '!', '?']);
    words
        .split_inclusive(ends)
        .map(|words| {
            words
                .join(" ")
                .trim_start_matches(['-', '*', ' '])
                .to_owned()
        })
        .collect()
}

/// Whether a sentence is hard to read by one of the rules.
fn is_riddle(sentence: &str) -> bool {
    let first = sentence.split(|c: char| !c.is_alphabetic()).next();
    let padded = format!(
        " {} ",
        sentence.replace([',', '.', ':', ';', '(', ')'], " ")
    );
    first.is_some_and(|word| FIRST_WORDS.contains(&word))
        || PHRASES
            .iter()
            .any(|phrase| padded.contains(&format!(" {phrase} ")))
}

/// The sentences of a source file that break a rule.
fn riddles(source: &str) -> Vec<String> {
    paragraphs(source)
        .iter()
        .flat_map(|paragraph| sentences(paragraph))
        .filter(|sentence| is_riddle(sentence))
        .collect()
}

#[test]
fn comments_are_plain() {
    let mut faults = Vec::new();
    let files: Vec<PathBuf> = READ
        .iter()
        .flat_map(|top| sources(&root().join(top)))
        .collect();
    assert!(files.len() > 500, "{} files", files.len());
    for file in &files {
        let name = file.strip_prefix(root()).unwrap().to_str().unwrap();
        let riddles = riddles(&fs::read_to_string(file).unwrap());
        if !riddles.is_empty() {
            faults.push(format!("{name} has comments to rewrite: {riddles:#?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The page shows the name, the help and the choices of each parameter.
#[test]
fn texts_of_parameters_are_plain() {
    let rows = ALL.iter().flat_map(|generator| generator.schema.rows);
    let texts = rows.flat_map(|row| {
        let labels = row.choices.iter().map(|choice| choice.label);
        labels.chain([row.name, row.help])
    });
    let faults: Vec<String> = texts
        .flat_map(sentences)
        .filter(|sentence| is_riddle(sentence))
        .collect();
    assert!(faults.is_empty(), "texts to rewrite: {faults:#?}");
}

#[test]
fn riddles_are_found() {
    let source = "/// The area. Of one, its name.\n///\n/// What it has.\nlet a = 1; // so\nlet b = 2; // many\n\
        /* A block\n * of\u{20}what is so, many\n */\n// There are so\n// many of them.\n//! ```\n//! // What?\n//! ```\n";
    let found = riddles(source);
    let expected = [
        "of one, its name.",
        "what it has.",
        "a block of what is so, many",
        "there are so many of them.",
    ];
    assert_eq!(found, expected);
    assert!(riddles("// Often. Whatever. Not only what is seen.\nlet of = what;").is_empty());
}
