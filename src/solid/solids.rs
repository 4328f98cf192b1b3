//! From cells to solids: control meshes, refined by stencils.

use super::footprint::{Footprint, MOST_CORNERS};
use super::stencil_cache::{MOST_LEVELS, StencilCache, memory};
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
/// The range of the number of triangles that the last Loop step shown must reach.
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
    /// Most Loop steps that a picture gets.
    most: u32,
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
            most: MOST_LEVELS,
        }
    }

    /// Limits the Loop steps of a picture, so that its stencils take at most about `bytes`, as far as possible. Returns
    /// the bytes that they take.
    pub fn fit(&mut self, cells: &[Cell], params: &StoneParams, bytes: usize) -> usize {
        let mut needs = [0; MOST_CORNERS + 1];
        for cell in cells {
            if let Some(plan) = Footprint::new(&cell.ring, cell.centre) {
                needs[plan.corners.len()] |= 1u32 << self.levels(&plan, params, cell);
            }
        }
        loop {
            let taken = self.bytes(params.kind == StoneKind::Skin, &needs);
            if taken <= bytes || self.most == 0 {
                return taken;
            }
            self.most -= 1;
        }
    }

    /// The bytes of all stencils, and of the making of the largest. `needs` has an entry for each
    /// number of corners, with a bit for each level.
    fn bytes(&self, skin: bool, needs: &[u32]) -> usize {
        let (mut kept, mut making) = (0, 0);
        for (corners, bits) in needs.iter().enumerate() {
            let bit = |level: u32| bits & (1 << level) != 0;
            let triangles = match skin {
                true => prism::triangle_count(corners),
                false => control::triangle_count(corners),
            };
            let limited = (self.most..=MOST_LEVELS).any(bit);
            let below = (0..self.most).filter(|&level| bit(level));
            for level in below.chain(limited.then_some(self.most)) {
                let [own, more] = memory(triangles, level);
                kept += own;
                making = making.max(more);
            }
        }
        kept + making
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

    /// Like [`Solids::solid`], after exactly `level` Loop steps, at most [`MOST_LEVELS`]. Noise of skin ends at the
    /// level of the solid that a picture needs.
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

    /// Loop steps of a cell's solid.
    fn levels(&self, plan: &Footprint, params: &StoneParams, cell: &Cell) -> u32 {
        match params.kind {
            StoneKind::Skin => {
                let prism = Prism::over(plan, cell.axis, params, cell.id);
                self.levels_of_skin(plan, &prism).1
            }
            _ => self.levels_of_stone(plan, params),
        }
    }

    fn levels_of_stone(&self, plan: &Footprint, params: &StoneParams) -> u32 {
        let wanted = STONE_TRIANGLES * self.pixels * area(plan, params);
        let coarse = control::triangle_count(plan.corners.len());
        let most = STONE_LEVELS.min(self.most);
        self.steps(coarse, levels(coarse, wanted).min(most))
    }

    /// The Loop steps that a picture needs, and those of the solid.
    fn levels_of_skin(&self, plan: &Footprint, prism: &Prism) -> (u32, u32) {
        let coarse = prism::triangle_count(plan.corners.len());
        let needed = levels(coarse, SKIN_TRIANGLES * self.pixels * prism.area());
        let needed = needed.min(self.most);
        let finer = needed.saturating_add_signed(self.finer).min(self.most);
        (needed, self.steps(coarse, finer))
    }

    fn stone(&mut self, plan: &Footprint, params: &StoneParams, id: u32) -> Option<Solid> {
        let corners = plan.corners.len();
        let points = control::points(plan, params, id);
        let levels = self.levels_of_stone(plan, params);
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
        let (needed, finer) = self.levels_of_skin(plan, &prism);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::CellKind;

    #[test]
    fn stencils_fit_into_the_bytes_that_are_left() {
        let corners = [[0.0, 0.0], [40.0, 0.0], [40.0, 40.0], [0.0, 40.0]];
        let cell = Cell {
            id: 1,
            centre: DVec2::splat(20.0),
            kind: CellKind::Square,
            size: 40.0,
            aspect: 1.0,
            axis: DVec2::X,
            ring: corners.map(DVec2::from).to_vec(),
        };
        for kind in [StoneKind::Skin, StoneKind::Cobble] {
            let params = StoneParams {
                kind,
                ..StoneParams::default()
            };
            let made = |bytes| {
                let mut solids = Solids::for_picture(2, 0);
                let taken = solids.fit(std::slice::from_ref(&cell), &params, bytes);
                (taken, solids.solid(&cell, &params).triangles.len())
            };
            let (whole, finest) = made(usize::MAX);
            assert_eq!(made(whole), (whole, finest));
            let (taken, coarser) = made(whole - 1);
            assert!(taken < whole && 4 * coarser == finest, "{kind:?}");
            assert!(made(0).1 < coarser);
        }
    }
}
