//! The exact search for a body's place on its line.

use super::Body;
use super::blocked::Blocked;
use crate::component::Sphere;
use glam::DVec3;
use std::array::from_fn;
use wide::f32x4;

/// The greatest rounding error of a length, relative to the largest of its summands.
const ROUNDING: f64 = 1e-9;
/// The same for squares of single precision.
const COARSE: f32 = 1e-4;
/// Where spheres are that only fill up four, and meet nothing.
const NOWHERE: Along = Along {
    u: 1e9,
    w: 1e9,
    t: 1e9,
    radius: 0.0,
};

/// Axes of which the third is a body's normal.
struct Axes {
    u: DVec3,
    w: DVec3,
    n: DVec3,
}

/// A sphere in such axes, relative to a dart.
#[derive(Clone, Copy)]
struct Along {
    u: f64,
    w: f64,
    t: f64,
    radius: f64,
}

/// A sphere that the body may meet.
struct Met {
    sphere: Along,
    /// The R of the smaller of both bodies.
    unit: f64,
    /// The square of the distance from the line.
    off: f64,
    /// The square of the greatest distance at which the body reaches it.
    reach: f64,
    /// Rounding of lengths, and of their squares.
    slack: [f64; 2],
}

/// Four spheres in single precision, in units of the body's bound.
struct Four {
    u: f32x4,
    w: f32x4,
    t: f32x4,
    radius: f32x4,
}

/// A body on its line, among settled spheres.
pub(super) struct Sliding {
    range: (f64, f64),
    /// R of the body.
    radius: f64,
    own: Vec<Along>,
    /// The same spheres, four by four.
    fours: Vec<Four>,
    axes: Axes,
    at: DVec3,
    /// The greatest distances of its surface: from its origin, from the line, and along the line both ways.
    bound: f64,
    beside: f64,
    ends: (f64, f64),
    met: Vec<Met>,
}

impl Axes {
    fn of(n: DVec3) -> Self {
        let u = n.any_orthonormal_vector();
        Self {
            u,
            w: n.cross(u),
            n,
        }
    }

    fn along(&self, p: DVec3, radius: f64) -> Along {
        Along {
            u: p.dot(self.u),
            w: p.dot(self.w),
            t: p.dot(self.n),
            radius,
        }
    }
}

impl Along {
    fn off(&self) -> f64 {
        self.u * self.u + self.w * self.w
    }

    /// The t at which this sphere, moved along the axis by t, overlaps another by more than `allowed`; none if `t` is
    /// not among them. Their ends count.
    fn overlap(&self, other: &Met, allowed: f64, t: f64) -> Option<(f64, f64)> {
        let least = self.radius + other.sphere.radius - allowed;
        let (du, dw) = (other.sphere.u - self.u, other.sphere.w - self.w);
        let square = least * least - du * du - dw * dw;
        let middle = other.sphere.t - self.t;
        let away = middle - t;
        if square <= 0.0 || least <= 0.0 || away * away > square + other.slack[1] {
            return None;
        }
        let half = square.sqrt();
        let (from, to) = (middle - half, middle + half);
        (from <= t && t <= to).then_some((from, to))
    }
}

impl Four {
    fn new(four: &[Along], bound: f64) -> Self {
        let all = |number: fn(&Along) -> f64| {
            let each = |k| (number(four.get(k).unwrap_or(&NOWHERE)) / bound) as f32;
            f32x4::new(from_fn(each))
        };
        Self {
            u: all(|s| s.u),
            w: all(|s| s.w),
            t: all(|s| s.t),
            radius: all(|s| s.radius),
        }
    }

    /// Whether one of the spheres may meet another, in the same units.
    fn may_meet(&self, [u, w, t, radius]: [f32x4; 4]) -> bool {
        let reach = self.radius + radius;
        let square = |v: f32x4| v * v;
        let away = square(self.u - u) + square(self.w - w) + square(self.t - t);
        let room = square(reach) + (square(radius) + f32x4::ONE) * f32x4::splat(COARSE);
        room.simd_lt(away).to_bitmask() != 15
    }
}

impl Sliding {
    /// A body of these spheres, with R.
    pub fn new(body: &Body, spheres: &[Sphere], radius: f64) -> Self {
        let axes = Axes::of(body.normal);
        let own: Vec<Along> = spheres
            .iter()
            .map(|s| axes.along(body.turn * (body.scale * s.centre), body.scale * s.radius))
            .collect();
        let most = |far: fn(&Along) -> f64| own.iter().map(far).fold(f64::NEG_INFINITY, f64::max);
        let bound = most(|s| (s.off() + s.t * s.t).sqrt() + s.radius);
        Self {
            range: body.range,
            radius,
            bound,
            fours: own.chunks(4).map(|four| Four::new(four, bound)).collect(),
            beside: most(|s| s.off().sqrt() + s.radius),
            ends: (-most(|s| s.radius - s.t), most(|s| s.t + s.radius)),
            own,
            axes,
            at: body.at,
            met: Vec::new(),
        }
    }

    /// Adds the spheres of a settled body with R, except those that are too far from the line.
    pub fn meet(&mut self, spheres: &[Sphere], radius: f64) {
        let (lo, hi) = self.range;
        for sphere in spheres {
            let there = self.axes.along(sphere.centre - self.at, sphere.radius);
            let off = there.off();
            let size = self.bound + there.radius + lo.abs().max(hi.abs());
            let slack = ROUNDING * size;
            let beside = self.beside + there.radius + slack;
            if off > beside * beside
                || there.t + there.radius - self.ends.0 + slack < lo
                || there.t - there.radius - self.ends.1 - slack > hi
            {
                continue;
            }
            let reach = self.bound + there.radius + slack;
            self.met.push(Met {
                unit: self.radius.min(radius),
                off,
                reach: reach * reach,
                slack: [slack, slack * size],
                sphere: there,
            });
        }
    }

    /// The place nearest to the dart at which no spheres overlap by more than `tau`, in R of the smaller body.
    ///
    /// All places at which two spheres overlap are blocked. But only those intervals are added to the blocked ones
    /// that contain the nearest place that seems free, until none does: others would not change it, not even in its
    /// last bit.
    pub fn free_place(&self, tau: f64) -> Option<f64> {
        let mut blocked = Blocked::new(self.range.0, self.range.1);
        let mut best = blocked.nearest_to_zero()?;
        let (mut k, mut agree) = (0, 0);
        while agree < self.met.len() {
            let other = &self.met[k];
            let before = best;
            let away = other.sphere.t - best;
            if other.off + away * away <= other.reach {
                let allowed = tau * other.unit;
                for (four, own) in self.fours.iter().zip(self.own.chunks(4)) {
                    if !four.may_meet(self.there(other, best)) {
                        continue;
                    }
                    for own in own {
                        if let Some((from, to)) = own.overlap(other, allowed, best) {
                            blocked.add(from, to);
                            best = blocked.nearest_to_zero()?;
                        }
                    }
                }
            }
            agree = if best == before { agree + 1 } else { 0 };
            k = if k + 1 == self.met.len() { 0 } else { k + 1 };
        }
        Some(best)
    }

    /// A sphere as it is seen from the body at t, in single precision.
    fn there(&self, other: &Met, t: f64) -> [f32x4; 4] {
        let Along {
            u,
            w,
            t: along,
            radius,
        } = other.sphere;
        [u, w, along - t, radius].map(|v| f32x4::splat((v / self.bound) as f32))
    }
}
