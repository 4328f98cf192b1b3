//! Turns cells' polygons into cells for stones: with neighbours, agreeing axes, and coats.

use super::build::Built;
use super::params::{CellParams, UNIT};
use crate::material::Coat;
use crate::notice::{Code, Notice};
use crate::surface_cells::SurfaceCell;
use crate::surface_cells::SurfaceMesh;
use crate::surface_field::{AlongBones, SurfaceFields};
use crate::surface_stones::{Claw, Paving, SurfaceCoats, links, make_one_sense};
use crate::trimesh::{Search, SurfacePoint};

/// The number of cells in one slice of making coats.
const CELLS: usize = 500;
/// The number of cells that one slice carries to another surface. It is small, because a search may
/// meet very many triangles.
const CARRIED: usize = 4;

/// Cells with everything that stones need.
#[derive(Clone, Default)]
pub(super) struct PavedCells {
    pub cells: Vec<SurfaceCell>,
    pub links: Vec<Vec<u32>>,
    pub coats: Vec<Coat>,
    pub claws: Vec<Claw>,
}

impl PavedCells {
    pub fn paving(&self) -> Paving<'_> {
        Paving {
            cells: &self.cells,
            links: &self.links,
            coats: &self.coats,
            claws: &self.claws,
        }
    }
}

/// The inputs of paving.
#[derive(Clone, Copy)]
pub(super) struct PavingInputs<'a> {
    pub mesh: &'a SurfaceMesh,
    pub built: &'a Built,
    pub fields: &'a SurfaceFields,
}

/// Cells in progress.
pub(super) enum PavingProgress {
    /// Finds the neighbours of each cell.
    Link(Vec<SurfaceCell>),
    Turn(PavedCells),
    /// Carries cells to the surface of the stones; the number is the next cell.
    Carry(PavedCells, usize),
    Coat(PavedCells, Box<SurfaceCoats>),
}

impl PavingProgress {
    /// Does one slice; returns the cells when all is done.
    ///
    /// # Errors
    /// If there is no cell.
    pub fn advance(
        params: &CellParams,
        work: &mut Option<PavingProgress>,
        from: PavingInputs,
    ) -> Result<Option<PavedCells>, Notice> {
        let next = match work.take() {
            None => match from.mesh.surface_cells() {
                cells if cells.is_empty() => return Err(Code::SurfaceNoCells.into()),
                cells => PavingProgress::Link(cells),
            },
            Some(PavingProgress::Link(cells)) => PavingProgress::Turn(PavedCells {
                links: links(&cells),
                coats: Vec::new(),
                claws: from.built.claws.clone(),
                cells,
            }),
            Some(PavingProgress::Turn(mut paved)) => {
                let sense = if params.flip { -1.0 } else { 1.0 };
                let flow = |p: &SurfacePoint| Some(sense * from.fields.flow(p));
                make_one_sense(&mut paved.cells, &paved.links, &flow);
                PavingProgress::Carry(paved, 0)
            }
            Some(PavingProgress::Carry(mut paved, first)) => match &from.built.search {
                None => coating(params, paved, from.built),
                Some(search) => {
                    let end = paved.cells.len().min(first + CARRIED);
                    for cell in &mut paved.cells[first..end] {
                        carry(cell, from.built, search);
                    }
                    match end == paved.cells.len() {
                        true => coating(params, paved, from.built),
                        false => PavingProgress::Carry(paved, end),
                    }
                }
            },
            Some(PavingProgress::Coat(mut paved, mut coats)) => {
                match coats.advance(&paved.cells, CELLS) {
                    true => {
                        paved.coats = coats.finish(&paved.cells);
                        return Ok(Some(paved));
                    }
                    false => PavingProgress::Coat(paved, coats),
                }
            }
        };
        *work = Some(next);
        Ok(None)
    }
}

fn coating(params: &CellParams, paved: PavedCells, built: &Built) -> PavingProgress {
    let unit = unit(&paved.cells);
    let (low, high) = built.whole.bounds();
    let mut colour = params.colour;
    colour.scale *= (high - low).max_element() * unit;
    let mut coats = SurfaceCoats::new(colour, params.seed, unit, &paved.cells, &paved.links);
    let bones = AlongBones::new(&built.bones, built.whole.diagonal());
    if let Some(bones) = bones.filter(|_| params.is_around) {
        let along = paved.cells.iter().map(|cell| bones.at(cell.centre.at));
        coats = coats.around(along.collect());
    }
    PavingProgress::Coat(paved, Box::new(coats))
}

/// Picture units for each unit of the model.
fn unit(cells: &[SurfaceCell]) -> f64 {
    let sum: f64 = cells.iter().map(|cell| cell.size).sum();
    let mean = sum / cells.len().max(1) as f64;
    if mean > 0.0 { UNIT / mean } else { 1.0 }
}

/// Carries a cell to the surface of the stones.
fn carry(cell: &mut SurfaceCell, built: &Built, search: &Search) {
    let along = cell.centre.frame().out(cell.axis);
    cell.centre = search.closest_facing(&built.whole, cell.centre.at, cell.centre.normal);
    cell.axis = cell.centre.frame().within(along).normalize_or_zero();
    for (corner, normal) in cell.ring.iter_mut().zip(&mut cell.normals) {
        let on = search.closest_facing(&built.whole, *corner, *normal);
        (*corner, *normal) = (on.at, on.normal);
    }
}
