//! Mesh files of a finished pile.

use super::PileEngine;
use super::materials::names_of_rows;
use crate::export::{MeshOrder, MeshSize, SceneTerms};
use crate::generators::scene_picture::Saving;
use crate::generators::{Clock, MeshSlice, Meshes};
use crate::notice::Notice;
use crate::surface_stones::Fit;
use crate::surface_views::BareSurface;

impl Meshes for PileEngine {
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        let scene = self.made.shared.scene().cloned();
        let pile = self.made.settled.made().map_or(&[][..], |s| s.bodies());
        let words = &self.made.words();
        // A body's name has the word of its type, its dart and its layer.
        let name = |dart: usize| {
            let body = pile.get(dart)?;
            let word = words[body.kind as usize];
            Some(format!("{word}_{dart}_layer_{}", body.layer))
        };
        let names = (|_| "shape", name);
        let of = (&self.made, scene);
        let terms = SceneTerms {
            materials: names_of_rows(words),
            fit: self
                .made
                .ground
                .made()
                .map_or(Fit::default(), BareSurface::fit),
            lengths: "the lengths of the shape, as the table of places",
        };
        let order = (order, terms);
        Saving::of_scene(&mut self.saving, of, order, (clock, budget), names)
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        Some(order.scene_size(self.made.shared.scene()?))
    }

    fn places(&self) -> Option<String> {
        Some(self.places_table())
    }

    fn stop_mesh(&mut self) {
        self.saving = None;
    }
}
