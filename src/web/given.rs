//! Files that recipes ask for. They arrive in pieces, so that no call takes long.

use super::Bubblestone;
use super::said::all;
use crate::generators::surface::{SCHEMA, keys};
use crate::generators::{self, GivenFile};
use crate::notice::Code;
use crate::recipe::{NamedFile, Recipe};
use js_sys::Array;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Bubblestone {
    /// A file of so many bytes begins to arrive; one that was on its way before is let go of.
    #[wasm_bindgen(js_name = beginFile)]
    pub fn begin_file(&mut self, name: &str, size: u32) {
        self.arriving = Some(GivenFile::begin(name, size as usize));
    }

    /// Its next bytes.
    #[wasm_bindgen(js_name = addToFile)]
    pub fn add_to_file(&mut self, piece: &[u8]) {
        if let Some(file) = &mut self.arriving {
            file.add(piece);
        }
    }

    /// All of it is here: a recipe that asks for it by its digest finds it. Answers with that digest, '' where this
    /// generator has no use for files.
    #[wasm_bindgen(js_name = giveFile)]
    pub fn give_file(&mut self) -> String {
        let file = self.arriving.take();
        let row = file.and_then(|file| self.studio.engine_mut().give(file));
        row.map_or(String::new(), |row| digest_text(&row))
    }

    /// All of it is here: it becomes the recipe's. Answers with what is to be said.
    #[wasm_bindgen(js_name = openFile, unchecked_return_type = "Notice[]")]
    pub fn open_file(&mut self) -> Array {
        let file = self.arriving.take().ok_or(Code::NoSuchFile.into());
        let said = file.and_then(|file| self.studio.open_file(file));
        all(&said.unwrap_or_else(|why| vec![why]))
    }

    /// The digest and the name of the file that the work waits for, both empty where the recipe names none yet; nothing
    /// where it waits for none.
    #[wasm_bindgen(js_name = missingFile)]
    pub fn missing_file(&self) -> Option<Vec<String>> {
        let (digest, name) = self.studio.engine().missing()?;
        Some(vec![digest, name])
    }
}

/// The digest of a file, and the value of the parameter `model` that asks for it.
#[wasm_bindgen]
pub struct FileDigest(generators::FileDigest);

#[wasm_bindgen]
impl FileDigest {
    /// Of a file of so many bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(size: u32) -> FileDigest {
        Self(generators::FileDigest::new(size as usize))
    }

    /// Its next bytes.
    pub fn add(&mut self, piece: &[u8]) {
        self.0.add(piece);
    }

    /// 16 hex digits.
    pub fn text(&self) -> String {
        format!("{:016x}", self.0.number())
    }

    /// What the parameter `model` of a link is to be for a file of this name.
    pub fn model(&self, name: &str) -> String {
        let mut recipe = Recipe::new(&SCHEMA);
        let row = NamedFile::new(self.0.number(), name).row();
        let set = recipe.set_rows(keys::MODEL, vec![row]);
        set.map_or(String::new(), |()| recipe.get(keys::MODEL.0))
    }
}

/// The digest at the beginning of a row that names a file.
fn digest_text(row: &[i64]) -> String {
    row.iter().take(4).map(|n| format!("{n:04x}")).collect()
}
