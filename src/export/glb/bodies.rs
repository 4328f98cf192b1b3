//! Bodies of a scene in a GLB file: their nodes and their materials.

use super::super::json::text;
use super::layout::{BLENDED, BODY, LISTS, NO_SCALE, PAINTED, ROOT};
use super::template::fill;
use super::{FileMaterial, Glb};
use crate::light::decoded;
use crate::scene::Place;
use crate::surface_stones::Fit;
use glam::{Mat3, Quat};

impl Glb {
    /// Adds a body: a node with a mesh, in its place.
    pub(in crate::export) fn add_body(&mut self, mesh: usize, name: &str, place: &Place) {
        let scale = place.scale();
        let axes = place.axes.map(|axis| axis / scale);
        let turn = Quat::from_mat3(&Mat3::from_cols(axes[0], axes[1], axes[2])).normalize();
        let [own, placed, scaled] = BODY;
        self.nodes += r#",{"name":"#;
        self.nodes += &text(name);
        fill(&mut self.nodes, own, &[mesh as f64]);
        if *place != Place::default() {
            let parts = [&turn.to_array()[..], &place.origin.to_array()].concat();
            let numbers: Vec<f64> = parts.into_iter().map(shortest).collect();
            fill(&mut self.nodes, placed, &numbers);
        }
        if (scale - 1.0).abs() >= NO_SCALE {
            fill(&mut self.nodes, scaled, &[shortest(scale); 3]);
        }
        self.nodes.push('}');
        self.list_node();
    }

    /// The same file of surfaces that `fit` has mapped from the file's coordinates: its first node maps all others back.
    pub(in crate::export) fn placed(self, fit: Fit) -> Self {
        Self { fit, ..self }
    }

    /// The end of the first node.
    pub(super) fn root_end(&self) -> String {
        let Fit { middle, scale } = self.fit;
        if self.fit == Fit::default() {
            return LISTS[1].to_owned();
        }
        let mut end = String::new();
        let numbers = [[1.0 / scale; 3], middle.to_array()].concat();
        fill(&mut end, ROOT, &numbers);
        end
    }

    /// Adds a material; returns its number. Number 0 is that of [`Glb::new`].
    pub(in crate::export) fn add_material(&mut self, material: &FileMaterial) -> usize {
        let linear = material.tint.map(|c| decoded(f64::from(c) / 255.0));
        let [r, g, b] = linear.map(|v| (v * 1e6).round() / 1e6);
        let factors = [material.alpha, material.metal, material.roughness].map(shortest);
        let numbers = [[r, g, b], factors].concat();
        self.materials += ",{";
        if let Some(name) = &material.name {
            self.materials += &format!("\"name\":{},", text(name));
        }
        fill(&mut self.materials, PAINTED, &numbers);
        if material.alpha < 1.0 {
            self.materials += BLENDED;
        }
        self.materials.push('}');
        self.materials_made += 1;
        self.materials_made
    }
}

/// A number with few decimals that rounds to `v` in single precision.
fn shortest(v: f32) -> f64 {
    let exact = f64::from(v);
    let scales = [1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10];
    let mut rounded = scales
        .map(|scale| (exact * scale).round() / scale)
        .into_iter();
    rounded.find(|&near| near as f32 == v).unwrap_or(exact)
}
