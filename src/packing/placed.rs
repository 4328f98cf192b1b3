//! The cells placed so far, none of them in motion yet.

use super::grid::Grid;
use super::shape::Shape;
use crate::domain::Domain;
use crate::field::Fields;
use glam::DVec2;

/// The front takes a place whose nearest cell is at least this far, in stable distances.
pub(super) const FRONT_GAP: f64 = 0.75;

/// Cells' centres, with the grid to find them.
pub(super) struct Placed {
    pub cells: Vec<DVec2>,
    shapes: Vec<Shape>,
    grid: Grid,
    longest: f64,
}

impl Placed {
    pub fn new(domain: &Domain, fields: &Fields) -> Self {
        let (lo, hi) = domain.bounds();
        Self {
            cells: Vec::new(),
            shapes: Vec::new(),
            grid: Grid::new(lo, hi, fields.params().size),
            longest: 0.0,
        }
    }

    pub fn push(&mut self, fields: &Fields, p: DVec2) {
        let shape = Shape::metric_at(fields, p);
        self.cells.push(p);
        self.shapes.push(shape);
        self.grid.push(p);
        self.longest = self.longest.max(shape.length());
    }

    /// Puts a cell into the middle of each island that has none.
    pub fn fill_empty_islands(&mut self, domain: &Domain, fields: &Fields) {
        for p in domain.empty_middles(&self.cells) {
            self.push(fields, p);
        }
    }

    /// Is every cell at least `gap` stable distances away from this place?
    pub fn is_free(&self, domain: &Domain, fields: &Fields, p: DVec2, gap: f64) -> bool {
        let shape = Shape::metric_at(fields, p);
        let reach = gap * 0.5 * (shape.length() + self.longest);
        let space = domain.space();
        !self.grid.any_near(space, p, reach, |k| {
            let r = space.shortest(self.cells[k] - p);
            shape.is_closer(&self.shapes[k], r, gap) && !domain.is_parted(p, p + r)
        })
    }
}
