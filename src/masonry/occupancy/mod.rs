//! Occupancy maps: which parts of edges and faces cells have claimed.
//!
//! Legakis, Dorsey, Gortler (2001), section 3.3, keep a row of booleans for an edge, and a quadtree of bits for a
//! face. Here an edge has exact intervals ([`EdgeMap`]). A face ([`FaceMap`]) has a bitmap for the question how much
//! of a place is free, and exact polygons for clipping and for measures. The map of a face begins as occupied, and the
//! face itself is then made empty, so nothing is laid in windows.

mod bitmap;
mod claims;
mod edge_map;
mod face_map;
mod pixel_runs;

pub use bitmap::{Bitmap, Coverage};
pub use claims::{Claim, ClaimNumbers, Claims};
pub use edge_map::EdgeMap;
pub use face_map::{FaceMap, Obstacles};
pub use pixel_runs::PixelRun;
