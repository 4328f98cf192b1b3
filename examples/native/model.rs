//! Gives the recipe of a link its model file.

use bubblestone::generators::{GivenFile, MissingFile};
use bubblestone::notice::Notice;
use bubblestone::recipe::Item;
use bubblestone::studio::Studio;
use std::ffi::OsStr;
use std::path::Path;

/// Splits `ROLE=FILE`. Without a role of the recipe, the whole text is the file's path.
fn role_and_path<'a>(studio: &Studio, text: &'a str) -> (Option<&'a str>, &'a str) {
    let is_role = |word: &str| {
        let row = studio.recipe().schema().row(word);
        row.is_some_and(|row| row.item == Some(Item::File))
    };
    match text.split_once('=') {
        Some((role, path)) if is_role(role) => (Some(role), path),
        _ => (None, text),
    }
}

/// Gives the recipe a file, `ROLE=FILE` or `FILE`. It must have the digest that the link names; if the link
/// names none, it is added to the link.
pub fn open_model(studio: &mut Studio, text: &OsStr) -> Result<Vec<Notice>, String> {
    let (role, path) = match text.to_str().map(|text| role_and_path(studio, text)) {
        Some((role, path)) => (role, Path::new(path)),
        // The name of a file need not be text.
        None => (None, Path::new(text)),
    };
    let shown = path.display();
    let bytes = std::fs::read(path).map_err(|e| format!("Cannot read {shown}: {e}."))?;
    let name = path.file_name().unwrap_or_default();
    let file = GivenFile::whole(&name.to_string_lossy(), bytes);
    let digest = file.named().digest_text();
    let missing = studio.files().map_or(Vec::new(), |files| files.missing());
    let missing = missing.into_iter();
    let wanted = missing.filter(|one| role.is_none_or(|role| one.role == role));
    let wanted: Vec<MissingFile> = wanted.collect();
    let Some(first) = wanted.first() else {
        return Ok(studio.open_file(role, file)?);
    };
    if wanted.iter().all(|one| one.digest != digest) {
        return Err(format!(
            "{shown} is not the file {} that the link asks for: its digest is {digest}, not {}.",
            first.name, first.digest
        ));
    }
    studio.files()?.give(file);
    Ok(Vec::new())
}
