//! Triangle meshes in space, and cells on them.
//!
//! Itoh, Miyata, Shimada (2003), section 5 and figures 18 and 19; Miyata, Itoh, Shimada (2001), section 4. Particles
//! live on a triangle mesh ([`TriMesh`]) as points of its triangles ([`SurfacePoint`]) and move along straightest
//! paths ([`TriMesh::walk`]). What is between two of them is seen in the plane of their mean normal ([`way`]), so
//! that all that is done in the plane with two-dimensional vectors is done here with the same code.
//!
//! Space is right-handed with y up. Triangles run counter-clockwise seen from outside. A vector along the surface at
//! a point is a [`glam::DVec2`] in the [`Frame`] of the point's normal: its x axis, its y axis and the normal are
//! right-handed, so a positive turn is counter-clockwise seen from outside.

mod cell;
mod frame;
mod mesh;
mod point;
pub mod stones;
mod walk;

pub use cell::SurfaceCell;
pub use frame::{Frame, Turn, Way, way};
pub use mesh::{MeshFault, NONE, TriMesh};
pub use point::SurfacePoint;
pub use walk::Walked;
