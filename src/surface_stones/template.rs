//! Levels of detail that all stones with one number of corners share.
//!
//! Stones with the same number of corners have the same triangles, and are alike. So it is enough to find once which
//! vertices the coarser levels keep ([`simplify`]): on a stone over a regular polygon, bent by the mean curvature of
//! the surface. There are two such templates, for humps and for hollows: in a hollow the coarse triangles of a hump
//! would cover fine ones. A stone uses its own vertices, and takes normals and colours from the finest mesh.

use super::QuadricPatch;
use crate::cells::Cell;
use crate::solid::{
    Footprint, Solid, Solids, StoneKind, StoneParams, Surface, boundary_edges, levels, simplify,
    used,
};
use glam::{DVec2, Vec3};
use std::f64::consts::TAU;
use std::rc::Rc;

/// A stone has at least this many triangles.
const LEAST: usize = 16;
/// The ratio of the solid's triangles to those of the finest level, which is simplified from the solid.
const BEFORE: f64 = 1.3;

/// The levels of stones with one number of corners.
#[derive(Debug)]
pub(super) struct SharedLevels {
    /// Edges of the open base.
    pub boundary: Vec<[u32; 2]>,
    pub levels: Vec<StoneLevel>,
}

/// A level of detail.
#[derive(Debug)]
pub(super) struct StoneLevel {
    /// The vertices that it keeps, as indices into the solid's vertices.
    pub kept: Vec<u32>,
    /// Its triangles, as indices into `kept`.
    pub triangles: Vec<[u32; 3]>,
}

/// Makes the levels for each number of corners on first use.
#[derive(Debug)]
pub(super) struct Templates {
    solids: Solids,
    stone: StoneParams,
    /// Triangles of the finest level.
    most: usize,
    /// The mean curvature of cells, without sign, in one over picture units.
    curvature: f64,
    /// The lowest height that is visible.
    floor: f32,
    /// Templates at index twice the number of corners, plus one for hollows.
    made: Vec<Option<Rc<SharedLevels>>>,
}

impl Templates {
    pub fn new(stone: StoneParams, most: usize, curvature: f64, floor: f32) -> Self {
        Self {
            solids: Solids::new(),
            stone,
            most,
            curvature,
            floor,
            made: Vec::new(),
        }
    }

    /// The solid of a cell with its levels. Nothing if the cell has next to no area.
    pub fn solid(
        &mut self,
        cell: &Cell,
        stone: &StoneParams,
        is_hollow: bool,
    ) -> Option<(Solid, Rc<SharedLevels>)> {
        let corners = Footprint::new(&cell.ring, cell.centre)?.corners.len();
        let level = loop_steps(stone.kind, corners, self.most);
        let solid = self.solids.solid_of_level(cell, stone, level);
        if solid.vertices.is_empty() {
            return None;
        }
        let place = 2 * corners + usize::from(is_hollow);
        self.made.resize(self.made.len().max(place + 1), None);
        if let Some(template) = &self.made[place] {
            return Some((solid, template.clone()));
        }
        let curvature = if is_hollow {
            -self.curvature
        } else {
            self.curvature
        };
        let template = Rc::new(self.template(cell, (corners, &solid), level, curvature));
        self.made[place] = Some(template.clone());
        Some((solid, template))
    }

    fn template(
        &mut self,
        cell: &Cell,
        (corners, own): (usize, &Solid),
        level: u32,
        curvature: f64,
    ) -> SharedLevels {
        let mut stone = self.stone;
        (stone.distortion, stone.skin.amplitude) = (0.0, 0.0);
        let regular = regular(cell, corners);
        let solid = self.solids.solid_of_level(&regular, &stone, level);
        let solid = match solid.vertices.len() == own.vertices.len() {
            true => &solid,
            false => own,
        };
        let boundary = boundary_edges(&solid.triangles, solid.vertices.len());
        let mut bend = QuadricPatch::new(&[], &[], &[]);
        bend.shape = [curvature, 0.0, curvature];
        let bent = |p: &Vec3| bend.bent(p.as_dvec3()).as_vec3();
        let mut surface = Surface {
            positions: solid.vertices.clone(),
            colours: vec![[0; 3]; solid.vertices.len()],
            triangles: solid.triangles.to_vec(),
            ..Surface::default()
        };
        surface.cap(&boundary);
        let positions: Vec<Vec3> = surface.positions.iter().map(bent).collect();
        let mut triangles = surface.triangles;
        let level = |most: usize| {
            simplify(&positions, &mut triangles, most, self.floor);
            triangles.retain(|t| t[0] != t[1]);
            let (kept, triangles) = used(&triangles, positions.len());
            StoneLevel { kept, triangles }
        };
        SharedLevels {
            boundary,
            levels: levels(self.most, LEAST).map(level).collect(),
        }
    }
}

/// The number of Loop steps of a solid with this number of corners. `most` is the number of triangles of the finest
/// level, which is simplified from the solid.
pub(super) fn loop_steps(kind: StoneKind, corners: usize, most: usize) -> u32 {
    let coarse = match kind {
        StoneKind::Skin => 3 * corners,
        _ => 27 * corners,
    };
    let wanted = BEFORE * most as f64;
    let mut level = 0;
    while ((coarse << (2 * level)) as f64) < wanted {
        level += 1;
    }
    level
}

/// A regular polygon as long and wide as a cell.
fn regular(cell: &Cell, corners: usize) -> Cell {
    let turn = TAU / corners as f64;
    let stretch = cell.aspect.max(1e-3).sqrt();
    let radius = cell.size * (2.0 / (corners as f64 * libm::sin(turn))).sqrt();
    let corner = |k: usize| {
        let angle = (k as f64 + 0.5) * turn;
        radius * DVec2::new(libm::cos(angle) * stretch, libm::sin(angle) / stretch)
    };
    Cell {
        ring: (0..corners).map(corner).collect(),
        axis: DVec2::X,
        ..cell.clone()
    }
}
