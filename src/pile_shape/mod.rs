//! Shapes made for piles: heaps, a rice ball, a block, a bowl and an open box.
//!
//! A shape has a surface, on which the bodies of a pile are thrown, and the walls that they do not pass. Bowls and
//! boxes are seen, too: each is a vessel around its content.
//!
//! y is up. A shape stands on y = 0, with its middle over the origin, and its largest side is about 1.

mod bowl;
mod closed;
mod cuboid;
mod edges;
pub(crate) mod numbers;
mod open;
mod open_box;
mod piled;
mod rings;
#[cfg(test)]
mod tests;

pub use piled::{PiledShape, Vessel};

use crate::shapes::numbers::by_rule;
use closed::RiceBallBuilding;

/// A shape to heap bodies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PileShape {
    /// Things poured on the ground.
    Heap,
    /// Half an ellipsoid on the ground.
    Dome,
    /// An onigiri: a thick triangle with soft corners.
    RiceBall,
    /// A box with rounded edges.
    Block,
    /// The content of a bowl.
    Bowl,
    /// The content of a box without a lid.
    OpenBox,
}

/// The shortest and the longest edges that a surface is made of.
const EDGES: [f64; 2] = [0.004, 0.25];

by_rule! {
    PileShape {
        RiceBall: "riceball", "Rice ball", numbers::RICE_BALL;
        Heap: "heap", "Heap", numbers::HEAP;
        Dome: "dome", "Dome", numbers::DOME;
        Block: "block", "Block", numbers::BLOCK;
        Bowl: "bowl", "Bowl", numbers::BOWL;
        OpenBox: "openbox", "Open box", numbers::OPEN_BOX;
    }
}

impl PileShape {
    /// Starts the shape. `numbers` are those of [`Self::numbers`]: they are clamped to their ranges, and defaults stand
    /// for missing ones. `edge` is the wanted length of the longest edges, as a share of 1; it is clamped to
    /// 0.004..0.25.
    pub fn building(self, numbers: &[f64], edge: f64) -> PileShapeBuilding {
        let n = self.fitted(numbers);
        let edge = if edge.is_finite() { edge } else { EDGES[1] };
        let edge = edge.clamp(EDGES[0], EDGES[1]);
        let made = match self {
            Self::RiceBall => {
                return PileShapeBuilding {
                    rice_ball: Some(Box::new(RiceBallBuilding::new(&n, edge))),
                    made: None,
                };
            }
            Self::Heap => open::heap(&n, edge),
            Self::Dome => open::dome(&n, edge),
            Self::Block => closed::block(&n, edge),
            Self::Bowl => bowl::bowl(&n, edge),
            Self::OpenBox => open_box::open_box(&n, edge),
        };
        PileShapeBuilding {
            rice_ball: None,
            made: Some(made),
        }
    }

    /// Makes the shape at once ([`Self::building`]).
    pub fn build(self, numbers: &[f64], edge: f64) -> PiledShape {
        let mut building = self.building(numbers, edge);
        loop {
            if let Some(made) = building.advance() {
                return made;
            }
        }
    }
}

/// A shape in progress, made in slices.
pub struct PileShapeBuilding {
    /// A rice ball takes several slices.
    rice_ball: Option<Box<RiceBallBuilding>>,
    /// Any other shape is made at once.
    made: Option<PiledShape>,
}

impl PileShapeBuilding {
    /// Does one slice; returns the shape in the end, once.
    pub fn advance(&mut self) -> Option<PiledShape> {
        match &mut self.rice_ball {
            Some(building) => building.advance(),
            None => self.made.take(),
        }
    }
}
