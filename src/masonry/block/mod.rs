//! Blocks: convex bodies that cells claim, and their geometry.
//!
//! A cell claims a [`Polyhedron`]: a prism on a footprint, or what planes cut from one (mitres, skewbacks). Its
//! geometry is the polyhedron shrunk to its joints ([`Polyhedron::shrunk`]), then dressed: with a chamfer and a small
//! turn ([`Dressing`]), or rounded and rough ([`Stonecutter`]). Legakis, Dorsey, Gortler (2001), sections 3.3 and 5.1,
//! name the intersection of planes and the shrinking as tools of all generators.

mod bevel;
mod cutting;
mod dressing;
mod plane;
mod polyhedron;
mod rounded;
#[cfg(test)]
mod tests;

pub use bevel::{Bevelled, BlockMesh};
pub use dressing::Dressing;
pub use plane::Plane;
pub use polyhedron::{Polyhedron, Side};
pub use rounded::{Rough, Stonecutter};
