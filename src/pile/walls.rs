//! Walls and the ground, which bodies do not pass.

use glam::DVec3;

/// A wall of a container, or the ground. The space that it leaves free is convex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wall {
    /// Free are the points p with `normal` · p ≤ `offset`; the unit normal points into the wall.
    Plane {
        /// The unit normal, which points into the wall.
        normal: DVec3,
        /// The distance of the plane from the origin, along the normal.
        offset: f64,
    },
    /// The inside of a bowl, a paraboloid about a vertical axis. Free are the points at a height of at least
    /// `curve` r² above `lowest`, at the distance r from the axis.
    Bowl {
        /// The lowest point.
        lowest: DVec3,
        /// The height at the distance 1 from the axis; above 0.
        curve: f64,
    },
}

impl Wall {
    /// Whether a ball is free all along a part of the line p + t n. Its free places form a convex set, so it is enough
    /// to test both ends.
    pub fn is_free(&self, (p, radius): (DVec3, f64), n: DVec3, range: (f64, f64)) -> bool {
        [range.0, range.1].iter().all(|&t| {
            let centre = p + t * n;
            match *self {
                Self::Plane { normal, offset } => normal.dot(centre) + radius <= offset,
                Self::Bowl { lowest, curve } => {
                    let d = centre - lowest;
                    let across = (d.x * d.x + d.z * d.z).sqrt() + radius;
                    curve * across * across + radius <= d.y
                }
            }
        })
    }

    /// The part of a range in which p + t n passes the wall by at most `slack`, which is above 0.
    pub fn narrowed(&self, (p, n): (DVec3, DVec3), slack: f64, (lo, hi): (f64, f64)) -> (f64, f64) {
        let (a, b, c) = self.room(p, n);
        let is_free = |t: f64| a + (b - c * t) * t >= 0.0;
        // With the slack, the ends of the free part are clearly beyond those of the range.
        if is_free(lo) && is_free(hi) {
            return (lo, hi);
        }
        let free = roots(a + slack, b, c);
        (lo.max(free.0), hi.min(free.1))
    }

    /// The numbers a, b and c ≥ 0 of the room before the wall at p + t n, which is a + b t - c t².
    fn room(&self, p: DVec3, n: DVec3) -> (f64, f64, f64) {
        match *self {
            Self::Plane { normal, offset } => (offset - normal.dot(p), -normal.dot(n), 0.0),
            Self::Bowl { lowest, curve } => {
                let d = p - lowest;
                let flat = |a: DVec3, b: DVec3| curve * (a.x * b.x + a.z * b.z);
                (d.y - flat(d, d), n.y - 2.0 * flat(d, n), flat(n, n))
            }
        }
    }
}

/// The least and greatest t with a + b t - c t² ≥ 0, for c ≥ 0; empty if the end is less than the start.
fn roots(a: f64, b: f64, c: f64) -> (f64, f64) {
    const EMPTY: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);
    if c <= 1e-12 * b.abs() || c == 0.0 {
        return match b {
            _ if b > 0.0 => (-a / b, f64::INFINITY),
            _ if b < 0.0 => (f64::NEG_INFINITY, -a / b),
            _ if a >= 0.0 => (f64::NEG_INFINITY, f64::INFINITY),
            _ => EMPTY,
        };
    }
    let square = b * b + 4.0 * a * c;
    if square < 0.0 {
        return EMPTY;
    }
    let root = square.sqrt();
    ((b - root) / (2.0 * c), (b + root) / (2.0 * c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    impl Wall {
        /// The least and greatest t at which p + t n passes the wall by at most `slack` (measured upright in a bowl).
        /// The range is empty if its end is less than its start.
        pub(crate) fn free_range(&self, p: DVec3, n: DVec3, slack: f64) -> (f64, f64) {
            let (a, b, c) = self.room(p, n);
            roots(a + slack, b, c)
        }
    }

    #[test]
    fn a_plane_stops_a_point_at_its_distance() {
        let ground = Wall::Plane {
            normal: -DVec3::Y,
            offset: -1.0,
        };
        let down = ground.free_range(DVec3::new(0.0, 3.0, 0.0), -DVec3::Y, 0.5);
        assert_eq!(down, (f64::NEG_INFINITY, 2.5));
        let level = ground.free_range(DVec3::new(0.0, 3.0, 0.0), DVec3::X, 0.0);
        assert_eq!(level, (f64::NEG_INFINITY, f64::INFINITY));
        let below = ground.free_range(DVec3::ZERO, DVec3::X, 0.0);
        assert!(below.0 > below.1);
    }

    #[test]
    fn a_range_is_narrowed_to_its_free_part() {
        let walls = [
            Wall::Plane {
                normal: DVec3::new(0.6, -0.8, 0.0),
                offset: 0.5,
            },
            Wall::Bowl {
                lowest: DVec3::new(0.2, -1.5, 0.1),
                curve: 0.7,
            },
        ];
        let mut all_free = 0;
        for k in 0..2000 {
            let mut random = Random::new(7, Purpose::Dart, k);
            let mut draw = || DVec3::new(random.signed(), random.signed(), random.signed());
            let (centre, n, beside) = (2.0 * draw(), draw().normalize(), draw());
            let (p, range) = (centre + 0.3 * beside, (-0.4_f64, 0.5_f64));
            for wall in &walls {
                let free = wall.free_range(p, n, 0.05);
                let wanted = (range.0.max(free.0), range.1.min(free.1));
                assert_eq!(wall.narrowed((p, n), 0.05, range), wanted);
                if wall.is_free((centre, 0.3 * beside.length()), n, range) {
                    assert_eq!(wanted, range, "{centre} {n} {beside}");
                    all_free += 1;
                }
            }
        }
        assert!(all_free > 200, "{all_free}");
    }

    #[test]
    fn a_bowl_is_free_between_its_sides() {
        let bowl = Wall::Bowl {
            lowest: DVec3::new(1.0, -2.0, 0.0),
            curve: 0.5,
        };
        let room = |p: DVec3| p.y + 2.0 - 0.5 * ((p.x - 1.0) * (p.x - 1.0) + p.z * p.z);
        for k in 0..400 {
            let mut random = Random::new(5, Purpose::Dart, k);
            let mut draw = || DVec3::new(random.signed(), random.signed(), random.signed());
            let (p, n) = (3.0 * draw(), draw().normalize());
            let (from, to) = bowl.free_range(p, n, 0.0);
            for t in [-3.0, -1.0, 0.0, 0.5, 2.0] {
                let is_free = room(p + t * n) >= 0.0;
                assert_eq!(is_free, from <= t && t <= to, "{p} {n} {t}");
            }
        }
    }
}
