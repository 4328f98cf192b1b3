//! The file of a model, for a link.

use bubblestone::generators::GivenFile;
use bubblestone::notice::Notice;
use bubblestone::studio::Studio;
use std::path::Path;

/// Gives the file that the link asks for, which must have the digest that it names; where it names none, the file
/// becomes the link's.
pub fn open_model(studio: &mut Studio, path: &str) -> Result<Vec<Notice>, String> {
    let bytes = std::fs::read(path).map_err(|e| format!("Cannot read {path}: {e}."))?;
    let name = Path::new(path).file_name().unwrap_or_default();
    let file = GivenFile::whole(&name.to_string_lossy(), bytes);
    let Some((asked, wanted)) = studio.engine().missing() else {
        return Ok(studio.open_file(file)?);
    };
    let digest = file.named().digest_text();
    if digest != asked {
        return Err(format!(
            "{path} is not the file {wanted} that the link asks for: its digest is {digest}, not {asked}."
        ));
    }
    studio.engine_mut().give(file);
    Ok(Vec::new())
}
