//! Makes the polygons of cells, in slices.

use super::params::CellParams;
use crate::cells::{self, Cell, Fitting, Scatter, ScatterParams};
use crate::domain::Domain;
use crate::field::Fields;
use crate::notice::{Code, Notice};
use crate::packing::Packing;

/// Cells while they are made.
pub(super) enum Shaping {
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

impl Shaping {
    /// Does one slice of the work; returns the cells when all are made.
    ///
    /// # Errors
    /// A notice if there are no cells.
    pub fn advance(
        params: &CellParams,
        work: &mut Option<Shaping>,
        from: Packed,
    ) -> Result<Option<Vec<Cell>>, Notice> {
        if *params == CellParams::Packed {
            return some(cells::packed(&from.packing.particles()));
        }
        let Some(begun) = work.take() else {
            *work = Some(Shaping::new(params, from));
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
            return Shaping::fit(Fitting::new(from.packing.particles()));
        };
        let count = from.packing.report().cells;
        let params = ScatterParams {
            count,
            rounds,
            seed,
        };
        Shaping::Scatter(Box::new(Scatter::new(from.domain, params)))
    }

    fn fit(fitting: Fitting) -> Self {
        Shaping::Fitting(Box::new(fitting))
    }

    /// The cells, or the remaining work.
    fn slice(self, from: Packed) -> Result<Vec<Cell>, Self> {
        match self {
            Shaping::Fitting(mut fitting) => match fitting.advance(from.domain) {
                true => Ok(fitting.finish()),
                false => Err(Shaping::Fitting(fitting)),
            },
            Shaping::Scatter(mut scatter) => Err(match scatter.advance(from.domain) {
                true => Shaping::fit(Fitting::voronoi(scatter.particles(from.fields))),
                false => Shaping::Scatter(scatter),
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
