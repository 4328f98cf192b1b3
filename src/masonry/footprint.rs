//! Convex polygons in a face's (s, t), whose sides carry the widths of joints.

use crate::order;
use crate::planar::{cut_polygon, orientation};
use glam::DVec2;
use smallvec::SmallVec;

/// Corners nearer to each other than this are one (metres).
const WELD: f64 = 1e-9;
/// Polygons below this area are nothing (square metres).
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

    /// The half-plane in which a place lies, with the border through two others, which differ.
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

    /// The same, with its border moved inwards by `by` (metres).
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
#[derive(Clone, Debug, PartialEq)]
pub struct Footprint {
    corners: FootprintCorners,
}

/// Most polygons have four corners, and a list of up to six needs no allocation.
type FootprintCorners = SmallVec<[FootprintCorner; 6]>;

impl Footprint {
    /// The polygon with these corners, counter-clockwise, and no insets. Repeated corners are joined.
    ///
    /// # Errors
    /// If the corners make no convex polygon.
    pub fn new(corners: &[DVec2]) -> Result<Self, FootprintFault> {
        if corners.iter().any(|p| !p.is_finite()) {
            return Err(FootprintFault::NotFinite);
        }
        let corners = corners.iter().map(|&at| FootprintCorner { at, inset: 0.0 });
        let polygon = Self::welded(corners.collect()).ok_or(FootprintFault::Flat)?;
        let count = polygon.corners.len();
        let turns = (0..count).map(|k| {
            let [a, b, c] = [k, k + 1, k + 2].map(|k| polygon.corners[k % count].at);
            (b - a).normalize().perp_dot(c - b)
        });
        let is_convex = turns.fold(f64::MAX, f64::min) >= -WELD;
        is_convex
            .then_some(polygon)
            .ok_or(FootprintFault::NotConvex)
    }

    /// The rectangle between two corners; none if it has no area.
    pub fn rectangle(low: DVec2, high: DVec2) -> Option<Self> {
        let (s, t) = (DVec2::new(high.x, low.y), DVec2::new(low.x, high.y));
        let is_right = low.cmplt(high).all() && low.is_finite() && high.is_finite();
        let corners = [low, s, high, t].map(|at| FootprintCorner { at, inset: 0.0 });
        Self::welded(corners.into_iter().collect()).filter(|_| is_right)
    }

    /// Whether it is a rectangle along s and t that begins at its least corner, as [`Self::rectangle`] makes it.
    pub fn is_rectangle(&self) -> bool {
        match self.corners[..] {
            [a, b, c, d] => [a.at.x, b.at.x, a.at.y, c.at.y] == [d.at.x, c.at.x, b.at.y, d.at.y],
            _ => false,
        }
    }

    /// The convex hull of points, with no insets (Andrew 1979, Another efficient algorithm for convex hulls in two
    /// dimensions); none without area.
    pub fn hull(points: &[DVec2]) -> Option<Self> {
        let mut sorted = points.to_vec();
        order::sort(&mut sorted, |p| (order::rank(p.x), order::rank(p.y)));
        let lower = chain(sorted.iter().copied());
        let upper = chain(sorted.iter().rev().copied());
        let corners = [
            &lower[..lower.len().saturating_sub(1)],
            &upper[..upper.len().saturating_sub(1)],
        ]
        .concat();
        Self::new(&corners).ok()
    }

    /// Joins repeated corners; none without area.
    fn welded(mut corners: FootprintCorners) -> Option<Self> {
        // The later corner of two carries the side that is left.
        let is_short =
            |a: &FootprintCorner, b: &FootprintCorner| a.at.distance_squared(b.at) < WELD * WELD;
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
        let polygon = Self { corners };
        (polygon.corners.len() > 2 && polygon.area() > LEAST_AREA).then_some(polygon)
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

    /// The same with the inset of each side given by its ends (metres, at least 0).
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

    /// Its centre of gravity.
    pub fn centre(&self) -> DVec2 {
        let origin = self.corners[0].at;
        let parts = self.corners.windows(2).map(|w| {
            let [a, b] = [w[0].at - origin, w[1].at - origin];
            (a + b) * a.perp_dot(b)
        });
        origin + parts.sum::<DVec2>() / (6.0 * self.area())
    }

    /// The corner with the smallest s and t, and that with the largest, of its bounding box.
    pub fn bounds(&self) -> [DVec2; 2] {
        let first = [self.corners[0].at; 2];
        let grow = |[low, high]: [DVec2; 2], p: DVec2| [low.min(p), high.max(p)];
        self.places().fold(first, grow)
    }

    /// Whether a point lies inside or on the border.
    pub fn contains(&self, p: DVec2) -> bool {
        self.half_planes().all(|half| half.distance(p) >= 0.0)
    }

    /// The polygon at another place.
    pub fn moved(mut self, by: DVec2) -> Self {
        self.corners.iter_mut().for_each(|corner| corner.at += by);
        self
    }

    /// The part in a half-plane; the new side gets this inset (metres). None if no area is left.
    pub fn clip(&self, half: HalfPlane, inset: f64) -> Option<Self> {
        let mut corners = FootprintCorners::new();
        let crossing =
            |(a, da): (FootprintCorner, f64), (b, db): (FootprintCorner, f64)| FootprintCorner {
                at: a.at + (b.at - a.at) * (da / (da - db)),
                // A side that leaves the half-plane ends here, where the cut begins.
                inset: if da >= 0.0 { inset } else { a.inset },
            };
        cut_polygon(
            &self.corners,
            |corner| half.distance(corner.at),
            crossing,
            |c| corners.push(c),
        );
        Self::welded(corners)
    }

    /// The part that two polygons share, with the insets of the first; the sides of the second get none.
    pub fn intersection(&self, other: &Self) -> Option<Self> {
        let mut part = self.clone();
        for half in other.half_planes() {
            part = part.clip(half, 0.0)?;
        }
        Some(part)
    }

    /// The area that two polygons share, in square metres.
    pub fn shared_area(&self, other: &Self) -> f64 {
        let ([low, high], [from, to]) = (self.bounds(), other.bounds());
        let both = high.min(to) - low.max(from);
        // No polygon is as narrow as this.
        if both.min_element() < WELD {
            return 0.0;
        }
        if self.is_rectangle() && other.is_rectangle() {
            return both.x * both.y;
        }
        self.intersection(other).map_or(0.0, |part| part.area())
    }

    /// The polygon with each side moved in by its inset, as the paper's cells are shrunk for mortar; none if nothing
    /// is left.
    pub fn shrunk(&self) -> Option<Self> {
        let mut part = self.clone();
        for (half, corner) in self.half_planes().zip(&self.corners) {
            part = part.clip(half.inset(corner.inset), 0.0)?;
        }
        Some(part)
    }
}

/// The points of a sorted list at which its hull turns left, its ends included.
fn chain(points: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut chain: Vec<DVec2> = Vec::new();
    for p in points {
        while let [.., a, b] = chain[..]
            && orientation(a, b, p) <= 0.0
        {
            chain.pop();
        }
        chain.push(p);
    }
    chain
}
