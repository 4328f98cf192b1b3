//! Tangent frames, and the logarithmic map between two points of a surface.

use super::SurfacePoint;
use crate::packing::transport::ParallelTransport;
use glam::{DVec2, DVec3};

/// A right-handed orthonormal frame: two axes in the tangent plane, and its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentFrame {
    /// The x axis, in the tangent plane.
    pub x: DVec3,
    /// The y axis, in the tangent plane.
    pub y: DVec3,
    /// The unit normal: x cross y.
    pub normal: DVec3,
}

impl TangentFrame {
    /// The frame of a unit normal; equal normals get equal frames (Duff et al. 2017, Building an Orthonormal Basis,
    /// Revisited).
    pub fn of(normal: DVec3) -> Self {
        let n = normal;
        let sign = if n.z < 0.0 { -1.0 } else { 1.0 };
        let a = -1.0 / (sign + n.z);
        let b = n.x * n.y * a;
        Self {
            x: DVec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x),
            y: DVec3::new(b, sign + n.y * n.y * a, -n.y),
            normal: n,
        }
    }

    /// The tangential part of a vector in space, in coordinates of the frame.
    pub fn within(&self, v: DVec3) -> DVec2 {
        DVec2::new(self.x.dot(v), self.y.dot(v))
    }

    /// The vector in space with these coordinates of the frame.
    pub fn out(&self, v: DVec2) -> DVec3 {
        self.x * v.x + self.y * v.y
    }

    /// The turn that carries vectors of another frame into this one, by the smallest rotation between the two
    /// normals. If the normals are opposite, the turn is arbitrary.
    pub fn turn_from(&self, other: &TangentFrame) -> Transport {
        Transport(self.within(rotated(other.x, other.normal, self.normal)))
    }
}

/// Turns a vector by the smallest rotation that takes one unit normal to the other.
#[inline(always)]
pub(crate) fn rotated(v: DVec3, from: DVec3, to: DVec3) -> DVec3 {
    let cos = from.dot(to);
    v - (from + to) * (v.dot(to) / (1.0 + cos).max(1e-12))
}

/// A rotation of the plane that takes coordinates of one frame to those of another, stored as the image of the x axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transport(pub DVec2);

impl Transport {
    /// The identity.
    pub const NONE: Self = Self(DVec2::X);

    /// This turn followed by another one.
    pub fn then(self, other: Self) -> Self {
        Self(self.0.rotate(other.0))
    }

    /// Takes a vector of the first frame to the second one.
    #[inline(always)]
    pub fn apply(self, v: DVec2) -> DVec2 {
        self.0.rotate(v)
    }

    /// Takes a vector of the second frame to the first one.
    #[inline(always)]
    pub fn undo(self, v: DVec2) -> DVec2 {
        DVec2::new(self.0.x, -self.0.y).rotate(v)
    }
}

impl ParallelTransport for Transport {
    #[inline(always)]
    fn apply(self, v: DVec2) -> DVec2 {
        Transport::apply(self, v)
    }

    #[inline(always)]
    fn undo(self, v: DVec2) -> DVec2 {
        Transport::undo(self, v)
    }
}

/// The logarithmic map of one point at another, with the turn between their frames.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogMap {
    /// Direction and distance to the other point, in the frame of the first one.
    pub to: DVec2,
    /// Carries vectors of the other point's frame into that of the first one.
    pub turn: Transport,
}

impl SurfacePoint {
    /// The frame of the normal at this point.
    pub fn frame(&self) -> TangentFrame {
        TangentFrame::of(self.normal)
    }
}

/// [`log`] is `None` if the dot product of the two normals is less than this.
const SEES: f64 = -0.2;
/// [`log`] is `None` if the part of the points' difference along the surface is less than this share of its length.
const LIES: f64 = 0.3;

/// The logarithmic map from one point to another. The vector lies in the plane normal to the mean of the two normals,
/// turned into the plane of the first point; its length is that of the circular arc with these normals at its ends. The
/// map from `b` to `a` is the reverse. `None` if the points lie on different sides of a thin sheet. For two points at
/// one place the vector is zero.
pub fn log(a: &SurfacePoint, b: &SurfacePoint) -> Option<LogMap> {
    let to = seen(a.at, a.normal, b.at, b.normal)?;
    let own = TangentFrame::of(a.normal);
    let turn = own.turn_from(&TangentFrame::of(b.normal));
    let to = if to == DVec3::ZERO {
        DVec2::ZERO
    } else {
        own.within(to)
    };
    Some(LogMap { to, turn })
}

/// [`LogMap::to`] in the frame `own`, which may be any frame of the first point's normal.
pub(crate) fn log_in(own: &TangentFrame, from: DVec3, at: DVec3, normal: DVec3) -> Option<DVec2> {
    Some(own.within(seen(from, own.normal, at, normal)?))
}

/// The squared length of [`LogMap::to`].
#[inline(always)]
pub(crate) fn apart(from: DVec3, own: DVec3, at: DVec3, normal: DVec3) -> Option<f64> {
    let cos = own.dot(normal);
    if cos < SEES {
        return None;
    }
    let r = at - from;
    let out = (own + normal).dot(r);
    let length = r.length_squared();
    if length - out * out / (2.0 + 2.0 * cos) < LIES * LIES * length {
        return None;
    }
    let arc = arc_over_chord(cos);
    Some(length * arc * arc)
}

/// [`LogMap::to`] as a vector in space.
#[inline(always)]
fn seen(from: DVec3, own: DVec3, at: DVec3, normal: DVec3) -> Option<DVec3> {
    let cos = own.dot(normal);
    if cos < SEES {
        return None;
    }
    // The sum of the normals serves instead of their mean; its square is 2 + 2 cos.
    let sum = own + normal;
    let square = 2.0 + 2.0 * cos;
    let r = at - from;
    let out = sum.dot(r) / square;
    let (length, along) = (r.length_squared(), r.length_squared() - out * out * square);
    if along < LIES * LIES * length {
        return None;
    }
    if along <= 0.0 {
        return Some(DVec3::ZERO);
    }
    let in_plane = (r - sum * out) * (arc_over_chord(cos) * (length / along).sqrt());
    Some(rotated(in_plane, sum / square.sqrt(), own))
}

/// The length of an arc divided by that of its chord, (a / 2) / sin(a / 2), from the cosine of the angle a between the
/// normals at the arc's ends.
#[inline(always)]
pub(crate) fn arc_over_chord(cos: f64) -> f64 {
    // The square of sin(a / 2).
    let s = ((1.0 - cos) * 0.5).clamp(0.0, 1.0);
    if s > SERIES {
        let sine = s.sqrt();
        return libm::asin(sine) / sine;
    }
    // Summed in pairs, so that the products do not wait for each other.
    let (s2, a) = (s * s, ARC);
    let low = (a[0] + a[1] * s) + (a[2] + a[3] * s) * s2;
    let high = (a[4] + a[5] * s) + (a[6] + a[7] * s) * s2;
    low + high * (s2 * s2)
}

/// Below this the first terms of the series of asin(sqrt s) / sqrt s have ten exact digits, more than a mesh has.
const SERIES: f64 = 0.06;
/// The coefficients of these terms: 1, 1/2 / 3, (1 3)/(2 4) / 5, ...
const ARC: [f64; 8] = [
    1.0,
    1.0 / 6.0,
    3.0 / 40.0,
    15.0 / 336.0,
    105.0 / 3456.0,
    945.0 / 42240.0,
    10395.0 / 599_040.0,
    135_135.0 / 9_676_800.0,
];

#[cfg(test)]
mod tests {
    use super::*;

    fn normals() -> impl Iterator<Item = DVec3> {
        (0..200).map(|k| {
            let t = f64::from(k);
            let z = 1.0 - (t + 0.5) / 100.0;
            let r = (1.0 - z * z).sqrt();
            DVec3::new(r * libm::cos(2.4 * t), r * libm::sin(2.4 * t), z)
        })
    }

    #[test]
    fn frames_are_right_handed_and_orthonormal() {
        for n in normals().chain([DVec3::Z, DVec3::NEG_Z]) {
            let frame = TangentFrame::of(n);
            assert!((frame.x.cross(frame.y) - n).length() < 1e-12, "{n}");
            assert!((frame.x.length() - 1.0).abs() < 1e-12 && frame.x.dot(n).abs() < 1e-12);
        }
    }

    #[test]
    fn the_way_back_is_the_reverse() {
        let all: Vec<DVec3> = normals().collect();
        for (k, &a) in all.iter().enumerate() {
            for &b in &all[..k] {
                let [p, q] = [a, b].map(|n| SurfacePoint {
                    triangle: 0,
                    at: n,
                    normal: n,
                });
                let (Some(there), Some(back)) = (log(&p, &q), log(&q, &p)) else {
                    assert!(a.dot(b) < SEES + 0.1);
                    continue;
                };
                let reverse = -there.turn.undo(there.to);
                assert!((reverse - back.to).length() < 1e-9, "{a} {b}");
                // On the unit ball the logarithmic map follows the great circle.
                assert!((there.to.length() - libm::acos(a.dot(b))).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn points_at_one_place_are_at_no_distance() {
        let p = SurfacePoint {
            triangle: 0,
            at: DVec3::ONE,
            normal: DVec3::X,
        };
        assert_eq!(log(&p, &p).unwrap().to, DVec2::ZERO);
    }
}
