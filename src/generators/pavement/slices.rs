//! Packing and cells in slices: what each has begun, and its next step.

use super::params::CellParams;
use crate::cells::{self, Cell, Fitting, Scatter, ScatterParams};
use crate::domain::Domain;
use crate::field::Fields;
use crate::notice::{Code, Notice};
use crate::packing::{Packing, PackingParams, Placing};

/// A packing on its way.
pub(super) enum Packs {
    /// Its first cells are being placed.
    Placing(Box<Placing>),
    /// They move.
    Moving(Box<Packing>),
}

impl Packs {
    /// Places some cells, or moves all of them by one step; answers with the packing at rest.
    ///
    /// # Errors
    /// If no cell has room.
    pub fn advance(
        params: &PackingParams,
        work: &mut Option<Packs>,
        domain: &Domain,
        fields: &Fields,
    ) -> Result<Option<Packing>, Notice> {
        let mut placing = match work.take() {
            Some(Packs::Moving(mut packing)) => {
                if packing.step(domain, fields).done {
                    return Ok(Some(*packing));
                }
                *work = Some(Packs::Moving(packing));
                return Ok(None);
            }
            Some(Packs::Placing(placing)) => placing,
            None => Box::new(Placing::new(domain, fields, *params)?),
        };
        if !placing.advance(domain, fields) {
            *work = Some(Packs::Placing(placing));
            return Ok(None);
        }
        let packing = placing.finish(domain, fields);
        if packing.report().cells == 0 {
            return Err(Code::NoCells.into());
        }
        *work = Some(Packs::Moving(Box::new(packing)));
        Ok(None)
    }
}

/// Cells on their way.
pub(super) enum Shaping {
    /// Points are scattered, to be the middles of Voronoi cells.
    Scatter(Box<Scatter>),
    /// Cells are fitted to each other.
    Fitting(Box<Fitting>),
}

/// What cells are made of.
#[derive(Clone, Copy)]
pub(super) struct Packed<'a> {
    pub domain: &'a Domain,
    pub fields: &'a Fields,
    pub packing: &'a Packing,
}

impl Shaping {
    /// One slice; answers with the cells once they are made.
    ///
    /// # Errors
    /// If there are none.
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

    /// The cells, or what is left to do.
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
