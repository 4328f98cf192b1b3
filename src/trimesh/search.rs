//! Finds the point of a mesh that is nearest to a point in space, and the first hit of a ray.
//!
//! The search tree is a hierarchy of boxes over the triangles in the order of a Morton curve (Lauterbach et al. 2009,
//! Fast BVH Construction on GPUs). A radix sort makes that order, so all the work is loops that can be cut anywhere.

mod nearest;
mod ray;
mod tree;

pub(crate) use nearest::{NearestWalk, nearest_in};
pub use ray::Hit;
pub use tree::Search;

#[cfg(test)]
mod tests;
