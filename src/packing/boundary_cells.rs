//! Placement of the cells along the boundary.

use super::clearance::is_clear;
use super::grid::Grid;
use super::placed::Placed;
use super::shape::CellShape;
use super::surroundings::PlaneDomain;
use crate::field::Fields;
use glam::DVec2;

/// Corners are the points at which a ring turns by more than 25 degrees; this is the cosine.
const CORNER: f64 = 0.906;
/// A boundary cell is dropped if another cell is nearer than this, in stable distances.
const BOUNDARY_GAP: f64 = 0.6;
/// A boundary cell is also dropped if the boundary is nearer than this share of its row's inset: there a bend is
/// tighter than a cell.
const BOUNDARY_CLEARANCE: f64 = 0.8;
/// Insets of the first row, in sizes, in the order in which they are tried: half a cell, or less where the outline is
/// narrow.
const DEPTHS: [f64; 4] = [0.5, 0.4, 0.3, 0.22];

/// A piece of a ring between corners, as a polyline; a smooth ring is one closed piece.
pub(super) struct RingPiece {
    points: Vec<DVec2>,
    /// Unit vectors along the previous and the next piece where they meet this one; `None` if this piece is closed.
    before: Option<DVec2>,
    after: Option<DVec2>,
}

/// The pieces of a ring, or of an open line.
pub(super) fn pieces(points: &[DVec2], closed: bool) -> Vec<RingPiece> {
    let n = points.len();
    let along = |k: usize| (points[(k + 1) % n] - points[k % n]).normalize();
    let turns = |k: usize| along(k + n - 1).dot(along(k)) < CORNER;
    let mut corners: Vec<usize> = if closed {
        (0..n).filter(|&k| turns(k)).collect()
    } else {
        (0..n)
            .filter(|&k| k == 0 || k == n - 1 || turns(k))
            .collect()
    };
    if corners.is_empty() {
        let mut points = points.to_vec();
        points.push(points[0]);
        return vec![RingPiece {
            points,
            before: None,
            after: None,
        }];
    }
    if closed {
        corners.push(corners[0] + n);
    }
    let runs = corners.windows(2).map(|w| (w[0], w[1]));
    runs.map(|(from, to)| {
        // The free ends of a line continue straight.
        let first = if !closed && from == 0 {
            from
        } else {
            from + n - 1
        };
        let last = if !closed && to == n - 1 { to - 1 } else { to };
        RingPiece {
            points: (from..=to).map(|k| points[k % n]).collect(),
            before: Some(along(first)),
            after: Some(along(last)),
        }
    })
    .collect()
}

/// The pieces of a constraint line. It is followed there and back, for a row of cells along each side. If `fixed`,
/// cells stand on the line, and it is followed only once.
pub(super) fn line_pieces(line: &[DVec2], fixed: bool) -> Vec<RingPiece> {
    let closed = line.first() == line.last();
    let mut points = line.to_vec();
    if closed {
        points.pop();
    }
    let mut both = pieces(&points, closed);
    if !fixed {
        points.reverse();
        both.extend(pieces(&points, closed));
    }
    both
}

/// Places evenly spaced cells along a piece: on it if `fixed`, else inside it by half a cell or less.
pub(super) fn boundary_cells(
    placed: &mut Placed<DVec2, Grid>,
    piece: &RingPiece,
    around: PlaneDomain,
    fixed: bool,
) {
    let PlaneDomain { domain, fields, .. } = around;
    // The inset fits if most of the row is clear of the opposite side.
    let is_wide = |depth: &&f64| {
        let line = offset_line(piece, fields, **depth);
        let clear = |p: &&DVec2| is_clear(**p, BOUNDARY_CLEARANCE * **depth, fields, domain);
        2 * line.iter().filter(clear).count() >= line.len()
    };
    let wide = DEPTHS.iter().find(is_wide);
    if wide.is_none() && !fixed {
        return narrow_cells(placed, piece, around);
    }
    let depth = *wide.unwrap_or(&DEPTHS[0]);
    let line = if fixed {
        piece.points.clone()
    } else {
        offset_line(piece, fields, depth)
    };
    let closed = piece.before.is_none();
    let spaced = spaced(&line, fields, 0.0);
    for &(p, _) in &spaced[..spaced.len() - usize::from(closed)] {
        let clear = || is_clear(p, BOUNDARY_CLEARANCE * depth, fields, domain);
        if (fixed || clear()) && placed.is_free(around, p, BOUNDARY_GAP) {
            placed.push(fields, p);
        }
    }
}

/// Where the outline is narrower than a cell, places cells on its centre line, in even steps along the wall.
fn narrow_cells(placed: &mut Placed<DVec2, Grid>, piece: &RingPiece, around: PlaneDomain) {
    let PlaneDomain { domain, fields, .. } = around;
    for (p, along) in spaced(&piece.points, fields, 0.5) {
        let inward = along.perp();
        let most = DEPTHS[0] * CellShape::metric_at(fields, p).extent(inward);
        let p = p + inward * domain.medial_depth(p, inward, most);
        if domain.contains(p) && placed.is_free(around, p, BOUNDARY_GAP) {
            placed.push(fields, p);
        }
    }
}

/// Evenly spaced places along a line that holds a whole number of cells, each with the line's unit vector. The first
/// place is `from` cells after the start, the last as far before the end.
fn spaced(line: &[DVec2], fields: &Fields, from: f64) -> Vec<(DVec2, DVec2)> {
    // Lengths in cells: steps are shorter where cells are smaller.
    let mut reached = vec![0.0];
    for w in line.windows(2) {
        let cells = CellShape::metric_at(fields, w[0].midpoint(w[1])).cells_along(w[1] - w[0]);
        reached.push(reached[reached.len() - 1] + cells);
    }
    let total = reached[reached.len() - 1];
    let count = (total.round() as usize).max(1);
    let places = if from > 0.0 { count } else { count + 1 };
    let mut k = 0;
    let place = |place: usize| {
        let at = total * (place as f64 + from) / count as f64;
        while k + 2 < line.len() && reached[k + 1] < at {
            k += 1;
        }
        let span = reached[k + 1] - reached[k];
        let t = if span > 0.0 {
            ((at - reached[k]) / span).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let (a, b) = (line[k], line[k + 1]);
        (a.lerp(b, t), (b - a).normalize_or_zero())
    };
    (0..places).map(place).collect()
}

/// The piece moved inwards by `depth` cells. At its ends it meets the neighbouring pieces' offset lines.
fn offset_line(piece: &RingPiece, fields: &Fields, depth: f64) -> Vec<DVec2> {
    let points = &piece.points;
    let last = points.len() - 1;
    let along = |k: usize| (points[k + 1] - points[k]).normalize();
    let closing = (piece.before.is_none()).then(|| (along(last - 1), along(0)));
    (0..=last)
        .map(|k| {
            let earlier = match (k, piece.before, closing) {
                (0, Some(before), _) => before,
                (0, None, Some((end, _))) => end,
                _ => along(k.max(1) - 1),
            };
            let later = match (k == last, piece.after, closing) {
                (true, Some(after), _) => after,
                (true, None, Some((_, start))) => start,
                _ => along(k.min(last - 1)),
            };
            let mitre = mitre(earlier, later);
            let shape = CellShape::metric_at(fields, points[k]);
            points[k] + mitre * depth * shape.extent(mitre.normalize())
        })
        .collect()
}

/// The intersection of two lines' inward offsets by 1, relative to their common point. At tips sharper than
/// about 40 degrees it is pulled back.
fn mitre(earlier: DVec2, later: DVec2) -> DVec2 {
    let normal = (earlier.perp() + later.perp()).normalize_or(later.perp());
    normal / normal.dot(later.perp()).max(0.35)
}
