//! The physics of a packing as one value: the constants of the equation of motion, of the corner bubbles, of
//! the population, and of the end of a run.
//!
//! Miyata, Itoh, Shimada (2000), sections 4.2 and 4.3; Itoh, Miyata, Shimada (2003), section 5.1. Lengths are
//! in sizes of a cell d, the spring constant k0 of a pair is its squared stable distance, and time is in
//! units of sqrt(m d^2 / k0). So one set of constants serves all sizes.

use super::shape::CUT;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// The four corner bubbles of cells with corners (eq. 4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CornerBubbles {
    /// Weight of the corner bubbles' potentials.
    pub weight: f64,
    /// The range of a corner's force, over the range of the papers' corner bubbles.
    reach: f64,
}

impl CornerBubbles {
    /// The corner bubbles of the papers: weight and radius are sqrt 2 - 1.
    pub const PAPERS: Self = Self {
        weight: SQRT_2 - 1.0,
        reach: 1.0,
    };

    /// Corner bubbles of this weight and this radius, in radii r0 of the central bubble. The stable distance
    /// of a corner from a neighbour's centre is the sum of both radii.
    pub fn new(weight: f64, radius: f64) -> Self {
        let reach = (1.0 + radius) * FRAC_1_SQRT_2;
        Self { weight, reach }
    }

    /// The stable distance of a corner from a neighbour's centre, for two cells of these sizes. For equal sizes d and
    /// the papers' radius it is d / sqrt 2, so that the neighbour touches along an edge.
    #[inline(always)]
    pub(super) fn stable_distance(self, (a, b): (f64, f64)) -> f64 {
        self.reach
            * if a == b {
                a * FRAC_1_SQRT_2
            } else {
                0.5 * (a * a + b * b).sqrt()
            }
    }

    /// Reach of a square cell, in stable distances of its pair: half a diagonal to the corner, plus the reach
    /// of the corner's own force.
    pub(super) fn square_reach(self) -> f64 {
        FRAC_1_SQRT_2 * (1.0 + CUT * self.reach)
    }
}

/// The constants of a packing. While one of them differs from [`Physics::DEFAULT`], all aids that save time or smooth
/// are off: the limit of a move, the sleep of cells, and cooling. So an unstable run visibly explodes, and cells that
/// move little in short time steps do not fall asleep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Physics {
    /// Viscous damping c, 0..; by default 2, and 0.2 for circles.
    pub damping: Option<f64>,
    /// The mass m of a cell.
    pub mass: f64,
    /// Factor of k0, and so of all forces.
    pub stiffness: f64,
    /// The time step; by default 0.5, and 0.6 for Runge-Kutta.
    pub time_step: Option<f64>,
    /// The corner bubbles.
    pub corners: CornerBubbles,
    /// A cell is removed if its nearest neighbour is nearer than this, in stable distances (w); by default it depends
    /// on the kind.
    pub crowded: Option<f64>,
    /// The least distance for a new cell, in stable distances: from its place to the nearest cell, or by the papers'
    /// rule from a cell to its nearest neighbour. By default it depends on the rule and the kind.
    pub roomy: Option<f64>,
    /// A run ends when no force is larger than this and no move larger than `move_end`. In sizes.
    pub force_end: f64,
    /// The limit of the moves of the last step, in sizes; see `force_end`.
    pub move_end: f64,
    /// A run ends at this step in any case.
    pub most_steps: u32,
    /// Late in a run, the time step is multiplied by this each step; by default 0.97, or 1 while another
    /// constant differs from its default.
    pub cooling: Option<f64>,
}

impl Physics {
    /// The constants of all pictures that ask for no others.
    pub const DEFAULT: Self = Self {
        damping: None,
        mass: 1.0,
        stiffness: 1.0,
        time_step: None,
        corners: CornerBubbles::PAPERS,
        crowded: None,
        roomy: None,
        force_end: 0.05,
        move_end: 0.02,
        most_steps: 200,
        cooling: None,
    };
}
