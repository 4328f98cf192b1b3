//! Parameters of the fields.

use super::{CellKind, Grading, SoftSpot};
use crate::domain::Domain;
use glam::DVec2;

/// Source of the direction of the cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Direction {
    /// Along the boundary, the constraint lines and the strokes; each piece is weighted with an inverse power
    /// of its distance.
    #[default]
    Boundary,
    /// Along the strokes and the constraint lines only; a constant angle if there are none.
    Strokes,
    /// A constant angle; near strokes, the direction follows them.
    Constant,
    /// A constant angle to the rays from a point: 0 is radial, a quarter turn circular, and angles between give
    /// spirals. Near strokes, the direction follows them. On the torus the rays are those of (sin x, sin y) with the
    /// side as period: the same near the point, with three more singular points half a side away.
    Spiral,
    /// Equation (1) of Miyata, Itoh, Shimada (2000) to the letter: signed segment vectors are
    /// summed, so that the two sides of a road cancel on its middle line. For comparison.
    Printed,
}

/// Parameters of the fields. Lengths and places are picture units, angles radians from +x towards +y
/// (clockwise on screen).
#[derive(Clone, Debug, PartialEq)]
pub struct FieldParams {
    /// Source of the direction.
    pub direction: Direction,
    /// The angle of [`Direction::Constant`], or the angle to the rays of [`Direction::Spiral`].
    pub angle: f64,
    /// The point of [`Direction::Spiral`].
    pub centre: DVec2,
    /// Power of the distance in the weights of boundary, lines and strokes: 2 (as printed), 3 or 4.
    pub power: u32,
    /// Weight of the boundary's ends for two-fold directions, 0..1. An end is a piece between two corners
    /// that is shorter than its neighbours, as at the end of a road.
    pub ends: f64,
    /// Painted polylines for rows to follow.
    pub strokes: Vec<Vec<DVec2>>,
    /// For the constant and the spiral direction: the distance at which a long stroke weighs as much as the
    /// background.
    pub reach: f64,
    /// Kind of the cells.
    pub kind: CellKind,
    /// Kinds of the parts made by constraint lines, each with a place in its part. Later entries override
    /// earlier ones; other parts have `kind`.
    pub part_kinds: Vec<(DVec2, CellKind)>,
    /// Aspect ratio of stretched cells (Ca), 1..5: length along the direction over width.
    pub aspect: f64,
    /// Change of the aspect ratio towards the boundary.
    pub aspect_grading: Grading,
    /// Spots with their own aspect ratio; later ones override earlier ones.
    pub aspect_spots: Vec<SoftSpot>,
    /// Mean size of a cell (Cs): its side, or the side of the square with its area.
    pub size: f64,
    /// Relative change of the size from the picture's centre to its right and lower edge, -0.8..0.8. On the
    /// torus, amplitudes of waves.
    pub linear: DVec2,
    /// Relative change of the size towards the picture's rim (the centre changes the other way).
    pub radial: f64,
    /// Change of the size towards the boundary.
    pub size_grading: Grading,
    /// Spots with a factor of the size; where they overlap, factors are multiplied.
    pub size_spots: Vec<SoftSpot>,
    /// Side of the square picture.
    pub side: f64,
}

impl Default for FieldParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// No change towards the boundary.
const EVEN: Grading = Grading {
    factor: 1.0,
    reach: 128.0,
};

impl FieldParams {
    /// Squares along the boundary, for a picture of 512 units.
    pub const DEFAULT: Self = Self {
        direction: Direction::Boundary,
        angle: 0.0,
        centre: DVec2::splat(256.0),
        power: 4,
        ends: 0.0,
        strokes: Vec::new(),
        reach: 76.8,
        kind: CellKind::Square,
        part_kinds: Vec::new(),
        aspect: 2.0,
        aspect_grading: EVEN,
        aspect_spots: Vec::new(),
        size: 23.0,
        linear: DVec2::ZERO,
        radial: 0.0,
        size_grading: EVEN,
        size_spots: Vec::new(),
        side: 512.0,
    };

    /// The kinds by the index of the domain's part; empty if all parts have `kind`.
    pub(super) fn kinds(&self, domain: &Domain) -> Vec<CellKind> {
        let mut kinds = vec![self.kind; domain.parts()];
        for &(place, own) in &self.part_kinds {
            if domain.contains(place)
                && let Some(kind) = kinds.get_mut(domain.part(place))
            {
                *kind = own;
            }
        }
        if kinds.iter().all(|&own| own == self.kind) {
            kinds.clear();
        }
        kinds
    }

    /// Whether the size changes towards the boundary or at spots, so that a number and a gradient are not enough.
    pub(super) fn varies_size(&self) -> bool {
        !self.size_grading.is_flat() || !self.size_spots.is_empty()
    }

    /// Whether the aspect ratio changes towards the boundary or at spots, so that a number is not enough.
    pub(super) fn varies_aspect(&self) -> bool {
        !self.aspect_grading.is_flat() || !self.aspect_spots.is_empty()
    }
}
