//! The stencils of all connectivities, each computed once.
//!
//! All stones with the same number of corners share one connectivity, so subdividing one multiplies its few
//! control points with cached weights.

use super::footprint::MOST_CORNERS;
use super::subdivide::{Stencil, StencilBuilder};
use super::{control, prism};
use std::rc::Rc;

/// Most Loop steps.
pub const MOST_LEVELS: u32 = 8;

/// Rows of a stencil that are computed in one slice.
const ROWS: usize = 12_000;

/// Bytes of a refinement for each of its vertices, and more while it is made and applied to a cell.
const BYTES: [usize; 2] = [120, 360];

const SLOTS: usize = (MOST_CORNERS + 1) * (MOST_LEVELS as usize + 1);

/// Data shared by all solids with the same connectivity.
#[derive(Debug)]
pub(super) struct Refinement {
    pub stencil: Stencil,
    /// For skin, the radial coordinate of each vertex: see [`prism::radii`].
    pub radii: Vec<f32>,
}

/// Caches refinements by kind of control mesh, number of corners and level.
#[derive(Debug)]
pub(super) struct StencilCache {
    /// The refinements of stones, then those of skin: each by corners, then by level.
    refinements: Vec<Option<Rc<Refinement>>>,
    /// The refinement in progress, with its index.
    building: Option<(usize, StencilBuilder)>,
}

/// The approximate bytes that a refinement takes for good, and while it is made, from the number of triangles of the
/// control mesh.
pub(super) fn memory(triangles: usize, levels: u32) -> [usize; 2] {
    let vertices = (triangles << (2 * levels)) / 2;
    BYTES.map(|bytes| bytes * vertices)
}

impl StencilCache {
    /// An empty cache.
    pub fn new() -> Self {
        Self {
            refinements: vec![None; 2 * SLOTS],
            building: None,
        }
    }

    /// The refinement of control meshes with this number of corners and Loop steps; `None` if only a slice of
    /// the work on it was done.
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
        // Applying a large refinement to a cell needs a slice of its own.
        let large = refinement.stencil.len() > ROWS;
        self.refinements[slot] = Some(refinement.clone());
        (!large).then_some(refinement)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refinements_take_the_memory_that_is_told() {
        for corners in [3, 4, 6, MOST_CORNERS] {
            for (skin, triangles) in [
                (false, control::triangle_count(corners)),
                (true, prism::triangle_count(corners)),
            ] {
                let mut cache = StencilCache::new();
                for levels in [3, 5] {
                    let made = loop {
                        if let Some(made) = cache.get(skin, corners, levels) {
                            break made;
                        }
                    };
                    let taken = made.stencil.bytes() + 4 * made.radii.capacity();
                    let [told, _] = memory(triangles, levels);
                    assert!(
                        taken <= told && told < 2 * taken,
                        "{corners} {levels}: {taken}, {told}"
                    );
                }
            }
        }
    }
}
