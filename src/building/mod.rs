//! Buildings: the model that masonry is laid on.
//!
//! Legakis, Dorsey, Gortler (2001), Feature-based cellular texturing for architectural models, section 3: a building is
//! two complete meshes. The *child mesh* has vertices, polygon edges and polygons; it is the shape. The *parent mesh*
//! has corners, edges and faces; it is what patterns are made for. A face consists of polygons, an edge is a chain of
//! polygon edges, and a corner is a vertex. Both are winged-edge structures ([`Wings`]). Faces have surfaces in closed
//! form ([`FaceSurface`]), edges are chains of lines and arcs ([`Path`]). Features have labels ([`labels`]).
//!
//! A building is described by a [`Draft`], which comes from a rule ([`Rule`]), from JSON ([`json`]; docs/building.md)
//! or from an OBJ file ([`obj`]). [`Building::new`] checks it, and derives both meshes. [`Mortar`] is the building's
//! surface moved inwards. [`WallThickness`] measures how thick the wall behind a place is.
//!
//! Lengths are metres, angles radians. Space is right-handed with y up; faces are counter-clockwise seen from outside.

mod bows;
mod checking;
mod child;
mod class;
mod draft;
mod facets;
mod fault;
#[cfg(test)]
mod fault_tests;
#[cfg(test)]
mod feature_tests;
#[cfg(test)]
mod file_tests;
mod fit;
mod flattening;
mod georeference;
mod ids;
pub mod json;
mod json_writing;
pub mod labels;
mod making;
mod making_child;
mod making_corners;
mod making_parent;
mod mortar;
pub mod obj;
mod parent;
mod path;
mod piece;
mod polygon_sides;
mod recognising;
mod region;
pub mod rules;
mod sides;
mod sorting;
mod surface;
mod t_junctions;
#[cfg(test)]
mod tests;
mod thickening;
mod thickness;
mod triangles;
mod whole;
mod wings;

pub use child::{Polygon, PolygonEdge, Vertex};
pub use class::{Bend, CornerClass, Heading};
pub use draft::{Draft, DraftArc, DraftFace, ExtraMesh};
pub use fault::{
    ArcFault, BuildingFault, BuildingWarning, FARTHEST, MOST_FACES, MOST_SIDES, OFF_SURFACE,
    PolygonFault, SurfaceFault,
};
pub use fit::{Misfit, ThinWall};
pub use ids::{CornerId, EdgeId, FaceId, PolygonEdgeId, PolygonId, VertexId};
pub use json_writing::write_json;
pub use making::BuildingMaking;
pub use mortar::Mortar;
pub use parent::{Corner, Edge, EdgeEnd, EdgeUse, Face, Stance};
pub use path::Path;
pub use piece::{CircularArc, Piece};
pub use rules::{DrawnFault, DrawnPlan, Module, Rule};
pub use surface::{Disk, FaceSurface, SurfaceFrame, Sweep};
pub use thickness::WallThickness;
pub use whole::{Building, EdgeFrame};
pub use wings::Wings;
