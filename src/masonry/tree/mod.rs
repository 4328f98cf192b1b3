//! Trees of pattern generators, as data.
//!
//! Legakis, Dorsey, Gortler (2001), section 4.1: each feature of the building begins at the root and is passed down
//! the tree. A selector passes it to one child, by its label, its type or its geometry (section 5.3). A generator lays
//! cells on it. [`PatternNode::Seq`] passes it to several children one after the other: each fills what those before
//! have left.
//!
//! A tree is written as JSON. A node is an object with its `type`, its parameters and its children:
//!
//! ```
//! use bubblestone::masonry::tree::{FeatureView, PatternTree};
//!
//! let tree = PatternTree::read(r#"{
//!   "type": "ByLabel",
//!   "cases": {"Glass": {"type": "None"}},
//!   "else": {"type": "Bricks", "tag": 1}
//! }"#).expect("a tree");
//! let walk = tree.walk(&FeatureView::FACE);
//! assert_eq!(walk.reached[0].path, "else");
//! ```

mod fault;
mod feature;
mod generator;
mod node;
#[cfg(test)]
mod preset_tests;
mod presets;
mod read;
#[cfg(test)]
mod read_tests;
mod walk;
mod write;

pub use fault::{TreeError, TreeFault};
pub use feature::{FeatureKind, FeatureView, WindowPart};
pub use generator::{GeneratorNode, Parameter, PatternGenerator, StoneRow};
pub use node::{CornerPattern, PatternNode, PatternTree};
pub use presets::{PRESETS, TreePreset};
pub use walk::{Reached, Unexpected, Walk};

/// The greatest depth of a tree; a single node has depth 1.
pub const MOST_DEPTH: usize = 32;
/// The most nodes of a tree.
pub const MOST_NODES: usize = 200;
