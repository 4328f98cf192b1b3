//! Components: the things that are heaped.
//!
//! A component is a closed mesh by rule ([`ComponentKind`]) or from a file, at several levels of detail, with inner
//! spheres that stand for it when bodies are pushed apart (Sakurai, Miyata 2014, Modelling of Non-Periodic Aggregates
//! Having a Pile Structure, section 4: R is the radius of the largest one, whose centre is the origin). Vertices have
//! marks ([`Mark`]), so that caps, tips, veins and threads get colours of their own, and bands move with the body.
//!
//! No two bodies need be alike: a [`Variant`] is a smooth map of space, drawn from a seed. It stretches, tapers, bulges
//! and bends the meshes, and carries the medial balls along, so a variant costs little beside the first one.
//!
//! [`OriginalMaking`] and [`VariantMaking`] work in slices. Their results do not depend on the division.

mod choice;
mod crossing;
mod fault;
mod finishes;
mod four_spheres;
mod fruit;
mod grain;
mod hardware;
mod inner;
mod kind;
mod leaf;
mod level;
mod making;
mod mark;
mod paint;
mod pool;
mod round;
mod shell;
mod variant;

#[cfg(test)]
mod file_tests;
#[cfg(test)]
mod paint_tests;
#[cfg(test)]
mod tests;

pub use crossing::{CrossingSearch, Crossings};
pub use fault::{Checked, Checking, ComponentFault};
pub use finishes::FINISHES;
pub(crate) use four_spheres::{COARSE, FourSpheres, four, fourfold};
pub use inner::Gaps;
pub use kind::ComponentKind;
pub use level::Level;
pub use making::{Component, FULL_COVER, Original, OriginalMaking, VariantMaking};
pub use mark::{Mark, Part};
pub use paint::{Finish, Texture};
pub use pool::Sphere;
pub use variant::{Variant, Vary};
