//! Makes the edges of the parent mesh: chains of sides between the same two faces.

use super::ids::{CornerId, EdgeId, FaceId};
use super::path::Path;
use super::piece::{CircularArc, Piece};
use super::sides::{Side, SideTable};

/// A turn of a chain whose cosine is less makes a corner: 28 degrees.
const TURN: f64 = 0.883;
/// The tolerance for two circles (metres), or two unit tangents, to count as the same.
const SAME: f64 = 1e-6;

/// The edges of the parent mesh, and which sides they consist of.
pub(super) struct Chains {
    /// The sides of each edge from start to end, all of its first face.
    pub chains: Vec<Vec<usize>>,
    /// The edge of each side, and true if the side is of the edge's first face, so that it runs as the edge does.
    pub of_side: Vec<(EdgeId, bool)>,
    /// The corner at each welded vertex.
    pub corner: Vec<Option<CornerId>>,
    /// The number of corners.
    pub corners: usize,
}

/// Finds corners, and joins sides to edges between them.
///
/// A vertex is a corner unless exactly two sides meet there (twins count as one), with the same faces and in nearly the
/// same direction.
pub(super) fn find(sides: &SideTable) -> Chains {
    let corner = corners(sides);
    let count = corner.iter().flatten().count();
    let all = &sides.sides;
    let unset = (EdgeId(u32::MAX), true);
    let mut chains = Chains {
        chains: Vec::new(),
        of_side: vec![unset; all.len()],
        corner,
        corners: count,
    };
    // Chains between corners come first. The sides left over then lie on closed chains, which may start anywhere.
    for is_closed in [false, true] {
        for k in 0..all.len() {
            let starts = is_closed || chains.corner[all[k].from as usize].is_some();
            if starts && is_first(all, k) && chains.of_side[k] == unset {
                chains.walk(all, k);
            }
        }
    }
    chains
}

/// Whether the face of a side is the first one of its edge: the one with the lower number, or the only one.
fn is_first(sides: &[Side], k: usize) -> bool {
    let other = sides[k].twin.map(|twin| sides[twin].face);
    other.is_none_or(|other| sides[k].face < other)
}

/// The faces of a side, the lower one first.
fn pair(sides: &[Side], k: usize) -> (FaceId, Option<FaceId>) {
    let own = sides[k].face;
    match sides[k].twin.map(|twin| sides[twin].face) {
        Some(other) => (own.min(other), Some(own.max(other))),
        None => (own, None),
    }
}

/// The corners, numbered in the order of their vertices.
fn corners(sides: &SideTable) -> Vec<Option<CornerId>> {
    let all = &sides.sides;
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); sides.positions.len()];
    // Twins count as one side.
    let each = (0..all.len()).filter(|&k| all[k].twin.is_none_or(|twin| k < twin));
    for k in each {
        at[all[k].from as usize].push(k);
        at[all[k].to as usize].push(k);
    }
    let mut count = 0;
    let mut corner = vec![None; at.len()];
    for (v, ends) in at.iter().enumerate() {
        let goes_on = match ends[..] {
            [] => true,
            [a, b] => pair(all, a) == pair(all, b) && !turns(all, v as u32, [a, b]),
            _ => false,
        };
        if !goes_on {
            corner[v] = Some(CornerId(count));
            count += 1;
        }
    }
    corner
}

/// Whether the way from one side to the other turns sharply at a vertex.
fn turns(sides: &[Side], v: u32, ends: [usize; 2]) -> bool {
    let leaving = ends.map(|k| {
        let piece = &sides[k].piece;
        match sides[k].from == v {
            true => piece.tangent(0.0),
            false => -piece.tangent(piece.length()),
        }
    });
    -leaving[0].dot(leaving[1]) < TURN
}

impl Chains {
    /// Makes the edge that starts with a side.
    fn walk(&mut self, sides: &[Side], first: usize) {
        let id = EdgeId(self.chains.len() as u32);
        let mut chain = Vec::new();
        let mut k = first;
        loop {
            chain.push(k);
            self.of_side[k] = (id, true);
            if let Some(twin) = sides[k].twin {
                self.of_side[twin] = (id, false);
            }
            let end = self.corner[sides[k].to as usize];
            k = sides[k].next;
            if end.is_some() || k == first {
                break;
            }
        }
        self.chains.push(chain);
    }
}

/// The path along sides. Pieces of one line or one circle become one piece.
pub(super) fn path(sides: &[Side], chain: &[usize]) -> Path {
    let mut pieces: Vec<Piece> = Vec::new();
    for &k in chain {
        let next = sides[k].piece;
        let joined = pieces.last().and_then(|last| join(last, &next));
        match (joined, pieces.last_mut()) {
            (Some(joined), Some(last)) => *last = joined,
            _ => pieces.push(next),
        }
    }
    Path::new(pieces)
}

/// Two pieces as one, if the second one goes on along the same line or circle.
fn join(a: &Piece, b: &Piece) -> Option<Piece> {
    match (a, b) {
        (&Piece::Line { from, .. }, &Piece::Line { to, .. }) => {
            let along = a.tangent(0.0).dot(b.tangent(0.0));
            (along > 1.0 - SAME * SAME).then_some(Piece::Line { from, to })
        }
        (Piece::Arc(first), Piece::Arc(second)) => {
            let is_same = first.centre.distance(second.centre) < SAME
                && (first.radius - second.radius).abs() < SAME
                && a.tangent(a.length()).distance(b.tangent(0.0)) < SAME;
            let turn = (second.to - second.from).abs() * first.sense();
            is_same.then_some(Piece::Arc(CircularArc {
                to: first.to + turn,
                ..*first
            }))
        }
        _ => None,
    }
}
