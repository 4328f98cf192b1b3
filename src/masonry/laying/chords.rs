//! Chords of edges on faces: claims of faces are handed on to the edges that they cover.

use crate::building::{Building, Edge, EdgeId, Face, Piece};
use crate::masonry::footprint::Footprint;
use glam::DVec2;

/// Vertices this near to a face or an edge lie on it (metres).
pub(super) const ON: f64 = 2e-3;
/// The longest chord of an arc in (s, t) when an edge is claimed (metres).
const CHORD: f64 = 0.06;

/// The chords of an edge on a face.
pub(super) struct EdgeChords {
    pub id: EdgeId,
    pub chords: Vec<Chord>,
}

/// A chord of an edge on a face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chord {
    /// Its ends by arc length (metres).
    pub span: [f64; 2],
    /// Its ends in the face's (s, t).
    pub ends: [DVec2; 2],
}

/// The chords of a face's edges, in the order of its loops.
pub(super) fn face_chords(building: &Building, face: &Face) -> Vec<EdgeChords> {
    let edges = face.loops.iter().flatten().map(|walk| walk.edge);
    let found = edges.map(|id| {
        let edge = building.edge(id);
        let place = |at: f64| face.surface.project(edge.path.point(at)).truncate();
        let chords = chords(edge).into_iter().map(|span| Chord {
            span,
            ends: span.map(place),
        });
        EdgeChords {
            id,
            chords: chords.collect(),
        }
    });
    found.collect()
}

/// The ends of the straight pieces of an edge, and of short chords of its arcs, by arc length.
pub(super) fn chords(edge: &Edge) -> Vec<[f64; 2]> {
    let joints = edge.path.joints();
    let pieces = joints.windows(2).zip(edge.path.pieces());
    let chords = pieces.flat_map(|(ends, piece)| {
        let is_line = matches!(piece, Piece::Line { .. });
        let count = if is_line {
            1.0
        } else {
            ((ends[1] - ends[0]) / CHORD).ceil().max(1.0)
        };
        let at = move |k: f64| ends[0] + (ends[1] - ends[0]) * k / count;
        (0..count as usize)
            .map(move |k| [at(k as f64), at(k as f64 + 1.0)])
            .collect::<Vec<_>>()
    });
    chords.collect()
}

/// The ends of a chord, moved by whole periods of a cylinder to the turn in which `near` lies.
pub(super) fn same_turn([a, b]: [DVec2; 2], near: DVec2, period: Option<f64>) -> [DVec2; 2] {
    let Some(period) = period else {
        return [a, b];
    };
    let turned = |p: DVec2, to: f64| DVec2::new(p.x - period * ((p.x - to) / period).round(), p.y);
    let a = turned(a, near.x);
    [a, turned(b, a.x)]
}

/// The part of a chord in or along a polygon, as shares of its length from 0 to 1.
pub(super) fn covered(polygon: &Footprint, [a, b]: [DVec2; 2]) -> Option<[f64; 2]> {
    let [low, high] = polygon.bounds();
    if a.min(b).cmpgt(high + ON).any() || a.max(b).cmplt(low - ON).any() {
        return None;
    }
    let (mut from, mut to) = (0.0f64, 1.0f64);
    let length = a.distance(b);
    for half in polygon.half_planes() {
        let (start, end) = (half.distance(a), half.distance(b));
        // Along a side the chord may lie a little outside of it.
        let slack = if (end - start).abs() < 0.1 * length {
            ON
        } else {
            1e-6
        };
        let (start, end) = (start + slack, end + slack);
        if start < 0.0 && end < 0.0 {
            return None;
        }
        if start < 0.0 {
            from = from.max(start / (start - end));
        } else if end < 0.0 {
            to = to.min(start / (start - end));
        }
    }
    ((to - from) * length > 1e-5).then_some([from, to])
}
