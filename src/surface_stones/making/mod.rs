//! The steps of making a stone on a surface, as surfaces that can be drawn.
//!
//! The polygon of a cell is laid into its tangent plane. The steps of the plane follow there
//! ([`crate::solid::steps_to`]). Then the level of detail keeps some of the triangles, and the stone is bent back
//! onto the surface. Each step is made by the code that makes the stone itself. The finished stone is that of the
//! scene, and has no shape here.
//!
//! All shapes are in the axes and units of a picture, as those of the steps in a plane. The height `anchor` of the bend
//! lies on the surface.

#[cfg(test)]
mod tests;

use super::build::most_triangles;
use super::maker::{FlatStone, Maker, leans_out, own_params};
use super::template::loop_steps;
use super::{Paving, StonesParams, UnfoldedCell};
use crate::solid::{
    Footprint, Making, PLAIN, Solids, StoneKind, Surface, normals, step_to, steps_to,
};
use crate::surface_cells::SurfaceCell;
use glam::{DVec3, Vec3};

/// The colour of neighbours: red, green, blue.
const BESIDE: [u8; 3] = [150, 147, 140];
/// Thickness of polygons, in sizes of the cell.
const PLATE: f64 = 0.03;

/// A step in the making of a stone on a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StoneStep {
    /// The cell's polygon on the surface, between those of its neighbours.
    Cell,
    /// The polygon in its tangent plane.
    Plane,
    /// A step of the plane, in the tangent plane.
    Solid(Making),
    /// The triangles of the finest level of detail.
    Kept,
    /// The stone, bent onto the surface.
    Bent,
    /// The finished stone of the scene.
    Finish,
}

impl StoneStep {
    /// The word for it, such as `bent` or `loop2`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Cell => "cell",
            Self::Plane => "plane",
            Self::Solid(making) => making.word(),
            Self::Kept => "kept",
            Self::Bent => "bent",
            Self::Finish => Making::Finish.word(),
        }
    }
}

/// The state of a stone after a step.
#[derive(Clone, Debug)]
pub struct StepShape {
    /// Its cell in the tangent plane; the bend is that of the stone.
    pub flat: UnfoldedCell,
    /// Closed surfaces; empty for [`StoneStep::Finish`].
    pub surface: Surface,
    /// Lines to draw over the surface.
    pub edges: Vec<[Vec3; 2]>,
}

/// The steps in the making of the stone of cell `k`, in order; empty if it has no appreciable area.
pub fn steps(params: &StonesParams, paving: Paving, k: usize) -> Vec<StoneStep> {
    let Some(last) = last_level(params, paving, k) else {
        return Vec::new();
    };
    let stone = &params.texture.stone;
    let mut solid = steps_to(stone, last);
    if stone.kind != StoneKind::Skin {
        solid.push(Making::Noise);
    }
    let flat = solid.into_iter().map(StoneStep::Solid);
    let begin = [StoneStep::Cell, StoneStep::Plane].into_iter();
    let end = [StoneStep::Kept, StoneStep::Bent, StoneStep::Finish];
    begin.chain(flat).chain(end).collect()
}

/// One of these [`steps`]; `None` if the stone has no such step.
pub fn step(params: &StonesParams, paving: Paving, k: usize, step: StoneStep) -> Option<StepShape> {
    let last = last_level(params, paving, k)?;
    let cell = paving.cells.get(k)?;
    let leans_out = leans_out(cell, linked(paving, k), paving.cells);
    let mut maker = primed(params, paving, k)?;
    let coat = paving.coats.get(k).copied().unwrap_or_default();
    let made = maker.flat_stone(cell, coat, leans_out)?;
    let is_skin = params.texture.stone.kind == StoneKind::Skin;
    let (surface, edges) = match step {
        StoneStep::Cell | StoneStep::Plane => {
            let mut plates = Plates::beside(&made.flat, paving, k);
            match step {
                StoneStep::Cell => plates.add_on_surface(&made.flat, cell, PLAIN),
                _ => plates.add_flat(&made.flat, cell),
            }
            (plates.facets.surface, plates.edges)
        }
        StoneStep::Solid(Making::Noise) if !is_skin => (rough(&made), Vec::new()),
        StoneStep::Solid(making) => {
            let own = own_params(&params.texture.stone, leans_out);
            let making = (making, last);
            let step = step_to(&mut Solids::new(), &made.flat.cell, &own, making)?;
            (step.surface, step.edges)
        }
        StoneStep::Kept => kept(&made)?,
        StoneStep::Bent => {
            let mut plates = Plates::beside(&made.flat, paving, k);
            // Stones lie below the level of the polygons, which would hide them.
            if !is_skin {
                plates.facets = Facets::default();
            }
            append(&mut plates.facets.surface, bent(&made)?);
            (plates.facets.surface, plates.edges)
        }
        StoneStep::Finish => Default::default(),
    };
    Some(StepShape {
        flat: made.flat,
        surface,
        edges,
    })
}

/// A maker with the template that all stones of this sort share ([`sort_of`]). As in the scene, the first of these
/// stones makes it.
fn primed(params: &StonesParams, paving: Paving, k: usize) -> Option<Maker> {
    let cells = paving.cells;
    let mut maker = Maker::new(params, cells, most_triangles(cells.len()));
    let own = sort_of(params, &cells[k])?;
    let mut before = cells[..k].iter();
    let first = before.position(|cell| sort_of(params, cell) == Some(own));
    if let Some(first) = first {
        let leans_out = leans_out(&cells[first], linked(paving, first), cells);
        maker.flat_stone(&cells[first], Default::default(), leans_out)?;
    }
    Some(maker)
}

/// The number of corners of a cell's base, and whether the surface is hollow there.
fn sort_of(params: &StonesParams, cell: &SurfaceCell) -> Option<(usize, bool)> {
    let flat = UnfoldedCell::new(cell, params.unit);
    let corners = Footprint::new(&flat.cell.ring, flat.cell.centre)?
        .corners
        .len();
    Some((corners, flat.bend.is_hollow()))
}

/// The number of Loop steps of the stone of cell `k`.
fn last_level(params: &StonesParams, paving: Paving, k: usize) -> Option<u32> {
    let (corners, _) = sort_of(params, paving.cells.get(k)?)?;
    let most = most_triangles(paving.cells.len());
    Some(loop_steps(params.texture.stone.kind, corners, most))
}

fn linked(paving: Paving<'_>, k: usize) -> &[u32] {
    paving.links.get(k).map_or(&[], Vec::as_slice)
}

/// The stone with the relief, in its plane.
fn rough(made: &FlatStone) -> Surface {
    let mut surface = made.surface.clone();
    surface.normals = normals(&surface.positions, &made.walls);
    surface.colours = vec![PLAIN; surface.positions.len()];
    surface
}

/// The finest level of detail in its plane, with the edges of its triangles.
fn kept(made: &FlatStone) -> Option<(Surface, Vec<[Vec3; 2]>)> {
    let level = made.template.levels.first()?;
    let at = |v: u32| made.surface.positions[level.kept[v as usize] as usize];
    let (mut facets, mut edges) = (Facets::default(), Vec::new());
    for &[a, b, c] in &level.triangles {
        facets.add([a, b, c].map(at), PLAIN);
        // The surface is closed, so each edge comes in both directions.
        let sides = [[a, b], [b, c], [c, a]].into_iter();
        edges.extend(sides.filter(|[a, b]| a < b).map(|ends| ends.map(at)));
    }
    Some((facets.surface, edges))
}

/// The finest level of detail on the surface.
fn bent(made: &FlatStone) -> Option<Surface> {
    let level = made.template.levels.first()?;
    let bend = &made.flat.bend;
    let points = made.surface.positions.iter();
    let bent: Vec<Vec3> = points
        .map(|p| (bend.bent(p.as_dvec3()) + DVec3::Z * bend.anchor).as_vec3())
        .collect();
    let normals = normals(&bent, &made.walls);
    let kept = || level.kept.iter().map(|&v| v as usize);
    Some(Surface {
        positions: kept().map(|v| bent[v]).collect(),
        normals: kept().map(|v| normals[v]).collect(),
        colours: vec![PLAIN; level.kept.len()],
        triangles: level.triangles.clone(),
    })
}

/// Polygons as thin plates, with lines along their sides.
#[derive(Default)]
struct Plates {
    facets: Facets,
    edges: Vec<[Vec3; 2]>,
}

impl Plates {
    /// The polygons of the neighbours of cell `k`, on the surface.
    fn beside(flat: &UnfoldedCell, paving: Paving, k: usize) -> Self {
        let mut plates = Self::default();
        for &other in linked(paving, k) {
            plates.add_on_surface(flat, &paving.cells[other as usize], BESIDE);
        }
        plates
    }

    fn add_on_surface(&mut self, flat: &UnfoldedCell, cell: &SurfaceCell, colour: [u8; 3]) {
        let local = |v: DVec3| DVec3::from(flat.axes.map(|axis| axis.dot(v)));
        let down = local(cell.centre.normal) * (-PLATE * flat.cell.size);
        let middle = seen(flat, cell.centre.at);
        self.add(&ring(flat, cell), middle, down.as_vec3(), colour);
    }

    /// The polygon in its plane, and lines that join its corners to the corners on the surface.
    fn add_flat(&mut self, flat: &UnfoldedCell, cell: &SurfaceCell) {
        let high = flat.bend.anchor;
        let corners = flat.cell.ring.iter();
        let plane: Vec<Vec3> = corners.map(|p| p.extend(high).as_vec3()).collect();
        let down = Vec3::NEG_Z * (PLATE * flat.cell.size) as f32;
        self.add(&plane, Vec3::Z * high as f32, down, PLAIN);
        let on_surface = ring(flat, cell);
        self.edges.extend(around(&on_surface));
        let both = on_surface.iter().zip(&plane);
        self.edges.extend(both.map(|(&a, &b)| [a, b]));
    }

    fn add(&mut self, ring: &[Vec3], middle: Vec3, down: Vec3, colour: [u8; 3]) {
        for [a, b] in around(ring) {
            let [low_a, low_b] = [a, b].map(|p| p + down);
            self.facets.add([middle, a, b], colour);
            self.facets.add([middle + down, low_b, low_a], colour);
            self.facets.add([a, low_a, low_b], colour);
            self.facets.add([a, low_b, b], colour);
            self.edges.push([a, b]);
        }
    }
}

/// A place of the model, in the axes and units of the picture.
fn seen(flat: &UnfoldedCell, at: DVec3) -> Vec3 {
    let from = flat.axes.map(|axis| axis.dot(at - flat.at) * flat.unit);
    (DVec3::from(from) + DVec3::Z * flat.bend.anchor).as_vec3()
}

/// The corners of a cell on the surface, in the order of a picture.
fn ring(flat: &UnfoldedCell, cell: &SurfaceCell) -> Vec<Vec3> {
    cell.ring.iter().rev().map(|&p| seen(flat, p)).collect()
}

fn around(ring: &[Vec3]) -> impl Iterator<Item = [Vec3; 2]> {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(&a, &b)| [a, b])
}

/// Flat triangles with separate corners, without degenerate ones.
#[derive(Default)]
struct Facets {
    surface: Surface,
}

impl Facets {
    fn add(&mut self, [a, b, c]: [Vec3; 3], colour: [u8; 3]) {
        let Some(normal) = (b - a).cross(c - a).try_normalize() else {
            return;
        };
        let corner = Surface {
            positions: vec![a, b, c],
            normals: vec![normal; 3],
            colours: vec![colour; 3],
            triangles: vec![[0, 1, 2]],
        };
        append(&mut self.surface, corner);
    }
}

fn append(surface: &mut Surface, other: Surface) {
    let first = surface.positions.len() as u32;
    let triangles = other.triangles.iter().map(|t| t.map(|v| v + first));
    surface.triangles.extend(triangles);
    surface.positions.extend(other.positions);
    surface.normals.extend(other.normals);
    surface.colours.extend(other.colours);
}
