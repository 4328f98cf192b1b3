//! The results as text, for measurements.

use super::SurfaceEngine;
use crate::export::{model_obj, surface_cells_json, surface_mesh_json};
use crate::mesh::Face;
use glam::DVec3;

impl SurfaceEngine {
    /// The results as text files: names and contents.
    pub(super) fn data_files(&self) -> Vec<(&'static str, String)> {
        let cells = self
            .made
            .paved()
            .map(|paved| surface_cells_json(&paved.cells));
        let mesh = self.made.mesh().map(|made| {
            let places: Vec<DVec3> = made.nodes.iter().map(|node| node.at).collect();
            surface_mesh_json(&places, made.elements.iter().map(Face::nodes))
        });
        let model = self.made.built().map(|built| model_obj(&built.whole));
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
