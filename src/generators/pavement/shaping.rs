//! Makes the polygons of cells, in slices.

use super::params::CellParams;
use crate::cells::{self, Cell, Fitting, Scatter, ScatterParams};
use crate::domain::Domain;
use crate::field::Fields;
use crate::notice::{Code, Notice};
use crate::packing::{Packing, Particle};

/// Cells while they are made.
pub(super) enum CellsProgress {
    /// Points are scattered; later they are the centres of Voronoi cells.
    Scatter(Box<Scatter>),
    /// Cells are fitted to their neighbours.
    Fitting(Box<Fitting>),
}

/// The inputs for making cells.
#[derive(Clone, Copy)]
pub(super) struct Packed<'a> {
    pub domain: &'a Domain,
    pub fields: &'a Fields,
    pub packing: &'a Packing,
}

impl Packed<'_> {
    /// The packed cells in the outline.
    pub fn packed(&self) -> Vec<Particle> {
        self.packing.particles_within(self.domain)
    }
}

impl CellsProgress {
    /// Does one slice of the work; returns the cells when all are made.
    ///
    /// # Errors
    /// A notice if there are no cells.
    pub fn advance(
        params: &CellParams,
        work: &mut Option<CellsProgress>,
        from: Packed,
    ) -> Result<Option<Vec<Cell>>, Notice> {
        if *params == CellParams::Packed {
            return some(cells::packed(&from.packed()));
        }
        let Some(begun) = work.take() else {
            *work = Some(CellsProgress::new(params, from));
            return Ok(None);
        };
        match begun.slice(from) {
            Ok(cells) => some(cells),
            Err(rest) => {
                *work = Some(rest);
                Ok(None)
            }
        }
    }

    fn new(params: &CellParams, from: Packed) -> Self {
        let &CellParams::Scattered { rounds, seed } = params else {
            return CellsProgress::fit(Fitting::new(from.packed()));
        };
        let count = from.packing.report().cells;
        let params = ScatterParams {
            count,
            rounds,
            seed,
        };
        CellsProgress::Scatter(Box::new(Scatter::new(from.domain, params)))
    }

    fn fit(fitting: Fitting) -> Self {
        CellsProgress::Fitting(Box::new(fitting))
    }

    /// The cells, or the remaining work.
    fn slice(self, from: Packed) -> Result<Vec<Cell>, Self> {
        match self {
            CellsProgress::Fitting(mut fitting) => match fitting.advance(from.domain) {
                true => Ok(fitting.finish()),
                false => Err(CellsProgress::Fitting(fitting)),
            },
            CellsProgress::Scatter(mut scatter) => Err(match scatter.advance(from.domain) {
                true => CellsProgress::fit(Fitting::voronoi(scatter.particles(from.fields))),
                false => CellsProgress::Scatter(scatter),
            }),
        }
    }
}

fn some(cells: Vec<Cell>) -> Result<Option<Vec<Cell>>, Notice> {
    match cells.is_empty() {
        true => Err(Code::NoCells.into()),
        false => Ok(Some(cells)),
    }
}
