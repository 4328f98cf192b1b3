//! The first cells: along the boundary, then inside; or where they are given.

use super::boundary_cells::{boundary_cells, line_pieces, pieces};
use super::front::Front;
use super::grid::Grid;
use super::packing_domain::PackingDomain;
use super::placed::Placed;
use super::quadtree::Quadtree;
use super::run::Run;
use super::surroundings::PlaneDomain;
use super::wall::reach;
use super::{BoundaryCondition, GivenCell, Packing, PackingParams, Start, TUNING, greatest_length};
use crate::decimal;
use crate::domain::{Domain, Walls};
use crate::field::Fields;
use crate::notice::{Code, Notice};
use crate::random::{Purpose, Random};
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
    Random(RandomPlaces),
    /// Not filled: all cells are given.
    Given,
}

/// Random places in the outline.
struct RandomPlaces {
    random: Random,
    /// The number of cells still to be placed.
    missing: u32,
    /// Remaining tries, because most of the box may lie outside.
    tries: u32,
}

/// Tries for each random place.
const TRIES: u32 = 200;

impl RandomPlaces {
    fn new(count: u32, seed: u64) -> Self {
        Self {
            random: Random::new(seed, Purpose::Placement, 1),
            missing: count,
            tries: count.saturating_mul(TRIES),
        }
    }

    /// Tries one place; true when finished.
    fn grow(&mut self, placed: &mut Placed<DVec2, Grid>, around: PlaneDomain) -> bool {
        if self.missing == 0 || self.tries == 0 {
            return true;
        }
        self.tries -= 1;
        let p = around.anywhere(&mut self.random);
        if around.domain.contains(p) {
            placed.push(around.fields, p);
            self.missing -= 1;
        }
        false
    }
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
        let walls = walls(domain, fields, &params);
        let around = PlaneDomain {
            domain,
            fields,
            walls: &walls,
            boundary: params.boundary,
        };
        let is_on = params.boundary == BoundaryCondition::On;
        let mut placed = match params.start {
            _ if !params.given.is_empty() => given(around, &params.given),
            Start::Random if !is_on => Placed::new(around),
            _ => along_boundary(around),
        };
        let along = placed.cells.len();
        let inside = match params.start {
            _ if !params.given.is_empty() => Inside::Given,
            Start::Stream => Inside::Front(Front::new(&mut placed, around, params.seed)),
            Start::Quadtree => Inside::Quadtree(Quadtree::new(domain, fields)),
            Start::Random => {
                let room = (expected.round() as u32).saturating_sub(along as u32);
                let count = if params.count > 0 { params.count } else { room };
                Inside::Random(RandomPlaces::new(count, params.seed))
            }
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
            Inside::Random(places) => places.grow(placed, around),
            Inside::Given => true,
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
        let held: Vec<bool> = match self.inside {
            Inside::Given => kept(around, &self.params.given)
                .map(|cell| cell.is_held)
                .collect(),
            _ => {
                self.placed.fill_empty_parts(around);
                let fixed = self.params.boundary == BoundaryCondition::On;
                vec![fixed; self.along]
            }
        };
        let cells = self.placed.cells.iter().enumerate();
        let cells = cells.map(|(k, &centre)| (centre, held.get(k) == Some(&true)));
        let left_out = match self.inside {
            Inside::Given => self.params.given.len() - held.len(),
            _ => 0,
        };
        let mut run = Run::of(cells, fields, self.params);
        run.jolt(around);
        Packing {
            run,
            walls: self.walls,
            left_out,
        }
    }
}

/// The walls that cells feel: none in an open outline.
pub(super) fn walls(domain: &Domain, fields: &Fields, params: &PackingParams) -> Walls {
    Walls::new(
        domain,
        match params.boundary {
            BoundaryCondition::Open => 0.0,
            _ => reach(greatest_length(domain, fields, params)),
        },
    )
}

/// The given cells that are used: those in the outline, or all if it is open.
fn kept<'a>(around: PlaneDomain<'a>, cells: &'a [GivenCell]) -> impl Iterator<Item = GivenCell> {
    let is_open = around.boundary == BoundaryCondition::Open;
    let kept = cells.iter().copied();
    kept.filter(move |cell| is_open || around.domain.contains(cell.centre))
}

fn given(around: PlaneDomain, cells: &[GivenCell]) -> Placed<DVec2, Grid> {
    let mut placed = Placed::new(around);
    for cell in kept(around, cells) {
        let centre = around.domain.space().wrap(cell.centre);
        placed.push(around.fields, centre);
    }
    placed
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
