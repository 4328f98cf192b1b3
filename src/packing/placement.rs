//! The first cells: along the boundary, then inside.

use super::front::Front;
use super::grid::Grid;
use super::integrate::Surroundings;
use super::rim::{boundary_cells, line_pieces, pieces};
use super::shape::Shape;
use super::wall::reach;
use super::{Edge, Packing, PackingParams, Start, TUNING, greatest_length};
use crate::decimal;
use crate::domain::{Domain, Facing, Nearest};
use crate::field::Fields;
use glam::DVec2;

/// The front takes a place whose nearest cell is at least this far, in stable distances.
pub(super) const FRONT_GAP: f64 = 0.75;
/// The least distance at which a cell of a quadtree's leaf is put beside others.
const LEAF_GAP: f64 = 0.6;
/// The fewest sizes from the boundary at which a cell is placed inside.
const INSIDE_CLEARANCE: f64 = 0.35;

/// Where it is nearer than this from the middle of an outline to its walls, in sizes, cells go into
/// the middle ...
const NARROW: f64 = 0.4;
/// ... but not where it is nearer than this.
const NARROWEST: f64 = 0.25;

/// Places that are looked at in one slice of the work.
const PLACES: usize = 2000;

/// The first cells of a packing in the making.
pub struct Placing {
    params: PackingParams,
    facing: Facing,
    crowd: Crowd,
    /// So many of them stand along the boundary.
    along: usize,
    inside: Inside,
}

/// How the inside fills.
enum Inside {
    Front(Front),
    Quadtree(Quadtree),
}

impl Placing {
    /// The cells along the boundary, none inside yet.
    ///
    /// # Errors
    /// A sentence where the outline would take more cells than can be packed.
    pub fn new(domain: &Domain, fields: &Fields, params: PackingParams) -> Result<Self, String> {
        let size = fields.params().size;
        let expected = domain.area() / (size * size);
        if expected > TUNING.most_cells {
            return Err(format!(
                "About {} cells of size {} fit into this outline; at most {} are packed. Choose larger \
                 cells.",
                decimal::text(expected.round()),
                decimal::text(size),
                decimal::text(TUNING.most_cells)
            ));
        }
        let facing = Facing::new(domain, reach(greatest_length(domain, fields, &params)));
        let mut crowd = along_boundary(domain, fields, params.edge == Edge::On);
        let along = crowd.cells.len();
        let inside = match params.start {
            Start::Stream => Inside::Front(Front::new(&mut crowd, domain, fields, params.seed)),
            Start::Quadtree => Inside::Quadtree(Quadtree::new(domain, fields)),
        };
        Ok(Self {
            params,
            facing,
            crowd,
            along,
            inside,
        })
    }

    /// One slice of the work; true when all places are filled.
    pub fn advance(&mut self, domain: &Domain, fields: &Fields) -> bool {
        let around = Surroundings {
            domain,
            fields,
            facing: &self.facing,
        };
        let (crowd, edge) = (&mut self.crowd, self.params.edge);
        (0..PLACES).any(|_| match &mut self.inside {
            Inside::Front(front) => front.grow(crowd, around, edge),
            Inside::Quadtree(tree) => tree.grow(crowd, around, edge),
        })
    }

    /// The packing of the cells so far.
    pub fn finish(mut self, domain: &Domain, fields: &Fields) -> Packing {
        self.crowd.settle_all(domain, fields);
        let fixed = self.params.edge == Edge::On;
        let cells = self.crowd.cells.iter().enumerate();
        let cells = cells.map(|(k, &centre)| (centre, fixed && k < self.along));
        Packing::of(cells, fields, self.params, self.facing)
    }
}

/// The cells along the rings and the constraint lines.
fn along_boundary(domain: &Domain, fields: &Fields, fixed: bool) -> Crowd {
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
pub(super) struct Crowd {
    pub cells: Vec<DVec2>,
    shapes: Vec<Shape>,
    grid: Grid,
    longest: f64,
}

impl Crowd {
    fn new(domain: &Domain, fields: &Fields) -> Self {
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
        !self.grid.any_near(domain.period(), p, reach, |k| {
            let r = domain.shortest(self.cells[k] - p);
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
        facing,
    } = around;
    if edge == Edge::On || !domain.is_in_box(p) || !facing.is_near(p) {
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
        facing,
    } = around;
    if !domain.is_in_box(p) {
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
struct Quadtree {
    /// Squares to come, the next one last: corner and side.
    open: Vec<(DVec2, f64)>,
}

impl Quadtree {
    fn new(domain: &Domain, fields: &Fields) -> Self {
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

    /// Looks at the next square; true when there is none.
    fn grow(&mut self, crowd: &mut Crowd, around: Surroundings, edge: Edge) -> bool {
        let Surroundings { domain, fields, .. } = around;
        let Some((corner, side)) = self.open.pop() else {
            return true;
        };
        let middle = corner + DVec2::splat(side / 2.0);
        if side > 1.414 * fields.size(middle) {
            let half = side / 2.0;
            for (x, y) in [(half, half), (0.0, half), (half, 0.0), (0.0, 0.0)] {
                self.open.push((corner + DVec2::new(x, y), half));
            }
        } else if crowd.is_free(domain, fields, middle, LEAF_GAP) && has_room(middle, around, edge)
        {
            crowd.push(fields, middle);
        }
        false
    }
}
