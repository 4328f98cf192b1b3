//! Cells fitted into the outline: the dual of the mesh of the packed centres (`dual`), straightened.
//!
//! Near the boundary the dual's polygons and the outline are laid over each other in one
//! planar arrangement (`arrangement`), whose regions are then given to the cells; so the cells
//! fill the outline without gap or overlap whatever its shape.

use super::dual::Dual;
use super::making::{Made, Making};
use super::straighten::Straightening;
use super::{Cell, torus};
use crate::domain::Domain;
use crate::packing::Particle;
use glam::DVec2;

/// The dual of the packed cells, filling the outline, all at once; see [`Fitting`].
pub fn fitted(domain: &Domain, particles: &[Particle]) -> Vec<Cell> {
    let mut fitting = Fitting::new(particles.to_vec());
    while !fitting.advance(domain) {}
    fitting.finish()
}

/// The dual of the packed cells, filling the outline, in the making. Cells that would be slivers are
/// joined to a neighbour, so there can be a few less than particles.
pub struct Fitting {
    cells: Vec<Cell>,
    /// How many of these are no images of others.
    count: usize,
    next: Next,
}

/// What the next slice of the work begins with.
enum Next {
    Dual(Vec<Particle>),
    Voronoi(Vec<Particle>),
    Making(Making),
    Band(Dual),
    Corners,
    Rounds(Straightening),
    Nothing,
}

impl Fitting {
    /// Cells for these particles, none made yet.
    pub fn new(particles: Vec<Particle>) -> Self {
        Self {
            cells: Vec::new(),
            count: 0,
            next: Next::Dual(particles),
        }
    }

    /// The plain Voronoi cells of these particles' centres within the outline, none made yet: each
    /// holds what is nearer to its centre than to any other, whatever comes of it. Pieces that the
    /// outline cuts off from their centre go to a neighbour, or are cells where they are large.
    pub fn voronoi(particles: Vec<Particle>) -> Self {
        Self {
            cells: Vec::new(),
            count: 0,
            next: Next::Voronoi(particles),
        }
    }

    /// One slice of the work; true when all is done.
    pub fn advance(&mut self, domain: &Domain) -> bool {
        self.next = match std::mem::replace(&mut self.next, Next::Nothing) {
            Next::Dual(particles) | Next::Voronoi(particles) if particles.is_empty() => {
                Next::Nothing
            }
            Next::Dual(particles) => Next::Making(Making::new(domain, particles, false)),
            Next::Voronoi(particles) => Next::Making(Making::new(domain, particles, true)),
            Next::Making(mut making) => match making.advance(domain) {
                Some(Made::Cells(cells)) => {
                    self.cells = cells;
                    Next::Corners
                }
                Some(Made::Dual(dual)) => Next::Band(dual),
                None => Next::Making(making),
            },
            Next::Band(dual) => {
                self.cells = dual.cells(domain);
                if dual.plain {
                    Next::Nothing
                } else {
                    Next::Corners
                }
            }
            Next::Corners => {
                self.count = self.cells.len();
                self.cells.extend(torus::images(domain, &self.cells));
                Next::Rounds(Straightening::new(domain, &self.cells))
            }
            Next::Rounds(mut straightening) => {
                if straightening.round(&self.cells) {
                    straightening.finish(&mut self.cells);
                    self.cells.truncate(self.count);
                    Next::Nothing
                } else {
                    Next::Rounds(straightening)
                }
            }
            Next::Nothing => Next::Nothing,
        };
        matches!(self.next, Next::Nothing)
    }

    /// The cells in the order of their ids.
    pub fn finish(self) -> Vec<Cell> {
        self.cells
    }
}

pub(super) fn cell(p: &Particle, ring: Vec<DVec2>) -> Cell {
    Cell {
        id: p.id,
        centre: p.centre,
        kind: p.kind,
        size: p.size,
        aspect: p.aspect,
        axis: p.axis,
        ring,
    }
}
