//! Blocks of the last finished wall that stay in sight after an edit, until the new ones are laid in their places.

use super::params::BlockParams;
use crate::masonry::laying::MasonryCell;
use crate::scene::{Body, Instance, Scene};
use crate::surface_stones::Fit;
use std::collections::BTreeMap;

/// The cells and the looks of the last finished wall.
pub(super) struct LastWall {
    /// The marks of its cells, in their order.
    pub marks: Vec<u32>,
    pub params: BlockParams,
    pub fit: Fit,
}

/// The blocks that have their places in the new wall, too.
#[derive(Default)]
pub(crate) struct KeptBlocks {
    bodies: Vec<Body>,
    /// In the order of their ids, which are those of the new wall.
    instances: Vec<Instance>,
    /// Whether new blocks look like the kept ones, as the parameters are equal.
    are_same: bool,
}

/// The marks of cells, in their order.
pub(super) fn marks(cells: &[MasonryCell]) -> Vec<u32> {
    cells.iter().map(MasonryCell::mark).collect()
}

impl KeptBlocks {
    /// The blocks of the last wall that stand where a new one will. None are kept if the building lies otherwise in the
    /// scene.
    pub(super) fn new(
        (last, scene): (&LastWall, &Scene),
        cells: &[MasonryCell],
        (params, fit): (&BlockParams, Fit),
    ) -> Self {
        if last.fit != fit {
            return Self::default();
        }
        let ids: BTreeMap<u32, u32> = marks(cells).into_iter().zip(1..).collect();
        let blocks = scene.instances.iter().filter_map(|block| {
            let number = (block.id as usize).checked_sub(1)?;
            let id = *ids.get(last.marks.get(number)?)?;
            Some(Instance { id, ..*block })
        });
        let mut instances: Vec<Instance> = blocks.collect();
        instances.sort_by_key(|block| block.id);
        Self {
            bodies: scene.bodies.clone(),
            instances,
            are_same: last.params == *params,
        }
    }

    /// The bodies of the last wall, to which its blocks refer.
    pub(super) fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The kept blocks that still stand when this number of new blocks is laid.
    pub(super) fn after(&self, laid: usize) -> &[Instance] {
        let first = self
            .instances
            .partition_point(|block| block.id as usize <= laid);
        &self.instances[first..]
    }

    /// Whether laying the block with this number (from 0) changes nothing in sight: a kept block already stands there
    /// and looks the same.
    pub(super) fn has(&self, number: usize) -> bool {
        let own = |block: &Instance| (block.id as usize).cmp(&(number + 1));
        self.are_same && self.instances.binary_search_by(own).is_ok()
    }
}
