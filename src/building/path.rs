//! Chains of lines and arcs by arc length: the shape of an edge, and the profile of a swept face.

use super::piece::Piece;
use glam::DVec3;

/// A chain of lines and arcs. Each begins where the one before it ends.
///
/// Arc length runs from 0 at the start. Before the start and behind the end, the first and the last piece go on.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    pieces: Vec<Piece>,
    /// The arc length at the start of each piece, and that of the whole.
    starts: Vec<f64>,
}

impl Path {
    /// A chain of at least one piece. Whether the ends meet is for the caller to check, see [`Self::widest_gap`].
    pub fn new(pieces: Vec<Piece>) -> Self {
        let mut starts = vec![0.0];
        for piece in &pieces {
            starts.push(starts[starts.len() - 1] + piece.length());
        }
        Self { pieces, starts }
    }

    /// The lines and arcs.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The arc lengths (metres) at which pieces begin, and the whole length at the end.
    pub fn joints(&self) -> &[f64] {
        &self.starts
    }

    /// The length of all pieces (metres).
    pub fn length(&self) -> f64 {
        self.starts[self.pieces.len()]
    }

    /// The number of the piece at an arc length.
    fn piece_at(&self, s: f64) -> usize {
        let inner = &self.starts[1..self.pieces.len()];
        inner.partition_point(|&start| start <= s)
    }

    /// The point at an arc length (metres).
    pub fn point(&self, s: f64) -> DVec3 {
        let k = self.piece_at(s);
        self.pieces[k].point(s - self.starts[k])
    }

    /// The unit tangent at an arc length; where two pieces meet, that of the second one.
    pub fn tangent(&self, s: f64) -> DVec3 {
        let k = self.piece_at(s);
        self.pieces[k].tangent(s - self.starts[k])
    }

    /// The unit tangents at the start and at the end, both in the direction of the path.
    pub fn end_tangents(&self) -> [DVec3; 2] {
        let last = &self.pieces[self.pieces.len() - 1];
        [self.tangent(0.0), last.tangent(last.length())]
    }

    /// The arc length of the nearest point of the path, whose first and last piece go on without end. Keep the first
    /// of two equally near pieces.
    pub fn project(&self, p: DVec3) -> f64 {
        let last = self.pieces.len() - 1;
        let mut best = (f64::INFINITY, 0.0);
        for (k, piece) in self.pieces.iter().enumerate() {
            let low = if k == 0 { f64::NEG_INFINITY } else { 0.0 };
            let high = if k == last {
                f64::INFINITY
            } else {
                piece.length()
            };
            let s = piece.nearest(p).clamp(low, high);
            let square = piece.point(s).distance_squared(p);
            if square < best.0 {
                best = (square, self.starts[k] + s);
            }
        }
        best.1
    }

    /// The widest gap between the end of a piece and the start of the next one (metres).
    pub fn widest_gap(&self) -> f64 {
        let gap = |pair: &[Piece]| pair[0].point(pair[0].length()).distance(pair[1].point(0.0));
        self.pieces.windows(2).map(gap).fold(0.0, f64::max)
    }

    /// The sharpest turn between two pieces, as the length of the difference of their unit tangents: 0 if smooth.
    pub fn sharpest_turn(&self) -> f64 {
        let turn = |pair: &[Piece]| {
            let end = pair[0].tangent(pair[0].length());
            end.distance(pair[1].tangent(0.0))
        };
        self.pieces.windows(2).map(turn).fold(0.0, f64::max)
    }

    /// The path walked the other way.
    pub fn reversed(&self) -> Self {
        Self::new(self.pieces.iter().rev().map(Piece::reversed).collect())
    }
}
