//! Stones in number: the weights of each connectivity are worked out once and kept.

use super::control;
use super::footprint::{Footprint, MOST_CORNERS};
use super::subdivide::Stencil;
use super::{StoneParams, TriangleMesh};
use crate::cells::Cell;
use glam::{DVec2, Vec3};
use std::rc::Rc;

/// At most so many Loop steps.
pub const MOST_LEVELS: u32 = 5;

/// Triangles of a stone for a pixel of its area; nearly half of them stand in its walls.
const TRIANGLES_PER_PIXEL: f64 = 1.2;

/// A stone: its surface from the base up, open below.
#[derive(Clone, Debug)]
pub struct Solid {
    /// x, y and height above the base level, in picture units.
    pub vertices: Vec<Vec3>,
    /// Triangles, clockwise on screen seen from above; shared by all stones of one connectivity.
    pub triangles: Rc<[[u32; 3]]>,
}

impl Solid {
    fn empty() -> Self {
        Self {
            vertices: Vec::new(),
            triangles: Rc::new([]),
        }
    }
}

/// Makes stones, and keeps the subdivision weights of each number of corners and level.
#[derive(Debug, Default)]
pub struct Quarry {
    /// By corners, then level.
    stencils: Vec<Option<Rc<Stencil>>>,
}

impl Quarry {
    /// A quarry that has made no stone yet.
    pub fn new() -> Self {
        Self {
            stencils: vec![None; (MOST_CORNERS + 1) * (MOST_LEVELS as usize + 1)],
        }
    }

    /// The weights of `levels` Loop steps on the control mesh of a stone with `corners` corners.
    pub fn stencil(&mut self, corners: usize, levels: u32) -> Rc<Stencil> {
        let (corners, levels) = (corners.clamp(3, MOST_CORNERS), levels.min(MOST_LEVELS));
        let slot = corners * (MOST_LEVELS as usize + 1) + levels as usize;
        if self.stencils.len() <= slot {
            *self = Self::new();
        }
        let made = || {
            let triangles = control::triangles(corners);
            Rc::new(Stencil::new(
                control::point_count(corners),
                &triangles,
                levels,
            ))
        };
        self.stencils[slot].get_or_insert_with(made).clone()
    }

    /// The stone of a cell, empty where the cell has no area to speak of. It lies inside the cell's
    /// ring, or inside the ring enlarged by the scale where that is above 1.
    pub fn stone(&mut self, cell: &Cell, params: &StoneParams) -> Solid {
        let Some(plan) = Footprint::new(&cell.ring, cell.centre) else {
            return Solid::empty();
        };
        let points = control::points(&plan, params, cell.id);
        let levels = levels(&plan, params.scale);
        let stencil = self.stencil(plan.corners.len(), levels);
        let mut vertices = stencil.apply(&points);
        if !plan.convex {
            keep_in(&plan, params, &mut vertices);
        }
        Solid {
            vertices,
            triangles: stencil.triangles.clone(),
        }
    }

    /// The control mesh a stone is refined from; None where the cell has no area to speak of.
    pub fn control_mesh(cell: &Cell, params: &StoneParams) -> Option<TriangleMesh> {
        let plan = Footprint::new(&cell.ring, cell.centre)?;
        Some(TriangleMesh {
            vertices: control::points(&plan, params, cell.id),
            triangles: control::triangles(plan.corners.len()),
        })
    }
}

/// Smoothing fills the inner side of a reflex corner: there vertices are drawn back.
fn keep_in(plan: &Footprint, params: &StoneParams, vertices: &mut [Vec3]) {
    for v in vertices {
        let p = DVec2::new(f64::from(v.x), f64::from(v.y));
        let q = plan.kept_in(p, params.scale.max(1.0));
        (v.x, v.y) = (q.x as f32, q.y as f32);
    }
}

/// Steps until a triangle has about a pixel's area.
fn levels(plan: &Footprint, scale: f64) -> u32 {
    let wanted = TRIANGLES_PER_PIXEL * plan.size * plan.size * scale * scale;
    let mut triangles = control::triangle_count(plan.corners.len()) as f64;
    let mut levels = 0;
    while triangles < wanted && levels < MOST_LEVELS {
        triangles *= 4.0;
        levels += 1;
    }
    levels
}
