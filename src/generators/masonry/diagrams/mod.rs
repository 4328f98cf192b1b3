//! Diagrams of masonry: what the plan says, what is occupied, and what was clipped. Each lies on the plain mortar.

mod clipping;
mod grid;
mod kinds;
mod occupancy;
mod parity;
mod plates;
mod seams;
mod unrolled;

pub(super) use clipping::{Clipped, clipped};
pub(super) use grid::lines;
pub(super) use occupancy::Claimed;
pub(super) use seams::Texture;
pub(super) use unrolled::{STATES, occupied, scene as map_scene};

use super::blocks::{add_mortar, flat, widest};
use super::params::BlockParams;
use super::parts::add_plain;
use super::site::BuildingSite;
use super::views::MasonryView;
use crate::building::{FaceId, VertexId};
use crate::masonry::block::BlockMesh;
use crate::masonry::laying::{Feature, Laying, MasonryCell};
use crate::random::{Purpose, Random};
use crate::scene::Scene;

/// The colour of mortar in views.
const CALM: [u8; 3] = [168, 162, 151];
/// The rows of the bare surface, of maps and of plain bodies in the materials of views.
const BARE: u8 = 0;
const MAP: u8 = 1;
const SATIN: u8 = 2;
/// The reach of ambient occlusion (metres).
const REACH: f64 = 0.3;

/// Cells that a slice of the work adds to a diagram.
const SLICE: usize = 60;

/// The diagram of a view.
#[derive(Default)]
pub(crate) struct Diagram {
    pub scene: Scene,
    /// The pixels of all faces, if the diagram shows them.
    pub claimed: Option<Claimed>,
}

impl From<Scene> for Diagram {
    fn from(scene: Scene) -> Self {
        Self {
            scene,
            claimed: None,
        }
    }
}

/// The diagram of a view in the making, over the mortar of blocks.
pub(crate) struct DiagramWork {
    made: Diagram,
    /// How many cells, and how many faces, have been added.
    cells: usize,
    faces: usize,
    /// The index of the first instance of the building's copy, which stands beside the seams.
    copy: usize,
}

impl DiagramWork {
    /// Starts with the mortar of these blocks, which are made of these cells.
    pub(super) fn new(site: &BuildingSite, blocks: &BlockParams, cells: &[MasonryCell]) -> Self {
        Self {
            made: bare(site, blocks, cells).into(),
            cells: 0,
            faces: 0,
            copy: 0,
        }
    }

    /// Adds some cells. Views without cells are made at once. Returns the diagram at the end.
    pub(super) fn advance(
        &mut self,
        view: MasonryView,
        laying: &Laying,
        (site, blocks): (&BuildingSite, &BlockParams),
    ) -> Option<Diagram> {
        let (fit, all) = (site.fit, laying.cells().len());
        let is_first = self.cells == 0;
        let cells = self.cells..all.min(self.cells + SLICE);
        self.cells = cells.end;
        let mut is_done = self.cells == all;
        let scene = &mut self.made.scene;
        match view {
            MasonryView::Plan => grid::add(scene, laying, fit),
            MasonryView::Parity => parity::add(scene, laying, fit),
            MasonryView::Occupancy => {
                let face = faces(laying).nth(self.faces);
                is_done = face.is_none();
                self.faces += 1;
                let counts = self.made.claimed.get_or_insert_default();
                if let Some(face) = face {
                    occupancy::add((scene, counts), laying, face, fit);
                }
            }
            MasonryView::Clipping => clipping::add(scene, laying, fit, cells),
            MasonryView::Seams => {
                if is_first {
                    seams::add(scene, laying, fit);
                    self.copy = scene.instances.len();
                    add_bare(scene, site, blocks, laying.cells());
                }
                seams::add_cells(scene, laying, (fit, cells));
                if is_done {
                    seams::set_apart(scene, laying, self.copy, fit);
                }
            }
            _ => kinds::add(scene, view, laying, (fit, cells)),
        }
        let is_whole = matches!(view, MasonryView::Plan | MasonryView::Parity);
        (is_done || is_whole).then(|| std::mem::take(&mut self.made))
    }
}

/// The mortar alone, with room for these cells.
pub(super) fn bare(site: &BuildingSite, blocks: &BlockParams, cells: &[MasonryCell]) -> Scene {
    let mut scene = empty(site);
    add_bare(&mut scene, site, blocks, cells);
    scene
}

fn add_bare(scene: &mut Scene, site: &BuildingSite, blocks: &BlockParams, cells: &[MasonryCell]) {
    let widest = widest(&site.building, cells, blocks.length);
    add_mortar(scene, site, (blocks.recess, &widest), [(CALM, BARE); 3]);
}

fn empty(site: &BuildingSite) -> Scene {
    Scene {
        reach: (REACH * site.fit.scale) as f32,
        ..Scene::default()
    }
}

/// The polygons of the child mesh, each in a tone of its own, with their edges. Ids count from 1 in the order of the
/// building.
pub(super) fn polygons(site: &BuildingSite) -> Scene {
    let mut scene = empty(site);
    for (id, polygon) in (1_u32..).zip(site.building.polygons()) {
        let place = |v: &VertexId| site.building.vertex(*v).position;
        let count = polygon.vertices.len() as u32;
        let mesh = BlockMesh {
            positions: polygon.vertices.iter().map(place).collect(),
            triangles: (2..count).map(|k| [0, k - 1, k]).collect(),
        };
        let mut random = Random::new(7, Purpose::Paint, u64::from(id));
        let colour = [0; 3].map(|_| 130 + random.below(90) as u8);
        let surface = flat(&mesh, |p| site.fit.place(p));
        add_plain(&mut scene, surface, (id, colour, BARE));
        let next = mesh.positions.iter().cycle().skip(1);
        let edges = mesh.positions.iter().zip(next);
        let lines = edges.map(|(&a, &b)| [a, b].map(|p| site.fit.place(p)));
        scene.lines.extend(lines);
    }
    scene
}

/// The id of a feature in diagrams of features: its place in the order of the laying, from 1.
fn id_of(laying: &Laying, feature: Feature) -> u32 {
    let (corners, edges) = (
        laying.building().corners().len(),
        laying.building().edges().len(),
    );
    let place = match feature {
        Feature::Corner(id) => id.index(),
        Feature::Edge(id) => corners + id.index(),
        Feature::Face(id) => corners + edges + id.index(),
    };
    place as u32 + 1
}

/// The faces that the pattern reaches, with their ids; glass and the like are left out.
fn faces(laying: &Laying) -> impl Iterator<Item = (FaceId, u32)> + '_ {
    let ids = laying.textured_faces();
    ids.map(|face| (face, id_of(laying, Feature::Face(face))))
}

/// A lighter or darker tone of a colour: times a factor from 1 - `by` to 1 + `by` that depends on `number` only.
fn toned(colour: [u8; 3], by: f64, number: u32) -> [u8; 3] {
    let tone = 1.0 + by * Random::new(5, Purpose::Paint, u64::from(number)).signed();
    colour.map(|v| (f64::from(v) * tone).clamp(0.0, 255.0) as u8)
}
