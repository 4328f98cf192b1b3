//! Drawings of many shapes, made some rows at a time, so that no piece of them takes long.

use super::board::{Board, Tint, bar, pieces_of};
use glam::DVec2;

/// So many pixels, about, are drawn at a time.
const AT_A_TIME: usize = 32_768;
/// Fewer rows than these are not worth their shapes that reach into other rows.
const LEAST_ROWS: usize = 16;

/// Shapes of one colour.
#[derive(Clone, Debug)]
pub struct Layer {
    rings: Vec<Vec<DVec2>>,
    tint: Tint,
    /// The width of the rings' lines; without one the rings are filled.
    pen: Option<f64>,
    round: f64,
}

impl Layer {
    /// The area that the rings run around; see [`Board::fill`].
    pub fn fill(rings: Vec<Vec<DVec2>>, tint: Tint, round: f64) -> Self {
        Self {
            rings,
            tint,
            pen: None,
            round,
        }
    }

    /// The lines of rings; see [`Board::edges`].
    pub fn edges(rings: Vec<Vec<DVec2>>, tint: Tint, width: f64, round: f64) -> Self {
        Self {
            pen: Some(width),
            ..Self::fill(rings, tint, round)
        }
    }

    /// Lines through points; see [`Board::polylines`].
    pub fn polylines(lines: &[Vec<DVec2>], tint: Tint, width: f64) -> Self {
        let bars = pieces_of(lines).into_iter().map(|line| bar(line, width));
        Self::fill(bars.map(Vec::from).collect(), tint, 0.0)
    }

    /// Draws it at once.
    pub fn draw(&self, board: &mut Board) {
        let rings: Vec<&[DVec2]> = self.rings.iter().map(Vec::as_slice).collect();
        match self.pen {
            Some(width) => board.edges(&rings, self.tint, width, self.round),
            None => board.fill(&rings, self.tint, self.round),
        }
    }
}

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
        self.board.within(self.rows..to, |board| {
            layers.iter().for_each(|layer| layer.draw(board))
        });
        self.rows = to;
        self.rows == side
    }

    /// The finished drawing.
    pub fn finish(mut self) -> Board {
        while !self.advance() {}
        self.board
    }
}
