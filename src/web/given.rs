//! Files that recipes name. They are received in pieces, so that no call takes long.

use super::said::all;
use super::{Bubblestone, object};
use crate::generators::{self, GivenFile};
use crate::notice::Code;
use crate::recipe::NamedFile;
use js_sys::Array;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r"
/** A file that a recipe names. */
export interface RecipeFile {
  /** The key of the parameter that names it. */
  role: string;
  /** The digest as 16 hex digits. */
  digest: string;
  name: string;
}

/** Measures of a model from a file. */
export interface ModelFacts {
  /** Width, height and depth, in sizes of its cells. */
  cells: [width: number, height: number, depth: number];
  /** Whether it has open parts, which have two sides. */
  open: boolean;
}
";

#[wasm_bindgen]
impl Bubblestone {
    /// Begins to receive a file of `size` bytes. A file that was being received is dropped.
    #[wasm_bindgen(js_name = beginFile)]
    pub fn begin_file(&mut self, name: &str, size: u32) {
        self.arriving = Some(GivenFile::begin(name, size as usize));
    }

    /// Receives the next bytes.
    #[wasm_bindgen(js_name = addToFile)]
    pub fn add_to_file(&mut self, piece: &[u8]) {
        if let Some(file) = &mut self.arriving {
            file.add(piece);
        }
    }

    /// Gives the received file to a recipe that names it by its digest. Returns that digest; '' if this
    /// generator uses no files.
    #[wasm_bindgen(js_name = giveFile)]
    pub fn give_file(&mut self) -> String {
        let Some(file) = self.arriving.take() else {
            return String::new();
        };
        let digest = file.named().digest_text();
        let given = self.studio.files().map(|files| files.give(file));
        given.map_or(String::new(), |()| digest)
    }

    /// Adds the received file to the recipe in a role; '' is the first role. Returns notices.
    #[wasm_bindgen(js_name = openFile, unchecked_return_type = "Notice[]")]
    pub fn open_file(&mut self, role: &str) -> Array {
        let file = self.arriving.take().ok_or(Code::NoSuchFile.into());
        let role = Some(role).filter(|role| !role.is_empty());
        let said = file.and_then(|file| self.studio.open_file(role, file));
        all(&said.unwrap_or_else(|why| vec![why]))
    }

    /// The files that the work waits for. Digest and name are empty if the recipe names no file yet.
    #[wasm_bindgen(js_name = missingFiles, unchecked_return_type = "RecipeFile[]")]
    pub fn missing_files(&mut self) -> Array {
        let files = self.studio.files();
        let missing = files.map_or(Vec::new(), |files| files.missing());
        let missing = missing.iter();
        missing
            .map(|one| recipe_file(one.role, &one.digest, &one.name))
            .collect()
    }

    /// Measures of the model that a file gives; undefined before it is read and mended.
    #[wasm_bindgen(js_name = modelFacts, unchecked_return_type = "ModelFacts | undefined")]
    pub fn model_facts(&mut self) -> JsValue {
        let files = self.studio.files().ok();
        let facts = files.and_then(|files| files.model());
        facts.map_or(JsValue::UNDEFINED, |facts| {
            let cells: Array = facts.cells.iter().map(|&n| JsValue::from(n)).collect();
            object(&[("cells", cells.into()), ("open", facts.is_open.into())]).into()
        })
    }

    /// The files that the recipe names, where they have an effect.
    #[wasm_bindgen(js_name = recipeFiles, unchecked_return_type = "RecipeFile[]")]
    pub fn recipe_files(&self) -> Array {
        let named = self.studio.recipe().named_files().into_iter();
        named
            .map(|(key, file)| recipe_file(key.0, &file.digest_text(), &file.name))
            .collect()
    }
}

fn recipe_file(role: &str, digest: &str, name: &str) -> JsValue {
    object(&[
        ("role", role.into()),
        ("digest", digest.into()),
        ("name", name.into()),
    ])
    .into()
}

/// The digest of a file, and the parameter's value that names the file.
#[wasm_bindgen]
pub struct FileDigest(generators::FileDigest);

#[wasm_bindgen]
impl FileDigest {
    /// The digest of a file of `size` bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(size: u32) -> FileDigest {
        Self(generators::FileDigest::new(size as usize))
    }

    /// Adds the next bytes.
    pub fn add(&mut self, piece: &[u8]) {
        self.0.add(piece);
    }

    /// The digest as 16 hex digits.
    pub fn text(&self) -> String {
        format!("{:016x}", self.0.number())
    }

    /// The parameter's value that names this file, with this name.
    pub fn value(&self, name: &str) -> String {
        NamedFile::new(self.0.number(), name).text()
    }
}
