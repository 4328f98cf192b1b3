//! Drawings of many shapes, painted a few rows at a time, so that no slice takes long.

use super::{Board, Layer};

/// About the number of pixels painted in a slice.
const AT_A_TIME: usize = 32_768;
/// Fewest rows of a slice: shapes across its edges are drawn again.
const LEAST_ROWS: usize = 16;

/// Layers, and the board that they are painted on from the top down.
#[derive(Clone, Debug)]
pub struct Sketch {
    board: Board,
    layers: Vec<Layer>,
    /// The number of finished rows; `at_a_time` is the number of rows in a slice.
    rows: usize,
    at_a_time: usize,
}

impl Sketch {
    /// Layers to be drawn on a board, each over those before it.
    pub fn new(board: Board, layers: Vec<Layer>) -> Self {
        Self {
            rows: 0,
            at_a_time: (AT_A_TIME / board.side()).max(LEAST_ROWS),
            board,
            layers,
        }
    }

    /// Draws the next rows; true when there are no more.
    pub fn advance(&mut self) -> bool {
        let side = self.board.side();
        let to = (self.rows + self.at_a_time).min(side);
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
