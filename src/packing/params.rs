//! Parameters of a packing, and its fixed constants.

use crate::random::SEED;

/// How the cells meet the boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundaryCondition {
    /// The cells' edges lie on it: a soft wall pushes them to half a cell from it.
    Wall,
    /// The cells' centres lie on it and are fixed, as in the papers.
    On,
}

/// How the inside is first filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Cell by cell from the boundary inwards along the direction field.
    Stream,
    /// One cell in every leaf of a quadtree, as in the papers.
    Quadtree,
}

/// How the equation of motion is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Semi-implicit Euler: one evaluation of the forces a step.
    SemiImplicit,
    /// Fourth-order Runge-Kutta, as in the papers: four evaluations a step.
    RungeKutta,
}

/// How cells are added and removed during the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Population {
    /// A cell is added where another one has an empty neighbouring place.
    Slots,
    /// The papers' rule: a cell is added beside one whose nearest neighbour is far.
    Smallest,
    /// The number of cells does not change.
    Off,
}

/// Parameters of a packing, besides the outline and the fields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackingParams {
    /// How the cells meet the boundary.
    pub boundary: BoundaryCondition,
    /// How the inside is first filled.
    pub start: Start,
    /// How the equation of motion is integrated.
    pub integrator: Integrator,
    /// How cells are added and removed.
    pub population: Population,
    /// Vs: the standard deviation of the cells' sizes over their mean, 0..0.5.
    pub variance: f64,
    /// Seed of the sizes and of random choices in placement.
    pub seed: u64,
}

impl PackingParams {
    /// Cells with their edges on the boundary, and our own choices for placement, motion and population.
    pub const DEFAULT: Self = Self {
        boundary: BoundaryCondition::Wall,
        start: Start::Stream,
        integrator: Integrator::SemiImplicit,
        population: Population::Slots,
        variance: 0.0,
        seed: SEED,
    };
}

impl Default for PackingParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The constants of the relaxation; lengths are in cell sizes.
pub(crate) struct Tuning {
    /// A run ends when no force is larger than this ...
    pub force_end: f64,
    /// ... and no move of the last step larger than this ...
    pub move_end: f64,
    /// ... but not before this many steps.
    pub least_steps: u32,
    /// Interval of population control, in steps ...
    pub population_every: u32,
    /// ... and its last step.
    pub population_until: u32,
    /// From this step on the time step is multiplied by `cooling` each step, so that a cell caught between
    /// two directions comes to rest.
    pub cooling_from: u32,
    pub cooling: f64,
    /// The run ends at this step in any case.
    pub most_steps: u32,
    /// The most cells in a packing; a larger number gives a notice.
    pub most_cells: f64,
}

pub(crate) const TUNING: Tuning = Tuning {
    force_end: 0.05,
    move_end: 0.02,
    least_steps: 10,
    population_every: 10,
    population_until: 100,
    cooling_from: 100,
    cooling: 0.97,
    most_steps: 200,
    most_cells: 250_000.0,
};
