//! Drawings and diagrams of what the stages found: packed cells, cells, mesh, forces, energy, fields with
//! their singular points, the potential of one cell, the planes.
//!
//! Most are said once, as [`Layer`]s, and handed to a sink: a [`Board`], which paints them, or a file of
//! [`crate::export::svg`]. What varies from pixel to pixel (potentials, sizes, planes) is pictures. What
//! is drawn is shown, never worked on: no result depends on it.

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
pub use layer::{Layer, Pen, Shape};
pub use shapes::copies;
pub use sketch::Sketch;
pub use tones::{SHEET, Tones};
