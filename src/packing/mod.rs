//! Packs cells of all kinds into the outline by the forces between them.
//!
//! Miyata, Itoh, Shimada (2000), section 4, in its order: cells along the boundary and inside it
//! (`placement`), forces between neighbours (`force`) and from the walls (`wall`), the equation of
//! motion (`integrate`), population control (`population`). A [`Packing`] advances one step at a
//! time; nothing in it knows of time or frames.
//!
//! Particles are sorted by the neighbour grid's buckets whenever the list of neighbours is made, so
//! that what is near in the plane is near in memory. Their ids stay, and whatever might depend on the
//! order (population control, the result) goes by id.
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

mod boundary_cells;
mod clearance;
pub mod force;
mod front;
mod grid;
mod integrate;
mod measures;
mod params;
mod placed;
mod placement;
mod population;
mod quadtree;
mod shape;
mod stress;
mod wall;
mod warm_start;

pub(crate) use grid::Grid;
pub use measures::{Alignment, NetForce, Sample};
pub use params::{BoundaryCondition, Integrator, PackingParams, Population, Start};
pub use placement::Placing;
pub use stress::{Stress, stress};

use crate::domain::{Domain, Walls};
use crate::field::{Fields, Kind};
use crate::notice::Notice;
use crate::order;
use crate::random::{Purpose, Random};
use glam::DVec2;
use integrate::Motion;
use params::TUNING;
use shape::Shape;

/// What cells are packed in.
#[derive(Clone, Copy)]
struct Surroundings<'a> {
    pub domain: &'a Domain,
    pub fields: &'a Fields,
    pub walls: &'a Walls,
    pub boundary: BoundaryCondition,
}

/// A packed cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Names the cell: the number of its making, never used again.
    pub id: u32,
    /// Its middle, in picture units.
    pub centre: DVec2,
    /// Its shape.
    pub kind: Kind,
    /// The side of its square, the diameter of its circle; a stretched cell has half axes of
    /// `size / 2` times and over the root of `aspect`.
    pub size: f64,
    /// Length along `axis` over width; 1 for squares and circles.
    pub aspect: f64,
    /// Unit vector along a side; zero where the direction field vanishes.
    pub axis: DVec2,
    /// Its centre is held on the boundary.
    pub fixed: bool,
}

impl Particle {
    /// A cell that has what the fields ask for at its place.
    pub fn new(id: u32, centre: DVec2, fixed: bool, fields: &Fields) -> Self {
        Self {
            id,
            centre,
            kind: fields.kind(centre),
            size: fields.size(centre),
            aspect: fields.aspect(centre),
            axis: fields.direction(centre),
            fixed,
        }
    }
}

/// What the last step did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Steps made so far.
    pub step: u32,
    /// Cells there are.
    pub cells: usize,
    /// The largest move of a cell, in its size.
    pub largest_move: f64,
    /// The largest force on a cell, in its size.
    pub largest_force: f64,
    /// Cells added so far after the first placement.
    pub added: u32,
    /// Cells removed so far.
    pub removed: u32,
    /// Nothing more will happen.
    pub done: bool,
    /// The run ended because forces and moves were small.
    pub converged: bool,
}

/// A cell in motion.
#[derive(Clone, Copy, Debug)]
struct Body {
    particle: Particle,
    velocity: DVec2,
    /// This cell's size over what the size field asks for.
    factor: f64,
    /// It has moved in the last step, or is new.
    has_moved: bool,
}

impl Body {
    /// Moves it; its direction and size follow the fields.
    fn place(&mut self, centre: DVec2, fields: &Fields) {
        self.particle.centre = centre;
        self.particle.axis = fields.direction(centre);
        self.particle.size = self.factor * fields.size(centre);
        self.particle.aspect = fields.aspect(centre);
    }
}

/// A packing on its way.
#[derive(Clone, Debug)]
pub struct Packing {
    params: PackingParams,
    walls: Walls,
    bodies: Vec<Body>,
    motion: Motion,
    next_id: u32,
    report: StepReport,
    /// The step of the last population control.
    controlled: u32,
    /// The record of the run.
    samples: Vec<Sample>,
}

impl Packing {
    /// Places the first cells, all at once; see [`Placing`].
    ///
    /// # Errors
    /// A notice where the outline would take more cells than can be packed.
    pub fn new(domain: &Domain, fields: &Fields, params: PackingParams) -> Result<Self, Notice> {
        let mut placing = Placing::new(domain, fields, params)?;
        while !placing.advance(domain, fields) {}
        Ok(placing.finish(domain, fields))
    }

    /// Of these centres; true where one is fixed.
    fn of(
        cells: impl Iterator<Item = (DVec2, bool)>,
        fields: &Fields,
        params: PackingParams,
        walls: Walls,
    ) -> Self {
        let mut packing = Self {
            params,
            walls,
            bodies: Vec::new(),
            motion: Motion::default(),
            next_id: 0,
            report: StepReport::default(),
            controlled: 0,
            samples: Vec::new(),
        };
        for (centre, fixed) in cells {
            packing.add(fields, centre, fixed);
        }
        packing.assign_sizes(fields);
        packing.report.cells = packing.bodies.len();
        packing.report.done = packing.bodies.is_empty();
        packing.report.converged = packing.report.done;
        packing
    }

    fn add(&mut self, fields: &Fields, centre: DVec2, fixed: bool) {
        let particle = Particle::new(self.next_id, centre, fixed, fields);
        self.next_id += 1;
        self.bodies.push(Body {
            particle,
            velocity: DVec2::ZERO,
            factor: 1.0,
            has_moved: true,
        });
    }

    /// Vs: cells are placed at equal sizes, then each gets its own. Drawing sizes while places are
    /// filled would leave the large ones out.
    fn assign_sizes(&mut self, fields: &Fields) {
        let variance = self.params.variance;
        if variance == 0.0 {
            return;
        }
        for body in &mut self.bodies {
            let mut random = Random::new(self.params.seed, Purpose::Size, body.particle.id.into());
            // Uniform with the standard deviation Vs.
            body.factor = 1.0 + variance * 3.0_f64.sqrt() * random.signed();
            body.particle.size = body.factor * fields.size(body.particle.centre);
        }
    }

    /// The cells in the order of their ids.
    pub fn particles(&self) -> Vec<Particle> {
        let mut particles: Vec<Particle> = self.bodies.iter().map(|b| b.particle).collect();
        order::sort(&mut particles, |p| (p.id.into(), 0));
        particles
    }

    /// What the last step did.
    pub fn report(&self) -> StepReport {
        self.report
    }

    /// Nothing more will happen.
    pub fn done(&self) -> bool {
        self.report.done
    }

    /// One step of the equation of motion and, now and then, population control.
    pub fn step(&mut self, domain: &Domain, fields: &Fields) -> StepReport {
        if self.report.done {
            return self.report;
        }
        let step = self.report.step + 1;
        let late = step.saturating_sub(TUNING.cooling_from);
        let pace = (0..late).fold(1.0, |pace, _| pace * TUNING.cooling);
        self.motion.refresh(&mut self.bodies, domain);
        let around = Surroundings {
            domain,
            fields,
            walls: &self.walls,
            boundary: self.params.boundary,
        };
        let (largest_move, largest_force) =
            self.motion
                .step(&mut self.bodies, around, self.params.integrator, pace);
        self.report.step = step;
        self.report.largest_move = largest_move;
        self.report.largest_force = largest_force;
        let small = step >= TUNING.least_steps
            && largest_move < TUNING.move_end
            && (largest_force < TUNING.force_end || late > 0);
        let changed = self.control_population(domain, fields, small);
        self.report.cells = self.bodies.len();
        self.report.converged = small && !changed;
        self.report.done = self.report.converged || step >= TUNING.most_steps;
        self.sample(domain);
        self.report
    }

    /// Adds and removes cells where it is time to; true where any were.
    fn control_population(&mut self, domain: &Domain, fields: &Fields, small: bool) -> bool {
        let step = self.report.step;
        let due = step - self.controlled >= TUNING.population_every;
        if self.params.population == Population::Off
            || step > TUNING.population_until
            || !(due || small)
        {
            return false;
        }
        self.controlled = step;
        let around = Surroundings {
            domain,
            fields,
            walls: &self.walls,
            boundary: self.params.boundary,
        };
        let change = population::change(around, &self.bodies, &self.params);
        let mut index = 0;
        self.bodies.retain(|_| {
            index += 1;
            !change.remove[index - 1]
        });
        let removed = change.remove.iter().filter(|&&gone| gone).count() as u32;
        for &centre in &change.add {
            self.add(fields, centre, false);
        }
        self.report.removed += removed;
        self.report.added += change.add.len() as u32;
        let changed = removed > 0 || !change.add.is_empty();
        if changed {
            self.motion.forget();
        }
        if removed > 0 {
            // Their neighbours are not known any more.
            self.bodies
                .iter_mut()
                .for_each(|body| body.has_moved = true);
        }
        changed
    }
}

/// The greatest length that any cell can have in this outline.
fn greatest_length(domain: &Domain, fields: &Fields, params: &PackingParams) -> f64 {
    let (lo, hi) = domain.bounds();
    let mut largest = 0.0_f64;
    for row in 0..=16 {
        for column in 0..=16 {
            let t = DVec2::new(f64::from(column), f64::from(row)) / 16.0;
            largest = largest.max(Shape::at(fields, lo + (hi - lo) * t).length());
        }
    }
    largest * (1.0 + params.variance * 3.0_f64.sqrt())
}
