//! Exports: files, and their sizes.

use super::said::or_why;
use super::{Bubblestone, objects};
use crate::export::{DETAILS, MapKind, MeshFormat, MeshOrder};
use crate::notice::Code;
use js_sys::Object;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Bubblestone {
    /// The cells as a standalone SVG file; '' before there are any, and in the first module.
    pub fn svg(&mut self) -> String {
        self.inspect().map_or(String::new(), |cells| cells.svg())
    }

    /// A map of the finished picture ('height', 'normal-opengl', 'normal-directx', 'albedo', 'roughness', 'ao',
    /// 'id', 'orm', 'height-float'), or a notice with the reason why there is none.
    #[wasm_bindgen(unchecked_return_type = "PixelMap | Notice")]
    pub fn map(&mut self, word: &str) -> Object {
        let kind = MapKind::of_word(word).ok_or(Code::NoSuchFile.into());
        let made = kind.and_then(|kind| self.studio.maps()?.map(kind));
        or_why(made.map(|map| objects::map(&map)))
    }

    /// Works for about `budget` milliseconds on a mesh file: 'glb' or 'obj', with 'low', 'middle' or 'high'
    /// detail. `images` is empty, or has the lengths of three images that the caller appends to a GLB file,
    /// each padded to a multiple of four bytes: colour, normals (OpenGL), 'orm'. `+joined` after the detail makes one
    /// mesh of all bodies in a GLB file. Only the second module makes mesh files.
    #[wasm_bindgen(js_name = meshFile, unchecked_return_type = "MeshSlice | Notice")]
    pub fn mesh_file(&mut self, ending: &str, detail: &str, images: &[u32], budget: f64) -> Object {
        self.memory.make_room();
        let clock = &self.clock;
        let order = order(ending, detail, images).ok_or(Code::NoSuchFile.into());
        let made = order.and_then(|order| {
            let meshes = self.studio.meshes()?;
            let slice = meshes.mesh_file(&order, &mut || clock.now(), budget);
            slice.map(|slice| objects::mesh_slice(&slice))
        });
        or_why(made)
    }

    /// The approximate triangles and bytes of a `meshFile`; empty if there is no such file.
    #[wasm_bindgen(js_name = meshSize)]
    pub fn mesh_size(&mut self, ending: &str, detail: &str, images: &[u32]) -> Vec<f64> {
        let order = order(ending, detail, images);
        let size = order.and_then(|order| self.studio.meshes().ok()?.mesh_size(&order));
        size.map_or(Vec::new(), |size| vec![size.triangles as f64, size.bytes])
    }

    /// The places of the bodies as a table in CSV; '' before there are any.
    pub fn places(&mut self) -> String {
        let meshes = self.studio.meshes().ok();
        let table = meshes.and_then(|meshes| meshes.places());
        table.unwrap_or_default()
    }

    /// The building as JSON, which opens again here; '' before there is one.
    pub fn building(&mut self) -> String {
        let meshes = self.studio.meshes().ok();
        let text = meshes.and_then(|meshes| meshes.building());
        text.unwrap_or_default()
    }

    /// Works for about `budget` milliseconds on maps of the finished picture at `scale` (1 to 8) times its
    /// side. `maps` has their words with spaces between; without words, the picture itself is made. `stopFile`
    /// frees the memory.
    #[wasm_bindgen(js_name = pictureFile, unchecked_return_type = "PictureSlice | Notice")]
    pub fn picture_file(&mut self, scale: u32, maps: &str, budget: f64) -> Object {
        let clock = &self.clock;
        let words = maps.split_ascii_whitespace();
        let kinds: Option<Vec<MapKind>> = words.map(MapKind::of_word).collect();
        let made = kinds.ok_or(Code::NoSuchFile.into()).and_then(|kinds| {
            let order = (scale as usize, &kinds[..]);
            self.studio
                .maps()?
                .picture_file(order, &mut || clock.now(), budget)
        });
        or_why(made.map(|slice| objects::picture_slice(&slice)))
    }

    /// Stops `meshFile` or `pictureFile` and frees their memory, for visitors who do not want to wait.
    #[wasm_bindgen(js_name = stopFile)]
    pub fn stop_file(&mut self) {
        if let Ok(meshes) = self.studio.meshes() {
            meshes.stop_mesh();
        }
        if let Ok(maps) = self.studio.maps() {
            maps.stop_picture();
        }
    }

    /// The fields of the native program's report.json, as text.
    pub fn report(&mut self) -> String {
        let mut report = self.studio.report();
        report.notices.clone_from(&self.notices);
        report.json()
    }
}

fn order(ending: &str, detail: &str, images: &[u32]) -> Option<MeshOrder> {
    // Only the second module makes mesh files.
    #[cfg(house)]
    let (detail, joined) = match detail.strip_suffix("+joined") {
        Some(detail) => (detail, true),
        None => (detail, false),
    };
    let (format, _) = *MeshFormat::ALL.iter().find(|(_, word)| *word == ending)?;
    let (_, detail) = *DETAILS.iter().find(|(word, _)| *word == detail)?;
    Some(MeshOrder {
        format,
        detail,
        images: images.try_into().ok(),
        #[cfg(house)]
        joined,
    })
}
