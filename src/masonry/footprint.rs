//! Convex polygons in a face's (s, t), whose sides carry the widths of joints.

use super::hull::hull;
use crate::planar::cut_polygon;
use glam::DVec2;
use smallvec::SmallVec;

/// Corners nearer to each other than this are joined (metres).
const WELD: f64 = 1e-9;
/// Polygons below this area count as empty (square metres).
const LEAST_AREA: f64 = 1e-12;

/// Why corners are no convex polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FootprintFault {
    /// A coordinate is not finite.
    NotFinite,
    /// Fewer than three different corners, or no area.
    Flat,
    /// The corners turn clockwise somewhere.
    NotConvex,
}

/// The points `p` with `normal.dot(p) >= offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane {
    /// Unit vector into the half-plane.
    pub normal: DVec2,
    /// Signed distance of its border from the origin, along the normal (metres).
    pub offset: f64,
}

impl HalfPlane {
    /// The half-plane to the left of the way from `a` to `b`, which differ.
    pub fn left_of(a: DVec2, b: DVec2) -> Self {
        let normal = (b - a).perp().normalize();
        Self {
            normal,
            offset: normal.dot(a),
        }
    }

    /// The half-plane that holds the point `inside`, with its border through `a` and `b`, which differ.
    pub fn with(inside: DVec2, [a, b]: [DVec2; 2]) -> Self {
        let half = Self::left_of(a, b);
        if half.distance(inside) > 0.0 {
            half
        } else {
            half.opposite()
        }
    }

    /// The other half of the plane.
    pub fn opposite(self) -> Self {
        Self {
            normal: -self.normal,
            offset: -self.offset,
        }
    }

    /// The half-plane with its border moved inwards by `by` (metres).
    pub fn inset(self, by: f64) -> Self {
        Self {
            offset: self.offset + by,
            ..self
        }
    }

    /// Signed distance of a point from the border, positive inside (metres).
    pub fn distance(self, p: DVec2) -> f64 {
        self.normal.dot(p) - self.offset
    }
}

/// A corner, and the side from it to the next corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FootprintCorner {
    /// Its place in (s, t), metres.
    pub at: DVec2,
    /// How far the geometry stays inside of this side: half a joint, or 0 where the side is exposed (metres, at least
    /// 0).
    pub inset: f64,
}

/// A convex polygon with area, counter-clockwise in (s, t).
///
/// It is the space that a cell claims. The geometry of the cell is smaller, by the inset of each side (Legakis,
/// Dorsey, Gortler 2001, Feature-based cellular texturing for architectural models, section 3.3).
#[derive(Debug, PartialEq)]
pub struct Footprint {
    corners: FootprintCorners,
}

impl Clone for Footprint {
    fn clone(&self) -> Self {
        // Copies all corners at once; `SmallVec::clone` would copy one by one.
        Self {
            corners: SmallVec::from_slice(&self.corners),
        }
    }
}

/// Most polygons have four corners, and a list of up to six needs no allocation.
type FootprintCorners = SmallVec<[FootprintCorner; 6]>;

impl Footprint {
    /// The polygon with these corners, counter-clockwise, and no insets. Repeated corners are joined.
    ///
    /// # Errors
    /// If the corners make no convex polygon.
    pub fn new(corners: &[DVec2]) -> Result<Self, FootprintFault> {
        let polygon = Self::joined(corners)?;
        let is_convex = polygon.is_convex();
        is_convex
            .then_some(polygon)
            .ok_or(FootprintFault::NotConvex)
    }

    /// The polygon with these corners, convex or not.
    fn joined(corners: &[DVec2]) -> Result<Self, FootprintFault> {
        if corners.iter().any(|p| !p.is_finite()) {
            return Err(FootprintFault::NotFinite);
        }
        let corners = corners.iter().map(|&at| FootprintCorner { at, inset: 0.0 });
        Self::welded(corners.collect()).ok_or(FootprintFault::Flat)
    }

    fn is_convex(&self) -> bool {
        let count = self.corners.len();
        let turns = (0..count).map(|k| {
            let [a, b, c] = [k, k + 1, k + 2].map(|k| self.corners[k % count].at);
            (b - a).normalize().perp_dot(c - b)
        });
        turns.fold(f64::MAX, f64::min) >= -WELD
    }

    /// The rectangle between two corners; none if it has no area.
    pub fn rectangle(low: DVec2, high: DVec2) -> Option<Self> {
        let is_right = low.cmplt(high).all() && low.is_finite() && high.is_finite();
        Self::welded(Self::between(low, high).corners).filter(|_| is_right)
    }

    /// The rectangle between two corners that are known to have an area between them.
    pub(super) fn between(low: DVec2, high: DVec2) -> Self {
        let (s, t) = (DVec2::new(high.x, low.y), DVec2::new(low.x, high.y));
        let corners = [low, s, high, t].map(|at| FootprintCorner { at, inset: 0.0 });
        Self {
            corners: SmallVec::from_slice(&corners),
        }
    }

    /// Whether the polygon is a rectangle along s and t whose first side runs along s, as [`Self::rectangle`] makes it.
    pub fn is_rectangle(&self) -> bool {
        match self.corners[..] {
            [a, b, c, d] => [a.at.x, b.at.x, a.at.y, c.at.y] == [d.at.x, c.at.x, b.at.y, d.at.y],
            _ => false,
        }
    }

    /// The convex hull of points, with no insets; none without area.
    pub fn hull(points: &[DVec2]) -> Option<Self> {
        let corners = hull(points);
        let hull = Self::joined(&corners).ok()?;
        // The hull turns left at each corner, and exactly so. Only corners that were joined can spoil this.
        let is_convex = hull.corners.len() == corners.len() || hull.is_convex();
        is_convex.then_some(hull)
    }

    /// Joins repeated corners; none without area.
    fn welded(corners: FootprintCorners) -> Option<Self> {
        let mut polygon = Self { corners };
        polygon.weld().map(|_| polygon)
    }

    /// Joins repeated corners and returns the area (square metres); none if there is none.
    fn weld(&mut self) -> Option<f64> {
        let corners = &mut self.corners;
        let is_short =
            |a: &FootprintCorner, b: &FootprintCorner| are_one(a.at.distance_squared(b.at));
        // Most polygons have nothing to join.
        let mut last = corners.last();
        if !corners
            .iter()
            .any(|corner| last.replace(corner).is_some_and(|a| is_short(a, corner)))
        {
            return self.sound_area();
        }
        // The side that is left belongs to the later corner of the two, and so does its inset.
        corners.dedup_by(|next, kept| {
            let same = is_short(next, kept);
            if same {
                kept.inset = next.inset;
            }
            same
        });
        if corners.len() > 1 && is_short(&corners[0], &corners[corners.len() - 1]) {
            corners.pop();
        }
        self.sound_area()
    }

    /// The area (square metres); none if it counts as empty.
    fn sound_area(&self) -> Option<f64> {
        let area = (self.corners.len() > 2).then(|| self.area());
        area.filter(|&area| Self::has_area(area))
    }

    /// Whether a polygon of this area is not empty (square metres).
    pub(super) fn has_area(area: f64) -> bool {
        area > LEAST_AREA
    }

    /// The corners, counter-clockwise.
    pub fn corners(&self) -> &[FootprintCorner] {
        &self.corners
    }

    /// The places of the corners, counter-clockwise.
    pub fn places(&self) -> impl ExactSizeIterator<Item = DVec2> + Clone + '_ {
        self.corners.iter().map(|corner| corner.at)
    }

    /// The ends of side `k`, from corner `k` to the next.
    pub fn side(&self, k: usize) -> [DVec2; 2] {
        let next = (k + 1) % self.corners.len();
        [self.corners[k].at, self.corners[next].at]
    }

    /// The half-planes of all sides, whose intersection is the polygon.
    pub fn half_planes(&self) -> impl Iterator<Item = HalfPlane> + '_ {
        (0..self.corners.len()).map(|k| {
            let [a, b] = self.side(k);
            HalfPlane::left_of(a, b)
        })
    }

    /// The polygon with new insets: `inset` gets the two ends of each side (metres, at least 0).
    pub fn with_insets(mut self, inset: impl Fn([DVec2; 2]) -> f64) -> Self {
        let insets: Vec<f64> = (0..self.corners.len())
            .map(|k| inset(self.side(k)))
            .collect();
        for (corner, inset) in self.corners.iter_mut().zip(insets) {
            corner.inset = inset;
        }
        self
    }

    /// Its area, in square metres.
    pub fn area(&self) -> f64 {
        let origin = self.corners[0].at;
        let twice = self.corners.windows(2).map(|w| {
            let [a, b] = [w[0].at - origin, w[1].at - origin];
            a.perp_dot(b)
        });
        0.5 * twice.sum::<f64>()
    }

    /// The distance between the two nearest parallel lines that hold it between them (metres).
    pub fn least_width(&self) -> f64 {
        let widths = self.half_planes().map(|half| {
            let distances = self.places().map(|p| half.distance(p));
            distances.fold(0.0, f64::max)
        });
        widths.fold(f64::MAX, f64::min)
    }

    /// Its centre of gravity.
    pub fn centre(&self) -> DVec2 {
        let origin = self.corners[0].at;
        let parts = self.corners.windows(2).map(|w| {
            let [a, b] = [w[0].at - origin, w[1].at - origin];
            (a + b) * a.perp_dot(b)
        });
        origin + parts.sum::<DVec2>() / (6.0 * self.area())
    }

    /// The corners of the bounding box with the smallest and with the largest s and t.
    pub fn bounds(&self) -> [DVec2; 2] {
        let first = [self.corners[0].at; 2];
        let grow = |[low, high]: [DVec2; 2], p: DVec2| [low.min(p), high.max(p)];
        self.places().fold(first, grow)
    }

    /// Whether a point lies inside or on the border.
    pub fn contains(&self, p: DVec2) -> bool {
        self.half_planes().all(|half| half.distance(p) >= 0.0)
    }

    /// The polygon moved by `by` (metres).
    pub fn moved(mut self, by: DVec2) -> Self {
        self.corners.iter_mut().for_each(|corner| corner.at += by);
        self
    }

    /// The part in a half-plane; the new side gets this inset (metres). None if no area is left.
    pub fn clip(&self, half: HalfPlane, inset: f64) -> Option<Self> {
        let mut part = self.clone();
        part.cut(half, inset).map(|_| part)
    }

    /// The area of the part in a half-plane, in square metres.
    pub fn area_in(&self, half: HalfPlane) -> f64 {
        self.clone().cut(half, 0.0).unwrap_or(0.0)
    }

    /// Cuts off all that lies beyond a half-plane, as [`Self::clip`], and returns the area that is left (square
    /// metres); none if there is none.
    fn cut(&mut self, half: HalfPlane, inset: f64) -> Option<f64> {
        let distance = |corner: FootprintCorner| half.distance(corner.at);
        if self.corners.iter().all(|&corner| distance(corner) >= 0.0) {
            return self.weld();
        }
        let mut corners = FootprintCorners::new();
        let crossing =
            |(a, da): (FootprintCorner, f64), (b, db): (FootprintCorner, f64)| FootprintCorner {
                at: a.at + (b.at - a.at) * (da / (da - db)),
                // The new side begins where the border leaves the half-plane. Where it comes back, the side of `a` goes
                // on.
                inset: if da >= 0.0 { inset } else { a.inset },
            };
        cut_polygon(&self.corners, distance, crossing, |c| corners.push(c));
        self.corners = corners;
        self.weld()
    }

    /// The part that two polygons share, with the insets of the first; the sides of the second get none.
    pub fn intersection(&self, other: &Self) -> Option<Self> {
        let mut part = self.clone();
        part.cut_to(other).map(|_| part)
    }

    /// Cuts off all that lies beyond the sides of another polygon, and returns the area that is left (square metres);
    /// none if there is none.
    fn cut_to(&mut self, other: &Self) -> Option<f64> {
        let mut halves = other.half_planes();
        halves.try_fold(0.0, |_, half| self.cut(half, 0.0))
    }

    /// The area that two polygons share, in square metres.
    pub fn shared_area(&self, other: &Self) -> f64 {
        match shared_box(self.bounds(), other.bounds()) {
            None => 0.0,
            Some(both) if self.is_rectangle() && other.is_rectangle() => both.x * both.y,
            Some(_) if self.has_side_before(other) => 0.0,
            Some(_) => self.clone().cut_to(other).unwrap_or(0.0),
        }
    }

    /// Whether two polygons share no area: their bounding boxes do not overlap, or a side of one lies between them.
    pub(super) fn is_apart(&self, other: &Self) -> bool {
        shared_box(self.bounds(), other.bounds()).is_none() || self.has_side_before(other)
    }

    /// Whether a side of one of the two polygons separates them.
    fn has_side_before(&self, other: &Self) -> bool {
        self.lies_beside(other) || other.lies_beside(self)
    }

    /// Whether a side of `other` has all of this polygon on its outer side. Rounding decides only where the shared part
    /// is too narrow to count.
    fn lies_beside(&self, other: &Self) -> bool {
        let mut sides = (0..other.corners.len()).map(|k| other.side(k));
        sides.any(|[a, b]| self.places().all(|p| (b - a).perp_dot(p - a) <= 0.0))
    }

    /// The polygon with each side moved in by its inset, as the paper's cells are shrunk for mortar; none if nothing
    /// is left.
    pub fn shrunk(&self) -> Option<Self> {
        let mut part = self.clone();
        let mut sides = self.half_planes().zip(&self.corners);
        let mut cut = |half: HalfPlane, inset: f64| part.cut(half.inset(inset), 0.0).is_some();
        let is_left = sides.all(|(half, corner)| cut(half, corner.inset));
        is_left.then_some(part)
    }
}

/// Whether two corners count as one: `square` is the square of their distance.
pub(super) fn are_one(square: f64) -> bool {
    square < WELD * WELD
}

/// The size of the box that two boxes share; none if it is too narrow for any polygon.
pub(super) fn shared_box([low, high]: [DVec2; 2], [from, to]: [DVec2; 2]) -> Option<DVec2> {
    let both = high.min(to) - low.max(from);
    (both.min_element() >= WELD).then_some(both)
}
