//! Packs cells of all kinds into the outline by the forces between them.
//!
//! The modules follow Miyata, Itoh, Shimada (2000), section 4: cells along the boundary and inside it (`placement`),
//! forces between neighbours (`force`) and from the walls (`wall`), the equation of motion (`integrate`), population
//! control (`population`). A [`Packing`] advances one step at a time; it knows nothing of clocks or frames.
//!
//! Particles are sorted by the neighbour grid's buckets whenever the neighbour list is made, so that
//! neighbours in the plane are close in memory. Their ids stay. Whatever might depend on the order
//! (population control, the result) goes by id.
//!
//! ```
//! # use bubblestone::domain::{Domain, Outline};
//! # use bubblestone::field::{FieldBuilder, FieldParams};
//! use bubblestone::packing::{Integrator, Packing, PackingParams};
//!
//! # let corners = [(14.0, 14.0), (114.0, 14.0), (114.0, 114.0), (14.0, 114.0)];
//! # let rings = vec![corners.map(glam::DVec2::from).to_vec()];
//! # let domain = Domain::from_checked(&Outline { rings, ..Outline::default() });
//! # let params = FieldParams { size: 12.5, ..FieldParams::default() };
//! # let fields = FieldBuilder::build(&domain, params);
//! // `domain` is a square of side 100, and `fields` ask for cells of side 12.5.
//! let params = PackingParams {
//!     integrator: Integrator::RungeKutta,
//!     ..PackingParams::default()
//! };
//! let mut packing = Packing::new(&domain, &fields, params).expect("not too many cells");
//! while !packing.done() {
//!     packing.step(&domain, &fields);
//! }
//! assert!(packing.report().converged);
//! assert_eq!(packing.particles().len(), 64);
//! ```

mod body;
mod boundary_cells;
pub(crate) mod cell_fields;
pub(crate) mod chains;
pub(crate) mod clearance;
mod energy;
pub mod force;
pub(crate) mod front;
mod grid;
mod history;
mod integrate;
mod measures;
mod neighbour_list;
mod new_places;
mod numbers;
pub(crate) mod packing_domain;
mod pair_forces;
mod params;
mod physics;
pub(crate) mod placed;
mod placement;
mod plane;
pub(crate) mod population;
mod quadtree;
mod report;
pub(crate) mod run;
mod runge_kutta;
pub(crate) mod shape;
mod square_pairs;
mod step_rule;
mod stress;
mod surroundings;
pub(crate) mod transport;
pub(crate) mod wall;
mod warm_start;

pub(crate) use grid::Grid;
pub use history::{History, Kept};
pub use measures::{Alignment, NetForce};
pub use numbers::{CellNumbers, NeighbourNumbers};
pub use params::{BoundaryCondition, GivenCell, Integrator, PackingParams, Population, Start};
pub use physics::{CornerBubbles, Physics};
pub use placement::Placing;
pub use report::{EnergyParts, PopulationChange, Sample, StepReport};
#[cfg(house)]
pub(crate) use stress::{BEYOND, stress_on};
pub use stress::{Stress, stress};

use crate::domain::{Domain, Walls};
use crate::field::{CellKind, Fields};
use crate::notice::Notice;
use cell_fields::CellFields;
use glam::DVec2;
pub(crate) use params::TUNING;
#[cfg(house)]
pub(crate) use params::Tuning;
use run::Run;
use shape::CellShape;
use surroundings::PlaneDomain;

/// A packed cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle<P = DVec2> {
    /// The cell's number in order of creation, never reused.
    pub id: u32,
    /// The cell's centre; in the plane, in picture units.
    pub centre: P,
    /// The cell's kind, which defines its shape.
    pub kind: CellKind,
    /// The side of a square or the diameter of a circle. A stretched cell's half axes are `size / 2` times the root of
    /// `aspect`, along `axis`, and `size / 2` over that root, across.
    pub size: f64,
    /// Length along `axis` over width; 1 for squares and circles.
    pub aspect: f64,
    /// Unit vector along a side, in the frame of the centre; zero where the direction field vanishes.
    pub axis: DVec2,
    /// Whether the centre is held in place, as on the boundary.
    pub fixed: bool,
}

impl<P: Copy> Particle<P> {
    /// A cell with the fields' values at its place.
    pub(crate) fn new<A: CellFields<Place = P>>(id: u32, centre: P, fixed: bool, asked: A) -> Self {
        Self {
            id,
            centre,
            kind: asked.kind(centre),
            size: asked.size(centre),
            aspect: asked.aspect(centre),
            axis: asked.direction(centre),
            fixed,
        }
    }
}

/// A packing in progress.
#[derive(Clone, Debug)]
pub struct Packing {
    run: Run<DVec2>,
    walls: Walls,
    left_out: usize,
}

impl Packing {
    /// Places all the first cells at once; see [`Placing`].
    ///
    /// # Errors
    /// A notice if the outline would take more cells than can be packed.
    pub fn new(domain: &Domain, fields: &Fields, params: PackingParams) -> Result<Self, Notice> {
        let mut placing = Placing::new(domain, fields, params)?;
        while !placing.advance(domain, fields) {}
        Ok(placing.finish(domain, fields))
    }

    /// The cells in the order of their ids.
    pub fn particles(&self) -> Vec<Particle> {
        self.run.particles()
    }

    /// The cells in the outline, in the order of their ids. Cells can leave only an open outline.
    pub fn particles_within(&self, domain: &Domain) -> Vec<Particle> {
        let is_open = self.run.params.boundary == BoundaryCondition::Open;
        let mut particles = self.particles();
        particles.retain(|cell| !is_open || domain.contains(cell.centre));
        particles
    }

    /// How many given cells were left out, because they lie outside the outline.
    pub fn left_out(&self) -> usize {
        self.left_out
    }

    /// The result of the last step.
    pub fn report(&self) -> StepReport {
        self.run.report()
    }

    /// Whether the run has ended.
    pub fn done(&self) -> bool {
        self.run.report().done
    }

    /// Makes one step of the equation of motion, with population control when it is due.
    pub fn step(&mut self, domain: &Domain, fields: &Fields) -> StepReport {
        let around = PlaneDomain {
            domain,
            fields,
            walls: &self.walls,
            boundary: self.run.params.boundary,
        };
        self.run.step(around)
    }
}

/// The greatest length that a cell can have in this outline, from the fields at 17 x 17 places and the variance.
fn greatest_length(domain: &Domain, fields: &Fields, params: &PackingParams) -> f64 {
    let (lo, hi) = domain.bounds();
    let mut largest = 0.0_f64;
    for row in 0..=16 {
        for column in 0..=16 {
            let t = DVec2::new(f64::from(column), f64::from(row)) / 16.0;
            largest = largest.max(CellShape::at(fields, lo + (hi - lo) * t).length());
        }
    }
    largest * (1.0 + params.variance * 3.0_f64.sqrt())
}
