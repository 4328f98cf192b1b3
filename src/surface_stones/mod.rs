//! Stones and scales on a surface: from its cells to bodies in a scene.
//!
//! A cell is laid into its tangent plane ([`UnfoldedCell`]). Its stone is made there as in any picture, and bent back
//! onto the surface ([`QuadricPatch`]). So the shapes of stones, their lean, taper, keels and noise are those of the
//! plane. Before that, axes are made to agree ([`make_one_sense`]). [`Stones`] makes a [`crate::scene::Scene`] of all
//! stones on their ground.

mod build;
mod claws;
mod coats;
mod fit;
#[cfg(test)]
mod fixture;
mod flatten;
mod ground;
mod links;
mod look;
mod maker;
mod making;
mod pieces;
mod quadric_patch;
mod sense;
mod template;
#[cfg(test)]
mod tests;

pub use build::Stones;
pub use claws::Claw;
pub use coats::SurfaceCoats;
pub use fit::{Fit, Rim};
pub use flatten::UnfoldedCell;
pub(crate) use ground::parts;
pub use links::{links, neighbours};
pub use making::{StepShape, StoneStep, step, steps};
pub(crate) use pieces::{Piece, Pieces};
pub use quadric_patch::QuadricPatch;
pub use sense::{Flow, make_one_sense};

use crate::heightfield::TextureParams;
use crate::material::{Coat, WeatherParams};
use crate::surface_cells::SurfaceCell;
use maker::{Made, Maker, leans_out};

/// The cells to pave, with their neighbours and coats by index.
#[derive(Clone, Copy, Debug, Default)]
pub struct Paving<'a> {
    /// The cells; their axes agree already, see [`make_one_sense`].
    pub cells: &'a [SurfaceCell],
    /// The neighbours of each cell, see [`links`].
    pub links: &'a [Vec<u32>],
    /// The coats of the cells; cells beyond the end of the list are plain.
    pub coats: &'a [Coat],
    /// Claws and tips of horn, which carry no cells.
    pub claws: &'a [Claw],
}

impl Paving<'_> {
    /// Makes the stone of a cell.
    fn stone(&self, maker: &mut Maker, k: usize) -> Option<Made> {
        let cell = &self.cells[k];
        let neighbours = self.links.get(k).map_or(&[][..], Vec::as_slice);
        let coat = self.coats.get(k).copied().unwrap_or_default();
        maker.stone(cell, coat, leans_out(cell, neighbours, self.cells))
    }
}

/// How an open surface ends at its border.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Open {
    /// As a shell with an inside.
    #[default]
    Shell,
    /// As a closed body, cut off at the border.
    Capped,
    /// As ground whose sides go straight down to a floor.
    Block,
}

/// The parameters of stones on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StonesParams {
    /// As in a picture; `side`, `pixel_scale` and `tile` have no effect.
    pub texture: TextureParams,
    /// As in a picture; it falls from above (y up).
    pub weather: WeatherParams,
    /// Picture units in a unit of the model.
    pub unit: f64,
    /// How the surface ends at borders.
    pub open: Open,
}

impl StonesParams {
    /// Parameters for these cells: `unit` gives them the mean size that the texture asks for.
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

/// The mean size that cells should have, in the model's units.
pub(crate) fn mean_size(cells: &[SurfaceCell]) -> f64 {
    let sum: f64 = cells.iter().map(|cell| cell.size).sum();
    sum / cells.len().max(1) as f64
}
