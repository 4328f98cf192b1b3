//! The domain that cells are packed on, as traits: the plane within an outline (`plane`), or a surface in
//! space.
//!
//! The offset between two cells is a plane vector in the tangent frame of one of them, so forces and metrics
//! do not depend on the domain. The code is compiled for each domain. In the plane all frames are one, so the
//! abstraction costs nothing there and changes no bit.

use super::BoundaryCondition;
use super::cell_fields::CellFields;
use super::params::{TUNING, Tuning};
use super::shape::CellShape;
use super::transport::ParallelTransport;
use crate::random::Random;
use glam::DVec2;
use std::fmt::Debug;
use std::ops::Range;

/// The closest point of a wall to a cell.
pub(crate) trait ClosestPoint {
    /// The distance, positive.
    fn distance(&self) -> f64;
    /// Unit vector away from the wall, in the cell's frame.
    fn inward(&self) -> DVec2;
}

/// A spatial hash of places.
pub(crate) trait SpatialHash<P> {
    /// The number of a place's bucket.
    fn bucket(&self, p: P) -> usize;
    /// The number of buckets.
    fn buckets(&self) -> usize;
    /// The buckets whose places may lie within `radius` of `p`, as ranges in rising order.
    fn runs_near(&self, p: P, radius: f64) -> impl Iterator<Item = Range<usize>>;
    /// Adds the next place; places are numbered from 0 in order of insertion.
    fn push(&mut self, p: P);
}

/// The metric between places. Vectors are in the frame of the first place.
pub(crate) trait MetricSpace: Copy {
    type Place: Copy + Debug;
    type Transport: ParallelTransport;
    type Hash: SpatialHash<Self::Place>;
    /// Whether tracing a path from place to place is expensive.
    const WALKS: bool;

    /// The area to be packed.
    fn area(self) -> f64;
    /// The offset to another place, and the parallel transport from there; `None` if a wall separates them.
    fn log(self, from: Self::Place, to: Self::Place) -> Option<(DVec2, Self::Transport)>;
    /// The images of a place that may be within reach of places in the domain.
    fn images(self, p: Self::Place, reach: f64) -> impl Iterator<Item = Self::Place>;
    /// The offset to a place from an image of another place. `None` if another image is nearer, or if the offset is
    /// certainly longer than `reach`.
    fn log_from(
        self,
        image: Self::Place,
        to: Self::Place,
        reach: f64,
    ) -> Option<(DVec2, Self::Transport)>;
    /// The offset from a place to the nearest image of another one. `None` if it is certainly longer than `reach`.
    fn log_within(
        self,
        from: Self::Place,
        to: Self::Place,
        reach: f64,
    ) -> Option<(DVec2, Self::Transport)>;
    /// The place at the end of a straight path that ignores walls, and the parallel transport to it (the
    /// exponential map).
    fn exp(self, from: Self::Place, by: DVec2) -> (Self::Place, Self::Transport);
    /// The representative of a place if places repeat, as on a torus.
    fn wrap(self, p: Self::Place) -> Self::Place;
    /// The distance between two places of a cell, before and after a move.
    fn distance(self, from: Self::Place, to: Self::Place) -> f64;
    /// Whether a cell has moved at least this far; `square` is the squared distance.
    fn has_left(self, from: Self::Place, to: Self::Place, square: f64) -> bool;

    /// Whether a wall separates a place from another one at offset `r`.
    fn is_parted(self, p: Self::Place, r: DVec2) -> bool;
    /// Whether a constraint line separates a place from another one at offset `r`.
    fn crosses_line(self, p: Self::Place, r: DVec2) -> bool;
    /// Whether two places belong to parts that do not interact.
    fn is_gap_between(self, p: Self::Place, q: Self::Place) -> bool;

    /// A spatial hash over the whole domain.
    fn grid(self, step: f64) -> Self::Hash;
    /// A spatial hash over these places.
    fn grid_around(self, places: impl Iterator<Item = Self::Place>, step: f64) -> Self::Hash;
    /// Calls `visit` with the number of every place that may lie within `radius`, until one call returns true. Returns
    /// whether one did.
    fn any_near(
        self,
        grid: &Self::Hash,
        p: Self::Place,
        radius: f64,
        visit: impl FnMut(usize) -> bool,
    ) -> bool;
}

/// The walls, and their closest points to a place.
pub(crate) trait Boundary: Copy {
    type Place: Copy;
    type ClosestPoint: ClosestPoint;

    /// Whether walls may be within reach of a place.
    fn is_near(self, p: Self::Place) -> bool;
    /// The greatest distance at which closest points are found.
    fn reach(self) -> f64;
    /// The closest points of the walls within reach of a place, nearest first; overwrites `feet`.
    fn closest_points(self, p: Self::Place, reach: f64, feet: &mut Vec<Self::ClosestPoint>);
}

/// A domain with fields and walls; see the head of this file.
pub(crate) trait PackingDomain: Copy {
    type Place: Copy + Debug;
    type Fields: CellFields<Place = Self::Place>;
    type Metric: MetricSpace<Place = Self::Place>;
    type Walls: Boundary<Place = Self::Place>;
    /// The schedule of a run, and the size of a packing.
    const TUNING: Tuning = TUNING;

    fn fields(self) -> Self::Fields;
    fn metric(self) -> Self::Metric;
    fn walls(self) -> Self::Walls;
    /// How the cells meet the boundary.
    fn boundary(self) -> BoundaryCondition;

    /// The place of a cell after a move, held inside by the walls, and the parallel transport to it. `is_clear`: the
    /// move certainly stays clear of all walls.
    fn moved(
        self,
        from: Self::Place,
        by: DVec2,
        shape: CellShape,
        is_clear: bool,
    ) -> (Self::Place, TransportOf<Self>);
    /// Whether the walls leave room for a cell at this place.
    fn has_room(self, p: Self::Place) -> bool;
    /// If a place is too narrow for a cell, the point midway between the walls; otherwise `None`.
    fn middle_of_narrow(self, p: Self::Place) -> Option<Self::Place>;

    /// Centres of the parts without any of these cells.
    fn empty_parts(self, cells: &[Self::Place]) -> Vec<Self::Place>;
    /// Whether there are several parts.
    fn has_parts(self) -> bool;
    /// Seeds from which round cells grow, instead of growing from the walls.
    fn seeds(self) -> Vec<Self::Place> {
        Vec::new()
    }
    /// The row direction of each honeycomb.
    fn honeycombs(self) -> Vec<DVec2> {
        Vec::new()
    }
    /// The honeycomb that a place belongs to; `None` if rows follow the field.
    fn honeycomb(self, _: Self::Place) -> Option<usize> {
        None
    }
    /// A random place.
    fn anywhere(self, random: &mut Random) -> Self::Place;
}

pub(crate) type TransportOf<G> = <<G as PackingDomain>::Metric as MetricSpace>::Transport;
pub(crate) type HashOf<G> = <<G as PackingDomain>::Metric as MetricSpace>::Hash;
pub(crate) type ClosestPointOf<G> = <<G as PackingDomain>::Walls as Boundary>::ClosestPoint;
