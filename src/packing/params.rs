//! What a packing is asked for, and what of its making is fixed.

/// How the cells meet the boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundaryCondition {
    /// The cells' edges lie on it: a soft wall pushes them to half a cell from it.
    Wall,
    /// The cells' centres lie on it and are fixed, as in the papers.
    On,
}

/// How the inside is filled at first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Cell by cell from the boundary inwards along the direction field.
    Stream,
    /// One cell in every leaf of a quadtree, as the papers say.
    Quadtree,
}

/// How the equation of motion is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Semi-implicit Euler: one evaluation of the forces a step.
    SemiImplicit,
    /// Fourth-order Runge-Kutta, as the papers say: four evaluations a step.
    RungeKutta,
}

/// How cells are added and removed on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Population {
    /// A cell is added where an edge of another has an empty place for it.
    Slots,
    /// The papers' rule: a cell is added beside one whose nearest neighbour is far.
    Smallest,
    /// The number of cells stays as it was placed.
    Off,
}

/// What a packing is made from, besides the outline and the fields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackingParams {
    /// How the cells meet the boundary.
    pub boundary: BoundaryCondition,
    /// How the inside is filled at first.
    pub start: Start,
    /// How the equation of motion is integrated.
    pub integrator: Integrator,
    /// How cells are added and removed.
    pub population: Population,
    /// Vs: the standard deviation of the cells' sizes over their mean, 0..0.5.
    pub variance: f64,
    /// Draws the sizes and whatever placement leaves to chance.
    pub seed: u64,
}

/// The constants of the relaxation, in cell sizes where they are lengths.
pub(crate) struct Tuning {
    /// A run has ended when no force is larger ...
    pub force_end: f64,
    /// ... nor any move of the last step ...
    pub move_end: f64,
    /// ... but not before this many steps.
    pub least_steps: u32,
    /// Population is looked at every so many steps ...
    pub population_every: u32,
    /// ... and not after this many.
    pub population_until: u32,
    /// From this step on the time step shrinks by `cooling` a step, so that a cell caught between
    /// two directions comes to rest.
    pub cooling_from: u32,
    pub cooling: f64,
    /// The run ends here in any case.
    pub most_steps: u32,
    /// The most cells that are packed: of more there is a notice.
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
