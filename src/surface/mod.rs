//! Triangle meshes in space, and cells on them.
//!
//! Itoh, Miyata, Shimada (2003), section 5 and figures 18 and 19; Miyata, Itoh, Shimada (2001), section 4. Particles
//! live on a triangle mesh ([`TriMesh`]) as points of its triangles ([`SurfacePoint`]) and move along straightest
//! paths ([`TriMesh::walk`]). What is between two of them is seen in the plane of their mean normal ([`way`]), so
//! that all that is done in the plane with two-dimensional vectors is done here with the same code.
//!
//! A file becomes such a mesh in steps, each of them in slices: [`files::Reading`] takes it to pieces,
//! [`repair::Mending`] makes a surface of these, [`repair::Filling`] closes what is small beside cells,
//! [`refine::Refining`] makes edges short enough to tell cells apart, and [`repair::Cutting`], where it is asked for,
//! cuts along creases. [`fit`] says whether cells fit at all. [`Simplifying`] makes a simpler surface to pack on, and
//! [`Projector`] carries places of it to the full one.
//!
//! Space is right-handed with y up. Triangles run counter-clockwise seen from outside. A vector along the surface at
//! a point is a [`glam::DVec2`] in the [`Frame`] of the point's normal: its x axis, its y axis and the normal are
//! right-handed, so a positive turn is counter-clockwise seen from outside.

mod building;
mod cell;
pub mod cells;
pub mod curvature;
pub mod field;
pub mod files;
pub mod fit;
mod frame;
mod links;
mod mesh;
pub mod metrics;
pub mod packing;
mod point;
mod polygon;
mod projector;
pub mod refine;
pub mod repair;
#[cfg(test)]
mod samples;
mod search;
pub mod shapes;
mod simplify;
mod sorting;
mod soup;
pub mod stones;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
pub mod views;
mod walk;

pub use building::MeshBuilding;
pub use cell::SurfaceCell;
pub use frame::{Frame, Turn, Way, way};
pub use mesh::{MeshFault, NONE, TriMesh};
pub use point::SurfacePoint;
pub use projector::Projector;
pub use search::{Hit, Search};
pub use shapes::{Bone, OnBone, Shape, ShapeMaking, ShapeMesh, ShapeNumber};
pub use simplify::Simplifying;
pub use soup::{MOST_TRIANGLES, Soup};
pub use walk::Walked;
