//! The plane within an outline, as a domain for packing.

use super::BoundaryCondition;
use super::cell_fields::CellFields;
use super::clearance::{has_room, middle_of_narrow};
use super::grid::Grid;
use super::packing_domain::{Boundary, ClosestPoint, MetricSpace, PackingDomain, SpatialHash};
use super::shape::CellShape;
use super::surroundings::PlaneDomain;
use super::transport::IdentityTransport;
use super::wall::CLOSEST;
use crate::domain::{Domain, Projection, Walls};
use crate::field::{CellKind, Fields};
use crate::planar::unit_vector;
use crate::random::Random;
use glam::DVec2;
use std::ops::Range;

impl ClosestPoint for Projection {
    fn distance(&self) -> f64 {
        self.distance
    }

    fn inward(&self) -> DVec2 {
        self.inward
    }
}

impl CellFields for &Fields {
    type Place = DVec2;

    fn kind(self, p: DVec2) -> CellKind {
        Fields::kind(self, p)
    }

    fn size(self, p: DVec2) -> f64 {
        Fields::size(self, p)
    }

    fn aspect(self, p: DVec2) -> f64 {
        Fields::aspect(self, p)
    }

    fn direction(self, p: DVec2) -> DVec2 {
        Fields::direction(self, p)
    }

    fn mean_size(self) -> f64 {
        self.params().size
    }
}

impl SpatialHash<DVec2> for Grid {
    fn bucket(&self, p: DVec2) -> usize {
        Grid::bucket(self, p)
    }

    fn buckets(&self) -> usize {
        Grid::buckets(self)
    }

    fn runs_near(&self, p: DVec2, radius: f64) -> impl Iterator<Item = Range<usize>> {
        Grid::runs_near(self, p, radius)
    }

    fn push(&mut self, p: DVec2) {
        Grid::push(self, p);
    }
}

impl MetricSpace for &Domain {
    type Place = DVec2;
    type Transport = IdentityTransport;
    type Hash = Grid;
    const WALKS: bool = false;

    fn area(self) -> f64 {
        Domain::area(self)
    }

    #[inline(always)]
    fn log(self, from: DVec2, to: DVec2) -> Option<(DVec2, IdentityTransport)> {
        Some((self.space().shortest(to - from), IdentityTransport))
    }

    fn images(self, p: DVec2, reach: f64) -> impl Iterator<Item = DVec2> {
        self.space().images(p, reach)
    }

    #[inline(always)]
    fn log_from(self, image: DVec2, to: DVec2, _: f64) -> Option<(DVec2, IdentityTransport)> {
        let r = to - image;
        self.space()
            .is_shortest(r)
            .then_some((r, IdentityTransport))
    }

    #[inline(always)]
    fn log_within(self, from: DVec2, to: DVec2, _: f64) -> Option<(DVec2, IdentityTransport)> {
        self.log(from, to)
    }

    fn exp(self, from: DVec2, by: DVec2) -> (DVec2, IdentityTransport) {
        (from + by, IdentityTransport)
    }

    fn wrap(self, p: DVec2) -> DVec2 {
        self.space().wrap(p)
    }

    fn distance(self, from: DVec2, to: DVec2) -> f64 {
        self.space().shortest(to - from).length()
    }

    fn has_left(self, from: DVec2, to: DVec2, square: f64) -> bool {
        to.distance_squared(from) >= square
    }

    fn is_parted(self, p: DVec2, r: DVec2) -> bool {
        Domain::is_parted(self, p, p + r)
    }

    fn crosses_line(self, p: DVec2, r: DVec2) -> bool {
        Domain::crosses_line(self, p, p + r)
    }

    fn is_gap_between(self, p: DVec2, q: DVec2) -> bool {
        Domain::is_gap_between(self, p, q)
    }

    fn grid(self, step: f64) -> Grid {
        let (lo, hi) = self.bounds();
        Grid::new(lo, hi, step)
    }

    fn grid_around(self, mut places: impl Iterator<Item = DVec2>, step: f64) -> Grid {
        let first = places.next().unwrap_or_default();
        let (lo, hi) = places.fold((first, first), |(lo, hi), p| (lo.min(p), hi.max(p)));
        Grid::new(lo, hi, step)
    }

    fn any_near(
        self,
        grid: &Grid,
        p: DVec2,
        radius: f64,
        visit: impl FnMut(usize) -> bool,
    ) -> bool {
        grid.any_near(self.space(), p, radius, visit)
    }
}

impl Boundary for &Walls {
    type Place = DVec2;
    type ClosestPoint = Projection;

    fn is_near(self, p: DVec2) -> bool {
        Walls::is_near(self, p)
    }

    fn reach(self) -> f64 {
        Walls::reach(self)
    }

    fn closest_points(self, p: DVec2, reach: f64, feet: &mut Vec<Projection>) {
        self.project(p, reach, feet);
    }
}

impl<'a> PackingDomain for PlaneDomain<'a> {
    type Place = DVec2;
    type Fields = &'a Fields;
    type Metric = &'a Domain;
    type Walls = &'a Walls;

    fn fields(self) -> &'a Fields {
        self.fields
    }

    fn metric(self) -> &'a Domain {
        self.domain
    }

    fn walls(self) -> &'a Walls {
        self.walls
    }

    fn boundary(self) -> BoundaryCondition {
        self.boundary
    }

    fn moved(
        self,
        from: DVec2,
        by: DVec2,
        shape: CellShape,
        is_clear: bool,
    ) -> (DVec2, IdentityTransport) {
        let has_lines = !self.domain.lines().is_empty();
        let space = self.domain.space();
        let to = match self.boundary {
            BoundaryCondition::Open => space.wrap(keep_near(from + by, self.domain)),
            _ if is_clear && !has_lines => space.wrap(from + by),
            _ => keep_inside(from, from + by, shape, self),
        };
        (to, IdentityTransport)
    }

    fn has_room(self, p: DVec2) -> bool {
        has_room(p, self)
    }

    fn middle_of_narrow(self, p: DVec2) -> Option<DVec2> {
        middle_of_narrow(p, self)
    }

    fn empty_parts(self, cells: &[DVec2]) -> Vec<DVec2> {
        self.domain.empty_middles(cells)
    }

    fn has_parts(self) -> bool {
        self.domain.islands().len() > 1
    }

    fn seeds(self) -> Vec<DVec2> {
        let islands = self.domain.islands().iter();
        islands.filter_map(Domain::deepest).collect()
    }

    fn honeycombs(self) -> Vec<DVec2> {
        let islands = self.domain.islands().iter();
        islands.map(|i| along_most(i, self.fields)).collect()
    }

    fn honeycomb(self, p: DVec2) -> Option<usize> {
        Some(self.domain.island(p))
    }

    fn anywhere(self, random: &mut Random) -> DVec2 {
        let (lo, hi) = self.domain.bounds();
        lo + (hi - lo) * DVec2::new(random.unit(), random.unit())
    }
}

/// Cells that leave an open outline get no farther than this from its bounding box, in longer sides of the box.
const FARTHEST: f64 = 8.0;

/// The place, clamped to within [`FARTHEST`] of the outline's bounding box.
fn keep_near(p: DVec2, domain: &Domain) -> DVec2 {
    let (lo, hi) = domain.bounds();
    let around = DVec2::splat(FARTHEST * (hi - lo).max_element());
    p.clamp(lo - around, hi + around)
}

/// Moves a centre that has come too near to the boundary or a constraint line, or crossed it, back to its own
/// side; on a torus, back into the picture.
pub(super) fn keep_inside(from: DVec2, to: DVec2, shape: CellShape, around: PlaneDomain) -> DVec2 {
    let domain = around.domain;
    // After a move shorter than the reach of the walls, a cell that crossed them is still near them.
    let is_short = from.distance(to) < around.walls.reach();
    if is_short && domain.is_in_box(to) && !around.walls.is_near(to) {
        return to;
    }
    let near = domain.nearest(to);
    let mut centre = to;
    let least = CLOSEST * shape.extent(near.inward);
    if near.distance < least {
        // To the least distance; if the outline is narrower than that, to its centre line.
        let depth = domain.medial_depth(near.point, near.inward, least);
        centre = if depth > 0.0 {
            near.point + near.inward * depth
        } else {
            from
        };
    }
    if domain.is_parted(from, centre) {
        centre = from;
    }
    if let Some(line) = domain.nearest_line(centre) {
        let least = CLOSEST * shape.extent(line.inward);
        let away = line.point + line.inward * least;
        if line.distance < least
            && domain.nearest(away).distance > 0.0
            && !domain.is_parted(centre, away)
        {
            centre = away;
        }
    }
    domain.space().wrap(centre)
}

/// The direction along which most of the boundary lies, for a honeycomb's rows. It has six-fold symmetry, so segments
/// are averaged at six times their angles. Without a boundary it is the direction of the fields.
fn along_most(domain: &Domain, fields: &Fields) -> DVec2 {
    if domain.segments().is_empty() {
        return fields.direction(DVec2::ZERO);
    }
    let mut sum = DVec2::ZERO;
    for [a, b] in domain.segments() {
        let (length, angle) = (a.distance(*b), libm::atan2(b.y - a.y, b.x - a.x));
        sum += length * unit_vector(6.0 * angle);
    }
    let angle = libm::atan2(sum.y, sum.x) / 6.0;
    unit_vector(angle)
}
