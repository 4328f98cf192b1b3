//! Fits cells into the outline: the dual of the mesh of the packed centres (`dual`), straightened.
//!
//! Near the boundary the dual's polygons and the outline form one planar arrangement (`arrangement`), whose
//! regions are then assigned to the cells. So the cells fill the outline without gap or overlap, whatever its
//! shape.

use super::dual::Dual;
use super::dual_builder::{Built, DualBuilder};
use super::ownership::NAMELESS;
use super::straighten::Straightening;
use super::tessellation::Tessellation;
use super::{Cell, images};
use crate::domain::Domain;
use crate::order;
use crate::packing::Particle;

/// The dual of the packed cells, filling the outline, in one call; see [`Fitting`].
pub fn fitted(domain: &Domain, particles: &[Particle]) -> Vec<Cell> {
    let mut fitting = Fitting::new(particles.to_vec());
    while !fitting.advance(domain) {}
    fitting.finish()
}

/// The dual of the packed cells, filling the outline, in progress. Slivers are joined to a neighbour, so
/// there can be fewer cells than particles.
pub struct Fitting {
    cells: Vec<Cell>,
    /// A stack of islands to do: their numbers and particles.
    left: Vec<(usize, Vec<Particle>)>,
    tessellation: Tessellation,
    /// The largest id of a particle.
    largest: u32,
    /// The number of cells that are not images of others.
    count: usize,
    next: FittingPhase,
}

/// The next slice of the work.
enum FittingPhase {
    Islands(Vec<Particle>),
    Build(usize, DualBuilder),
    Band(usize, Dual),
    Corners,
    Straighten(Straightening),
    Nothing,
}

impl Fitting {
    /// Starts the cells for these particles.
    pub fn new(particles: Vec<Particle>) -> Self {
        Self::of(particles, Tessellation::PseudoVoronoi)
    }

    /// Starts the plain Voronoi cells of these particles' centres within the outline. Each cell has all points nearer
    /// to its centre than to any other centre, however thin or small the cell is. Pieces that the outline cuts off from
    /// their centre go to a neighbour, or become cells if they are large.
    pub fn voronoi(particles: Vec<Particle>) -> Self {
        Self::of(particles, Tessellation::Voronoi)
    }

    fn of(particles: Vec<Particle>, tessellation: Tessellation) -> Self {
        Self {
            cells: Vec::new(),
            left: Vec::new(),
            tessellation,
            largest: particles.iter().map(|p| p.id).max().unwrap_or(0),
            count: 0,
            next: FittingPhase::Islands(particles),
        }
    }

    /// Begins the next island.
    fn next_island(&mut self, domain: &Domain) -> FittingPhase {
        let Some((number, particles)) = self.left.pop() else {
            if domain.islands().len() > 1 {
                self.join_islands();
            }
            return if self.tessellation.is_tidied() {
                FittingPhase::Corners
            } else {
                FittingPhase::Nothing
            };
        };
        let island = &domain.islands()[number];
        FittingPhase::Build(
            number,
            DualBuilder::new(island, particles, self.tessellation),
        )
    }

    /// The cells of all islands in the order of their ids. Cells without a particle get new ids, because each
    /// island numbered them in the same way.
    fn join_islands(&mut self) {
        let mut nameless = NAMELESS;
        for cell in self.cells.iter_mut().filter(|c| c.id > self.largest) {
            cell.id = nameless;
            nameless -= 1;
        }
        order::sort(&mut self.cells, |c| (c.id.into(), 0));
    }

    /// Does one slice of the work; true when finished.
    pub fn advance(&mut self, domain: &Domain) -> bool {
        self.next = match std::mem::replace(&mut self.next, FittingPhase::Nothing) {
            FittingPhase::Islands(particles) if particles.is_empty() => FittingPhase::Nothing,
            FittingPhase::Islands(particles) => {
                let mut own = vec![Vec::new(); domain.islands().len()];
                for p in particles {
                    own[domain.island(p.centre)].push(p);
                }
                self.left = own.into_iter().enumerate().rev().collect();
                self.left.retain(|(_, particles)| !particles.is_empty());
                self.next_island(domain)
            }
            FittingPhase::Build(number, mut builder) => {
                match builder.advance(&domain.islands()[number]) {
                    Some(Built::Cells(cells)) => {
                        self.cells = cells;
                        FittingPhase::Corners
                    }
                    Some(Built::Dual(dual)) => FittingPhase::Band(number, dual),
                    None => FittingPhase::Build(number, builder),
                }
            }
            FittingPhase::Band(number, dual) => {
                self.cells.extend(dual.cells(&domain.islands()[number]));
                self.next_island(domain)
            }
            FittingPhase::Corners => {
                self.count = self.cells.len();
                self.cells.extend(images::images(domain, &self.cells));
                FittingPhase::Straighten(Straightening::new(domain, &self.cells))
            }
            FittingPhase::Straighten(mut straightening) => {
                if straightening.advance(domain, &self.cells) {
                    straightening.finish(&mut self.cells);
                    self.cells.truncate(self.count);
                    FittingPhase::Nothing
                } else {
                    FittingPhase::Straighten(straightening)
                }
            }
            FittingPhase::Nothing => FittingPhase::Nothing,
        };
        matches!(self.next, FittingPhase::Nothing)
    }

    /// The cells in the order of their ids.
    pub fn finish(self) -> Vec<Cell> {
        self.cells
    }
}
