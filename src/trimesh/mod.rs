//! Triangle meshes in space: repair, search, and walks on them.
//!
//! Points lie in triangles of a mesh ([`TriMesh`], [`SurfacePoint`]) and move along straightest paths
//! ([`TriMesh::walk`]). The vector between two points lies in the plane across their mean normal ([`log`]), so code for
//! the plane, which works with two-dimensional vectors, serves on a surface as well.
//!
//! The triangles of a file ([`Soup`]) become a mesh in steps, each of them in slices. [`repair::MeshRepair`] makes a
//! surface of them. [`Siding`] chooses the outside of open parts. [`repair::HoleFilling`] closes holes that are small
//! compared with a cell. [`refine::Refining`] makes edges short enough to tell cells apart. [`repair::CreaseCutting`],
//! an option, cuts along creases. [`Simplifying`] makes a simpler surface to pack on, and a [`Search`] brings points of
//! it to the full one.
//!
//! Space is right-handed with y up. Triangles run counter-clockwise seen from outside. A tangent vector at a point is a
//! [`glam::DVec2`] in the [`TangentFrame`] of the point's normal: its x axis, its y axis and the normal are
//! right-handed, so a positive turn is counter-clockwise seen from outside.

/// Stands for the missing triangle beyond an edge of the border.
pub(crate) use crate::csr::NONE;

pub(crate) mod adjacency;
mod borders;
mod box_grid;
mod building;
mod closed;
pub mod curvature;
pub(crate) mod frame;
mod mesh;
mod point;
pub(crate) mod polygon;
pub mod refine;
pub mod repair;
mod rings;
pub(crate) mod running_sums;
#[cfg(test)]
pub(crate) mod samples;
pub(crate) mod search;
mod sides;
mod simplify;
mod sorting;
mod soup;
pub(crate) mod spatial_hash;
#[cfg(test)]
pub(crate) mod testing;
mod walk;

pub(crate) use box_grid::box_triangles;
pub use building::MeshBuilding;
pub use closed::Closed;
pub use frame::{LogMap, TangentFrame, Transport, log};
pub use mesh::{MeshFault, TriMesh};
pub use point::SurfacePoint;
pub(crate) use rings::{ROW, VertexRing};
pub use search::{Hit, Search};
pub use sides::{Sided, Sides, Siding};
pub use simplify::Simplifying;
pub use soup::{MOST_TRIANGLES, Soup};
pub use walk::Walked;
