//! The scene of a building: blocks, mortar, and parts without masonry, such as doors and glass.

use super::colours::{BRICK_ROW, GLASS_ROW, IRON_ROW, MORTAR_ROW, STONE_ROW, WOOD_ROW};
use super::congruent::Congruent;
use super::cuboid::Cuboid;
use super::params::BlockParams;
use super::parts::add_plain;
use super::rounding::{cast, fewer_steps, is_hewn, stone};
use super::shapes::{BlockLook, BlockShape, ShapedBlock, SharedBody, WallShapes};
use super::site::BuildingSite;
use crate::building::labels::{GLASS, ROOF};
use crate::building::{Building, ExtraMesh, FaceId, Mortar};
use crate::masonry::block::{Bevelled, BlockMesh, Dressing, Polyhedron, Stonecutter};
use crate::masonry::laying::MasonryCell;
use crate::order::{greater, lesser};
use crate::scene::{Body, Instance, Paint, Place, Scene};
use crate::solid::Surface;
use crate::surface_stones::Fit;
use glam::{DVec3, Vec3};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Least depth of the mortar behind the surface of a wall of rough stones (metres): at less depth the arrises of the
/// mortar stand out of rounded corners. Below the roughness `ROUNDED` edges are less round, and it falls to 0 with them.
const SUNK: f64 = 0.022;
const ROUNDED: f64 = 0.3;
/// The colour and the material of glass.
const GLASS_LOOK: ([u8; 3], u8) = ([104, 118, 128], GLASS_ROW);
/// The colour of a roof's boards.
const BOARDS: [u8; 3] = [92, 72, 54];
/// Normals are rounded to steps of one over this; triangles with equal rounded normals share vertices.
const SAME_PLANE: f64 = 1e4;
/// The vertex colour of all meshes here. Each instance has its own tint.
const WHITE: [u8; 3] = [255; 3];

/// A wall in the making: mortar, parts without masonry, and the blocks laid so far.
pub(crate) struct Wall {
    /// Only its bodies and instances are filled in.
    scene: Scene,
    fit: Fit,
    params: BlockParams,
    /// The shapes of the blocks laid so far.
    shapes: WallShapes,
    /// The shapes of the last wall, if this one can share them.
    last: Option<Rc<WallShapes>>,
    dressing: Dressing,
    cutter: Option<Stonecutter>,
    /// Makes the cast stones, whose sides are marked as rough or smooth.
    caster: Stonecutter,
    /// The number of cells handled so far.
    shown: usize,
}

impl Wall {
    /// Starts with mortar for these cells, glass, doors and the like. `last` has the shapes of the last wall's blocks.
    pub(super) fn new(
        site: &BuildingSite,
        params: &BlockParams,
        cells: &[MasonryCell],
        last: Option<Rc<WallShapes>>,
    ) -> Self {
        let fewer = fewer_steps(params, cells);
        let look = (*params, fewer, site.fit);
        let mut scene = Scene::default();
        let mortar = (params.colours.mortar(), MORTAR_ROW);
        let looks = [mortar, (BOARDS, WOOD_ROW), GLASS_LOOK];
        let recess = mortar_depth(params);
        let widest = widest(&site.building, cells, params.length);
        add_mortar(&mut scene, site, (recess, &widest), looks);
        for extra in site.building.extras() {
            add_extra(&mut scene, extra, site.fit);
        }
        Self {
            scene,
            fit: site.fit,
            params: *params,
            shapes: WallShapes::new(look),
            last: last.filter(|last| last.serve(&look)),
            dressing: Dressing {
                chamfer: params.chamfer,
                turn: Dressing::BRICK.turn * params.crooked,
                // A block that lay deeper would vanish behind the mortar.
                shift: lesser(Dressing::BRICK.shift * params.crooked, 0.5 * recess),
                seed: params.seed,
            },
            cutter: (params.rough > 0.0).then(|| Stonecutter::new(stone(params, fewer))),
            caster: Stonecutter::new(cast(params, fewer)),
            shown: 0,
        }
    }

    /// Lays the cells whose numbers are below `end`.
    pub(super) fn lay(&mut self, cells: &[MasonryCell], end: usize) {
        let numbered = (0..).zip(cells).take(end).skip(self.shown);
        for (number, cell) in numbered {
            self.add(cell, number);
        }
        self.shown = end.max(self.shown);
    }

    /// The number of cells handled so far.
    pub fn shown(&self) -> usize {
        self.shown
    }

    fn add(&mut self, cell: &MasonryCell, number: u32) {
        let mark = cell.mark();
        let key = (self.params.seed, u64::from(mark));
        let (tint, material) = self.params.colours.of_cell(cell, key, self.params.vary);
        let Some((body, place)) = self.shape(cell, mark, material) else {
            return;
        };
        self.scene.instances.push(Instance {
            body,
            place,
            id: number + 1,
            paint: Some(Paint { tint, material }),
        });
    }

    /// The number of a cell's body, and the place where it stands. `None` if the joints take all of the cell.
    fn shape(&mut self, cell: &MasonryCell, mark: u32, material: u8) -> Option<(u32, Place)> {
        let last = self.last.clone();
        let known = last
            .as_ref()
            .and_then(|last| last.block(cell, mark, material));
        let (block, shrunk) = match known {
            Some(known) => (known.clone(), None),
            None => {
                let (look, shrunk) = self.look(cell, mark, material)?;
                (ShapedBlock::new(cell, material, look), shrunk)
            }
        };
        let placed = match &block.look {
            BlockLook::Own(body) => (self.push(body.clone()), Place::default()),
            BlockLook::Shared(shape, place) => {
                let key = (shape.clone(), material);
                (self.shared_body(key, cell, shrunk)?, *place)
            }
        };
        self.shapes.add(mark, block);
        Some(placed)
    }

    /// The look of a cell's block, and the block's body without joints if that was needed. `None` if the joints take
    /// all of the cell.
    fn look(
        &mut self,
        cell: &MasonryCell,
        mark: u32,
        material: u8,
    ) -> Option<(BlockLook, Option<Polyhedron>)> {
        let cutter = match cell.body.has_rough_sides() {
            true => Some(&mut self.caster),
            false => self.cutter.as_mut().filter(|_| is_hewn(cell, material)),
        };
        if let Some(cutter) = cutter {
            let levels = cutter.levels(&cell.body, mark)?;
            let surfaces = levels.iter().map(|level| self.fit_smooth(level));
            let body = Body::new(surfaces.collect(), material);
            return Some((BlockLook::Own(body), None));
        }
        let shrunk = cell.body.shrunk()?;
        let (turn, by) = self.dressing.out_of_true(cell.outwards, mark);
        let (shape, middle, axes) = match Cuboid::of(&shrunk, cell.outwards) {
            Some(own) => (BlockShape::Cuboid(own.steps), own.middle, own.axes),
            None => {
                let own = Congruent::of(&shrunk, cell.outwards);
                (BlockShape::Other(own.steps.into()), own.middle, own.axes)
            }
        };
        let axes = axes.map(|axis| (turn * axis).as_vec3());
        let origin = self.fit.place(middle + by);
        let look = BlockLook::Shared(shape, Place { axes, origin });
        Some((look, Some(shrunk)))
    }

    /// The number of the body that all blocks of one shape and material share. The first such cell makes the body.
    fn shared_body(
        &mut self,
        key: (BlockShape, u8),
        cell: &MasonryCell,
        shrunk: Option<Polyhedron>,
    ) -> Option<u32> {
        if let Some(known) = self.shapes.shared(&key) {
            return Some(known.number);
        }
        let last = self.last.as_ref();
        let body = match last.and_then(|last| last.same_body(&key, cell)) {
            Some(body) => body.clone(),
            None => self.chamfered(&key.0.plain(cell, shrunk)?, key.1),
        };
        let number = self.push(body.clone());
        self.shapes.share(key, SharedBody::new(number, body, cell));
        Some(number)
    }

    /// The body of a shape in two levels of detail: with chamfers, and plain for far away.
    fn chamfered(&self, plain: &Polyhedron, material: u8) -> Body {
        let scale = self.fit.scale;
        let levels = [self.dressing.chamfer, 0.0].map(|chamfer| {
            flat(&Bevelled::new(plain, chamfer).facets(), |p| {
                (p * scale).as_vec3()
            })
        });
        Body::new(levels.to_vec(), material)
    }

    fn push(&mut self, body: Body) -> u32 {
        self.scene.bodies.push(body);
        self.scene.bodies.len() as u32 - 1
    }

    fn fit_smooth(&self, mesh: &BlockMesh) -> Surface {
        smooth(mesh, |p| self.fit.place(p))
    }

    /// The scene so far.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The finished scene, and the shapes of its blocks for the next wall.
    pub(super) fn finish(self) -> (Scene, Rc<WallShapes>) {
        (self.scene, Rc::new(self.shapes))
    }
}

/// A surface whose triangles have the normals of their planes. Triangles of one plane share vertices.
pub(super) fn flat(mesh: &BlockMesh, place: impl Fn(DVec3) -> Vec3) -> Surface {
    let mut surface = Surface::default();
    let mut known: BTreeMap<(u32, [i32; 3]), u32> = BTreeMap::new();
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| mesh.positions[v as usize]);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let plane = normal.to_array().map(|v| (v * SAME_PLANE).round() as i32);
        let vertex = |v: u32| {
            *known.entry((v, plane)).or_insert_with(|| {
                surface.positions.push(place(mesh.positions[v as usize]));
                surface.normals.push(normal.as_vec3());
                surface.colours.push(WHITE);
                surface.positions.len() as u32 - 1
            })
        };
        let corners = triangle.map(vertex);
        surface.triangles.push(corners);
    }
    surface
}

/// A surface with one mean normal for each vertex.
pub(super) fn smooth(mesh: &BlockMesh, place: impl Fn(DVec3) -> Vec3) -> Surface {
    Surface {
        positions: mesh.positions.iter().map(|&p| place(p)).collect(),
        normals: mesh.normals().iter().map(|n| n.as_vec3()).collect(),
        colours: vec![WHITE; mesh.positions.len()],
        triangles: mesh.triangles.clone(),
    }
}

/// How far mortar lies behind the surface (metres).
fn mortar_depth(params: &BlockParams) -> f64 {
    let sunk = match params.colours.are_stone() {
        true => SUNK * lesser(params.rough / ROUNDED, 1.0),
        false => 0.0,
    };
    greater(params.recess, sunk)
}

/// The length of the widest block on each face (metres): `length`, or more where a cell claims more of a curved face.
pub(super) fn widest(building: &Building, cells: &[MasonryCell], length: f64) -> Vec<f64> {
    let mut widest = vec![length; building.faces().len()];
    for (face, claim) in cells.iter().flat_map(|cell| &cell.claims) {
        if !building.face(*face).surface.is_flat() {
            let [low, high] = claim.bounds();
            let widest = &mut widest[face.index()];
            *widest = greater(*widest, high.x - low.x);
        }
    }
    widest
}

/// Adds the mortar, the boards of roofs, and glass, each in one colour and material. `widest` has the length of the widest
/// block on each face (metres).
pub(super) fn add_mortar(
    scene: &mut Scene,
    site: &BuildingSite,
    (recess, widest): (f64, &[f64]),
    looks: [([u8; 3], u8); 3],
) {
    let mortar = Mortar::new(&site.building, recess, |face| widest[face.index()]);
    // By rule, panes stand before the faces of glass. A building from a file may have the faces alone.
    let has_extras = !site.building.extras().is_empty();
    let look_of = |face: FaceId| {
        let face = site.building.face(face);
        if face.has_label(ROOF) {
            1
        } else if face.has_label(GLASS) && !has_extras {
            2
        } else {
            0
        }
    };
    for (number, (tint, material)) in looks.into_iter().enumerate() {
        let own = mortar.triangles.iter().zip(&mortar.faces);
        let own = own.filter(|&(_, &face)| look_of(face) == number);
        let mesh = BlockMesh {
            positions: mortar.positions.clone(),
            triangles: own.map(|(&triangle, _)| triangle).collect(),
        };
        if !mesh.triangles.is_empty() {
            let surface = flat(&mesh, |p| site.fit.place(p));
            add_plain(scene, surface, (0, tint, material));
        }
    }
}

/// Adds a mesh that carries no masonry, in the colour of its material.
fn add_extra(scene: &mut Scene, extra: &ExtraMesh, fit: Fit) {
    let (tint, material) = match extra.material.as_str() {
        "glass" => GLASS_LOOK,
        "iron" => ([62, 62, 66], IRON_ROW),
        "slate" | "tile" => ([92, 94, 100], STONE_ROW),
        "stone" => ([196, 188, 170], STONE_ROW),
        "brick" => ([150, 80, 60], BRICK_ROW),
        "paint" => ([196, 192, 182], WOOD_ROW),
        _ => ([96, 66, 42], WOOD_ROW),
    };
    let mesh = BlockMesh {
        positions: extra.positions.clone(),
        triangles: extra.triangles.clone(),
    };
    add_plain(scene, flat(&mesh, |p| fit.place(p)), (0, tint, material));
}

/// The surface of a body without chamfers, with its vertices placed by `place`.
pub(super) fn plain(body: &Polyhedron, place: impl Fn(DVec3) -> Vec3) -> Surface {
    flat(&Bevelled::new(body, 0.0).facets(), place)
}
