//! The first cells: along the boundary, then inside.

use super::front::stream;
use super::grid::Grid;
use super::rim::{boundary_cells, line_pieces, pieces};
use super::shape::Shape;
use super::{Edge, PackingParams, Start};
use crate::domain::{Domain, Facing, Nearest};
use crate::field::Fields;
use glam::DVec2;

/// The front takes a place whose nearest cell is at least this far, in stable distances.
pub(super) const FRONT_GAP: f64 = 0.75;
/// The least distance at which a cell of a quadtree's leaf is put beside others.
const LEAF_GAP: f64 = 0.6;
/// The fewest sizes from the boundary at which a cell is placed inside.
const INSIDE_CLEARANCE: f64 = 0.35;

/// The cells of the start: centre, and whether it is fixed on the boundary.
pub(super) fn place(
    domain: &Domain,
    fields: &Fields,
    facing: &Facing,
    params: &PackingParams,
) -> Vec<(DVec2, bool)> {
    let fixed = params.edge == Edge::On;
    let mut crowd = along_boundary(domain, fields, fixed);
    let on_boundary = crowd.cells.len();
    match params.start {
        Start::Stream => stream(&mut crowd, domain, fields, facing, params),
        Start::Quadtree => quadtree(&mut crowd, domain, fields, facing, params.edge),
    }
    crowd.settle_all();
    let cells = crowd.cells.into_iter().enumerate();
    cells
        .map(|(k, centre)| (centre, fixed && k < on_boundary))
        .collect()
}

/// The cells along the rings and the constraint lines.
fn along_boundary<'a>(domain: &'a Domain, fields: &'a Fields, fixed: bool) -> Crowd<'a> {
    let mut crowd = Crowd::new(domain, fields);
    for island in domain.islands() {
        for piece in island.rings().iter().flat_map(|ring| pieces(ring, true)) {
            boundary_cells(&mut crowd, &piece, fields, island, fixed);
        }
    }
    for island in domain.islands() {
        let lines = island.lines().iter();
        for piece in lines.flat_map(|line| line_pieces(line, fixed)) {
            boundary_cells(&mut crowd, &piece, fields, island, fixed);
        }
    }
    crowd
}

/// The centres of the cells that are fixed on the boundary.
pub(super) fn on_boundary(domain: &Domain, fields: &Fields) -> Vec<DVec2> {
    along_boundary(domain, fields, true).cells
}

/// Cells so far, with the grid to find them.
pub(super) struct Crowd<'a> {
    pub cells: Vec<DVec2>,
    shapes: Vec<Shape>,
    grid: Grid,
    longest: f64,
    domain: &'a Domain,
    fields: &'a Fields,
}

impl<'a> Crowd<'a> {
    fn new(domain: &'a Domain, fields: &'a Fields) -> Self {
        let (lo, hi) = domain.bounds();
        Self {
            cells: Vec::new(),
            shapes: Vec::new(),
            grid: Grid::new(lo, hi, fields.params().size),
            longest: 0.0,
            domain,
            fields,
        }
    }

    pub fn push(&mut self, p: DVec2) {
        let shape = Shape::gauge(self.fields, p);
        self.cells.push(p);
        self.shapes.push(shape);
        self.grid.push(p);
        self.longest = self.longest.max(shape.length());
    }

    /// Puts a cell into the middle of each island that has none.
    pub fn settle_all(&mut self) {
        for p in self.domain.empty_middles(&self.cells) {
            self.push(p);
        }
    }

    /// Is every cell at least `gap` stable distances away from this place?
    pub fn is_free(&self, p: DVec2, gap: f64) -> bool {
        let shape = Shape::gauge(self.fields, p);
        let reach = gap * 0.5 * (shape.length() + self.longest);
        let (domain, grid) = (self.domain, &self.grid);
        !grid.any_near(domain.period(), p, reach, |k| {
            let r = domain.shortest(self.cells[k] - p);
            shape.is_closer(&self.shapes[k], r, gap) && !domain.is_parted(p, self.cells[k])
        })
    }
}

/// Is there room for a cell between the walls at this place?
pub(super) fn has_room(
    p: DVec2,
    fields: &Fields,
    domain: &Domain,
    facing: &Facing,
    edge: Edge,
) -> bool {
    let (lo, hi) = domain.bounds();
    if !(p.cmpgt(lo).all() && p.cmplt(hi).all()) {
        return false;
    }
    if !facing.is_near(p) {
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

/// One cell in the middle of every leaf; a square is divided while it is larger than the size
/// field asks for at its middle. For a constant size the leaves have just that size.
fn quadtree(crowd: &mut Crowd, domain: &Domain, fields: &Fields, facing: &Facing, edge: Edge) {
    let (lo, hi) = domain.bounds();
    let mut side = fields.params().size;
    while side < (hi - lo).max_element() {
        side *= 2.0;
    }
    let corner = lo.midpoint(hi) - DVec2::splat(side / 2.0);
    let mut open = vec![(corner, side)];
    while let Some((corner, side)) = open.pop() {
        let middle = corner + DVec2::splat(side / 2.0);
        if side > 1.414 * fields.size(middle) {
            let half = side / 2.0;
            for (x, y) in [(half, half), (0.0, half), (half, 0.0), (0.0, 0.0)] {
                open.push((corner + DVec2::new(x, y), half));
            }
        } else if crowd.is_free(middle, LEAF_GAP) && has_room(middle, fields, domain, facing, edge)
        {
            crowd.push(middle);
        }
    }
}
