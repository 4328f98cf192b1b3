//! Masonry: bricks and stones laid on a building, as a tree of patterns says.
//!
//! Legakis, Dorsey, Gortler (2001), Feature-based cellular texturing for architectural models. Patterns follow the
//! features of a [`crate::building::Building`]: its corners, edges and faces. The work goes in this order:
//!
//! 1. [`tree`] is the pattern: a tree of selectors and generators, as JSON (section 4.1).
//! 2. [`plan`] finds what several features must agree on: course lines, columns, and which way bricks of edges point.
//! 3. [`laying`] passes corners, then edges, then faces down the tree (section 4.2). Generators place cells where
//!    [`occupancy`] maps are free (section 3.3).
//! 4. [`block`] makes the geometry of each cell: shrunk to its joints, then chamfered or rounded.
//!
//! [`footprint`], [`grid_place`], [`region`] and [`free_space`] are the geometry of cells in a face's (s, t). Lengths are metres, y is
//! up; polygons are counter-clockwise seen from outside, and heights above a face are negative in the wall.

pub mod block;
pub mod footprint;
#[cfg(test)]
mod footprint_tests;
pub mod free_space;
pub mod grid_place;
mod hull;
pub mod laying;
pub mod module;
pub mod occupancy;
mod pieces;
pub mod plan;
pub mod region;
pub mod tree;
