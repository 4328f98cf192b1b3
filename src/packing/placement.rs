//! The first cells: along the boundary, then inside.

use super::boundary_cells::{boundary_cells, line_pieces, pieces};
use super::front::Front;
use super::grid::Grid;
use super::placed::Placed;
use super::quadtree::Quadtree;
use super::run::Run;
use super::surroundings::PlaneDomain;
use super::wall::reach;
use super::{BoundaryCondition, Packing, PackingParams, Start, TUNING, greatest_length};
use crate::decimal;
use crate::domain::{Domain, Walls};
use crate::field::Fields;
use crate::notice::{Code, Notice};
use glam::DVec2;

/// Places tried in one slice of the work.
const PLACES: usize = 2000;

/// The first cells of a packing, being placed.
pub struct Placing {
    params: PackingParams,
    walls: Walls,
    placed: Placed<DVec2, Grid>,
    /// The number of cells along the boundary.
    along: usize,
    inside: Inside,
}

/// How the inside is filled.
enum Inside {
    Front(Front),
    Quadtree(Quadtree),
}

impl Placing {
    /// Places the cells along the boundary, none inside yet.
    ///
    /// # Errors
    /// A notice if the outline would take more cells than can be packed.
    pub fn new(domain: &Domain, fields: &Fields, params: PackingParams) -> Result<Self, Notice> {
        let size = fields.params().size;
        let expected = domain.area() / (size * size);
        if expected > TUNING.most_cells {
            let notice = Notice::new(Code::TooManyCells).with("n", decimal::text(expected.round()));
            let notice = notice.with("size", decimal::text(size));
            return Err(notice.with("most", decimal::text(TUNING.most_cells)));
        }
        let walls = Walls::new(domain, reach(greatest_length(domain, fields, &params)));
        let around = PlaneDomain {
            domain,
            fields,
            walls: &walls,
            boundary: params.boundary,
        };
        let mut placed = along_boundary(around);
        let along = placed.cells.len();
        let inside = match params.start {
            Start::Stream => Inside::Front(Front::new(&mut placed, around, params.seed)),
            Start::Quadtree => Inside::Quadtree(Quadtree::new(domain, fields)),
        };
        Ok(Self {
            params,
            walls,
            placed,
            along,
            inside,
        })
    }

    /// Does one slice of the work; true when all places are filled.
    pub fn advance(&mut self, domain: &Domain, fields: &Fields) -> bool {
        let around = PlaneDomain {
            domain,
            fields,
            walls: &self.walls,
            boundary: self.params.boundary,
        };
        let placed = &mut self.placed;
        (0..PLACES).any(|_| match &mut self.inside {
            Inside::Front(front) => front.grow(placed, around),
            Inside::Quadtree(tree) => tree.grow(placed, around),
        })
    }

    /// Makes the packing from the cells so far.
    pub fn finish(mut self, domain: &Domain, fields: &Fields) -> Packing {
        let around = PlaneDomain {
            domain,
            fields,
            walls: &self.walls,
            boundary: self.params.boundary,
        };
        self.placed.fill_empty_parts(around);
        let fixed = self.params.boundary == BoundaryCondition::On;
        let cells = self.placed.cells.iter().enumerate();
        let cells = cells.map(|(k, &centre)| (centre, fixed && k < self.along));
        Packing {
            run: Run::of(cells, fields, self.params),
            walls: self.walls,
        }
    }
}

/// The cells along the rings and the constraint lines.
fn along_boundary(around: PlaneDomain) -> Placed<DVec2, Grid> {
    let fixed = around.boundary == BoundaryCondition::On;
    let mut placed = Placed::new(around);
    let islands = || around.domain.islands().iter();
    // Each island separately.
    let within = |domain| PlaneDomain { domain, ..around };
    for island in islands() {
        for piece in island.rings().iter().flat_map(|ring| pieces(ring, true)) {
            boundary_cells(&mut placed, &piece, within(island), fixed);
        }
    }
    for island in islands() {
        let lines = island.lines().iter();
        for piece in lines.flat_map(|line| line_pieces(line, fixed)) {
            boundary_cells(&mut placed, &piece, within(island), fixed);
        }
    }
    placed
}

/// The centres of the cells that are fixed on the boundary.
pub(super) fn on_boundary(around: PlaneDomain) -> Vec<DVec2> {
    along_boundary(around).cells
}
