//! The stencils of all connectivities, each worked out once.
//!
//! All stones with the same number of corners share one connectivity, so subdividing one is a product
//! of its few control points and cached weights.

use super::footprint::MOST_CORNERS;
use super::subdivide::{Stencil, StencilBuilder};
use super::{control, prism};
use std::rc::Rc;

/// At most so many Loop steps.
pub const MOST_LEVELS: u32 = 8;

/// Rows of a stencil that are worked out in one slice.
const ROWS: usize = 12_000;

const SLOTS: usize = (MOST_CORNERS + 1) * (MOST_LEVELS as usize + 1);

/// What all solids of one connectivity share.
#[derive(Debug)]
pub(super) struct Refinement {
    pub stencil: Stencil,
    /// Of skin, how far from the middle each vertex is: see [`prism::radii`].
    pub radii: Vec<f32>,
}

/// Keeps what was worked out for each kind of control mesh, number of corners and level.
#[derive(Debug)]
pub(super) struct StencilCache {
    /// By corners, then level; those of stones first, then those of skin.
    refinements: Vec<Option<Rc<Refinement>>>,
    /// The one in the making, for this place.
    building: Option<(usize, StencilBuilder)>,
}

impl StencilCache {
    /// An empty one.
    pub fn new() -> Self {
        Self {
            refinements: vec![None; 2 * SLOTS],
            building: None,
        }
    }

    /// The refinement of control meshes of so many corners in so many Loop steps; nothing where only a
    /// slice of the work on it could be done.
    pub fn get(&mut self, skin: bool, corners: usize, levels: u32) -> Option<Rc<Refinement>> {
        let slot = corners * (MOST_LEVELS as usize + 1) + levels as usize;
        let slot = slot + if skin { SLOTS } else { 0 };
        if let Some(refinement) = &self.refinements[slot] {
            return Some(refinement.clone());
        }
        let begun = self.building.take().filter(|&(at, _)| at == slot);
        let (_, mut builder) = begun.unwrap_or_else(|| {
            let (points, triangles) = match skin {
                true => (prism::point_count(corners), prism::triangles(corners)),
                false => (control::point_count(corners), control::triangles(corners)),
            };
            (slot, StencilBuilder::new(points, triangles, levels, skin))
        });
        if !builder.advance(ROWS) {
            self.building = Some((slot, builder));
            return None;
        }
        let stencil = builder.finish();
        let radii = match skin {
            true => stencil.apply(&prism::radii(corners)),
            false => Vec::new(),
        };
        let radii = radii.iter().map(|r| r.x).collect();
        let refinement = Rc::new(Refinement { stencil, radii });
        // The solid of a large one is work for a slice of its own.
        let large = refinement.stencil.len() > ROWS;
        self.refinements[slot] = Some(refinement.clone());
        (!large).then_some(refinement)
    }
}
