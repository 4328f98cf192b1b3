//! The bodies of a scene in one file. Bodies of one kind share a mesh in GLB; OBJ, which has no instances, gets an
//! object for each body.

use super::frame::ExportSpace;
use super::glb::{FileMaterial, Glb};
use super::ground::with_areas;
use super::maps::roughness;
use super::obj::Obj;
use super::order::{MeshFormat, MeshOrder};
use super::part_file::PartFile;
use super::shades::Shades;
use super::surface::mean_roughness;
use crate::heightfield::GROUND;
use crate::material::Material;
use crate::scene::{Instance, Paint, Scene};
use crate::solid::Surface;
use crate::surface_stones::Fit;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// The share of light that glass stops, in files.
const GLASS_ALPHA: f32 = 0.4;

/// How a file tells of a scene.
#[derive(Clone, Debug, Default)]
pub struct SceneTerms {
    /// The names of the rows of the table of materials. Materials of further rows have none.
    pub materials: Vec<String>,
    /// The map from the file to the scene.
    pub fit: Fit,
    /// The name of the file's lengths, for its readers, as "metres".
    pub lengths: &'static str,
}

/// A file of a scene that is being made.
pub struct SceneFile {
    writer: SceneWriter,
    /// The most triangles of a body.
    most: usize,
    next: usize,
}

enum SceneWriter {
    Obj(Obj),
    Glb(Box<SharedMeshes>),
}

/// A GLB file whose nodes share meshes.
struct SharedMeshes {
    glb: Glb,
    /// The rows of the table of materials.
    rows: Vec<Material>,
    names: Vec<String>,
    shades: Shades,
    /// The number of the surface of each body.
    surfaces: BTreeMap<u32, usize>,
    materials: BTreeMap<Paint, usize>,
    /// The number of the mesh of each body in each paint.
    meshes: BTreeMap<(u32, Option<Paint>), usize>,
}

impl SceneFile {
    /// A file of a scene with these materials. Images of the order are ignored.
    pub fn new(
        order: &MeshOrder,
        (materials, terms): (&[Material], SceneTerms),
        scene: &Scene,
    ) -> Self {
        let mean = mean_roughness(materials);
        let glb = || SharedMeshes {
            glb: Glb::of_scene(mean, order.joined, is_white(scene)).placed(terms.fit),
            rows: materials.to_vec(),
            names: terms.materials.clone(),
            shades: Shades::new(scene),
            surfaces: BTreeMap::new(),
            materials: BTreeMap::new(),
            meshes: BTreeMap::new(),
        };
        Self {
            writer: match order.format {
                MeshFormat::Obj => SceneWriter::Obj(Obj::of_scene(terms.fit, terms.lengths)),
                MeshFormat::Glb => SceneWriter::Glb(Box::new(glb())),
            },
            most: order.of_each(scene.instances.len()),
            next: 0,
        }
    }

    /// Adds the next body, under the name that `name` gives it; true when all are there. The scene must be the same
    /// each time.
    pub fn advance(&mut self, scene: &Scene, name: impl Fn(&Instance) -> String) -> bool {
        let Some(instance) = scene.instances.get(self.next) else {
            return true;
        };
        self.next += 1;
        let levels = scene.bodies[instance.body as usize].levels.iter();
        let fits = |surface: &&Surface| surface.triangles.len() <= self.most;
        let Some(surface) = levels.clone().find(fits).or(levels.last()) else {
            return false;
        };
        let surface = match instance.id {
            GROUND => with_areas(surface),
            _ => Cow::Borrowed(surface),
        };
        if surface.triangles.is_empty() {
            return false;
        }
        match &mut self.writer {
            SceneWriter::Obj(obj) => {
                let name = name(instance).replace(char::is_whitespace, "_");
                obj.add_named(
                    &ExportSpace::Model(None),
                    &placed(&surface, instance),
                    &name,
                );
            }
            SceneWriter::Glb(glb) => glb.add(&surface, instance, &name(instance)),
        }
        false
    }
}

/// Whether all surfaces are white, so that all colours are those of the instances' paint.
fn is_white(scene: &Scene) -> bool {
    let bodies: BTreeSet<u32> = scene.instances.iter().map(|one| one.body).collect();
    let levels = bodies
        .iter()
        .flat_map(|&body| scene.bodies[body as usize].levels.iter());
    let mut colours = levels.flat_map(|surface| &surface.colours);
    colours.all(|colour| *colour == [255; 3])
}

impl PartFile for SceneFile {
    fn take(&mut self) -> Vec<Vec<u8>> {
        match &mut self.writer {
            SceneWriter::Obj(obj) => obj.take(),
            SceneWriter::Glb(_) => Vec::new(),
        }
    }

    fn finish(self) -> Vec<Vec<u8>> {
        match self.writer {
            SceneWriter::Obj(obj) => obj.finish(),
            SceneWriter::Glb(shared) => shared.glb.finish(),
        }
    }
}

impl SharedMeshes {
    fn add(&mut self, surface: &Surface, instance: &Instance, name: &str) {
        let paint = instance.paint.map(|paint| self.shades.of(paint));
        let material = self.material(paint);
        let glb = &mut self.glb;
        if glb.is_joined() {
            let bare = Instance {
                paint: None,
                ..*instance
            };
            let space = ExportSpace::Model(None);
            glb.join(&space, &placed(surface, &bare), material);
            return;
        }
        let kind = (instance.body, paint);
        let mesh = *self.meshes.entry(kind).or_insert_with(|| {
            let shared = self.surfaces.entry(instance.body);
            let shared =
                *shared.or_insert_with(|| glb.add_surface(&ExportSpace::Model(None), surface));
            glb.add_mesh(shared, material)
        });
        glb.add_body(mesh, name, &instance.place);
    }

    /// The number of the material of a paint.
    fn material(&mut self, paint: Option<Paint>) -> usize {
        let Some(paint) = paint else {
            return 0;
        };
        if let Some(&known) = self.materials.get(&paint) {
            return known;
        }
        let row = usize::from(paint.material);
        let material = self.rows.get(row);
        let is_of_row = |other: &&Paint| other.material == paint.material;
        let named = |name: &String| match self.materials.keys().filter(is_of_row).count() {
            0 => name.clone(),
            earlier => format!("{name}_{}", earlier + 1),
        };
        let is_glass = material == Some(&Material::GLASS);
        let number = self.glb.add_material(&FileMaterial {
            name: self.names.get(row).map(named),
            tint: paint.tint,
            alpha: if is_glass { GLASS_ALPHA } else { 1.0 },
            metal: material.map_or(0.0, |material| material.metal),
            roughness: material.map_or(1.0, |one| roughness(f64::from(one.shininess))),
        });
        self.materials.insert(paint, number);
        number
    }
}

/// The surface of a body in its place and in its own colours.
fn placed(surface: &Surface, instance: &Instance) -> Surface {
    let place = &instance.place;
    let tinted = |&colour: &[u8; 3]| match instance.paint {
        Some(paint) => paint.over(colour.map(f32::from)).map(|c| (c + 0.5) as u8),
        None => colour,
    };
    let turned = |&normal| place.turned(normal) / place.scale();
    Surface {
        positions: surface.positions.iter().map(|&p| place.of(p)).collect(),
        normals: surface.normals.iter().map(turned).collect(),
        colours: surface.colours.iter().map(tinted).collect(),
        ..surface.clone()
    }
}
