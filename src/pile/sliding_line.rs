//! The line on which a body slides, and the settled spheres near it. All orientations of the body share both.

use super::Body;
use super::blocked::Blocked;
use super::settled::Neighbour;
use crate::component::{self, COARSE, fourfold};
use crate::order::{greater, set_bits};
use glam::DVec3;
use std::cell::OnceCell;
use wide::f32x4;

/// The greatest rounding error of a length, relative to the largest of its summands.
const ROUNDING: f64 = 1e-9;

/// A sphere that fills up a group of four; no body meets it.
const NOTHING: Met = Met {
    sphere: NOWHERE,
    unit: 0.0,
    slack: 0.0,
};
/// The place of `NOTHING`, far from all bodies.
pub(super) const NOWHERE: SlidingSphere = SlidingSphere {
    u: 1e9,
    w: 1e9,
    t: 1e9,
    radius: 0.0,
};

/// Three axes: `n` is a body's normal, along which it slides, and `u` and `w` are across.
struct Axes {
    u: DVec3,
    w: DVec3,
    n: DVec3,
}

/// A sphere in these axes, relative to a dart; `t` is along `n`.
#[derive(Clone, Copy, Default)]
pub(super) struct SlidingSphere {
    pub u: f64,
    pub w: f64,
    pub t: f64,
    pub radius: f64,
}

/// A sphere that the body may meet.
#[derive(Clone, Copy)]
pub(super) struct Met {
    pub sphere: SlidingSphere,
    /// The R of the smaller of both bodies.
    pub unit: f64,
    /// The rounding error of squared lengths beside the sphere.
    slack: f64,
}

/// Four such spheres in single precision, in units of the body's bound.
pub(super) struct MetFour {
    /// The square of the distance from the line.
    off: f32x4,
    t: f32x4,
    radius: f32x4,
    unit: f32x4,
}

/// How far a body reaches beside its line, and from which t to which, in units of its bound.
pub(super) struct Extent {
    pub beside: f32x4,
    pub low: f32x4,
    pub high: f32x4,
}

/// The line along a dart's normal, with the settled spheres near it.
pub(super) struct SlidingLine {
    axes: Axes,
    at: DVec3,
    range: (f64, f64),
    /// The sphere at the body's origin, which no turn moves; of radius 0 if there is none.
    core: SlidingSphere,
    /// The greatest distance of the body's spheres from its origin.
    pub bound: f64,
    /// The settled spheres near the line, the most important ones first.
    pub met: Vec<Met>,
    pub fours: Vec<MetFour>,
    /// The places at which settled spheres meet the core, for each of two offsets: T, and T + D.
    blocked: [OnceCell<Blocked>; 2],
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

    fn along(&self, p: DVec3, radius: f64) -> SlidingSphere {
        SlidingSphere {
            u: p.dot(self.u),
            w: p.dot(self.w),
            t: p.dot(self.n),
            radius,
        }
    }
}

impl SlidingSphere {
    /// The square of the distance from the line.
    pub fn off(&self) -> f64 {
        self.u * self.u + self.w * self.w
    }

    /// The middle of the interval of t in which this sphere, moved by t along the axis, overlaps another by more than
    /// `allowed`, and the square of half its length (at most 0 if there is no such t).
    fn middle(&self, other: &Met, allowed: f64) -> (f64, f64) {
        let least = self.radius + other.sphere.radius - allowed;
        let (du, dw) = (other.sphere.u - self.u, other.sphere.w - self.w);
        let square = least * least - du * du - dw * dw;
        (
            other.sphere.t - self.t,
            if least > 0.0 { square } else { 0.0 },
        )
    }

    /// The interval of t in which this sphere, moved by t along the axis, overlaps another by more than `allowed`.
    pub fn interval(&self, other: &Met, allowed: f64) -> Option<(f64, f64)> {
        let (middle, square) = self.middle(other, allowed);
        let half = square.sqrt();
        (square > 0.0).then_some((middle - half, middle + half))
    }

    /// Like [`Self::interval`], but `None` if `t` is outside of it, which is found faster. The ends are inside.
    pub fn overlap(&self, other: &Met, allowed: f64, t: f64) -> Option<(f64, f64)> {
        let (middle, square) = self.middle(other, allowed);
        let away = middle - t;
        if square <= 0.0 || away * away > square + other.slack {
            return None;
        }
        let half = square.sqrt();
        let (from, to) = (middle - half, middle + half);
        (from <= t && t <= to).then_some((from, to))
    }
}

impl MetFour {
    fn new(four: &[Met], bound: f64) -> Self {
        let all = |number: fn(&Met) -> f64, scale: f64| {
            component::four(|k| number(four.get(k).unwrap_or(&NOTHING)) / scale)
        };
        Self {
            off: all(|met| met.sphere.off(), bound * bound),
            t: all(|met| met.sphere.t, bound),
            radius: all(|met| met.sphere.radius, bound),
            unit: all(|met| met.unit, bound),
        }
    }

    /// A bit for each sphere that may overlap a body of this extent at t by more than `tau`, in R of the smaller body.
    pub fn near(&self, extent: &Extent, tau: f32x4, t: f32x4) -> u32 {
        let reach = self.radius - tau * self.unit;
        let beside = (extent.beside + reach).max(f32x4::ZERO);
        let slack = (self.radius * self.radius + self.t.abs() + f32x4::ONE) * f32x4::splat(COARSE);
        let away = self.t - t;
        let is_beside = self.off.simd_le(beside * beside + slack);
        let is_level = (away + reach + slack).simd_ge(extent.low)
            & (away - reach - slack).simd_le(extent.high);
        (is_beside & is_level).to_bitmask()
    }

    /// A bit for each sphere that may block a sphere of this radius on the line.
    fn blocks(&self, radius: f32x4, tau: f32x4) -> u32 {
        let reach = (radius + self.radius - tau * self.unit).max(f32x4::ZERO);
        let slack = (self.radius * self.radius + f32x4::ONE) * f32x4::splat(COARSE);
        self.off.simd_le(reach * reach + slack).to_bitmask()
    }
}

impl SlidingLine {
    /// The line of a body among settled bodies. `radius` is R, `core` is the radius of its core, and its spheres lie
    /// within `bound` of its origin.
    pub fn new(
        body: &Body,
        range: (f64, f64),
        (radius, core, bound): (f64, f64, f64),
        settled: &[Neighbour],
    ) -> Self {
        let core = SlidingSphere {
            radius: core,
            ..SlidingSphere::default()
        };
        let mut line = Self {
            axes: Axes::of(body.normal),
            at: body.at,
            range,
            core,
            bound: bound * (1.0 + ROUNDING),
            met: Vec::new(),
            fours: Vec::new(),
            blocked: Default::default(),
        };
        line.meet(settled, radius);
        let bound = line.bound;
        let fours = line.met.chunks(4).map(|four| MetFour::new(four, bound));
        line.fours = fours.collect();
        line
    }

    /// A sphere in the line's axes; `p` is its centre relative to the dart.
    pub fn along(&self, p: DVec3, radius: f64) -> SlidingSphere {
        self.axes.along(p, radius)
    }

    /// The places at which settled spheres meet the core, in a part of the range. `depth` is the number of the offset
    /// `tau`: 0 for T, 1 for T + D.
    pub fn blocked(&self, range: (f64, f64), tau: f64, depth: usize) -> Blocked {
        let whole = self.blocked[depth].get_or_init(|| self.blocked_by_core(tau));
        whole.within(range)
    }

    fn blocked_by_core(&self, tau: f64) -> Blocked {
        let mut blocked = Blocked::new(self.range.0, self.range.1);
        let (radius, coarse_tau) = (fourfold(self.core.radius / self.bound), fourfold(tau));
        if self.core.radius <= 0.0 {
            return blocked;
        }
        for (four, met) in self.fours.iter().zip(self.met.chunks(4)) {
            for lane in set_bits(four.blocks(radius, coarse_tau)) {
                let allowed = tau * met[lane].unit;
                if let Some((from, to)) = self.core.interval(&met[lane], allowed) {
                    blocked.add(from, to);
                }
            }
        }
        blocked
    }

    /// Adds the spheres of settled bodies that are near enough to the line: first the first sphere of each body, then
    /// the second ones, and so on. Early spheres matter most.
    fn meet(&mut self, settled: &[Neighbour], radius: f64) {
        let most = settled.iter().map(|other| other.spheres.len()).max();
        for k in 0..most.unwrap_or(0) {
            for other in settled {
                let Some(sphere) = other.spheres.get(k) else {
                    continue;
                };
                let there = self.axes.along(sphere.centre - self.at, sphere.radius);
                if let Some(slack) = self.slack_near(&there) {
                    self.met.push(Met {
                        unit: radius.min(other.radius),
                        slack,
                        sphere: there,
                    });
                }
            }
        }
    }

    /// The rounding error of squared lengths beside a sphere; `None` if the body cannot meet the sphere.
    fn slack_near(&self, there: &SlidingSphere) -> Option<f64> {
        let (lo, hi) = self.range;
        let reach = self.bound + there.radius;
        let size = reach + greater(-lo, hi);
        let slack = ROUNDING * size;
        let beside = reach + slack;
        let is_near =
            there.off() <= beside * beside && there.t + beside >= lo && there.t - beside <= hi;
        is_near.then_some(slack * size)
    }
}
