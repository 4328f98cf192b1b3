//! Mesh files of a finished building.

use super::MasonryEngine;
use crate::export::{MeshOrder, MeshSize, SceneFile};
use crate::generators::scene_picture::Saving;
use crate::generators::{Clock, Engine, MeshSlice, Meshes};
use crate::notice::{Code, Notice};
use crate::scene::{Instance, Scene};
use std::rc::Rc;

impl Meshes for MasonryEngine {
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        let is_done = self.at().is_none();
        let Some(blocks) = self.made.blocks.made().filter(|_| is_done) else {
            return Err(Code::NotYet.into());
        };
        let scene: Rc<Scene> = blocks.scene.clone();
        let materials = &self.made.still.params().light.materials;
        let cells = self
            .made
            .cells
            .made()
            .map_or(&[][..], |laying| laying.cells());
        // A name tells the type of the feature, and the number of the block.
        let name = |instance: &Instance| match (instance.id as usize).checked_sub(1) {
            None => "building".to_owned(),
            Some(number) => format!("{}_{number}", cells[number].feature.word()),
        };
        Ok(Saving::slice(
            &mut self.saving,
            (order, self.made.blocks.revision()),
            || SceneFile::new(order, materials, &scene),
            (clock, budget),
            |file| file.advance(&scene, name),
        ))
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        let scene = &self.made.blocks.made()?.scene;
        Some(order.scene_size(scene))
    }

    fn stop_mesh(&mut self) {
        self.saving = None;
    }
}
