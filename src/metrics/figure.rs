//! Measures of one cell.

use super::cells::{corners, principal_axis, share};
use super::{angle, ring_edges};
use crate::cells::Cell;
use crate::domain::signed_area;
use crate::field::CellKind;
use crate::planar::unit_vector;
use glam::DVec2;

/// Measures of a cell by its polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Area in square picture units.
    pub area: f64,
    /// The size that a cell of this kind and area has, in picture units.
    pub size: f64,
    /// Length over width by the second moments, at least 1.
    pub aspect: f64,
    /// The number of corners that turn by more than 10 degrees.
    pub sides: usize,
    /// Unit vector along its rows (squares) or its long axis (rectangles and ellipses); `None` for circles.
    pub axis: Option<DVec2>,
}

impl Figure {
    /// Measures a cell.
    pub fn new(cell: &Cell) -> Self {
        let ring = &cell.ring;
        let area = signed_area(ring).abs();
        let moments = principal_axis(ring);
        let axis = match cell.kind {
            CellKind::Square => square_axis(ring),
            CellKind::Circle => None,
            CellKind::Rectangle | CellKind::Ellipse => moments.map(|(_, axis)| axis),
        };
        Self {
            area,
            size: (area / share(cell.kind)).sqrt(),
            aspect: moments.map_or(1.0, |(aspect, _)| aspect),
            sides: corners(ring),
            axis,
        }
    }

    /// The angle between its axis and a direction in degrees, 0..45 for squares, otherwise 0..90; `None` if
    /// one of them is missing.
    pub fn misalignment(&self, kind: CellKind, direction: DVec2) -> Option<f64> {
        let axis = self.axis.filter(|_| direction != DVec2::ZERO)?;
        Some(angle(axis, direction, symmetry_angle(kind)))
    }
}

/// The smallest turn, in degrees, that leaves a cell of a kind unchanged.
pub(crate) fn symmetry_angle(kind: CellKind) -> f64 {
    360.0 / f64::from(kind.symmetry())
}

/// The mean direction of the edges, weighted by length, up to quarter turns.
fn square_axis(ring: &[DVec2]) -> Option<DVec2> {
    let mut sum = DVec2::ZERO;
    for [a, b] in ring_edges(ring) {
        let edge = b - a;
        let twice = edge.rotate(edge);
        let length = edge.length().max(f64::MIN_POSITIVE);
        sum += twice.rotate(twice / length) / (length * length);
    }
    let turn = 0.25 * libm::atan2(sum.y, sum.x);
    (sum != DVec2::ZERO).then(|| unit_vector(turn))
}
