//! Stones in number: the weights of each connectivity are worked out once and kept.

use super::footprint::{Footprint, MOST_CORNERS};
use super::subdivide::{Growing, Stencil};
use super::{Prism, StoneKind, StoneParams, TriangleMesh};
use super::{control, hide, prism};
use crate::cells::Cell;
use glam::{DVec2, Vec3};
use std::rc::Rc;

/// At most so many Loop steps.
pub const MOST_LEVELS: u32 = 8;

/// Triangles of a stone for a pixel of its area; nearly half of them stand in its walls.
const STONE_TRIANGLES: f64 = 1.2;
/// Loop steps of a stone at most: its control mesh is fine.
const STONE_LEVELS: u32 = 5;
/// Triangles of a cell of skin for a pixel of its prism's surface, at least. Finer ones change
/// nothing that can be seen.
const SKIN_TRIANGLES: f64 = 0.9;

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

/// The refinement of one connectivity.
#[derive(Debug)]
struct Pattern {
    stencil: Stencil,
    /// Of skin, how far from the middle each vertex is: see [`prism::radii`].
    radii: Vec<f32>,
}

/// Makes stones, and keeps the subdivision weights of each number of corners and level.
#[derive(Debug)]
pub struct Quarry {
    /// By corners, then level; stones first, then skin.
    patterns: Vec<Option<Rc<Pattern>>>,
    /// The one in the making, for this place.
    growing: Option<(usize, Growing)>,
    /// Loop steps of skin more than a picture needs, or fewer.
    finer: i32,
    /// Pixels for each square picture unit.
    pixels: f64,
}

/// Rows of a connectivity's weights that are worked out in one slice.
const ROWS: usize = 12_000;

const SLOTS: usize = (MOST_CORNERS + 1) * (MOST_LEVELS as usize + 1);

impl Default for Quarry {
    fn default() -> Self {
        Self::new()
    }
}

impl Quarry {
    /// A quarry that has made no stone yet.
    pub fn new() -> Self {
        Self::for_picture(1, 0)
    }

    /// A quarry for pictures with `fine` pixels for each picture unit, along a side. Skin has `finer`
    /// Loop steps more than such a picture needs, or below 0 fewer.
    pub fn for_picture(fine: usize, finer: i32) -> Self {
        Self {
            patterns: vec![None; 2 * SLOTS],
            growing: None,
            finer,
            pixels: (fine * fine) as f64,
        }
    }

    /// The refinement of a connectivity; nothing while it takes more than this slice of work.
    fn pattern(&mut self, skin: bool, corners: usize, levels: u32) -> Option<Rc<Pattern>> {
        let slot = corners * (MOST_LEVELS as usize + 1) + levels as usize;
        let slot = slot + if skin { SLOTS } else { 0 };
        if let Some(pattern) = &self.patterns[slot] {
            return Some(pattern.clone());
        }
        let begun = self.growing.take().filter(|&(at, _)| at == slot);
        let (_, mut growing) = begun.unwrap_or_else(|| {
            let (points, triangles) = match skin {
                true => (prism::point_count(corners), prism::triangles(corners)),
                false => (control::point_count(corners), control::triangles(corners)),
            };
            (slot, Growing::new(points, triangles, levels, skin))
        });
        if !growing.advance(ROWS) {
            self.growing = Some((slot, growing));
            return None;
        }
        let stencil = growing.finish();
        let radii = match skin {
            true => stencil.apply(&prism::radii(corners)),
            false => Vec::new(),
        };
        let radii = radii.iter().map(|r| r.x).collect();
        let pattern = Rc::new(Pattern { stencil, radii });
        let large = pattern.stencil.len() > ROWS;
        self.patterns[slot] = Some(pattern.clone());
        (!large).then_some(pattern)
    }

    /// The stone of a cell, empty where the cell has no area to speak of. Stones lie inside the
    /// cell's ring, or inside the ring enlarged by the scale where that is above 1. Skin leans along
    /// the cell's axis: see [`super::oriented`].
    pub fn stone(&mut self, cell: &Cell, params: &StoneParams) -> Solid {
        loop {
            if let Some(solid) = self.stone_or_slice(cell, params) {
                return solid;
            }
        }
    }

    /// The same, or nothing where only a slice of the work on its connectivity could be done.
    pub fn stone_or_slice(&mut self, cell: &Cell, params: &StoneParams) -> Option<Solid> {
        let Some(plan) = Footprint::new(&cell.ring, cell.centre) else {
            return Some(Solid::empty());
        };
        match params.kind {
            StoneKind::Skin => self.skin(&plan, params, cell),
            _ => self.hewn(&plan, params, cell.id),
        }
    }

    fn hewn(&mut self, plan: &Footprint, params: &StoneParams, id: u32) -> Option<Solid> {
        let corners = plan.corners.len();
        let points = control::points(plan, params, id);
        let area = plan.size * plan.size * params.scale * params.scale;
        let wanted = STONE_TRIANGLES * self.pixels * area;
        let levels = levels(control::triangle_count(corners), wanted).min(STONE_LEVELS);
        let pattern = self.pattern(false, corners, levels)?;
        let mut vertices = pattern.stencil.apply(&points);
        if !plan.convex {
            keep_in(plan, params, &mut vertices);
        }
        Some(Solid {
            vertices,
            triangles: pattern.stencil.triangles.clone(),
        })
    }

    /// Itoh, Miyata, Shimada (2003), section 6: prism, subdivision, noise.
    fn skin(&mut self, plan: &Footprint, params: &StoneParams, cell: &Cell) -> Option<Solid> {
        let (flow, id) = (cell.axis, cell.id);
        let corners = plan.corners.len();
        let prism = Prism::over(plan, flow, params, id);
        let coarse = prism::triangle_count(corners);
        let needed = levels(coarse, SKIN_TRIANGLES * self.pixels * prism.area());
        let finer = needed.saturating_add_signed(self.finer).min(MOST_LEVELS);
        let pattern = self.pattern(true, corners, finer)?;
        let (stencil, radii) = (&pattern.stencil, &pattern.radii);
        let control = prism.points();
        let mut vertices = stencil.apply(&control);
        hide::flatten(&mut vertices, stencil, &control, params.skin.flatness);
        let place = (&prism, plan.centre, flow);
        hide::shape(&mut vertices, radii, place, &params.skin);
        let size = prism.skin_size;
        hide::roughen(&mut vertices, radii, (stencil, needed), (size, id), params);
        Some(Solid {
            vertices,
            triangles: stencil.triangles.clone(),
        })
    }

    /// The control mesh a stone is refined from; None where the cell has no area to speak of.
    pub fn control_mesh(cell: &Cell, params: &StoneParams) -> Option<TriangleMesh> {
        let plan = Footprint::new(&cell.ring, cell.centre)?;
        let corners = plan.corners.len();
        Some(match params.kind {
            StoneKind::Skin => TriangleMesh {
                vertices: Prism::over(&plan, cell.axis, params, cell.id).points(),
                triangles: prism::triangles(corners),
            },
            _ => TriangleMesh {
                vertices: control::points(&plan, params, cell.id),
                triangles: control::triangles(corners),
            },
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

/// Loop steps until `triangles` have become as many as are wanted.
fn levels(triangles: usize, wanted: f64) -> u32 {
    let mut triangles = triangles as f64;
    let mut levels = 0;
    while triangles < wanted && levels < MOST_LEVELS {
        triangles *= 4.0;
        levels += 1;
    }
    levels
}
