//! Answers to questions about a cell.

use super::{Laying, MasonryCell, view};
use crate::masonry::plan::{FaceGrid, is_wall};

impl Laying {
    /// The number of a cell's course, from 1, by the cell's middle on the first wall that it claims. None if it claims
    /// no wall.
    pub fn course(&self, cell: &MasonryCell) -> Option<usize> {
        let is_on_wall = |face| is_wall(self.building().face(face));
        let (face, claim) = cell.claims.iter().find(|(face, _)| is_on_wall(*face))?;
        let grid: &FaceGrid = self.plan().grid(*face);
        let below = grid
            .row_lines()
            .partition_point(|&line| line < claim.centre().y);
        Some(grid.first_course + below.max(1))
    }

    /// The path in the tree of the node that made a cell, such as `else.edge.children.1`: the keys of children in the
    /// tree's JSON, and the numbers of those in lists. No two nodes have the same path; that of the root is empty.
    pub fn node_path(&self, cell: &MasonryCell) -> Option<String> {
        let walk = self.tree.walk(&view(self.building(), cell.feature));
        let made = walk.reached.into_iter().nth(cell.reached);
        made.map(|reached| reached.path)
    }
}
