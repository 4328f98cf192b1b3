//! Notices on GLB files.

use crate::notice::{Code, Notice};

/// The notice that a part of the file is invalid. `number` is the index of the part; `None` if the file gives no valid
/// index.
pub(super) fn broken(what: &str, number: impl Into<Option<usize>>) -> Notice {
    let what = match number.into() {
        Some(number) => format!("{what} {number}"),
        None => what.to_owned(),
    };
    Notice::new(Code::FileBroken)
        .with("kind", "GLB".to_owned())
        .with("what", what)
}

/// The notice that a file needs a feature that cannot be read. It quotes the name, so that a visitor can search for it.
pub(super) fn needs(code: Code, name: &str) -> Notice {
    Notice::new(code)
        .with("kind", "GLB".to_owned())
        .with("name", crate::notice::quote_long(name))
}
