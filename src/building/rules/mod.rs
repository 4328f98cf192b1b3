//! Buildings by rule.
//!
//! Sizes are counted as masons do, in modules along walls and in courses upwards ([`Module`]): a pier is n modules less
//! a joint, an opening n modules and a joint. So all solids lie half a joint inside of the lines of the module's grid,
//! and cells that claim whole modules fill the walls, with a half joint beyond each end. Only the ground is a line of
//! the grid itself.
//!
//! Buildings stand on y = 0, with their middle over the origin. Fronts look along +z.

mod drafting;
mod drawn;
mod drawn_fault;
#[cfg(test)]
mod drawn_tests;
mod gabled;
mod hipped;
mod lhouse;
pub(crate) mod numbers;
mod openings;
mod panes;
mod plain;
mod plan_line;
mod steps;
#[cfg(test)]
mod tests;
mod tower;
mod wall_line;
mod wall_plane;
mod walls;

pub(super) use drafting::flat_surface;
pub use drawn::DrawnPlan;
pub use drawn_fault::{
    DrawnFault, FARTHEST_CORNER, LEAST_OVER, LEAST_PIER, OpeningFault, SHARPEST,
};
pub use openings::OpeningHead;

use super::draft::Draft;
use crate::shapes::numbers::by_rule;

/// The module of masonry, joints included (metres).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Module {
    /// The width of half a brick with its joint, W; above `joint`.
    pub half: f64,
    /// The height of a course with its joint, H; above `joint`.
    pub course: f64,
    /// The thickness of a joint, at least 0.
    pub joint: f64,
}

impl Module {
    /// German normal format: 250 x 125 x 83.3 mm with joints of 10 mm.
    pub const NORMAL: Self = Self {
        half: 0.125,
        course: 0.25 / 3.0,
        joint: 0.01,
    };

    /// A solid of n modules: n W less a joint.
    pub(super) fn pier(&self, modules: f64) -> f64 {
        modules * self.half - self.joint
    }

    /// The height at which a solid of n courses on the ground ends.
    pub(super) fn top(&self, courses: f64) -> f64 {
        courses * self.course - self.joint
    }
}

/// A building by rule. Widths are modules, heights are courses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// A house with gables, a roof, windows and a door.
    Gabled,
    /// A house with an L-shaped plan, three gables, windows and a door.
    LHouse,
    /// A plain block.
    Block,
    /// A free-standing wall with three openings.
    Wall,
    /// A gate with a round arch.
    Gate,
    /// Steps between two columns, with rails.
    Steps,
    /// A round tower with windows.
    Tower,
    /// A closed ring of straight walls.
    Ring,
    /// A wall that is a single polygon with a thickness.
    Sheet,
    /// Walls over a plan, which may be drawn ([`DrawnPlan`]).
    Plan,
}

by_rule! {
    Rule {
        Gabled: "gabled", "House with gables", numbers::GABLED;
        LHouse: "lhouse", "L-shaped house", numbers::L_HOUSE;
        Block: "block", "Block", numbers::BLOCK;
        Wall: "wall", "Wall with openings", numbers::WALL;
        Gate: "gate", "Gate", numbers::GATE;
        Steps: "steps", "Steps with columns", numbers::STEPS;
        Tower: "tower", "Round tower", numbers::TOWER;
        Ring: "ring", "Ring of walls", numbers::RING;
        Sheet: "sheet", "Single wall", numbers::SHEET;
        Plan: "plan", "Walls over a plan", numbers::PLAN;
    }
}

impl Rule {
    /// Makes the building. `numbers` are those of [`Self::numbers`]: they are clamped to their ranges, and defaults stand
    /// for missing ones. Where parts would not fit, there are fewer or smaller ones.
    pub fn draft(self, module: &Module, numbers: &[f64]) -> Draft {
        let n = self.fitted(numbers);
        match self {
            Self::Block => plain::block(module, &n),
            Self::LHouse => lhouse::l_house(module, &n),
            Self::Gabled => gabled::gabled(module, &n),
            Self::Wall => walls::wall(module, &n),
            Self::Gate => walls::gate(module, &n),
            Self::Steps => steps::steps(module, &n),
            Self::Tower => tower::tower(module, &n),
            Self::Ring => plain::ring(module, &n),
            Self::Sheet => plain::sheet(module, &n),
            Self::Plan => DrawnPlan::default().draft(module, &n).0,
        }
    }
}
