//! The bubble force and the potential of a pair of cells.
//!
//! Miyata, Itoh, Shimada (2000), section 4.2: code `bubble_force` = eq. (2), `bubble_potential` = eq. (3),
//! `Pair::force` = the gradient of eq. (4). In these units a force is a length: the spring constant k0 of a
//! pair is l0 squared, so that k0 / l0 = l0, the pair's stable distance.

use super::Particle;
use super::physics::CornerBubbles;
use super::shape::{CUT, CellShape};
use super::transport::{IdentityTransport, ParallelTransport};
use crate::field::CellKind;
use crate::order::{greater, lesser};
use glam::{DVec2, Vec2Swizzles};
use wide::f64x2;

/// Equation (2) in units of k0 / l0: positive repels (w < 1), negative attracts (1 < w < 1.5).
pub fn bubble_force(w: f64) -> f64 {
    if w >= CUT {
        return 0.0;
    }
    (1.25 * w - 2.375) * w * w + 1.125
}

/// Equation (3) in units of k0: minus the integral of [`bubble_force`] over w, zero from 1.5 on.
pub fn bubble_potential(w: f64) -> f64 {
    if w >= CUT {
        return 0.0;
    }
    -(((0.3125 * w - 19.0 / 24.0) * w * w + 1.125) * w - 153.0 / 256.0)
}

/// The interaction of two cells.
///
/// Squares and circles push along the line between their centres (eq. 2); so do ellipses and rectangles, by their
/// effective distance (Itoh, Miyata, Shimada 2003, section 5.1). Cells with corners have four more potentials, one at
/// each corner (eq. 4). For stretched cells the corner potentials are evaluated in the frame in which the cells are
/// squares.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// Unit vector of the pair's frame, or zero where the field has no direction: then only the
    /// central potential acts (Miyata, Itoh, Shimada 2001, section 4).
    axis: DVec2,
    /// Sizes of the two cells.
    sizes: (f64, f64),
    /// Whether the first and the second cell have corners that act on the other.
    corners: (bool, bool),
    bubbles: CornerBubbles,
    /// Present if at least one of the cells is stretched.
    stretch: Option<Stretch>,
}

#[derive(Clone, Copy, Debug)]
struct Stretch {
    shapes: (CellShape, CellShape),
    /// The square root of the mean of both aspect ratios.
    root: f64,
}

impl Pair {
    /// The interaction of two cells. The axis of its frame is the mean of both cells' axes, the second turned by its
    /// symmetry to be nearest to the first. Forces are then reciprocal.
    pub fn new(a: &Particle, b: &Particle) -> Self {
        Self::seen(a, b, IdentityTransport, CornerBubbles::PAPERS)
    }

    /// The interaction of two cells on any domain, in the first cell's frame. `turn` maps vectors of the second cell's
    /// frame into it.
    #[inline(always)]
    pub(crate) fn seen<P>(
        a: &Particle<P>,
        b: &Particle<P>,
        turn: impl ParallelTransport,
        bubbles: CornerBubbles,
    ) -> Self {
        let sizes = (a.size, b.size);
        let axes = (a.axis, turn.apply(b.axis));
        if a.kind == CellKind::Square && b.kind == CellKind::Square {
            return Self::squares(axes, sizes, bubbles);
        }
        let stretch = (a.kind.is_stretched() || b.kind.is_stretched()).then(|| Stretch {
            shapes: (CellShape::of(a), CellShape::of(b).seen(turn)),
            root: (0.5 * (a.aspect + b.aspect)).sqrt(),
        });
        let corners = (a.kind.has_corners(), b.kind.has_corners());
        let axis = if corners.0 || corners.1 {
            mean_axis(axes.0, axes.1, if stretch.is_some() { 2 } else { 4 })
        } else {
            DVec2::ZERO
        };
        Self {
            axis,
            sizes,
            corners,
            bubbles,
            stretch,
        }
    }

    /// The same pair with other corner bubbles.
    pub fn with(self, bubbles: CornerBubbles) -> Self {
        Self { bubbles, ..self }
    }

    /// The interaction of two squares.
    #[inline(always)]
    fn squares(axes: (DVec2, DVec2), sizes: (f64, f64), bubbles: CornerBubbles) -> Self {
        Self {
            axis: mean_axis(axes.0, axes.1, 4),
            sizes,
            corners: (true, true),
            bubbles,
            stretch: None,
        }
    }

    /// The stable distance l0 of the two centres; for stretched cells in the frame in which they are squares.
    pub fn stable_distance(&self) -> f64 {
        0.5 * (self.sizes.0 + self.sizes.1)
    }

    /// The force on the second cell, whose centre is at `r` from the first cell's; the first cell feels the opposite
    /// force. The part of the corners is the mean over both cells' corners, 0 for a cell without corners.
    #[inline(always)]
    pub fn force(&self, r: DVec2) -> DVec2 {
        let l0 = self.stable_distance();
        let mut force = match &self.stretch {
            None => r * (l0 * radial_strength(r.length_squared(), 1.0 / l0)),
            Some(Stretch { shapes, .. }) => {
                let w = shapes.0.normalised_distance(&shapes.1, r);
                if w == 0.0 {
                    return DVec2::ZERO;
                }
                r * (bubble_force(w) / w)
            }
        };
        if self.axis != DVec2::ZERO {
            let local = self.framed(r);
            let corners = if self.sizes.0 == self.sizes.1 && self.corners == (true, true) {
                self.corner_force(local, self.sizes.0)
            } else {
                let mut sum = DVec2::ZERO;
                if self.corners.0 {
                    sum += self.corner_force(local, self.sizes.0);
                }
                if self.corners.1 {
                    sum += self.corner_force(local, self.sizes.1);
                }
                0.5 * sum
            };
            force += self.bubbles.weight * self.unframed(corners);
        }
        force
    }

    /// The pair's potential at `r`. [`Pair::force`] is minus its gradient; for stretched cells the gradient
    /// is taken in the frame in which they are squares.
    pub fn potential(&self, r: DVec2) -> f64 {
        let l0 = self.stable_distance();
        let w = match &self.stretch {
            None => r.length() / l0,
            Some(Stretch { shapes, .. }) => shapes.0.normalised_distance(&shapes.1, r),
        };
        let mut sum = l0 * l0 * bubble_potential(w);
        if self.axis != DVec2::ZERO {
            let local = self.framed(r);
            let corners = if self.sizes.0 == self.sizes.1 && self.corners == (true, true) {
                self.corner_potential(local, self.sizes.0)
            } else {
                let mut sum = 0.0;
                if self.corners.0 {
                    sum += self.corner_potential(local, self.sizes.0);
                }
                if self.corners.1 {
                    sum += self.corner_potential(local, self.sizes.1);
                }
                0.5 * sum
            };
            sum += self.bubbles.weight * corners;
        }
        sum
    }

    /// The penetration depth at `r`, in stable distances: 0 if the cells touch, negative if they are apart. It is
    /// measured edge to edge if both have corners.
    pub fn penetration(&self, r: DVec2) -> f64 {
        if self.corners == (true, true) && self.axis != DVec2::ZERO {
            return 1.0 - self.framed(r).abs().max_element() / self.stable_distance();
        }
        1.0 - match &self.stretch {
            None => r.length() / self.stable_distance(),
            Some(Stretch { shapes, .. }) => shapes.0.normalised_distance(&shapes.1, r),
        }
    }

    fn framed(&self, r: DVec2) -> DVec2 {
        let local = DVec2::new(self.axis.dot(r), self.axis.perp_dot(r));
        match &self.stretch {
            None => local,
            Some(Stretch { root, .. }) => DVec2::new(local.x / root, local.y * root),
        }
    }

    fn unframed(&self, v: DVec2) -> DVec2 {
        let v = match &self.stretch {
            None => v,
            Some(Stretch { root, .. }) => DVec2::new(v.x * root, v.y / root),
        };
        self.axis * v.x + self.axis.perp() * v.y
    }

    #[inline(always)]
    fn corner_force(&self, local: DVec2, size: f64) -> DVec2 {
        let l0 = self.stable_distance();
        let reach = self.bubbles.stable_distance(self.sizes);
        let half = 0.5 * size;
        // By symmetry, works below the diagonal of the first quadrant, and maps back at the end.
        let q = local.abs();
        let (x, y) = (greater(q.x, q.y), lesser(q.x, q.y));
        let per_reach = 1.0 / reach;
        let ys = f64x2::new([y - half, y + half]);
        // The force of the two corners at a distance `x` along the first axis.
        let column = |x: f64| {
            let strengths = two_strengths(f64x2::splat(x * x) + ys * ys, per_reach);
            let [above, below] = strengths.to_array();
            let [near, far] = (strengths * ys).to_array();
            DVec2::new((above + below) * x, near + far)
        };
        let mut sum = column(x - half);
        // The far corners are mostly out of reach.
        if x + half < CUT * reach {
            sum += column(x + half);
        }
        let sum = l0 * if q.x >= q.y { sum } else { sum.yx() };
        DVec2::new(
            if local.x < 0.0 { -sum.x } else { sum.x },
            if local.y < 0.0 { -sum.y } else { sum.y },
        )
    }

    fn corner_potential(&self, local: DVec2, size: f64) -> f64 {
        let l0 = self.stable_distance();
        let reach = self.bubbles.stable_distance(self.sizes);
        let half = 0.5 * size;
        // By symmetry, works in the first quadrant.
        let q = local.abs();
        let ys = f64x2::new([q.y - half, q.y + half]);
        let farthest = CUT * CUT * reach * reach;
        // The two corners at a distance `x` along the first axis.
        let column = |x: f64| two_potentials(f64x2::splat(x * x) + ys * ys, reach, farthest);
        let [above, below] = column(q.x - half);
        let mut sum = above + below;
        // The far corners are mostly out of reach.
        let x = q.x + half;
        if x * x < farthest {
            let [above, below] = column(x);
            sum = sum + above + below;
        }
        l0 * reach * sum
    }
}

/// [`bubble_potential`] of two distances divided by `reach`. `squares` are the squared distances; from `farthest` on,
/// the potential is zero.
#[inline(always)]
fn two_potentials(squares: f64x2, reach: f64, farthest: f64) -> [f64; 2] {
    let w = squares.sqrt() / f64x2::splat(reach);
    let is_felt = squares.simd_lt(f64x2::splat(farthest)) & w.simd_lt(f64x2::splat(CUT));
    let cubic = ((w * 0.3125 - 19.0 / 24.0) * w * w + 1.125) * w - 153.0 / 256.0;
    (-cubic & is_felt).to_array()
}

/// The force on the cell `b`, which is at the offset `r` from the cell `a`; in the frame of `a`. Cells of any kinds.
pub(super) fn force_between<P>(
    a: &Particle<P>,
    b: &Particle<P>,
    (r, turn): (DVec2, impl ParallelTransport),
    corners: CornerBubbles,
) -> DVec2 {
    Pair::seen(a, b, turn, corners).force(r)
}

/// The potential of two cells of any kinds; `b` is at the offset `r` from `a`.
pub(super) fn potential_between<P>(
    a: &Particle<P>,
    b: &Particle<P>,
    (r, turn): (DVec2, impl ParallelTransport),
    corners: CornerBubbles,
) -> f64 {
    let seen = CellShape::of(b).seen(turn);
    if !CellShape::of(a).may_touch(&seen, r, (corners.square_reach(), 0.0)) {
        return 0.0;
    }
    Pair::seen(a, b, turn, corners).potential(r)
}

/// The unit vector midway between `e` and `f`, after `f` is turned by the multiple of 1/`symmetry` (2 or 4) of a circle
/// that brings it nearest to `e`. Zero if `e` or `f` is zero.
#[inline(always)]
fn mean_axis(e: DVec2, f: DVec2, symmetry: u32) -> DVec2 {
    let (along, across) = (e.dot(f), e.perp_dot(f));
    let turned = if symmetry == 2 || along.abs() >= across.abs() {
        f * along.signum()
    } else {
        -f.perp() * across.signum()
    };
    if e == DVec2::ZERO || f == DVec2::ZERO {
        DVec2::ZERO
    } else {
        (e + turned).normalize()
    }
}

/// The bubble force at a squared distance, divided by the distance. Times the offset vector it gives the force, in
/// units of k0 / l0. It has no branches, because most pairs would take them at random. Distances are clamped to the
/// cut, where the force is exactly zero.
#[inline(always)]
fn radial_strength(square: f64, per_reach: f64) -> f64 {
    let square = lesser(square * (per_reach * per_reach), CUT * CUT);
    let w = greater(square, f64::MIN_POSITIVE).sqrt();
    (1.25 * square - 2.375 * w + 1.125 / w) * per_reach
}

/// [`radial_strength`] in two lanes. Compilers vectorise only a part of the scalar code.
#[inline(always)]
pub(super) fn two_strengths(squares: f64x2, per_reach: f64) -> f64x2 {
    let all = f64x2::splat;
    let squares = (squares * all(per_reach * per_reach)).fast_min(all(CUT * CUT));
    let w = squares.fast_max(all(f64::MIN_POSITIVE)).sqrt();
    (squares * 1.25 - w * 2.375 + all(1.125) / w) * per_reach
}
