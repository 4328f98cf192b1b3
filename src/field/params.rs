//! What the fields are made from.

use super::{Grading, Kind, Spot};
use crate::domain::Domain;
use glam::DVec2;

/// Where the direction of the cells comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Direction {
    /// Along the boundary, the constraint lines and the strokes: each piece counts with the inverse
    /// power of its distance.
    #[default]
    Boundary,
    /// Along the strokes and the constraint lines only; one angle where there are none.
    Strokes,
    /// One angle everywhere. Strokes count near them.
    Constant,
    /// At one angle to the rays from a point: 0 radial, a quarter turn circular, spirals in between.
    /// Strokes count near them. On the torus, the rays are those of (sin x, sin y) with a wave as
    /// long as the side: near the point the same, and half a side away from it three more singular
    /// points.
    Spiral,
    /// Equation (1) of Miyata, Itoh, Shimada (2000) to the letter: signed segment vectors are
    /// summed, so that the two sides of a road cancel on its middle line. For comparison.
    Printed,
}

/// What the fields are made from. Lengths and places are picture units, angles radians from +x
/// towards +y (clockwise on screen).
#[derive(Clone, Debug, PartialEq)]
pub struct FieldParams {
    /// Source of the direction.
    pub direction: Direction,
    /// The angle of [`Direction::Constant`], or that to the rays of [`Direction::Spiral`].
    pub angle: f64,
    /// The point of [`Direction::Spiral`].
    pub centre: DVec2,
    /// Power of the distance in the weights of boundary, lines and strokes: 2 (as printed), 3 or 4.
    pub power: u32,
    /// Weight of the boundary's ends for two-fold directions, 0..1: ends are pieces between two
    /// corners shorter than the sides next to them, as at the end of a road.
    pub ends: f64,
    /// Painted polylines that rows follow.
    pub strokes: Vec<Vec<DVec2>>,
    /// In the constant and the spiral direction: a long stroke counts as much as these at this
    /// distance.
    pub reach: f64,
    /// Kind of the cells.
    pub kind: Kind,
    /// Kinds of the parts that constraint lines cut the outline into, each with a place in its part;
    /// later ones over earlier ones, `kind` where there is none.
    pub part_kinds: Vec<(DVec2, Kind)>,
    /// Aspect ratio of stretched cells (Ca), 1..5: length along the direction over width.
    pub aspect: f64,
    /// The aspect ratio's change towards the boundary.
    pub aspect_grading: Grading,
    /// Spots with an aspect ratio of their own, later ones over earlier ones.
    pub aspect_spots: Vec<Spot>,
    /// Mean side of a cell (Cs): a stretched one has the area of a square of this side.
    pub size: f64,
    /// Relative change of the size from the picture's middle to its right and lower edge, -0.8..0.8.
    /// On the torus the amplitudes of waves.
    pub linear: DVec2,
    /// Relative change of the size towards the picture's rim (its middle changes the other way).
    pub radial: f64,
    /// The size's change towards the boundary.
    pub size_grading: Grading,
    /// Spots with a factor of the size; where they overlap, factors are multiplied.
    pub size_spots: Vec<Spot>,
    /// Side of the square picture.
    pub side: f64,
}

impl FieldParams {
    /// The kinds by the index of the domain's part; none where all have the same.
    pub(super) fn kinds(&self, domain: &Domain) -> Vec<Kind> {
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

    /// Is the size other than a number and a gradient?
    pub(super) fn varies_size(&self) -> bool {
        !self.size_grading.is_flat() || !self.size_spots.is_empty()
    }

    /// Is the aspect ratio other than a number?
    pub(super) fn varies_aspect(&self) -> bool {
        !self.aspect_grading.is_flat() || !self.aspect_spots.is_empty()
    }
}
