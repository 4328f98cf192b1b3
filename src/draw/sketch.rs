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
    /// The number of finished rows.
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

    /// The same, drawn at once: edges may differ a little where rows of slices meet.
    pub fn whole(mut self) -> Board {
        self.board.draw(&self.layers);
        self.board
    }

    /// The finished drawing.
    pub fn finish(mut self) -> Board {
        while !self.advance() {}
        self.board
    }
}
