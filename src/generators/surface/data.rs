//! The results as text, for measurements.

use super::SurfaceEngine;
use crate::export::{model_obj, surface_cells_json, surface_mesh_json};
use crate::mesh::Face;
use glam::DVec3;

impl SurfaceEngine {
    /// The results as text files: names and contents. Places are those of the model's file.
    pub(super) fn data_files(&self) -> Vec<(&'static str, String)> {
        let built = self.made.built();
        let anchor = built.map_or(DVec3::ZERO, |built| built.anchor);
        let paved = self.made.paved();
        let cells = paved.map(|paved| surface_cells_json(&paved.cells, anchor));
        let mesh = self.made.mesh().map(|made| {
            let places = made.nodes.iter().map(|node| node.at + anchor);
            let places: Vec<DVec3> = places.collect();
            surface_mesh_json(&places, made.elements.iter().map(Face::nodes))
        });
        let model = built.map(|built| model_obj(&built.whole, anchor));
        let named = [
            ("cells.json", cells),
            ("mesh.json", mesh),
            ("model.obj", model),
        ];
        named
            .into_iter()
            .filter_map(|(name, text)| Some((name, text?)))
            .collect()
    }
}
