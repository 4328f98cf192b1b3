//! Forces and potentials of two pairs of squares at once, in the two lanes of a vector.
//!
//! Most of a packing's time goes into pairs of squares. Each lane goes through the operations of
//! [`Pair`](super::force::Pair) in their order, so it gives the same bits.

use super::force::{CORNER_WEIGHT, radial_strengths};
use super::shape::CUT;
use super::transport::ParallelTransport;
use glam::DVec2;
use wide::f64x2;

/// A square as another one sees it: its axis and the offset to it, both in the other's frame, and its size.
#[derive(Clone, Copy, Debug)]
pub(super) struct SeenSquare {
    pub axis: DVec2,
    pub size: f64,
    pub way: DVec2,
}

/// The sum of the forces on a body from its neighbours, with their reactions in `forces`. Pairs of squares wait for
/// another one; sums run in the order of the neighbours all the same.
pub(super) struct NeighbourSum<'a, T> {
    forces: &'a mut [DVec2],
    waiting: Option<(usize, T, SeenSquare)>,
    pub total: DVec2,
}

impl<'a, T: ParallelTransport> NeighbourSum<'a, T> {
    pub fn new(forces: &'a mut [DVec2]) -> Self {
        Self {
            forces,
            waiting: None,
            total: DVec2::ZERO,
        }
    }

    /// Adds the force of a square with this axis and size on body `j`, a square, too.
    #[inline(always)]
    pub fn add_square(&mut self, own: (DVec2, f64), (j, turn): (usize, T), other: SeenSquare) {
        let Some((i, before, first)) = self.waiting.take() else {
            self.waiting = Some((j, turn, other));
            return;
        };
        let [one, two] = SquarePairs::new([own; 2], [first, other]).forces();
        self.put((i, before), one);
        self.put((j, turn), two);
    }

    /// Adds a force on body `j`. No square may be waiting.
    #[inline(always)]
    pub fn put(&mut self, (j, turn): (usize, T), force: DVec2) {
        self.forces[j] += turn.undo(force);
        self.total -= force;
    }

    /// Adds the force on the square that waits.
    #[inline(always)]
    pub fn finish(&mut self, own: (DVec2, f64)) {
        if let Some((j, turn, other)) = self.waiting.take() {
            let [force, _] = SquarePairs::new([own; 2], [other; 2]).forces();
            self.put((j, turn), force);
        }
    }
}

/// A plane vector in each lane.
#[derive(Clone, Copy)]
struct Vectors {
    x: f64x2,
    y: f64x2,
}

impl Vectors {
    fn new([a, b]: [DVec2; 2]) -> Self {
        Self {
            x: f64x2::new([a.x, b.x]),
            y: f64x2::new([a.y, b.y]),
        }
    }

    fn times(self, factor: f64x2) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
        }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
        }
    }

    fn dot(self, other: Self) -> f64x2 {
        self.x * other.x + self.y * other.y
    }

    fn perp_dot(self, other: Self) -> f64x2 {
        self.x * other.y - self.y * other.x
    }

    /// The lanes of one vector where a mask is set, those of the other elsewhere.
    fn chosen(mask: f64x2, one: Self, other: Self) -> Self {
        Self {
            x: mask.select(one.x, other.x),
            y: mask.select(one.y, other.y),
        }
    }
}

/// Two pairs of squares.
pub(super) struct SquarePairs {
    sizes: (f64x2, f64x2),
    /// Whether the squares of each pair have one size.
    is_even: bool,
    /// The pairs' mean sizes.
    stable: f64x2,
    /// The radii of the corners' forces.
    reach: f64x2,
    way: Vectors,
    axis: Vectors,
    has_axis: f64x2,
    /// The centres of the second squares in the pairs' frames.
    local: Vectors,
}

/// Equation (3) for two distances, as in [`bubble_potential`](super::force::bubble_potential).
#[inline(always)]
fn potentials(w: f64x2) -> f64x2 {
    let inner = (w * 0.3125 - 19.0 / 24.0) * w * w + 1.125;
    w.simd_lt(f64x2::splat(CUT)) & -(inner * w - 153.0 / 256.0)
}

/// The mean axes of pairs of squares, of which the second ones are turned by quarters to be nearest; and where there
/// is one, because neither axis is zero.
fn mean_axes((e, f): (Vectors, Vectors)) -> (Vectors, f64x2) {
    let (along, across) = (e.dot(f), e.perp_dot(f));
    let is_along = along.abs().simd_ge(across.abs());
    let aside = Vectors { x: f.y, y: -f.x };
    let sign = is_along.select(along, across) & f64x2::splat(-0.0);
    let turned = Vectors::chosen(is_along, f, aside).times(f64x2::splat(1.0) | sign);
    let sum = e.plus(turned);
    let axis = sum.times(f64x2::splat(1.0) / sum.dot(sum).sqrt());
    let zero = f64x2::ZERO;
    let is_any = |v: Vectors| v.x.simd_ne(zero) | v.y.simd_ne(zero);
    (axis, is_any(e) & is_any(f))
}

impl SquarePairs {
    /// Squares with these axes and sizes, and those that they see.
    #[inline(always)]
    pub fn new(own: [(DVec2, f64); 2], others: [SeenSquare; 2]) -> Self {
        let sizes = (
            f64x2::new(own.map(|o| o.1)),
            f64x2::new(others.map(|o| o.size)),
        );
        let axes = (
            Vectors::new(own.map(|o| o.0)),
            Vectors::new(others.map(|o| o.axis)),
        );
        let way = Vectors::new(others.map(|o| o.way));
        let (axis, has_axis) = mean_axes(axes);
        let mut pairs = Self {
            sizes,
            is_even: own
                .iter()
                .zip(others)
                .all(|(own, other)| own.1 == other.size),
            stable: (sizes.0 + sizes.1) * 0.5,
            reach: sizes.0 * std::f64::consts::FRAC_1_SQRT_2,
            way,
            axis,
            has_axis,
            local: Vectors {
                x: axis.dot(way),
                y: axis.perp_dot(way),
            },
        };
        if !pairs.is_even {
            let mean = (sizes.0 * sizes.0 + sizes.1 * sizes.1).sqrt() * 0.5;
            pairs.reach = sizes.0.simd_eq(sizes.1).select(pairs.reach, mean);
        }
        pairs
    }

    /// The forces on the second squares.
    pub fn forces(&self) -> [DVec2; 2] {
        let way = self.way;
        let strength = radial_strengths(way.dot(way), f64x2::splat(1.0) / self.stable);
        let central = way.times(self.stable * strength);
        let mut corners = self.corners(self.sizes.0);
        if !self.is_even {
            corners = corners.plus(self.corners(self.sizes.1));
            corners = corners.times(f64x2::splat(0.5));
        }
        let turned = Vectors {
            x: self.axis.x * corners.x - self.axis.y * corners.y,
            y: self.axis.y * corners.x + self.axis.x * corners.y,
        };
        let all = central.plus(turned.times(f64x2::splat(CORNER_WEIGHT)));
        let force = Vectors::chosen(self.has_axis, all, central);
        let ([a, b], [c, d]) = (force.x.to_array(), force.y.to_array());
        [DVec2::new(a, c), DVec2::new(b, d)]
    }

    /// The pairs' potentials.
    pub fn potentials(&self) -> [f64; 2] {
        let w = self.way.dot(self.way).sqrt() / self.stable;
        let central = self.stable * self.stable * potentials(w);
        let mut corners = self.corner_potentials(self.sizes.0);
        if !self.is_even {
            corners = (corners + self.corner_potentials(self.sizes.1)) * 0.5;
        }
        let all = central + corners * CORNER_WEIGHT;
        self.has_axis.select(all, central).to_array()
    }

    /// The potentials of the corners of squares of this size.
    fn corner_potentials(&self, size: f64x2) -> f64x2 {
        let half = size * 0.5;
        // By symmetry, works in the first quadrant.
        let (x, y) = (self.local.x.abs(), self.local.y.abs());
        let most = self.reach * (CUT * CUT) * self.reach;
        let (low, high) = (y - half, y + half);
        let radial = |x: f64x2, y: f64x2| {
            let square = x * x + y * y;
            let potential = potentials(square.sqrt() / self.reach);
            square.simd_lt(most) & potential
        };
        let mut sum = radial(x - half, low) + radial(x - half, high);
        let far = x + half;
        // The far corners are mostly out of reach.
        if (far * far).simd_lt(most).any() {
            sum += radial(far, low);
            sum += radial(far, high);
        }
        self.stable * self.reach * sum
    }

    /// The forces of the corners of squares of this size, in the pairs' frames.
    fn corners(&self, size: f64x2) -> Vectors {
        let half = size * 0.5;
        // By symmetry, works below the diagonal of the first quadrant, and maps back at the end.
        let (p, q) = (self.local.x.abs(), self.local.y.abs());
        let (x, y) = (p.fast_max(q), p.fast_min(q));
        let per_reach = f64x2::splat(1.0) / self.reach;
        let (low, high) = (y - half, y + half);
        let pull = |x: f64x2| {
            let above = radial_strengths(x * x + low * low, per_reach);
            let below = radial_strengths(x * x + high * high, per_reach);
            Vectors {
                x: (above + below) * x,
                y: above * low + below * high,
            }
        };
        let mut sum = pull(x - half);
        // The far corners are mostly out of reach.
        let is_far_near = (x + half).simd_lt(self.reach * CUT);
        if is_far_near.any() {
            sum = Vectors::chosen(is_far_near, sum.plus(pull(x + half)), sum);
        }
        let swapped = Vectors { x: sum.y, y: sum.x };
        let sum = Vectors::chosen(p.simd_ge(q), sum, swapped).times(self.stable);
        let signed = |v: f64x2, local: f64x2| local.simd_lt(f64x2::ZERO).select(-v, v);
        Vectors {
            x: signed(sum.x, self.local.x),
            y: signed(sum.y, self.local.y),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::force::Pair;
    use super::*;
    use crate::random::{Purpose, Random};

    #[test]
    fn lanes_have_the_bits_of_single_pairs() {
        let mut random = Random::new(1, Purpose::Placement, 0);
        let mut far = 0;
        for _ in 0..20_000 {
            let sizes = [10.0, [10.0, 8.0 + 4.0 * random.unit()][random.below(2)]];
            let mut axis = || {
                let turn = std::f64::consts::TAU * random.unit();
                let along = DVec2::new(libm::cos(turn), libm::sin(turn));
                [along, DVec2::X, DVec2::ZERO][random.below(20).saturating_sub(17)]
            };
            let axes = [axis(), axis(), axis()];
            let mut other = |axis| SeenSquare {
                axis,
                size: sizes[random.below(2)],
                way: 18.0 * DVec2::new(random.signed(), random.signed()),
            };
            let others = [other(axes[1]), other(axes[2])];
            let pairs = SquarePairs::new([(axes[0], sizes[0]); 2], others);
            let found = pairs.forces().into_iter().zip(pairs.potentials());
            for ((force, potential), other) in found.zip(others) {
                let pair = Pair::squares((axes[0], other.axis), (sizes[0], other.size));
                let wanted = pair.force(other.way);
                // Zeros may differ in sign, which no sum notices.
                assert_eq!(force, wanted, "{other:?}");
                assert_eq!(potential, pair.potential(other.way), "{other:?}");
                far += u32::from(wanted != DVec2::ZERO);
            }
        }
        assert!(far > 10_000);
    }
}
