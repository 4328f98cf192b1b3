//! What is taken away: files and what they hold.

use super::said::or_why;
use super::{Bubblestone, objects};
use crate::export::{DETAILS, Map, MapKind, MeshFormat, MeshOrder};
use crate::generators::pavement::Pavement;
use crate::notice::{Code, Notice};
use js_sys::Object;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Bubblestone {
    /// The cells as a standalone SVG file; '' before there are any.
    pub fn svg(&self) -> String {
        self.pavement().map_or(String::new(), Pavement::svg)
    }

    /// A map of the finished picture ('height', 'normal-opengl', 'normal-directx', 'albedo',
    /// 'roughness', 'ao', 'id', 'orm', 'height-float'), or why there is none.
    #[wasm_bindgen(unchecked_return_type = "PixelMap | Notice")]
    pub fn map(&self, word: &str) -> Object {
        let engine = self.studio.engine();
        map_of(word, |kind| engine.map(kind))
    }

    /// Works for about `budget` milliseconds on a mesh file: 'glb' or 'obj', with 'low', 'middle' or 'high'
    /// detail. The lengths of three images, or none, are those that the caller puts behind a GLB file, each
    /// filled up to a multiple of four bytes: colour, normals (OpenGL), 'orm'.
    #[wasm_bindgen(js_name = meshFile, unchecked_return_type = "MeshSlice | Notice")]
    pub fn mesh_file(&mut self, ending: &str, detail: &str, images: &[u32], budget: f64) -> Object {
        let clock = &self.clock;
        let order = order(ending, detail, images).ok_or(Code::NoSuchFile.into());
        let made = order.and_then(|order| {
            let engine = self.studio.engine_mut();
            let slice = engine.mesh_file(&order, &mut || clock.now(), budget);
            slice.map(|slice| objects::mesh_slice(&slice))
        });
        or_why(made)
    }

    /// The triangles of a `meshFile` and its bytes, about; empty where there is no such file.
    #[wasm_bindgen(js_name = meshSize)]
    pub fn mesh_size(&self, ending: &str, detail: &str, images: &[u32]) -> Vec<f64> {
        let order = order(ending, detail, images);
        let size = order.and_then(|order| self.studio.engine().mesh_size(&order));
        size.map_or(Vec::new(), |size| vec![size.triangles as f64, size.bytes])
    }

    /// Works for about `budget` milliseconds on the finished picture at `scale` (1 to 4) times its side.
    /// `stopFile` frees what it holds.
    #[wasm_bindgen(js_name = pictureFile, unchecked_return_type = "PictureSlice | Notice")]
    pub fn picture_file(&mut self, scale: u32, budget: f64) -> Object {
        let clock = &self.clock;
        let engine = self.studio.engine_mut();
        let made = engine.picture_file(scale as usize, &mut || clock.now(), budget);
        or_why(made.map(|slice| objects::picture_slice(&slice)))
    }

    /// As `map`, of the picture that `pictureFile` finished last: maps of more pixels than are on the screen.
    #[wasm_bindgen(js_name = biggerMap, unchecked_return_type = "PixelMap | Notice")]
    pub fn bigger_map(&self, word: &str) -> Object {
        let engine = self.studio.engine();
        map_of(word, |kind| engine.bigger_map(kind))
    }

    /// Stops `meshFile` or `pictureFile` and frees what they hold, for visitors who do not want to wait.
    #[wasm_bindgen(js_name = stopFile)]
    pub fn stop_file(&mut self) {
        self.studio.engine_mut().stop_file();
    }

    /// The fields of the native program's report.json, as text.
    pub fn report(&mut self) -> String {
        let mut report = self.studio.report();
        report.notices.clone_from(&self.notices);
        report.json()
    }
}

fn order(ending: &str, detail: &str, images: &[u32]) -> Option<MeshOrder> {
    let (format, _) = *MeshFormat::ALL.iter().find(|(_, word)| *word == ending)?;
    let (_, detail) = *DETAILS.iter().find(|(word, _)| *word == detail)?;
    Some(MeshOrder {
        format,
        detail,
        images: images.try_into().ok(),
    })
}

fn map_of(word: &str, made: impl Fn(MapKind) -> Result<Map, Notice>) -> Object {
    let kind = MapKind::of_word(word).ok_or(Code::NoSuchFile.into());
    or_why(kind.and_then(made).map(|map| objects::map(&map)))
}
