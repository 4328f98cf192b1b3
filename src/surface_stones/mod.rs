//! Stones and scales on a surface: from its cells to bodies in light.
//!
//! A cell is laid into its tangent plane ([`Flat`]), its stone is made there as in any picture, and bent back onto the
//! surface ([`Bend`]). So all stones, their lean, taper, keels and noise are those of the plane. Axes get one sense
//! first ([`make_one_sense`]). [`Stones`] makes a [`crate::scene::Scene`] of all of them on their ground.

mod bend;
mod build;
mod coats;
#[cfg(test)]
mod fixture;
mod flatten;
mod ground;
mod links;
mod look;
mod maker;
mod pieces;
mod sense;
mod template;
#[cfg(test)]
mod tests;

pub use bend::Bend;
pub use build::{Fit, Stones};
pub use coats::SurfaceCoats;
pub use flatten::Flat;
pub(crate) use ground::parts;
pub use links::links;
pub(crate) use pieces::{Piece, Pieces};
pub use sense::{Flow, make_one_sense};

use crate::heightfield::TextureParams;
use crate::material::{Coat, WeatherParams};
use crate::surface_cells::SurfaceCell;
use maker::{Made, Maker, leans_out};

/// The cells that are paved, with what belongs to each by its index.
#[derive(Clone, Copy, Debug, Default)]
pub struct Paving<'a> {
    /// They have one sense already: see [`make_one_sense`].
    pub cells: &'a [SurfaceCell],
    /// Their neighbours: see [`links`].
    pub links: &'a [Vec<u32>],
    /// What they wear by rule; those that are missing are plain.
    pub coats: &'a [Coat],
}

impl Paving<'_> {
    /// The stone of one of them.
    fn stone(&self, maker: &mut Maker, k: usize) -> Option<Made> {
        let cell = &self.cells[k];
        let neighbours = self.links.get(k).map_or(&[][..], Vec::as_slice);
        let coat = self.coats.get(k).copied().unwrap_or_default();
        maker.stone(cell, coat, leans_out(cell, neighbours, self.cells))
    }
}

/// What a surface with a border is like.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Open {
    /// A shell with an inside.
    #[default]
    Shell,
    /// A body cut off there.
    Capped,
    /// Ground, that goes straight down from there to a floor.
    Block,
}

/// What stones on a surface are made by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StonesParams {
    /// As in a picture; `side`, `pixel_scale` and `tile` are not asked for.
    pub texture: TextureParams,
    /// As in a picture; it falls from above.
    pub weather: WeatherParams,
    /// Picture units for a unit of the model.
    pub unit: f64,
    /// What openings are like.
    pub open: Open,
}

impl StonesParams {
    /// For these cells: on average they are as large as those of a picture are asked to be.
    pub fn new(texture: TextureParams, weather: WeatherParams, cells: &[SurfaceCell]) -> Self {
        let size = mean_size(cells);
        Self {
            texture: TextureParams {
                pixel_scale: 1,
                tile: false,
                ..texture
            },
            weather,
            unit: if size > 0.0 { texture.size / size } else { 1.0 },
            open: Open::default(),
        }
    }
}

/// Of the sizes that cells should have.
pub(crate) fn mean_size(cells: &[SurfaceCell]) -> f64 {
    let sum: f64 = cells.iter().map(|cell| cell.size).sum();
    sum / cells.len().max(1) as f64
}
