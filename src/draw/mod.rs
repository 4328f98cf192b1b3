//! Drawings and diagrams of what the stages found: packed cells, cells, mesh, forces, energy, fields with
//! their singular points, the potential of one cell, the planes. What is drawn is shown, never worked
//! on: no result depends on it.

mod board;
pub mod field;
pub mod forces;
pub mod over;
pub mod planes;
pub mod potential;
pub mod size;
mod sketch;
pub mod stages;
mod tones;

pub use board::{Board, Paper, Tint, blend, copies, lit};
pub use sketch::{Layer, Sketch};
pub use tones::{SHEET, Tones};
