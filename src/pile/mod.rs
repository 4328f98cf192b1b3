//! Piles: bodies heaped on a surface by rule, without physics.
//!
//! Sakurai, Miyata (2014), Modelling of Non-Periodic Aggregates Having a Pile Structure. The work has two steps:
//!
//! 1. *Placement* (section 4.1): [`Darting`] throws points on the surface so densely that bodies there overlap their
//!    neighbours, [`LayerDarting`] throws those of inner layers, [`merge`] joins the points of several types, and
//!    [`Turn`] gives each body an orientation.
//! 2. *Refinement* (section 4.2): [`Refining`] takes one body after the other and slides it along the surface's normal
//!    until it only touches those that have settled before. A body that finds no place is removed.
//!
//! The paper searches the place by golden section, which [`Method::Golden`] does. [`Method::Exact`] solves the same
//! question without iteration: two spheres, of which one moves along a line, overlap in one interval of that line. The
//! union of these intervals is all that is blocked.
//!
//! A body is known by the inner spheres of its component ([`Shape`]), in order of their use. Lengths are in the units of
//! the surface.

mod blocked;
mod body;
mod darts;
mod golden;
mod kind;
mod layers;
mod measures;
mod merge;
mod refine;
mod settled;
mod sliding;
mod sliding_line;
mod turn;
mod walls;

#[cfg(test)]
mod fixture;
#[cfg(test)]
mod tests;

pub use body::{Body, Fate};
pub use darts::{Dart, Darting, expected_darts, same_side};
pub use golden::Reading;
pub use kind::{Kind, Shape, natural_range};
pub use layers::LayerDarting;
pub use measures::{contacts, deepest_overlap, deepest_overlaps, pierced};
pub use merge::merge;
pub use refine::{Method, Order, RefineParams, Refining};
pub use turn::Turn;
pub use walls::Wall;
