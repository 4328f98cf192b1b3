//! Drawings of many shapes, made some rows at a time, so that no piece of them takes long.

use super::{Board, Layer};

/// So many pixels, about, are drawn at a time.
const AT_A_TIME: usize = 32_768;
/// Fewer rows than these are not worth their shapes that reach into other rows.
const LEAST_ROWS: usize = 16;

/// Layers, and the board that they are drawn on from the top down.
#[derive(Clone, Debug)]
pub struct Sketch {
    board: Board,
    layers: Vec<Layer>,
    /// The rows that are finished.
    rows: usize,
}

impl Sketch {
    /// Layers to be drawn on a board, each over those before it.
    pub fn new(board: Board, layers: Vec<Layer>) -> Self {
        Self {
            board,
            layers,
            rows: 0,
        }
    }

    /// Draws the next rows; true when there are no more.
    pub fn advance(&mut self) -> bool {
        let side = self.board.side();
        let to = (self.rows + (AT_A_TIME / side).max(LEAST_ROWS)).min(side);
        let layers = &self.layers;
        self.board.within(self.rows..to, |board| board.draw(layers));
        self.rows = to;
        self.rows == side
    }

    /// The finished drawing.
    pub fn finish(mut self) -> Board {
        while !self.advance() {}
        self.board
    }
}
