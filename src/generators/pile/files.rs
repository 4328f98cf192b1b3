//! Mesh files of a finished pile.

use super::PileEngine;
use crate::export::{MeshOrder, MeshSize, SceneFile};
use crate::generators::scene_picture::Saving;
use crate::generators::{Clock, Engine, MeshSlice, Meshes};
use crate::notice::{Code, Notice};
use crate::scene::{Instance, Scene};
use std::rc::Rc;

impl Meshes for PileEngine {
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        let is_done = self.at().is_none();
        let Some(bodies) = self.made.shared.bodies.made().filter(|_| is_done) else {
            return Err(Code::NotYet.into());
        };
        let scene: Rc<Scene> = bodies.scene.clone();
        let materials = &self.made.shared.still.params().light.materials;
        let pile = self.made.settled.made().map_or(&[][..], |s| s.bodies());
        let words = &self.made.words();
        // A name tells the dart, the type and the layer.
        let name = |instance: &Instance| match (instance.id as usize).checked_sub(1) {
            None => "shape".to_owned(),
            Some(dart) => {
                let body = &pile[dart];
                let word = words[body.kind as usize];
                format!("{word}_{dart}_layer_{}", body.layer)
            }
        };
        Ok(Saving::slice(
            &mut self.saving,
            (order, self.made.shared.bodies.revision()),
            || SceneFile::new(order, materials, &scene),
            (clock, budget),
            |file| file.advance(&scene, name),
        ))
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        let scene = &self.made.shared.bodies.made()?.scene;
        Some(order.scene_size(scene))
    }

    fn places(&self) -> Option<String> {
        Some(self.places_table())
    }

    fn stop_mesh(&mut self) {
        self.saving = None;
    }
}
