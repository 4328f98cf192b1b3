//! Mesh files of a finished building.

use super::MasonryEngine;
use super::colours::{GRASS_ROW, MATERIAL_NAMES};
use crate::building::write_json;
use crate::export::{MeshOrder, MeshSize, SceneFile, SceneTerms};
use crate::generators::scene_picture::Saving;
use crate::generators::{Clock, MeshSlice, Meshes};
use crate::masonry::laying::Laying;
use crate::notice::Notice;
use crate::scene::{Instance, Scene};
use crate::surface_stones::Fit;
use std::rc::Rc;

/// A mesh file in the making.
#[derive(Default)]
pub(crate) struct BuildingSaving {
    file: Option<Saving<SceneFile>>,
    /// The scene of mesh files, and the revision of the blocks that it was made of.
    scene: Option<(u64, Rc<Scene>)>,
}

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
        let bodies = &self.made.shared.bodies;
        let (revision, blocks) = (bodies.revision(), bodies.made()?);
        let known = self.saving.scene.take().filter(|(of, _)| *of == revision);
        let new = || (revision, Rc::new(without_grass(&blocks.scene)));
        let (_, scene) = self.saving.scene.insert(known.unwrap_or_else(new));
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
        let scene = self.modelled();
        let cells = self.made.cells.made().map_or(&[][..], Laying::cells);
        // A body's name has the type of its feature and the number of its block.
        let name = |number: usize| {
            let cell = cells.get(number)?;
            Some(format!("{}_{number}", cell.feature.word()))
        };
        let part = |row: u8| MATERIAL_NAMES[usize::from(row)];
        let terms = SceneTerms {
            materials: MATERIAL_NAMES.map(str::to_owned).to_vec(),
            fit: self
                .made
                .site
                .made()
                .map_or(Fit::default(), |site| site.fit),
            lengths: "metres",
        };
        let of = (&self.made, scene);
        let order = (order, terms);
        Saving::of_scene(
            &mut self.saving.file,
            of,
            order,
            (clock, budget),
            (part, name),
        )
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        let scene = self.made.shared.scene()?;
        Some(order.scene_size(&without_grass(scene)))
    }

    fn building(&self) -> Option<String> {
        let site = self.made.site.made();
        Some(site.map_or(String::new(), |site| write_json(&site.draft)))
    }

    fn stop_mesh(&mut self) {
        self.saving = BuildingSaving::default();
    }
}
