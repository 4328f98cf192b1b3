//! What packing asks of the ground that cells are packed on: the plane within an outline (`plane`), or a surface in
//! space.
//!
//! What is between two cells is told as a vector of the plane in the frame of one of them, so forces and metrics know
//! nothing of the ground. The code is compiled for each ground; in the plane, where all frames are one, nothing of
//! what is told here costs anything, nor changes a bit.

use super::BoundaryCondition;
use super::params::{TUNING, Tuning};
use super::shape::Shape;
use crate::field::Kind;
use crate::random::Random;
use glam::DVec2;
use std::fmt::Debug;
use std::ops::Range;

/// Carries vectors from the frame of one place into that of another, by a turn.
pub(crate) trait Carry: Copy {
    /// A vector of the first frame, in the second one.
    fn apply(self, v: DVec2) -> DVec2;
    /// A vector of the second frame, in the first one.
    fn undo(self, v: DVec2) -> DVec2;
}

/// The place on a wall where its distance to a cell is least.
pub(crate) trait Foot {
    /// The distance, positive.
    fn distance(&self) -> f64;
    /// Unit vector away from the wall, in the cell's frame.
    fn inward(&self) -> DVec2;
}

/// Buckets of places, to find neighbours in constant time.
pub(crate) trait Buckets<P> {
    /// The number of the bucket that a place lies in.
    fn bucket(&self, p: P) -> usize;
    /// How many there are.
    fn buckets(&self) -> usize;
    /// The buckets whose places may lie within `radius` of `p`, as runs in rising order.
    fn runs_near(&self, p: P, radius: f64) -> impl Iterator<Item = Range<usize>>;
    /// Adds the next place; they are numbered as they come, from 0.
    fn push(&mut self, p: P);
}

/// What cells are asked to be at a place.
pub(crate) trait Asks: Copy {
    /// Where a cell can be.
    type Place: Copy + Debug;

    fn kind(self, p: Self::Place) -> Kind;
    fn size(self, p: Self::Place) -> f64;
    fn aspect(self, p: Self::Place) -> f64;
    /// Unit vector along a side, in the frame of the place; zero where the field vanishes.
    fn direction(self, p: Self::Place) -> DVec2;
    /// The mean size asked for.
    fn mean_size(self) -> f64;
}

/// What places see of each other. Vectors are in the frame of the place that comes first.
pub(crate) trait Sees: Copy {
    type Place: Copy + Debug;
    type Turn: Carry;
    type Grid: Buckets<Self::Place>;
    /// Is it work to go from place to place?
    const WALKS: bool;

    /// The area that is packed.
    fn area(self) -> f64;
    /// The way to another place, and what carries vectors from there; nothing where the one cannot see the other.
    fn way(self, from: Self::Place, to: Self::Place) -> Option<(DVec2, Self::Turn)>;
    /// The images of a place that may be within reach of others at home.
    fn images(self, p: Self::Place, reach: f64) -> impl Iterator<Item = Self::Place>;
    /// The way from an image, where no other image is nearer; nothing where it is certainly longer than `reach`.
    fn way_from(
        self,
        image: Self::Place,
        to: Self::Place,
        reach: f64,
    ) -> Option<(DVec2, Self::Turn)>;
    /// The same from a place itself, to that image which is nearest.
    fn way_within(
        self,
        from: Self::Place,
        to: Self::Place,
        reach: f64,
    ) -> Option<(DVec2, Self::Turn)>;
    /// Where a way leads that goes straight on, past walls, and what carries vectors there.
    fn beyond(self, from: Self::Place, by: DVec2) -> (Self::Place, Self::Turn);
    /// At home, where places repeat.
    fn home(self, p: Self::Place) -> Self::Place;
    /// How far a cell has moved.
    fn distance(self, from: Self::Place, to: Self::Place) -> f64;
    /// Has a cell moved at least as far as this squared?
    fn has_left(self, from: Self::Place, to: Self::Place, square: f64) -> bool;

    /// Is there a wall between a place and another one, `r` away?
    fn is_parted(self, p: Self::Place, r: DVec2) -> bool;
    /// Is there a line between a place and another one, `r` away, that a cell does not look over?
    fn crosses_line(self, p: Self::Place, r: DVec2) -> bool;
    /// Do they belong to parts that know nothing of each other?
    fn is_gap_between(self, p: Self::Place, q: Self::Place) -> bool;

    /// Buckets over all of the ground.
    fn grid(self, step: f64) -> Self::Grid;
    /// Buckets over these places.
    fn grid_around(self, places: impl Iterator<Item = Self::Place>, step: f64) -> Self::Grid;
    /// Calls `visit` with the number of every place that may lie within `radius`, until it says true; then true.
    fn any_near(
        self,
        grid: &Self::Grid,
        p: Self::Place,
        radius: f64,
        visit: impl FnMut(usize) -> bool,
    ) -> bool;
}

/// Walls, and how they are seen from a place.
pub(crate) trait Walled: Copy {
    type Place: Copy;
    type Foot: Foot;

    /// May walls be within reach of a place?
    fn is_near(self, p: Self::Place) -> bool;
    /// How far walls reach.
    fn reach(self) -> f64;
    /// The feet of a place on walls within reach, the nearest first; overwrites `feet`.
    fn feet(self, p: Self::Place, reach: f64, feet: &mut Vec<Self::Foot>);
}

/// See the head of this file.
pub(crate) trait Ground: Copy {
    type Place: Copy + Debug;
    type Fields: Asks<Place = Self::Place>;
    type Sight: Sees<Place = Self::Place>;
    type Walls: Walled<Place = Self::Place>;
    /// The constants of the run.
    const TUNING: Tuning = TUNING;

    fn fields(self) -> Self::Fields;
    fn sight(self) -> Self::Sight;
    fn walls(self) -> Self::Walls;
    /// Are cells' centres, or their edges, on the boundary?
    fn boundary(self) -> BoundaryCondition;

    /// Where a cell comes that moves, held by the walls, and what carries vectors there. `is_clear`: none is near.
    fn moved(
        self,
        from: Self::Place,
        by: DVec2,
        shape: Shape,
        is_clear: bool,
    ) -> (Self::Place, TurnOf<Self>);
    /// Is there room for a cell between the walls at this place?
    fn has_room(self, p: Self::Place) -> bool;
    /// Where it is too narrow for a cell at a place, the middle between the walls there.
    fn middle_of_narrow(self, p: Self::Place) -> Option<Self::Place>;

    /// Middles of parts that none of these cells is in.
    fn empty_parts(self, cells: &[Self::Place]) -> Vec<Self::Place>;
    /// Are there several?
    fn has_parts(self) -> bool;
    /// Where round cells begin to grow, rather than along the walls.
    fn hearts(self) -> Vec<Self::Place>;
    /// Directions of the rows of honeycombs, as many as there are of them.
    fn honeycombs(self) -> Vec<DVec2>;
    /// That of them which a place belongs to; nothing where rows follow the field.
    fn honeycomb(self, p: Self::Place) -> Option<usize>;
    /// Any place, by chance.
    fn anywhere(self, random: &mut Random) -> Self::Place;
}

pub(crate) type TurnOf<G> = <<G as Ground>::Sight as Sees>::Turn;
pub(crate) type GridOf<G> = <<G as Ground>::Sight as Sees>::Grid;
pub(crate) type FootOf<G> = <<G as Ground>::Walls as Walled>::Foot;
