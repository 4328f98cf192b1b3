//! Reports of a run: on its last step, and on those before.

/// The result of the last step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Steps made so far.
    pub step: u32,
    /// The number of cells.
    pub cells: usize,
    /// The largest move of a cell, in its size.
    pub largest_move: f64,
    /// The largest force on a cell, in its size.
    pub largest_force: f64,
    /// Cells added so far after the first placement.
    pub added: u32,
    /// Cells removed so far.
    pub removed: u32,
    /// Whether the run has ended.
    pub done: bool,
    /// Whether it ended because forces and moves were small.
    pub converged: bool,
}

/// One row of a run's record.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Steps made.
    pub step: u32,
    /// See [`super::Packing::energy`].
    pub energy: f64,
    /// The largest move of a cell in this step, in its size.
    pub largest_move: f64,
}
