//! Drawings and diagrams of the stages' results: packed cells, cells, mesh, forces, energy, fields with their
//! singular points, the potential of one cell, the planes.
//!
//! Most are [`Layer`]s for a sink: a [`Board`], which paints them, or a file by [`crate::export::svg`].
//! Values that vary from pixel to pixel (potentials, sizes, planes) become pictures. Drawings are output
//! only: no result depends on them.

mod board;
mod colour;
pub mod field;
pub mod forces;
mod layer;
pub mod over;
pub mod planes;
pub mod potential;
mod shapes;
pub mod size;
mod sketch;
pub mod stages;
mod tones;

pub use board::Board;
pub use colour::{Colour, Paper, blend, lit};
pub use layer::{DrawnPath, Layer, Pen};
pub use shapes::copies;
pub use sketch::Sketch;
pub use tones::{SHEET, Tones};
