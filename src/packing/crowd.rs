//! The first cells so far, and where there is room for one more.

use super::grid::Grid;
use super::shape::Shape;
use super::{Edge, Surroundings};
use crate::domain::{Domain, Nearest};
use crate::field::Fields;
use glam::DVec2;

/// The front takes a place whose nearest cell is at least this far, in stable distances.
pub(super) const FRONT_GAP: f64 = 0.75;
/// The fewest sizes from the boundary at which a cell is placed inside.
const INSIDE_CLEARANCE: f64 = 0.35;

/// Where it is nearer than this from the middle of an outline to its walls, in sizes, cells go into
/// the middle ...
const NARROW: f64 = 0.4;
/// ... but not where it is nearer than this.
const NARROWEST: f64 = 0.25;

/// Cells so far, with the grid to find them.
pub(super) struct Crowd {
    pub cells: Vec<DVec2>,
    shapes: Vec<Shape>,
    grid: Grid,
    longest: f64,
}

impl Crowd {
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
        let shape = Shape::gauge(fields, p);
        self.cells.push(p);
        self.shapes.push(shape);
        self.grid.push(p);
        self.longest = self.longest.max(shape.length());
    }

    /// Puts a cell into the middle of each island that has none.
    pub fn settle_all(&mut self, domain: &Domain, fields: &Fields) {
        for p in domain.empty_middles(&self.cells) {
            self.push(fields, p);
        }
    }

    /// Is every cell at least `gap` stable distances away from this place?
    pub fn is_free(&self, domain: &Domain, fields: &Fields, p: DVec2, gap: f64) -> bool {
        let shape = Shape::gauge(fields, p);
        let reach = gap * 0.5 * (shape.length() + self.longest);
        let space = domain.space();
        !self.grid.any_near(space, p, reach, |k| {
            let r = space.shortest(self.cells[k] - p);
            shape.is_closer(&self.shapes[k], r, gap) && !domain.is_parted(p, p + r)
        })
    }
}

/// Where the outline is too narrow for a cell: the middle between its walls there. Nothing where it is
/// wide enough, and where it is so narrow that a cell would be a sliver.
pub(super) fn narrowed(p: DVec2, around: Surroundings, edge: Edge) -> Option<DVec2> {
    let Surroundings {
        domain,
        fields,
        walls,
    } = around;
    if edge == Edge::On || !domain.is_in_box(p) || !walls.is_near(p) {
        return None;
    }
    let near = domain.nearest(p);
    let extent = Shape::gauge(fields, p).extent(near.inward);
    let depth = domain.medial_depth(near.point, near.inward, NARROW * extent);
    let is_narrow = depth >= NARROWEST * extent && depth < NARROW * extent;
    is_narrow.then(|| near.point + near.inward * depth)
}

/// Is there room for a cell between the walls at this place?
pub(super) fn has_room(p: DVec2, around: Surroundings, edge: Edge) -> bool {
    let Surroundings {
        domain,
        fields,
        walls,
    } = around;
    if !domain.is_in_box(p) {
        return false;
    }
    if !walls.is_near(p) {
        return domain.contains(p);
    }
    let clearance = match edge {
        Edge::Wall => INSIDE_CLEARANCE,
        // The first row inside keeps off the cells on the boundary by itself.
        Edge::On => FRONT_GAP * 0.8,
    };
    is_clear(p, clearance, fields, domain)
}

/// Is a place inside, and this share of a cell's extent or more from the boundary and from lines?
pub(super) fn is_clear(p: DVec2, clearance: f64, fields: &Fields, domain: &Domain) -> bool {
    let shape = Shape::gauge(fields, p);
    let clear = |near: Nearest| near.distance >= clearance * shape.extent(near.inward);
    clear(domain.nearest(p)) && domain.nearest_line(p).is_none_or(clear)
}
