//! Where nodes are, as they are seen from each other.

use super::Node;

/// Nodes that are joined into elements: those of the plane, or of a surface, where a few that are near each other are
/// laid into one plane.
pub(crate) trait Nodes {
    /// How many there are.
    fn count(&self) -> usize;

    /// May it be a corner of quadrilaterals?
    fn has_corners(&self, node: u32) -> bool;

    /// Some that are near each other, laid into one plane, the same whatever their order is.
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
