//! The forces between squares, for two pairs at once.
//!
//! Most pairs of most pictures are squares of one size. Two lanes compute for both pairs what [`super::force::Pair`]
//! computes for one, operation by operation, so the bits are the same.

use super::force::two_strengths;
use super::physics::CornerBubbles;
use super::shape::CUT;
use glam::DVec2;
use wide::f64x2;

/// Two vectors, by components.
#[derive(Clone, Copy)]
struct TwoVectors {
    x: f64x2,
    y: f64x2,
}

impl TwoVectors {
    #[inline(always)]
    fn new([a, b]: [DVec2; 2]) -> Self {
        Self {
            x: f64x2::new([a.x, b.x]),
            y: f64x2::new([a.y, b.y]),
        }
    }

    #[inline(always)]
    fn dot(self, other: Self) -> f64x2 {
        self.x * other.x + self.y * other.y
    }

    #[inline(always)]
    fn perp_dot(self, other: Self) -> f64x2 {
        self.x * other.y - self.y * other.x
    }

    #[inline(always)]
    fn times(self, factor: f64x2) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
        }
    }
}

/// Two pairs of squares of one size. The first cell of both pairs is the same.
#[derive(Clone, Copy)]
pub(super) struct TwoSquarePairs {
    pub size: f64,
    pub bubbles: CornerBubbles,
}

impl TwoSquarePairs {
    /// The forces on the second cells, at the offsets `r` and with the axes `f`; the first cell has the axis `e`. No
    /// axis is zero. See `Pair::force`.
    #[inline(always)]
    pub fn forces(self, e: DVec2, f: [DVec2; 2], r: [DVec2; 2]) -> [DVec2; 2] {
        let (axis, r) = (
            mean_axes(TwoVectors::new([e, e]), TwoVectors::new(f)),
            TwoVectors::new(r),
        );
        let l0 = 0.5 * (self.size + self.size);
        let central = r.times(two_strengths(r.dot(r), 1.0 / l0) * l0);
        let local = TwoVectors {
            x: axis.dot(r),
            y: axis.perp_dot(r),
        };
        let corners = self.corner_forces(local, l0);
        let x = axis.x * corners.x - axis.y * corners.y;
        let y = axis.y * corners.x + axis.x * corners.y;
        let weight = self.bubbles.weight;
        let [ax, bx] = (central.x + x * weight).to_array();
        let [ay, by] = (central.y + y * weight).to_array();
        [DVec2::new(ax, ay), DVec2::new(bx, by)]
    }

    /// The forces of the corner bubbles, in the pairs' frames.
    #[inline(always)]
    fn corner_forces(self, local: TwoVectors, l0: f64) -> TwoVectors {
        let reach = self.bubbles.stable_distance((self.size, self.size));
        let half = f64x2::splat(0.5 * self.size);
        let per_reach = 1.0 / reach;
        // By symmetry, works below the diagonal of the first quadrant, and maps back at the end.
        let (qx, qy) = (local.x.abs(), local.y.abs());
        let (x, y) = (qx.fast_max(qy), qx.fast_min(qy));
        let (low, high) = (y - half, y + half);
        let column = |x: f64x2| {
            let square = x * x;
            let above = two_strengths(square + low * low, per_reach);
            let below = two_strengths(square + high * high, per_reach);
            ((above + below) * x, above * low + below * high)
        };
        let (mut along, mut across) = column(x - half);
        // The far corners are mostly out of reach.
        let far = x + half;
        let is_felt = far.simd_lt(f64x2::splat(CUT * reach));
        if is_felt.any() {
            let (more, aside) = column(far);
            along += more & is_felt;
            across += aside & is_felt;
        }
        let is_flat = qx.simd_ge(qy);
        TwoVectors {
            x: with_sign(is_flat.select(along, across) * l0, local.x),
            y: with_sign(is_flat.select(across, along) * l0, local.y),
        }
    }
}

/// The unit vectors midway between `e` and `f`, after each `f` is turned by the multiple of a quarter turn that brings
/// it nearest to its `e`.
#[inline(always)]
fn mean_axes(e: TwoVectors, f: TwoVectors) -> TwoVectors {
    let (along, across) = (e.dot(f), e.perp_dot(f));
    let is_along = along.abs().simd_ge(across.abs());
    let sign = is_along.select(along, across) & f64x2::splat(-0.0);
    let sum = TwoVectors {
        x: e.x + (is_along.select(f.x, f.y) ^ sign),
        y: e.y + (is_along.select(f.y, -f.x) ^ sign),
    };
    sum.times(f64x2::splat(1.0) / sum.dot(sum).sqrt())
}

/// The numbers, each negated if the same lane of `other` is negative.
#[inline(always)]
fn with_sign(numbers: f64x2, other: f64x2) -> f64x2 {
    numbers ^ (other.simd_lt(f64x2::splat(0.0)) & f64x2::splat(-0.0))
}
