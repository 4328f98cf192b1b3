//! The shapes of a wall's blocks. They are kept until the next wall is laid: a block that stays as it was takes its
//! shape from there.

use super::congruent::Congruent;
use super::cuboid::Cuboid;
use super::params::BlockParams;
use crate::masonry::block::Polyhedron;
use crate::masonry::laying::{CellSort, MasonryCell};
use crate::scene::{Body, Place};
use crate::surface_stones::Fit;
use glam::DVec3;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

/// A shape that several blocks may have.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum BlockShape {
    /// The sizes along the axes, in steps of 0.05 mm.
    Cuboid([u32; 3]),
    /// The vertices in the block's frame, in steps of 0.05 mm.
    Other(Rc<[[i32; 3]]>),
}

impl BlockShape {
    /// The shape about the origin; `None` if nothing is left of it. `cell` is the first block of this shape, and
    /// `shrunk` is its body without joints, if that is known.
    pub fn plain(&self, cell: &MasonryCell, shrunk: Option<Polyhedron>) -> Option<Polyhedron> {
        match self {
            Self::Cuboid(steps) => Cuboid::plain(*steps),
            Self::Other(_) => {
                let body = shrunk.or_else(|| cell.body.shrunk())?;
                Some(Congruent::of(&body, cell.outwards).plain(&body))
            }
        }
    }
}

/// How a block looks.
#[derive(Clone)]
pub(super) enum BlockLook {
    /// A shape that other blocks may have too, and the place of this block.
    Shared(BlockShape, Place),
    /// A body of its own, in its place.
    Own(Body),
}

/// The look of a block, with the data of the cell and the material that it was made from.
#[derive(Clone)]
pub(super) struct ShapedBlock {
    of: Arc<Polyhedron>,
    outwards: DVec3,
    sort: CellSort,
    material: u8,
    pub look: BlockLook,
}

impl ShapedBlock {
    pub fn new(cell: &MasonryCell, material: u8, look: BlockLook) -> Self {
        Self {
            of: cell.body.clone(),
            outwards: cell.outwards,
            sort: cell.sort,
            material,
            look,
        }
    }

    /// Whether a cell with the same mark is shaped in the same way, bit for bit.
    fn is_of(&self, cell: &MasonryCell, material: u8) -> bool {
        (self.sort, self.material) == (cell.sort, material)
            && are_same((&self.of, self.outwards), (&cell.body, cell.outwards))
    }
}

/// A body that blocks share.
pub(super) struct SharedBody {
    /// Its number in the scene.
    pub number: u32,
    pub body: Body,
    /// The first cell of this shape, and its outward direction. The body has the rounding errors of this cell.
    of: (Arc<Polyhedron>, DVec3),
}

impl SharedBody {
    pub fn new(number: u32, body: Body, cell: &MasonryCell) -> Self {
        let of = (cell.body.clone(), cell.outwards);
        Self { number, body, of }
    }
}

/// How all blocks of a wall are shaped: their parameters, the number of Loop steps that rounded stones have less than usual,
/// and the place of the building in the scene.
type WallLook = (BlockParams, u32, Fit);

/// The shapes of all blocks of a wall.
pub(super) struct WallShapes {
    look: WallLook,
    /// The blocks, by the marks of their cells.
    blocks: BTreeMap<u32, ShapedBlock>,
    /// The bodies that blocks share, by shape and material.
    bodies: BTreeMap<(BlockShape, u8), SharedBody>,
}

impl WallShapes {
    /// Starts without blocks.
    pub fn new(look: WallLook) -> Self {
        Self {
            look,
            blocks: BTreeMap::new(),
            bodies: BTreeMap::new(),
        }
    }

    /// Whether equal blocks of a wall with this look have the same shapes.
    pub fn serve(&self, look: &WallLook) -> bool {
        self.look == *look
    }

    /// The block that was made of an equal cell.
    pub fn block(&self, cell: &MasonryCell, mark: u32, material: u8) -> Option<&ShapedBlock> {
        let block = self.blocks.get(&mark)?;
        block.is_of(cell, material).then_some(block)
    }

    /// Keeps a block.
    pub fn add(&mut self, mark: u32, block: ShapedBlock) {
        self.blocks.insert(mark, block);
    }

    /// The body of a shape and a material.
    pub fn shared(&self, key: &(BlockShape, u8)) -> Option<&SharedBody> {
        self.bodies.get(key)
    }

    /// The body of a shape and a material, if this cell would make the same body bit for bit. The body of a cuboid
    /// depends only on its sizes.
    pub fn same_body(&self, key: &(BlockShape, u8), cell: &MasonryCell) -> Option<&Body> {
        let shared = self.shared(key)?;
        let is_cuboid = matches!(key.0, BlockShape::Cuboid(_));
        let of = (&*shared.of.0, shared.of.1);
        let is_same = is_cuboid || are_same(of, (&cell.body, cell.outwards));
        is_same.then_some(&shared.body)
    }

    /// Keeps the body of a shape and a material.
    pub fn share(&mut self, key: (BlockShape, u8), body: SharedBody) {
        self.bodies.insert(key, body);
    }
}

/// Whether two bodies with their directions are the same, bit for bit.
fn are_same((a, to_a): (&Polyhedron, DVec3), (b, to_b): (&Polyhedron, DVec3)) -> bool {
    let bits = |p: &DVec3| p.to_array().map(f64::to_bits);
    let [own, other] = [a, b].map(|body| body.vertices().iter().map(bits));
    bits(&to_a) == bits(&to_b) && own.eq(other) && a.sides() == b.sides()
}
