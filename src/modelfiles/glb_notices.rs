//! Notices on GLB files.

use crate::notice::{Code, Notice};

/// The notice that something in the file is invalid. Its number is not known if the file names it wrongly.
pub(super) fn broken(what: &str, number: impl Into<Option<usize>>) -> Notice {
    let what = match number.into() {
        Some(number) => format!("{what} {number}"),
        None => what.to_owned(),
    };
    Notice::new(Code::FileBroken)
        .with("kind", "GLB".to_owned())
        .with("what", what)
}

/// The notice that a file needs what cannot be read, whose name a visitor will search for.
pub(super) fn needs(code: Code, name: &str) -> Notice {
    Notice::new(code)
        .with("kind", "GLB".to_owned())
        .with("name", crate::notice::quote_long(name))
}
