//! Degrees of detail that all stones of one connectivity share.
//!
//! Stones with the same number of corners have the same triangles, and are alike. So which vertices the coarser degrees
//! keep is found out once, on a stone over a regular polygon, bent as the surface is on average ([`simplify`]), once where
//! that bulges and once in hollows, where coarse triangles would else lie in front of fine ones; a stone takes its own vertices there, and its normals and colours from the finest mesh.

use super::Bend;
use crate::cells::Cell;
use crate::solid::{
    Footprint, Solid, Solids, StoneParams, Surface, boundary_edges, levels, simplify, used,
};
use glam::{DVec2, Vec3};
use std::f64::consts::TAU;
use std::rc::Rc;

/// Fewer triangles than this are no stone any more.
const LEAST: usize = 16;
/// Triangles before the finest degree is taken from them, of what that has.
const BEFORE: f64 = 1.3;

/// The degrees of stones of one connectivity.
#[derive(Debug)]
pub(super) struct Template {
    /// Edges of the open base.
    pub boundary: Vec<[u32; 2]>,
    pub levels: Vec<Level>,
}

/// A degree of detail.
#[derive(Debug)]
pub(super) struct Level {
    /// The vertices that it keeps.
    pub kept: Vec<u32>,
    /// By their places among those.
    pub triangles: Vec<[u32; 3]>,
}

/// Makes the degrees of each connectivity when it is first met.
#[derive(Debug)]
pub(super) struct Templates {
    solids: Solids,
    stone: StoneParams,
    /// Triangles at the finest degree.
    most: usize,
    /// How curved cells are on average, whichever way, for each picture unit.
    curvature: f64,
    /// The lowest height that is seen.
    floor: f32,
    /// By twice the corners, and one more in hollows.
    made: Vec<Option<Rc<Template>>>,
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

    /// The solid of a cell, which lies in a hollow or does not, and its degrees; none where the cell has no area to
    /// speak of.
    pub fn solid(
        &mut self,
        cell: &Cell,
        stone: &StoneParams,
        is_hollow: bool,
    ) -> Option<(Solid, Rc<Template>)> {
        let corners = Footprint::new(&cell.ring, cell.centre)?.corners.len();
        let coarse = match stone.kind {
            crate::solid::StoneKind::Skin => 3 * corners,
            _ => 27 * corners,
        };
        let wanted = BEFORE * self.most as f64;
        let mut level = 0;
        while ((coarse << (2 * level)) as f64) < wanted {
            level += 1;
        }
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
    ) -> Template {
        let mut stone = self.stone;
        (stone.distortion, stone.skin.amplitude) = (0.0, 0.0);
        let regular = regular(cell, corners);
        let solid = self.solids.solid_of_level(&regular, &stone, level);
        let solid = match solid.vertices.len() == own.vertices.len() {
            true => &solid,
            false => own,
        };
        let boundary = boundary_edges(&solid.triangles, solid.vertices.len());
        let mut bend = Bend::new(&[], &[], &[]);
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
            Level { kept, triangles }
        };
        Template {
            boundary,
            levels: levels(self.most, LEAST).map(level).collect(),
        }
    }
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
