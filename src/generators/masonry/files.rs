//! Mesh files of a finished building.

use super::MasonryEngine;
use super::colours::GRASS_ROW;
use crate::export::{MeshOrder, MeshSize, SceneFile};
use crate::generators::scene_picture::Saving;
use crate::generators::{Clock, Engine, MeshSlice, Meshes};
use crate::notice::{Code, Notice};
use crate::scene::{Instance, Scene};
use std::rc::Rc;

/// A scene without blades of grass: thousands of them would make up most of a file.
fn without_grass(scene: &Scene) -> Scene {
    let is_grass = |instance: &Instance| {
        let paint = instance.paint;
        paint.is_some_and(|paint| paint.material == GRASS_ROW)
    };
    let instances = scene.instances.iter().copied();
    Scene {
        bodies: scene.bodies.clone(),
        instances: instances.filter(|instance| !is_grass(instance)).collect(),
        ..Scene::default()
    }
}

impl MasonryEngine {
    /// The scene of mesh files.
    fn modelled(&mut self) -> Option<Rc<Scene>> {
        let (revision, blocks) = (
            self.made.shared.bodies.revision(),
            self.made.shared.bodies.made()?,
        );
        let known = self.modelled.take().filter(|(of, _)| *of == revision);
        let new = || (revision, Rc::new(without_grass(&blocks.scene)));
        let (_, scene) = self.modelled.insert(known.unwrap_or_else(new));
        Some(scene.clone())
    }
}

impl Meshes for MasonryEngine {
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        let is_done = self.at().is_none();
        let Some(scene) = self.modelled().filter(|_| is_done) else {
            return Err(Code::NotYet.into());
        };
        let materials = &self.made.shared.still.params().light.materials;
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
            (order, self.made.shared.bodies.revision()),
            || SceneFile::new(order, materials, &scene),
            (clock, budget),
            |file| file.advance(&scene, name),
        ))
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        let scene = &self.made.shared.bodies.made()?.scene;
        Some(order.scene_size(&without_grass(scene)))
    }

    fn stop_mesh(&mut self) {
        (self.saving, self.modelled) = (None, None);
    }
}
