//! Clips triangles and lines to the drawable part.

use super::View;
use glam::Vec3;

/// Guard band: the frame is extended on each side by at least this many times its longer side before a
/// triangle is clipped, so hardly any is.
const GUARD: f32 = 2.0;
/// Most corners of a clipped triangle: three, and one more for each of five planes.
pub(super) const MOST: usize = 8;

/// A convex polygon; only the first `count` corners are valid.
#[derive(Clone, Copy)]
pub(super) struct Polygon {
    pub corners: [Vec3; MOST],
    pub count: usize,
}

/// The clipping planes: `distance` of a point in the view is not negative inside.
#[derive(Clone, Copy)]
pub(super) struct Planes {
    near: f32,
    /// Lateral extent for a unit of depth.
    across: f32,
    down: f32,
}

impl Planes {
    pub fn new(view: &View) -> Self {
        let [width, height] = view.size.map(|n| n as f32);
        let larger = if width > height { width } else { height };
        let slope = |half: f32| (half + GUARD * larger) / view.focal;
        Self {
            near: view.near,
            across: slope(0.5 * width),
            down: slope(0.5 * height),
        }
    }

    #[inline(always)]
    fn distance(&self, plane: usize, p: Vec3) -> f32 {
        match plane {
            0 => p.z - self.near,
            1 => self.across * p.z - p.x,
            2 => self.across * p.z + p.x,
            3 => self.down * p.z - p.y,
            _ => self.down * p.z + p.y,
        }
    }

    /// A bit for each plane that a point is outside of.
    #[inline(always)]
    pub fn beyond(&self, p: Vec3) -> u32 {
        let mut bits = 0;
        for plane in 0..5 {
            bits |= u32::from(self.distance(plane, p) < 0.0) << plane;
        }
        bits
    }

    /// The part of a triangle inside these planes. Two triangles with a common edge are cut at the same point
    /// of it, bit for bit, because cuts are computed from the inner end.
    pub fn cut(&self, triangle: [Vec3; 3], planes: u32) -> Polygon {
        let [a, b, c] = triangle;
        let mut corners = [Vec3::ZERO; MOST];
        corners[..3].copy_from_slice(&[a, b, c]);
        let mut polygon = Polygon { corners, count: 3 };
        for plane in (0..5).filter(|plane| planes >> plane & 1 == 1) {
            polygon = self.cut_by(plane, &polygon);
        }
        polygon
    }

    /// The part of a line between the planes, if any.
    pub fn part_of_line(&self, [mut a, mut b]: [Vec3; 2]) -> Option<[Vec3; 2]> {
        for plane in 0..5 {
            let (here, there) = (self.distance(plane, a), self.distance(plane, b));
            match (here >= 0.0, there >= 0.0) {
                (true, true) => {}
                (true, false) => b = self.crossing(plane, a, b),
                (false, true) => a = self.crossing(plane, b, a),
                (false, false) => return None,
            }
        }
        Some([a, b])
    }

    /// The crossing of a line with a plane between its ends.
    #[inline(always)]
    fn crossing(&self, plane: usize, inner: Vec3, outer: Vec3) -> Vec3 {
        let (from, to) = (self.distance(plane, inner), self.distance(plane, outer));
        let mut at = inner + (outer - inner) * (from / (from - to));
        if plane == 0 {
            at.z = self.near;
        }
        at
    }

    fn cut_by(&self, plane: usize, polygon: &Polygon) -> Polygon {
        let mut cut = Polygon {
            corners: [Vec3::ZERO; MOST],
            count: 0,
        };
        let mut add = |p: Vec3| {
            if cut.count < MOST {
                cut.corners[cut.count] = p;
                cut.count += 1;
            }
        };
        for k in 0..polygon.count {
            let (p, q) = (polygon.corners[k], polygon.corners[(k + 1) % polygon.count]);
            let (here, there) = (self.distance(plane, p), self.distance(plane, q));
            if here >= 0.0 {
                add(p);
            }
            if (here >= 0.0) != (there >= 0.0) {
                add(match here >= 0.0 {
                    true => self.crossing(plane, p, q),
                    false => self.crossing(plane, q, p),
                });
            }
        }
        cut
    }
}
