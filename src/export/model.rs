//! The stones on a surface in one file, cell by cell, and then the ground in parts, in the model's axes and units.

use super::chart::Chart;
use super::frame::ExportSpace;
use super::glb::Glb;
use super::ground::with_areas;
use super::obj::Obj;
use super::order::{MeshFormat, MeshOrder};
use super::part_file::PartFile;
use super::surface::{Writer, mean_roughness};
use crate::material::Material;
use crate::surface_cells::SurfaceCell;
use crate::surface_stones::{Fit, Paving, Piece, Pieces, StonesParams, mean_size};
use crate::trimesh::TriMesh;
use glam::DVec3;
use std::borrow::Cow;

/// A file of a model that is being made.
pub struct ModelFile {
    pieces: Pieces,
    writer: Writer,
}

impl ModelFile {
    /// A file of the stones of these cells. `materials` is the whole table; `anchor` is the place of the cells' origin in
    /// the model. Images of the order are ignored.
    pub fn new(
        order: &MeshOrder,
        params: StonesParams,
        materials: &[Material],
        (cells, anchor): (&[SurfaceCell], DVec3),
    ) -> Self {
        let fit = Fit {
            middle: anchor,
            ..Fit::default()
        };
        let glb = || Glb::of_model(mean_roughness(materials), order.joined).placed(fit);
        Self {
            pieces: Pieces::new(params, cells, order.of_each(cells.len())),
            writer: match order.format {
                MeshFormat::Obj => Writer::Obj(Obj::of_model(fit, mean_size(cells))),
                MeshFormat::Glb => Writer::Glb(Box::new(glb())),
            },
        }
    }

    /// The share of the work that is done, 0 to 1.
    pub fn progress(&self, cells: &[SurfaceCell]) -> f64 {
        self.pieces.progress(cells)
    }

    /// Adds the next stone or, after the last one, a part of the ground; true when all is there. Mesh and paving must
    /// be the same each time.
    pub fn advance(&mut self, mesh: &TriMesh, paving: Paving) -> bool {
        match self.pieces.next(mesh, paving) {
            Piece::None => false,
            Piece::Surface(id, surface) => {
                let cell = id.checked_sub(1).map(|k| &paving.cells[k as usize]);
                let surface = match cell {
                    None => with_areas(&surface),
                    Some(_) => Cow::Borrowed(&surface),
                };
                if !surface.triangles.is_empty() {
                    let chart = cell.map_or_else(|| Chart::of_surface(&surface), Chart::of_cell);
                    let space = ExportSpace::Model(Some(chart));
                    self.writer.add(&space, &surface, id);
                }
                false
            }
            Piece::End => true,
        }
    }
}

impl PartFile for ModelFile {
    fn take(&mut self) -> Vec<Vec<u8>> {
        self.writer.take()
    }

    fn finish(self) -> Vec<Vec<u8>> {
        self.writer.finish()
    }
}
