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
//! The inner spheres of its component stand for a body ([`Shape`]); the most important ones come first. Lengths are in
//! the units of the surface.
//!
//! Words of piles and their components, the usual terms of the field, and symbols or sections of the paper:
//!
//! | code | field | paper |
//! |---|---|---|
//! | component, `ComponentKind` | closed mesh that is instanced; one type of bodies has one | section 3 |
//! | `Variant` | smooth deformation of a component, drawn from a seed | section 6 (missed by designers) |
//! | inner sphere, medial ball | ball of the medial axis; few of them stand for a body | sections 4.1.1 and 4.2.1 |
//! | `radius`, `diagonal` of a component | radius of the largest inner sphere; diagonal of the bounding box | R; d |
//! | dart, `Darting` | sample of a maximal Poisson-disk distribution, by dart throwing | section 4.1.2 |
//! | dart spacing, `Kind::spacing` | least distance of two samples, σ R | 2 r of section 4.1.1 |
//! | density | factor of the spacing: below 1 tight, above 1 loose | σ |
//! | turn, `Turn` | orientation drawn at random within ranges | θu, θv, θw; section 4.1.3 |
//! | `merge` | samples of smaller types near those of larger ones are dropped | section 4.1.4 |
//! | `Refining` | refinement: bodies are translated along the normal one by one | section 4.2 |
//! | refinement range, `range` | interval of the translation t | l, in units of d |
//! | inward share, `inward`, `alpha` | share of that interval inside of the shape | α, ours |
//! | offset T, `offset` | overlap that counts as touching, the isovalue of the implicit function | T of eq. (2) |
//! | removal D, `removal` | tolerance beyond T at which a body is removed | D of eq. (3) |
//! | `Method::Golden`, `Method::Exact` | golden section search; union of blocked intervals | eq. (1); ours |
//! | layer, `LayerDarting` | samples on an offset surface inside of the shape | section 5, fig. 14 |
//! | shape, `PileShape`, `Site` | aggregate shape: the surface on which bodies are placed | section 3 |
//! | vessel, `Wall` | container that is seen; convex constraint that bodies do not pass | the open box of fig. 4 |
//! | `Finish` | colours, textures and materials of a component and its parts | |
//! | `Fate` | outcome of a dart: merged, stopped by walls, removed, kept | sections 4.1.4 and 4.2.3 |

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
mod dart_tests;
#[cfg(test)]
pub(crate) mod fixture;
#[cfg(test)]
mod tests;

pub use body::{Body, Fate};
pub use darts::{Dart, Darting, expected_darts, same_side};
pub use golden::CostScope;
pub use kind::{Kind, Shape, natural_range};
pub use layers::LayerDarting;
pub use measures::{OverlapWork, contacts, contacts_of};
pub use merge::merge;
pub use refine::{Method, RefineParams, Refining, SettlingOrder};
pub use turn::Turn;
pub use walls::Wall;
