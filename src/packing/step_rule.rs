//! The rule by which the steps of a packing are made: its integrator with the constants of its physics.

use super::physics::Physics;
use super::{Integrator, PackingParams};
use crate::field::CellKind;

/// Damping by kind. A honeycomb of circles has more faults to heal than rows and columns, so circles are
/// damped less and keep moving for longer.
const fn damping(kind: CellKind) -> f64 {
    if matches!(kind, CellKind::Circle) {
        0.2
    } else {
        2.0
    }
}

/// Cooling factor of the time step for each late step, so that a cell caught between two directions comes to rest.
const COOLING: f64 = 0.97;

/// How single steps are made.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepRule {
    pub integrator: Integrator,
    pub physics: Physics,
    /// Whether moves are limited, and cells sleep.
    pub is_aided: bool,
    /// The time step.
    pub time_step: f64,
    /// Factor of the time step; 1 until cooling begins.
    pub pace: f64,
}

impl StepRule {
    /// The rule of a packing, at full pace.
    pub fn new(params: &PackingParams) -> Self {
        let (physics, integrator) = (params.physics, params.integrator);
        let by_default = match integrator {
            Integrator::SemiImplicit | Integrator::Euler => 0.5,
            // Stable while damping times step is below 2.
            Integrator::RungeKutta => 0.6,
        };
        Self {
            integrator,
            physics,
            is_aided: physics == Physics::DEFAULT && integrator != Integrator::Euler,
            time_step: physics.time_step.unwrap_or(by_default),
            pace: 1.0,
        }
    }

    /// Viscous damping of a kind.
    pub fn damping(&self, kind: CellKind) -> f64 {
        self.physics.damping.unwrap_or(damping(kind))
    }

    /// Factor of the time step for each late step; 1 without cooling.
    pub fn cooling(&self) -> f64 {
        let by_default = if self.is_aided { COOLING } else { 1.0 };
        self.physics.cooling.unwrap_or(by_default)
    }
}
