//! Files of a finished surface.

use super::SurfaceEngine;
use super::stages::stones_params;
use crate::export::{MeshOrder, MeshSize, ModelFile};
use crate::generators::scene_picture::Saving;
use crate::generators::{Clock, Engine, MeshSlice, Meshes};
use crate::notice::{Code, Notice};

impl Meshes for SurfaceEngine {
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        let done = self.at().is_none();
        let (Some((_, revision)), Some(built), Some(paved)) = (
            self.made.scene().filter(|_| done),
            self.made.built(),
            self.made.paved(),
        ) else {
            return Err(Code::NotYet.into());
        };
        let materials = &self.made.shared.still.params().light.materials;
        let new = || {
            let stones = stones_params(self.made.shared.bodies.params(), &paved.cells);
            ModelFile::new(order, stones, materials, (&paved.cells, built.anchor))
        };
        let advance = |file: &mut ModelFile| file.advance(&built.whole, paved.paving());
        let wanted = (order, revision);
        Ok(Saving::slice(
            &mut self.saving,
            wanted,
            new,
            (clock, budget),
            advance,
        ))
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        let (paved, built) = (self.made.paved()?, self.made.last_built()?);
        let ground = built.whole.triangles().len();
        Some(order.model_size(paved.cells.len(), ground))
    }

    fn stop_mesh(&mut self) {
        self.saving = None;
    }
}
