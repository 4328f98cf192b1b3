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
//! [`footprint`], [`grid_place`], [`region`] and [`free_space`] are the geometry of cells in a face's (s, t). Lengths
//! are metres, and y is up. Polygons are counter-clockwise seen from outside. Heights above a face are negative inside
//! of the wall.
//!
//! Words of buildings and masonry, the usual terms of the field, and sections of the paper:
//!
//! | code | field | paper |
//! |---|---|---|
//! | `Building` | base mesh: a hierarchical winged-edge structure | section 3.1 |
//! | vertex, polygon edge, polygon | elements of the child mesh, the shape | section 3.1, fig. 2 |
//! | corner, edge, face | elements of the parent mesh, the features | section 3.1, fig. 2 |
//! | `Surface`: `Sweep`, `Disk` | face parameterisation: flat and cylindrical regions; sectors of disks | section 3.2 |
//! | `map`, `project` | from parameters to space, and back | section 3.2 |
//! | `CornerClass`, `Heading` | valence, convex and concave edges, direction of a single one | section 5.5 |
//! | `flip` | the stored bit of a corner or an edge | section 5.2 |
//! | `Mortar` | the shrunk base mesh | section 5.4 |
//! | `Module` | module: half a brick and a course, with their joints | |
//! | bend | whether an edge is convex, concave, smooth or open; its dihedral angle | |
//! | feature, `Feature` | corner, edge or face of a building, which patterns follow | section 3.1 |
//! | `FaceMap`, `EdgeMap` | occupancy maps | section 3.3 |
//! | claim, `Footprint`, inset | space that a cell fills; its geometry is shrunk for mortar | section 3.3 |
//! | `PatternTree`, `PatternNode` | tree of pattern generators | section 4.1, fig. 4 |
//! | course, column | row of masonry; unit of a row, W wide | section 5.1 (grid tool) |
//! | phase, `PhasePlan` | which way bricks point in running bond, for a whole wall | the bits of section 5.2; ours |
//! | `Laying` | texturing operations: corners, then edges, then faces | section 4.2 |

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
