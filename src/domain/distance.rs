//! Inside or outside, and the exact closest point on the boundary.

use super::Domain;
use glam::DVec2;

/// Distance to the boundary on a torus, which has none.
const NOWHERE: f64 = 1e30;

/// The closest point of the boundary, as seen from a query point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Distance to the boundary, positive inside, negative outside.
    pub distance: f64,
    /// The closest point.
    pub point: DVec2,
    /// Unit vector along which `distance` grows.
    pub inward: DVec2,
    /// Unit tangent of the nearest segment; the inside is on its right on screen.
    pub tangent: DVec2,
    /// Index of the nearest segment in [`Domain::segments`].
    pub segment: usize,
}

impl Domain {
    /// Whether the point is inside. A point on the boundary may count either way.
    pub fn contains(&self, p: DVec2) -> bool {
        self.nearest(p).distance > 0.0
    }

    /// The exact closest boundary point; on a torus the boundary is very far away.
    pub fn nearest(&self, p: DVec2) -> Nearest {
        let Some(grid) = &self.grid else {
            return Nearest {
                distance: NOWHERE,
                point: p - DVec2::X * NOWHERE,
                inward: DVec2::X,
                tangent: DVec2::NEG_Y,
                segment: 0,
            };
        };
        let (square, point, segment) = grid.nearest(&self.segments, p);
        let [a, b] = self.segments[segment];
        let tangent = (b - a).normalize();
        let inside = self.side(p, segment, point);
        let distance = square.sqrt();
        let away = if distance > 1e-9 {
            (p - point) / distance
        } else {
            tangent.perp()
        };
        let sign = if inside { 1.0 } else { -1.0 };
        Nearest {
            distance: sign * distance,
            point,
            inward: if distance > 1e-9 { sign * away } else { away },
            tangent,
            segment,
        }
    }

    /// Whether the point is inside, by its side of the nearest segment. If the closest point `foot` is a corner, both
    /// segments that meet there decide.
    fn side(&self, p: DVec2, segment: usize, foot: DVec2) -> bool {
        let [a, b] = self.segments[segment];
        let side = (b - a).perp_dot(p - a);
        let ends = foot == a || foot == b;
        if !ends {
            return side > 0.0;
        }
        let (before, after) = self.around(segment, foot == a);
        let ([a0, corner], [_, b1]) = (before, after);
        let (u, v) = (corner - a0, b1 - corner);
        let (su, sv) = (u.perp_dot(p - corner), v.perp_dot(p - corner));
        if u.perp_dot(v) >= 0.0 {
            su > 0.0 && sv > 0.0
        } else {
            su > 0.0 || sv > 0.0
        }
    }

    /// The two segments that meet at the start (or the end) of a segment, in ring order.
    fn around(&self, segment: usize, at_start: bool) -> ([DVec2; 2], [DVec2; 2]) {
        let mut first = 0;
        for ring in &self.rings {
            if segment < first + ring.len() {
                let (k, n) = (segment - first, ring.len());
                let other = if at_start {
                    (k + n - 1) % n
                } else {
                    (k + 1) % n
                };
                let (this, other) = (self.segments[segment], self.segments[first + other]);
                return if at_start {
                    (other, this)
                } else {
                    (this, other)
                };
            }
            first += ring.len();
        }
        unreachable!("a segment belongs to a ring")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Outline;

    fn square_with_hole() -> Domain {
        let p = |x: f64, y: f64| DVec2::new(x, y);
        Domain::from_checked(&Outline {
            rings: vec![
                vec![p(0., 0.), p(100., 0.), p(100., 100.), p(0., 100.)],
                vec![p(40., 40.), p(40., 60.), p(60., 60.), p(60., 40.)],
            ],
            ..Outline::default()
        })
    }

    #[test]
    fn distance_is_signed_and_exact() {
        let domain = square_with_hole();
        assert_eq!(domain.area(), 9600.0);
        let near = domain.nearest(DVec2::new(10.0, 50.0));
        assert_eq!(near.distance, 10.0);
        assert_eq!(near.inward, DVec2::X);
        assert_eq!(domain.nearest(DVec2::new(50.0, 45.0)).distance, -5.0);
        assert_eq!(domain.nearest(DVec2::new(-3.0, -4.0)).distance, -5.0);
        assert_eq!(domain.nearest(DVec2::new(37.0, 36.0)).distance, 5.0);
        assert_eq!(domain.nearest(DVec2::new(-300.0, 50.0)).distance, -300.0);
    }

    #[test]
    fn inward_points_to_growing_distance() {
        let domain = square_with_hole();
        for k in 0..400 {
            let p = DVec2::new((k * 37 % 113) as f64 - 6.3, (k * 53 % 109) as f64 - 4.1);
            let near = domain.nearest(p);
            let further = domain.nearest(p + 1e-4 * near.inward);
            assert!(further.distance > near.distance, "{p}");
        }
    }
}
