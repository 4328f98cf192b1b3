//! Reports of a run: the result of the last step, the record of all steps, and the changes of the population.

use glam::DVec2;

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
    /// The first step in which a cell flew: it moved farther in one step than the forces of neighbours reach. 0
    /// if none did.
    pub flown_at: u32,
    /// Whether the run has ended.
    pub done: bool,
    /// Whether it ended because forces and moves were small.
    pub converged: bool,
}

/// The energy of a packing by parts, in units of the mean cell's k0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyParts {
    /// The potentials of all pairs (eq. 4).
    pub pairs: f64,
    /// The potentials of the walls.
    pub walls: f64,
    /// The kinetic energy m v^2 / 2 of all cells.
    pub motion: f64,
}

impl EnergyParts {
    /// The sum of the parts; in exact motion of the same cells, only damping changes it.
    pub fn sum(&self) -> f64 {
        self.pairs + self.walls + self.motion
    }
}

/// One row of a run's record.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Steps made.
    pub step: u32,
    /// The energy of pairs, of walls and of motion.
    pub energy: EnergyParts,
    /// The largest move of a cell in this step, in its size.
    pub largest_move: f64,
}

/// A cell that came or went after the first placement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PopulationChange<P = DVec2> {
    /// The steps made when it came or went.
    pub step: u32,
    /// The cell's number.
    pub id: u32,
    /// The cell's centre when it came or went; in the plane, in picture units.
    pub centre: P,
    /// True if the cell came, false if it went.
    pub came: bool,
}
