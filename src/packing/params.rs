//! Parameters of a packing, and its fixed constants.

use super::physics::Physics;
use crate::random::SEED;
use glam::DVec2;

/// How the cells meet the boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundaryCondition {
    /// The cells' edges lie on the boundary: a soft wall pushes the centres to half a cell from it.
    Wall,
    /// Cells along the boundary have their centres on it and are fixed, as in the papers.
    On,
    /// There are no walls, and cells may leave the outline.
    Open,
}

/// How the inside is first filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Cell by cell from the boundary inwards along the direction field.
    Stream,
    /// One cell in every leaf of a quadtree, as in the papers.
    Quadtree,
    /// At random places.
    Random,
}

/// A cell whose place at the start is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GivenCell {
    /// Its centre, in picture units.
    pub centre: DVec2,
    /// Whether it is held there.
    pub is_held: bool,
}

/// How the equation of motion is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Semi-implicit Euler: one evaluation of the forces a step.
    SemiImplicit,
    /// Fourth-order Runge-Kutta, as in the papers: four evaluations a step.
    RungeKutta,
    /// Explicit Euler: one evaluation a step. It is unstable at time steps at which the other two are stable.
    Euler,
}

/// How cells are added and removed during the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Population {
    /// A cell is added where another one has an empty neighbouring place.
    Slots,
    /// The papers' rule, at empty places only: a cell is added beside a cell whose nearest neighbour is far.
    Smallest,
    /// The papers' rule alone: if a cell's nearest neighbour is far, a cell is added opposite that neighbour, even if
    /// the place is not empty.
    Opposite,
    /// The number of cells does not change.
    Off,
}

/// Parameters of a packing, besides the outline and the fields.
#[derive(Clone, Debug, PartialEq)]
pub struct PackingParams {
    /// How the cells meet the boundary.
    pub boundary: BoundaryCondition,
    /// How the inside is first filled.
    pub start: Start,
    /// The number of cells that start at random places; 0 for as many as have room.
    pub count: u32,
    /// The cells at the start: if there are any, no other cells are placed. Empty if cells are placed by `start`.
    pub given: Vec<GivenCell>,
    /// The greatest random displacement of a free cell at the start, in sizes: 0..2.
    pub jolt: f64,
    /// How the equation of motion is integrated.
    pub integrator: Integrator,
    /// How cells are added and removed.
    pub population: Population,
    /// Vs: the standard deviation of the cells' sizes over their mean, 0..0.5.
    pub variance: f64,
    /// Seed of the sizes and of random choices in placement.
    pub seed: u64,
    /// The constants of motion, forces, population and end.
    pub physics: Physics,
}

impl PackingParams {
    /// Cells with their edges on the boundary, and our own choices for placement, motion and population.
    pub const DEFAULT: Self = Self {
        boundary: BoundaryCondition::Wall,
        start: Start::Stream,
        count: 0,
        given: Vec::new(),
        jolt: 0.0,
        integrator: Integrator::SemiImplicit,
        population: Population::Slots,
        variance: 0.0,
        seed: SEED,
        physics: Physics::DEFAULT,
    };
}

impl Default for PackingParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The schedule of a run, and the greatest size of a packing; [`Physics`] has the constants that a recipe may change.
pub(crate) struct Tuning {
    /// A run does not end before this many steps.
    pub least_steps: u32,
    /// Interval of population control, in steps.
    pub population_every: u32,
    /// The last step with population control.
    pub population_until: u32,
    /// The step at which cooling begins.
    pub cooling_from: u32,
    /// The most cells in a packing; a larger number gives a notice.
    pub most_cells: f64,
}

pub(crate) const TUNING: Tuning = Tuning {
    least_steps: 10,
    population_every: 10,
    population_until: 100,
    cooling_from: 100,
    most_cells: 250_000.0,
};
