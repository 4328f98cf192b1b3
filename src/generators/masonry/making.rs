//! The steps in which a block is made, seen from near (Legakis, Dorsey, Gortler 2001, Feature-based cellular texturing
//! for architectural models, sections 3.3 and 5.1): its place on the face, the space that it claims among its neighbours,
//! the joints, the shape of its edges, and the block in the wall.

use super::blocks::{flat, plain, smooth};
use super::colours::STONE_ROW;
use super::diagrams::{Clipped, clipped};
use super::parts::add_plain;
use super::rounding::rounding;
use super::stages::MasonryStages;
use crate::generators::scene_picture::{SceneStages, seen_near};
use crate::masonry::block::{Bevelled, BlockMesh, Polyhedron, Rough, Stonecutter};
use crate::masonry::footprint::Footprint;
use crate::masonry::laying::{Feature, Laying, MasonryCell};
use crate::scene::{Place, Scene};
use crate::solid::Surface;
use glam::{DVec3, Vec3};
use std::rc::Rc;

/// The colours of neighbours, and of the block itself.
const BESIDE: [u8; 3] = [150, 147, 140];
const OWN: [u8; 3] = [226, 214, 190];
/// Cells are neighbours if the boxes around them are at most this far apart (metres).
const TOUCH: f64 = 1e-3;
/// How thick and how far before the face plates are drawn (metres).
const PLATES: [f64; 2] = [1e-3, 4e-3];
/// The angle (degrees) from which a block's front is seen: the page's first camera for one body stands at 80 degrees.
const FRONT: f64 = 50.0;
/// The distance of the corners of a block's box from the middle of the picture, in units of the scene.
const CORNER: f64 = 1.05;
/// The reach of ambient occlusion (metres).
const REACH: f64 = 0.05;

/// A step in the making of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum BlockStep {
    /// The place on the face before it is clipped, with the parts that other cells have claimed.
    Clip,
    /// The space that the cell claims, among the cells laid before it.
    Claim,
    /// The claim, shrunk to its joints.
    Joints,
    /// Chamfered edges.
    Chamfer,
    /// Edges and corners rounded by Loop's scheme.
    Round,
    /// Bumps on the sides.
    Bumps,
    /// The block, set among its neighbours.
    Set,
}

impl BlockStep {
    fn word(self) -> &'static str {
        match self {
            Self::Clip => "clip",
            Self::Claim => "claim",
            Self::Joints => "joints",
            Self::Chamfer => "chamfer",
            Self::Round => "round",
            Self::Bumps => "bumps",
            Self::Set => "set",
        }
    }
}

/// A block whose making is shown.
struct MadeBlock<'a> {
    laying: &'a Laying,
    cell: &'a MasonryCell,
    /// Its number in the order of laying.
    number: u32,
    mark: u32,
    /// Its shape if it is rounded.
    rough: Option<Rough>,
    chamfer: f64,
}

impl MasonryStages {
    /// Whether all blocks are laid and stand in the finished scene.
    pub(super) fn is_laid(&self) -> bool {
        self.has_scene_of(&self.laid)
    }

    /// The words of the steps in the making of the block with an id; none before all blocks are laid.
    pub(super) fn block_steps(&self, id: u32) -> Vec<&'static str> {
        let steps = self.made_block(id).map(|block| block.steps());
        let steps = steps.into_iter().flatten();
        steps.map(BlockStep::word).collect()
    }

    /// The scene of a step in the making of the block with an id.
    pub(super) fn block_scene(&self, id: u32, at: usize) -> Option<Scene> {
        let block = self.made_block(id)?;
        let fit = self.site.made()?.fit;
        let near = block.near();
        let step = *block.steps().get(at)?;
        if step == BlockStep::Set {
            let scale = (near.1 / fit.scale) as f32;
            let origin = near.0.of(fit.middle.as_vec3());
            let place = Place {
                axes: near.0.axes.map(|axis| axis / fit.scale as f32),
                origin,
            };
            let ids: Vec<u32> = block.neighbours().map(|(k, _)| k + 1).collect();
            let is_shown = |other: u32| other == id || ids.contains(&other);
            let all = self.shared.scene()?;
            return Some(seen_near(all, (place, scale), |i| is_shown(i.id)));
        }
        let scene = Rc::new(block.scene(step)?);
        Some(seen_near(&scene, (near.0, near.1 as f32), |_| true))
    }

    fn made_block(&self, id: u32) -> Option<MadeBlock<'_>> {
        let laying = self.laying().filter(|_| self.is_laid())?;
        let number = id.checked_sub(1)?;
        let cell = laying.cells().get(number as usize)?;
        let (params, mark) = (self.laid.params(), cell.mark());
        let key = (params.seed, u64::from(mark));
        let (_, material) = params.colours.of_cell(cell, key, params.vary);
        Some(MadeBlock {
            laying,
            cell,
            number,
            mark,
            rough: rounding(params, cell, material),
            chamfer: params.chamfer,
        })
    }
}

impl<'a> MadeBlock<'a> {
    fn steps(&self) -> Vec<BlockStep> {
        let mut steps = Vec::new();
        if !self.clipped().is_empty() {
            steps.push(BlockStep::Clip);
        }
        steps.push(BlockStep::Claim);
        if self.cell.body.shrunk().is_some() {
            steps.push(BlockStep::Joints);
            match self.rough {
                Some(_) => steps.extend([BlockStep::Round, BlockStep::Bumps]),
                None if self.chamfer > 0.0 => steps.push(BlockStep::Chamfer),
                None => {}
            }
            steps.push(BlockStep::Set);
        }
        steps
    }

    fn clipped(&self) -> Vec<Clipped> {
        clipped(self.laying, (self.number, self.cell))
    }

    /// The cells that touch this one, with their numbers.
    fn neighbours(&self) -> impl Iterator<Item = (u32, &'a MasonryCell)> {
        let [low, high] = self.cell.claimed.bounds();
        let (own, low, high) = (self.number, low - TOUCH, high + TOUCH);
        let all = (0..).zip(self.laying.cells());
        all.filter(move |&(number, cell)| {
            let [from, to] = cell.claimed.bounds();
            number != own && from.cmple(high).all() && low.cmple(to).all()
        })
    }

    /// The place that turns the block's front to the viewer and its middle to the origin, and its scale: units of the
    /// scene in a metre.
    fn near(&self) -> (Place, f64) {
        let [low, high] = self.cell.body.bounds();
        let scale = 2.0 * CORNER / low.distance(high).max(f64::MIN_POSITIVE);
        let (sin, cos) = libm::sincos(FRONT.to_radians());
        let front = self.cell.outwards.with_y(0.0);
        let wanted = DVec3::new(-sin, 0.0, cos);
        // Fronts that look up or down stay as they are.
        let from = front.try_normalize().unwrap_or(wanted);
        let (along, across) = (from.dot(wanted), wanted.cross(from).y);
        let axes = [
            DVec3::new(along, 0.0, across),
            DVec3::Y,
            DVec3::new(-across, 0.0, along),
        ]
        .map(|axis| (axis * scale).as_vec3());
        let turn = Place {
            axes,
            origin: Vec3::ZERO,
        };
        let origin = -turn.of(low.midpoint(high).as_vec3());
        (Place { axes, origin }, scale)
    }

    /// The scene of a step before the finished block, in the building's coordinates (metres).
    fn scene(&self, step: BlockStep) -> Option<Scene> {
        let mut scene = Scene {
            reach: REACH as f32,
            ..Scene::default()
        };
        let id = self.number + 1;
        if matches!(step, BlockStep::Clip | BlockStep::Claim) {
            let earlier = self
                .neighbours()
                .filter(|&(number, _)| number < self.number);
            for (number, cell) in earlier {
                add(&mut scene, solid(&cell.claimed), number + 1, BESIDE);
            }
        }
        let own = match step {
            BlockStep::Clip => {
                self.add_plates(&mut scene)?;
                return Some(scene);
            }
            BlockStep::Claim => solid(&self.cell.claimed),
            BlockStep::Joints => {
                scene.lines = edges(&self.cell.claimed);
                solid(&self.cell.body.shrunk()?)
            }
            BlockStep::Chamfer => {
                let bevelled = Bevelled::new(&self.cell.body.shrunk()?, self.chamfer);
                flat(&bevelled.facets(), |p| p.as_vec3())
            }
            BlockStep::Round => {
                let even = (*self.cell.body).clone().with_roughness(|_| 0.0);
                self.rounded(&even, 0.0)?
            }
            BlockStep::Bumps => self.rounded(&self.cell.body, self.rough?.height)?,
            BlockStep::Set => return None,
        };
        add(&mut scene, own, id, OWN);
        Some(scene)
    }

    /// Adds the place of the cell on its face before it was clipped: what is left of it, and each part that was cut
    /// off, in the colour of the feature that is in the way.
    fn add_plates(&self, scene: &mut Scene) -> Option<()> {
        let Feature::Face(face) = self.cell.feature else {
            return None;
        };
        let surface = &self.laying.building().face(face).surface;
        let mut plate = |part: &Footprint, z: f64, colour: [u8; 3]| {
            let ring = |z: f64| -> Vec<DVec3> {
                let places = part.places();
                places.map(|p| surface.map(p.x, p.y, z).origin).collect()
            };
            let body = Polyhedron::between(&[ring(z - PLATES[0]), ring(z)]);
            add(scene, solid(&body), self.number + 1, colour);
        };
        plate(self.cell.unclipped.as_deref()?, PLATES[0], OWN);
        for cut in self.clipped() {
            plate(&cut.part, PLATES[1], cut.colour(self.laying));
        }
        Some(())
    }

    /// The finest level of the rounded block, with bumps of this height.
    fn rounded(&self, body: &Polyhedron, height: f64) -> Option<Surface> {
        let rough = self.rough?;
        let mut cutter = Stonecutter::new(Rough { height, ..rough });
        let levels = cutter.levels(body, self.mark)?;
        levels
            .first()
            .map(|mesh: &BlockMesh| smooth(mesh, |p| p.as_vec3()))
    }
}

/// The surface of a body without chamfers, in metres.
fn solid(body: &Polyhedron) -> Surface {
    plain(body, |p| p.as_vec3())
}

fn add(scene: &mut Scene, surface: Surface, id: u32, colour: [u8; 3]) {
    add_plain(scene, surface, (id, colour, STONE_ROW));
}

/// The edges of a body, each once.
fn edges(body: &Polyhedron) -> Vec<[Vec3; 2]> {
    let mut edges = Vec::new();
    for side in body.sides() {
        let next = side.corners.iter().cycle().skip(1);
        for (&a, &b) in side.corners.iter().zip(next) {
            if a < b {
                edges.push([a, b].map(|v| body.vertices()[v as usize].as_vec3()));
            }
        }
    }
    edges
}
