//! Makes stones and ground one after the other, at one level of detail, for files.

use super::ground::{Bed, GroundMaking, GroundSlice};
use super::maker::Maker;
use super::{Paving, StonesParams, mean_size};
use crate::heightfield::GROUND;
use crate::solid::Surface;
use crate::surface_cells::SurfaceCell;
use crate::trimesh::TriMesh;

/// Rows of the bed in a slice.
const ROWS: usize = 64;

/// All pieces, while they are made.
pub(crate) struct Pieces {
    params: StonesParams,
    maker: Maker,
    size: f64,
    cell: usize,
    ground: Option<GroundMaking>,
    claw: usize,
}

/// The result of a slice of work.
pub(crate) enum Piece {
    /// Nothing yet.
    None,
    /// A surface in the model's axes and units, with the id of its stone or of the ground.
    Surface(u32, Surface),
    /// All pieces have been made.
    End,
}

impl Pieces {
    /// Starts with these cells; `most` is about the number of triangles of a stone.
    pub fn new(params: StonesParams, cells: &[SurfaceCell], most: usize) -> Self {
        Self {
            maker: Maker::new(&params, cells, most),
            size: mean_size(cells),
            cell: 0,
            ground: None,
            claw: 0,
            params,
        }
    }

    /// The share of the work that is done, 0 to 1.
    pub fn progress(&self, cells: &[SurfaceCell]) -> f64 {
        let stones = self.cell as f64 / cells.len().max(1) as f64;
        let ground = self.ground.as_ref().map_or(0.0, GroundMaking::progress);
        0.9 * stones + 0.1 * ground
    }

    /// Does one more slice.
    pub fn next(&mut self, mesh: &TriMesh, paving: Paving) -> Piece {
        if !self.maker.look.advance(ROWS) {
            return Piece::None;
        }
        if let Some(cell) = paving.cells.get(self.cell) {
            let made = paving.stone(&mut self.maker, self.cell);
            self.cell += 1;
            let level = made.and_then(|made| made.levels.into_iter().next());
            let Some(mut surface) = level else {
                return Piece::None;
            };
            let origin = cell.centre.at;
            for p in &mut surface.positions {
                *p = (p.as_dvec3() + origin).as_vec3();
            }
            return Piece::Surface(self.cell as u32, surface);
        }
        let colour = self.maker.look.ground_colour();
        let bed = || Bed::new(&self.params, mesh, self.size, colour);
        let ground = self.ground.get_or_insert_with(GroundMaking::default);
        match ground.next(mesh, bed) {
            GroundSlice::More => Piece::None,
            GroundSlice::Part(levels) => match levels.into_iter().next() {
                Some(surface) => Piece::Surface(GROUND, surface),
                None => Piece::None,
            },
            GroundSlice::End => {
                let claw = paving.claws.get(self.claw);
                self.claw += 1;
                let surface = claw.map(|claw| claw.surface(self.maker.look.palette));
                surface.map_or(Piece::End, |surface| Piece::Surface(GROUND, surface))
            }
        }
    }
}
