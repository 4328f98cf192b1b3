//! A packing while it is made, in the plane or on a surface.

use crate::domain::Domain;
use crate::field::Fields;
use crate::graph::Node;
use crate::notice::{Code, Notice};
use crate::packing::{Packing, PackingParams, Placing};
#[cfg(house)]
use crate::surface_field::SurfaceFields;
#[cfg(house)]
use crate::surface_packing::{PackingMesh, SurfacePacking, SurfacePlacing};

/// A packing while it is made: first `L` places the cells, then `M` moves them.
pub(super) enum PackingProgress<L, M> {
    Placing(Box<L>),
    Moving(Box<M>),
}

/// The node of a packing.
pub(super) type PackingNode<L, M> = Node<PackingParams, PackingProgress<L, M>, M>;

/// A domain with its fields, on which cells are packed.
pub(super) trait PackingGround: Copy {
    /// The placing of the first cells.
    type Placing;
    /// The packing of the placed cells.
    type Packing;

    /// Begins to place cells.
    ///
    /// # Errors
    /// A notice if there would be too many.
    fn begin(self, params: PackingParams) -> Result<Self::Placing, Notice>;

    /// Does one slice of the placing; true when all cells are placed.
    fn place(self, placing: &mut Self::Placing) -> bool;

    /// Makes a packing of the placed cells; also returns their number.
    fn finish(self, placing: Self::Placing) -> (Self::Packing, usize);

    /// Does one slice of a step; true when the packing is at rest.
    fn advance(self, packing: &mut Self::Packing) -> bool;
}

impl<L, M> PackingProgress<L, M> {
    /// The packing in progress, or the last one.
    pub fn shown(node: &PackingNode<L, M>) -> Option<&M> {
        node.work().and_then(Self::moving).or(node.made())
    }

    /// The packing in progress, or the last one; mutable, because a packing caches measures such as
    /// its energy.
    pub fn shown_mut(node: &mut PackingNode<L, M>) -> Option<&mut M> {
        let (work, made) = node.both_mut();
        work.and_then(Self::moving_mut).or(made)
    }

    /// Does one slice of the work; returns the packing when it is at rest.
    ///
    /// # Errors
    /// A notice if there is no room for a cell, or there would be too many.
    pub fn advance(
        params: &PackingParams,
        work: &mut Option<Self>,
        ground: impl PackingGround<Placing = L, Packing = M>,
    ) -> Result<Option<M>, Notice> {
        let next = match work.take() {
            None => Self::Placing(Box::new(ground.begin(params.clone())?)),
            Some(begun) => begun,
        };
        *work = Some(match next {
            Self::Moving(mut packing) => {
                if ground.advance(&mut packing) {
                    return Ok(Some(*packing));
                }
                Self::Moving(packing)
            }
            Self::Placing(mut placing) => {
                if ground.place(&mut placing) {
                    let (packing, cells) = ground.finish(*placing);
                    if cells == 0 {
                        return Err(Code::NoCells.into());
                    }
                    Self::Moving(Box::new(packing))
                } else {
                    Self::Placing(placing)
                }
            }
        });
        Ok(None)
    }

    /// The packing, once its cells move.
    pub fn moving(&self) -> Option<&M> {
        match self {
            Self::Moving(packing) => Some(packing),
            Self::Placing(_) => None,
        }
    }

    /// The packing, once its cells move; mutable.
    fn moving_mut(&mut self) -> Option<&mut M> {
        match self {
            Self::Moving(packing) => Some(packing),
            Self::Placing(_) => None,
        }
    }
}

impl PackingGround for (&Domain, &Fields) {
    type Placing = Placing;
    type Packing = Packing;

    fn begin(self, params: PackingParams) -> Result<Placing, Notice> {
        Placing::new(self.0, self.1, params)
    }

    fn place(self, placing: &mut Placing) -> bool {
        placing.advance(self.0, self.1)
    }

    fn finish(self, placing: Placing) -> (Packing, usize) {
        let packing = placing.finish(self.0, self.1);
        let cells = packing.report().cells;
        (packing, cells)
    }

    fn advance(self, packing: &mut Packing) -> bool {
        packing.step(self.0, self.1).done
    }
}

#[cfg(house)]
impl PackingGround for (&PackingMesh, &SurfaceFields) {
    type Placing = SurfacePlacing;
    type Packing = SurfacePacking;

    fn begin(self, params: PackingParams) -> Result<SurfacePlacing, Notice> {
        Ok(SurfacePlacing::new(self.0, self.1, params))
    }

    fn place(self, placing: &mut SurfacePlacing) -> bool {
        placing.advance(self.0, self.1)
    }

    fn finish(self, placing: SurfacePlacing) -> (SurfacePacking, usize) {
        let packing = placing.finish(self.0, self.1);
        let cells = packing.report().cells;
        (packing, cells)
    }

    fn advance(self, packing: &mut SurfacePacking) -> bool {
        packing.advance(self.0, self.1)
    }
}
