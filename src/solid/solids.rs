//! From cells to solids: control meshes, refined by stencils.

use super::footprint::Footprint;
use super::stencil_cache::{MOST_LEVELS, StencilCache};
use super::{Prism, Solid, StoneKind, StoneParams};
use super::{control, displacement, prism};
use crate::cells::Cell;
use glam::{DVec2, Vec3};

/// Triangles of a stone for each pixel of its area; nearly half of them are in its walls.
const STONE_TRIANGLES: f64 = 1.2;
/// Most Loop steps of a stone: its control mesh is already fine.
const STONE_LEVELS: u32 = 5;
/// Fewest triangles of a cell of skin for each pixel of its prism's surface. Finer ones make no visible
/// difference.
const SKIN_TRIANGLES: f64 = 0.9;
/// Fewest triangles of the last Loop step shown, and of a large cell's.
const SHOWN: [f64; 2] = [3000.0, 12_000.0];

/// Makes the solids of cells, and caches the stencils they share.
#[derive(Debug)]
pub struct Solids {
    stencils: StencilCache,
    /// Additional Loop steps of skin beyond a picture's needs.
    finer: i32,
    /// Pixels for each square picture unit.
    pixels: f64,
    /// Sufficient number of triangles for each solid, if it does not depend on the picture.
    enough: Option<usize>,
    /// Exact number of Loop steps, overriding everything else.
    exactly: Option<u32>,
}

impl Default for Solids {
    fn default() -> Self {
        Self::new()
    }
}

impl Solids {
    /// Solids for pictures with a pixel for each picture unit.
    pub fn new() -> Self {
        Self::for_picture(1, 0)
    }

    /// Solids for pictures with `pixel_scale` pixels for each picture unit, along a side. Skin has `finer`
    /// Loop steps more than such a picture needs, or fewer if negative.
    pub fn for_picture(pixel_scale: usize, finer: i32) -> Self {
        Self {
            stencils: StencilCache::new(),
            finer,
            pixels: (pixel_scale * pixel_scale) as f64,
            enough: None,
            exactly: None,
        }
    }

    /// Solids that will be simplified to this number of triangles. They have at least twice as many, or as
    /// many as a picture with a pixel for each picture unit needs, but never fewer than requested.
    pub fn to_simplify(triangles: usize) -> Self {
        Self {
            enough: Some(triangles),
            ..Self::new()
        }
    }

    /// Loop steps for a control mesh, if a picture needs `needed`.
    fn steps(&self, control: usize, needed: u32) -> u32 {
        if let Some(exactly) = self.exactly {
            return exactly;
        }
        let Some(enough) = self.enough else {
            return needed;
        };
        let steps = |triangles: usize| levels(control, triangles as f64);
        steps(2 * enough).min(needed.max(steps(enough)))
    }

    /// The solid of a cell, empty if the cell has no appreciable area. Stones lie inside the cell's ring, or
    /// if the scale is above 1 inside the ring enlarged by it. Skin leans along the cell's axis: see
    /// [`super::oriented`].
    pub fn solid(&mut self, cell: &Cell, params: &StoneParams) -> Solid {
        loop {
            if let Some(solid) = self.solid_or_slice(cell, params) {
                return solid;
            }
        }
    }

    /// The same after exactly `level` Loop steps, at most [`MOST_LEVELS`]. Noise of skin ends at the level of
    /// the solid that a picture needs.
    pub fn solid_of_level(&mut self, cell: &Cell, params: &StoneParams, level: u32) -> Solid {
        self.exactly = Some(level.min(MOST_LEVELS));
        let solid = self.solid(cell, params);
        self.exactly = None;
        solid
    }

    /// The solid of a cell, or `None` if only a slice of the work on its stencil was done.
    pub fn solid_or_slice(&mut self, cell: &Cell, params: &StoneParams) -> Option<Solid> {
        let Some(plan) = Footprint::new(&cell.ring, cell.centre) else {
            return Some(Solid::default());
        };
        match params.kind {
            StoneKind::Skin => self.skin(&plan, params, cell),
            _ => self.stone(&plan, params, cell.id),
        }
    }

    fn stone(&mut self, plan: &Footprint, params: &StoneParams, id: u32) -> Option<Solid> {
        let corners = plan.corners.len();
        let points = control::points(plan, params, id);
        let wanted = STONE_TRIANGLES * self.pixels * area(plan, params);
        let coarse = control::triangle_count(corners);
        let levels = self.steps(coarse, levels(coarse, wanted).min(STONE_LEVELS));
        let refinement = self.stencils.get(false, corners, levels)?;
        let stencil = &refinement.stencil;
        let mut vertices = stencil.apply(&points);
        if !plan.convex {
            keep_in(plan, params, &mut vertices);
        }
        Some(Solid {
            vertices,
            triangles: stencil.triangles.clone(),
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
        let finer = self.steps(coarse, finer);
        let refinement = self.stencils.get(true, corners, finer)?;
        let (stencil, radii) = (&refinement.stencil, &refinement.radii);
        let control = prism.points();
        let mut vertices = stencil.apply(&control);
        displacement::flatten(&mut vertices, stencil, &control, params.skin.flatness);
        let place = (&prism, plan.centre, flow);
        displacement::add_keel_and_rings(&mut vertices, radii, place, &params.skin);
        let size = prism.skin_size;
        displacement::add_noise(&mut vertices, radii, (stencil, needed), (size, id), params);
        Some(Solid {
            vertices,
            triangles: stencil.triangles.clone(),
        })
    }
}

/// The control mesh of a cell's solid; `None` if the cell has no appreciable area.
pub fn control_mesh(cell: &Cell, params: &StoneParams) -> Option<Solid> {
    let plan = Footprint::new(&cell.ring, cell.centre)?;
    let corners = plan.corners.len();
    Some(match params.kind {
        StoneKind::Skin => Solid {
            vertices: Prism::over(&plan, cell.axis, params, cell.id).points(),
            triangles: prism::triangles(corners).into(),
        },
        _ => Solid {
            vertices: control::points(&plan, params, cell.id),
            triangles: control::triangles(corners).into(),
        },
    })
}

/// The number of Loop steps that shows a cell's making at close range: as many as a picture with a pixel for
/// each unit needs, within limits. `None` if the cell has no appreciable area.
pub(super) fn shown_level(cell: &Cell, params: &StoneParams) -> Option<u32> {
    let plan = Footprint::new(&cell.ring, cell.centre)?;
    let corners = plan.corners.len();
    let (coarse, needed) = match params.kind {
        StoneKind::Skin => {
            let prism = Prism::over(&plan, cell.axis, params, cell.id);
            (
                prism::triangle_count(corners),
                SKIN_TRIANGLES * prism.area(),
            )
        }
        _ => (
            control::triangle_count(corners),
            STONE_TRIANGLES * area(&plan, params),
        ),
    };
    Some(levels(coarse, needed.clamp(SHOWN[0], SHOWN[1])))
}

/// The area of a stone's base, in square picture units.
fn area(plan: &Footprint, params: &StoneParams) -> f64 {
    plan.size * plan.size * params.scale * params.scale
}

/// Moves vertices back into the ring, because smoothing cuts across reflex corners.
fn keep_in(plan: &Footprint, params: &StoneParams, vertices: &mut [Vec3]) {
    for v in vertices {
        let p = DVec2::new(f64::from(v.x), f64::from(v.y));
        let q = plan.kept_in(p, params.scale.max(1.0));
        (v.x, v.y) = (q.x as f32, q.y as f32);
    }
}

/// Loop steps that turn `triangles` into the wanted number.
fn levels(triangles: usize, wanted: f64) -> u32 {
    let mut triangles = triangles as f64;
    let mut levels = 0;
    while triangles < wanted && levels < MOST_LEVELS {
        triangles *= 4.0;
        levels += 1;
    }
    levels
}
