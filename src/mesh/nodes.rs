//! Positions of nodes relative to each other.

use super::Node;

/// Nodes that are joined to elements. On a surface, a few nodes near each other are unfolded into one plane.
pub(crate) trait Nodes {
    /// The number of nodes.
    fn count(&self) -> usize;

    /// Whether a node may be a corner of quadrilaterals.
    fn has_corners(&self, node: u32) -> bool;

    /// A few nearby nodes, unfolded into one plane; the result does not depend on their order.
    fn laid<const N: usize>(&self, which: [u32; N]) -> [Node; N];
}

impl Nodes for [Node] {
    fn count(&self) -> usize {
        self.len()
    }

    fn has_corners(&self, node: u32) -> bool {
        self[node as usize].corners
    }

    fn laid<const N: usize>(&self, which: [u32; N]) -> [Node; N] {
        which.map(|k| self[k as usize])
    }
}
