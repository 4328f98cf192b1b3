//! Clips triangles and lines to the near plane and to a guard band around the frame.

use super::View;
use crate::planar::cut_polygon;
use glam::Vec3;

/// Guard band: the clipping planes lie outside of the frame by this many times its longer side, so hardly any triangle
/// is clipped.
const GUARD: f32 = 2.0;
/// Most corners of a clipped triangle: three, and one more for each of five planes.
const MOST: usize = 8;

/// A convex polygon of at most `N` corners; only the first `count` are valid.
#[derive(Clone, Copy)]
pub(super) struct ConvexPolygon<const N: usize> {
    pub corners: [Vec3; N],
    pub count: usize,
}

/// A corner with its distance from a plane, positive inside.
type CornerAt = (Vec3, f32);

impl<const N: usize> ConvexPolygon<N> {
    pub fn triangle([a, b, c]: [Vec3; 3]) -> Self {
        let mut corners = [Vec3::ZERO; N];
        corners[..3].copy_from_slice(&[a, b, c]);
        Self { corners, count: 3 }
    }

    /// The part of the polygon where the distance is not negative.
    #[inline(always)]
    pub fn cut(
        &self,
        distance: impl Fn(Vec3) -> f32,
        crossing: impl Fn(CornerAt, CornerAt) -> Vec3,
    ) -> Self {
        let mut cut = Self {
            corners: [Vec3::ZERO; N],
            count: 0,
        };
        let corners = &self.corners[..self.count];
        cut_polygon(corners, &distance, crossing, |p| {
            if cut.count < N {
                cut.corners[cut.count] = p;
                cut.count += 1;
            }
        });
        // The first corner stays first: a crossing on the last side is moved to the end.
        if let [first, .., last] = corners
            && (distance(*first) >= 0.0) != (distance(*last) >= 0.0)
        {
            cut.corners[..cut.count].rotate_left(1);
        }
        cut
    }
}

/// The place of distance zero between two corners. It is computed from the inner one, so that two triangles with a
/// common edge are cut at exactly the same place of it, bit for bit.
#[inline(always)]
pub(super) fn between((p, here): CornerAt, (q, there): CornerAt) -> Vec3 {
    match here >= 0.0 {
        true => p + (q - p) * (here / (here - there)),
        false => q + (p - q) * (there / (there - here)),
    }
}

/// The clipping planes: `distance` of a point in the view is not negative inside.
#[derive(Clone, Copy)]
pub(super) struct ClipPlanes {
    near: f32,
    /// Half the width of the clipped space at depth 1; `down` is half its height.
    across: f32,
    down: f32,
}

impl ClipPlanes {
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

    /// The part of a triangle inside the planes whose bits are set in `planes`.
    pub fn cut(&self, triangle: [Vec3; 3], planes: u32) -> ConvexPolygon<MOST> {
        let mut polygon = ConvexPolygon::triangle(triangle);
        for plane in (0..5).filter(|plane| planes >> plane & 1 == 1) {
            let crossing = |p, q| self.crossing(plane, p, q);
            polygon = polygon.cut(|p| self.distance(plane, p), crossing);
        }
        polygon
    }

    /// The part of a line between the planes, if any.
    pub fn part_of_line(&self, [mut a, mut b]: [Vec3; 2]) -> Option<[Vec3; 2]> {
        for plane in 0..5 {
            let (here, there) = (self.distance(plane, a), self.distance(plane, b));
            match (here >= 0.0, there >= 0.0) {
                (true, true) => {}
                (true, false) => b = self.crossing(plane, (a, here), (b, there)),
                (false, true) => a = self.crossing(plane, (a, here), (b, there)),
                (false, false) => return None,
            }
        }
        Some([a, b])
    }

    /// The crossing of a line with a plane between its ends.
    #[inline(always)]
    fn crossing(&self, plane: usize, p: CornerAt, q: CornerAt) -> Vec3 {
        let mut at = between(p, q);
        if plane == 0 {
            at.z = self.near;
        }
        at
    }
}
