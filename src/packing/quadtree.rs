//! Fills the inside with one cell in every leaf of a quadtree, as in the papers.

use super::clearance::has_room;
use super::grid::Grid;
use super::placed::Placed;
use super::surroundings::PlaneDomain;
use crate::domain::Domain;
use crate::field::Fields;
use glam::DVec2;

/// The least distance between a new cell and all other cells, in stable distances.
const LEAF_GAP: f64 = 0.6;

/// One cell at the centre of every leaf. A square is divided while its side is more than sqrt 2 times the size field at
/// its centre. For a constant size the leaves have exactly that size.
pub(super) struct Quadtree {
    /// A stack of squares to visit: corner and side.
    open: Vec<(DVec2, f64)>,
}

impl Quadtree {
    pub fn new(domain: &Domain, fields: &Fields) -> Self {
        let (lo, hi) = domain.bounds();
        let mut side = fields.params().size;
        while side < (hi - lo).max_element() {
            side *= 2.0;
        }
        let corner = lo.midpoint(hi) - DVec2::splat(side / 2.0);
        Self {
            open: vec![(corner, side)],
        }
    }

    /// Visits the next square; true when none is left.
    pub fn grow(&mut self, placed: &mut Placed<DVec2, Grid>, around: PlaneDomain) -> bool {
        let fields = around.fields;
        let Some((corner, side)) = self.open.pop() else {
            return true;
        };
        let middle = corner + DVec2::splat(side / 2.0);
        if side > 1.414 * fields.size(middle) {
            let half = side / 2.0;
            for (x, y) in [(half, half), (0.0, half), (half, 0.0), (0.0, 0.0)] {
                self.open.push((corner + DVec2::new(x, y), half));
            }
        } else if placed.is_free(around, middle, LEAF_GAP) && has_room(middle, around) {
            placed.push(fields, middle);
        }
        false
    }
}
