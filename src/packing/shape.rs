//! The metric of a cell.
//!
//! Kind, size and aspect ratio define a metric, which measures distances between cells. They also define a frame in
//! which a stretched cell is a square; `force` evaluates the corner potentials there. Only the damping (`integrate`)
//! and the thresholds of the population depend on the kind itself.

use super::Particle;
use super::cell_fields::CellFields;
use super::transport::ParallelTransport;
use crate::field::CellKind;
use crate::order::{greater, lesser};
use glam::DVec2;
use wide::f64x2;

/// End of the bubble force, in stable distances.
pub(super) const CUT: f64 = 1.5;

/// A cell's kind, direction, size and aspect ratio, without its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CellShape {
    kind: CellKind,
    axis: DVec2,
    pub size: f64,
    /// The root of the aspect ratio; 1 if the direction field vanishes, so that there is nothing to stretch
    /// along.
    pub root: f64,
    /// 1 over the root.
    per_root: f64,
}

const EDGES: &[[f64; 2]] = &[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];

const SIN_60: f64 = 0.866_025_403_784_438_6;
const AROUND: &[[f64; 2]] = &[
    [1.0, 0.0],
    [0.5, SIN_60],
    [-0.5, SIN_60],
    [-1.0, 0.0],
    [-0.5, -SIN_60],
    [0.5, -SIN_60],
];

/// Limit of a corner's half extent towards a wall, in half extents of the cell's ellipse: a turned square or
/// rectangle may poke its corner into the wall.
const POKE: f64 = 1.15;

impl Particle {
    /// The cell's ring, scaled, clockwise on screen: its four corners, or this many points of its ellipse.
    pub fn ring(&self, scale: f64, points: u32) -> Vec<DVec2> {
        let (e, f) = self.half_axes();
        let (e, f) = (scale * e, scale * f);
        let around = |k: u32| {
            let turn = std::f64::consts::TAU * f64::from(k) / f64::from(points);
            self.centre + e * libm::cos(turn) + f * libm::sin(turn)
        };
        if self.kind.has_corners() {
            return [-e - f, e - f, e + f, f - e]
                .map(|c| self.centre + c)
                .to_vec();
        }
        (0..points).map(around).collect()
    }

    /// The distance of an offset from the centre over the distance of the edge in that direction: 0 at the
    /// centre, 1 on the edge.
    pub(crate) fn relative_radius(&self, way: DVec2) -> f64 {
        let (e, f) = self.half_axes();
        let local = DVec2::new(
            way.dot(e) / e.length_squared(),
            way.dot(f) / f.length_squared(),
        );
        match self.kind.has_corners() {
            true => local.abs().max_element(),
            false => local.length(),
        }
    }

    /// Its longer side.
    pub(crate) fn length(&self) -> f64 {
        CellShape::of(self).length()
    }

    /// The distance to another cell at an offset, in stable distances of the two.
    pub(crate) fn normalised_distance(&self, other: &Particle, way: DVec2) -> f64 {
        CellShape::of(self).normalised_distance(&CellShape::of(other), way)
    }

    /// Centres of neighbours of the same kind and size that touch the cell: at its four edges, or six around it.
    pub(crate) fn places(&self) -> impl Iterator<Item = DVec2> {
        let (centre, size) = (self.centre, self.size);
        CellShape::of(self)
            .places()
            .map(move |place| centre + size * place)
    }
}

impl<P> Particle<P> {
    /// Half its sides, along its axis and across.
    pub(crate) fn half_axes(&self) -> (DVec2, DVec2) {
        let root = CellShape::of(self).root;
        let e = self.axis.normalize_or(DVec2::X) * (0.5 * self.size);
        (e * root, e.perp() / root)
    }
}

impl CellShape {
    /// The shape of a cell at this place, by the fields.
    pub fn at<A: CellFields>(asked: A, p: A::Place) -> Self {
        let kind = asked.kind(p);
        Self::new(kind, asked.direction(p), asked.size(p), asked.aspect(p))
    }

    /// The metric only: omits the axis of unstretched cells, which is quicker.
    pub fn metric_at<A: CellFields>(asked: A, p: A::Place) -> Self {
        let kind = asked.kind(p);
        if kind.is_stretched() {
            Self::at(asked, p)
        } else {
            Self::new(kind, DVec2::ZERO, asked.size(p), 1.0)
        }
    }

    /// The shape in the frame of another place.
    #[inline(always)]
    pub fn seen(self, turn: impl ParallelTransport) -> Self {
        Self {
            axis: turn.apply(self.axis),
            ..self
        }
    }

    #[inline]
    fn new(kind: CellKind, axis: DVec2, size: f64, aspect: f64) -> Self {
        let is_stretched = kind.is_stretched() && axis != DVec2::ZERO;
        let root = if is_stretched { aspect.sqrt() } else { 1.0 };
        Self {
            kind,
            axis,
            size,
            root,
            per_root: if is_stretched { 1.0 / root } else { 1.0 },
        }
    }

    #[inline]
    pub fn of<P>(particle: &Particle<P>) -> Self {
        let &Particle {
            kind,
            axis,
            size,
            aspect,
            ..
        } = particle;
        Self::new(kind, axis, size, aspect)
    }

    pub fn kind(&self) -> CellKind {
        self.kind
    }

    /// The length of its longer side.
    pub fn length(&self) -> f64 {
        self.size * self.root
    }

    /// The length of a vector, in diameters of the cell's ellipse along that vector.
    pub fn cells_along(&self, r: DVec2) -> f64 {
        self.square_along(r).sqrt() / self.size
    }

    /// The squared length of a vector in the frame in which the cell is as wide as long.
    #[inline]
    fn square_along(&self, r: DVec2) -> f64 {
        if self.root == 1.0 {
            return r.length_squared();
        }
        let local = DVec2::new(self.axis.dot(r), self.axis.perp_dot(r));
        (local * DVec2::new(self.per_root, self.root)).length_squared()
    }

    /// Sets the axis.
    pub fn turn(&mut self, axis: DVec2) {
        self.axis = axis;
    }

    /// Offsets of neighbours that touch the cell, in stable distances: at its four edges, or six around if it
    /// has no corners.
    pub fn places(self) -> impl Iterator<Item = DVec2> {
        let e = self.axis.normalize_or(DVec2::X);
        let (along, across) = (e * self.root, e.perp() / self.root);
        let places = if self.kind.has_corners() {
            EDGES
        } else {
            AROUND
        };
        places.iter().map(move |&[x, y]| along * x + across * y)
    }

    /// The extent of its ellipse along a unit vector.
    pub fn extent(&self, along: DVec2) -> f64 {
        if self.root == 1.0 {
            return self.size;
        }
        let (x, y) = (self.axis.dot(along), self.axis.perp_dot(along));
        self.size * DVec2::new(x * self.root, y / self.root).length()
    }

    /// Half its extent along a unit vector. For a cell with corners it is at most `POKE` times the half
    /// extent of its ellipse, so that a turned cell may poke a corner into a wall.
    pub fn half_extent(&self, along: DVec2) -> f64 {
        let round = 0.5 * self.extent(along);
        if !self.kind.has_corners() || self.axis == DVec2::ZERO {
            return round;
        }
        let (x, y) = (self.axis.dot(along).abs(), self.axis.perp_dot(along).abs());
        let support = 0.5 * self.size * (x * self.root + y / self.root);
        lesser(support, POKE * round)
    }

    /// Whether the forces of two cells could reach each other after they approach by `margin`. A square has the
    /// reach `square`, in stable distances.
    #[inline]
    pub fn may_touch(&self, other: &CellShape, r: DVec2, (square, margin): (f64, f64)) -> bool {
        let reach = if self.kind.has_corners() || other.kind.has_corners() {
            square
        } else {
            CUT
        };
        let within = reach * 0.5 * (self.length() + other.length()) + margin;
        if r.length_squared() >= within * within {
            return false;
        }
        let stable = 0.5 * (self.size + other.size);
        (self.root == 1.0 && other.root == 1.0)
            || self.normalised_distance(other, r) * stable < reach * stable + margin
    }

    /// Whether two cells at the offset `r` are nearer than `w` stable distances.
    #[inline]
    pub fn is_closer(&self, other: &CellShape, r: DVec2, w: f64) -> bool {
        if self.root == 1.0 && other.root == 1.0 {
            let reach = w * (0.5 * (self.size + other.size));
            return r.length_squared() < reach * reach;
        }
        self.normalised_distance(other, r) < w
    }

    /// The distance of two cells over their stable distance: w of eq. (2), by effective distances (Itoh,
    /// Miyata, Shimada 2003, section 5.1). The stable distance is the sum of the two lengths that the cells'
    /// ellipses cut out of the line between the centres.
    #[inline]
    pub fn normalised_distance(&self, other: &CellShape, r: DVec2) -> f64 {
        if self.root == 1.0 && other.root == 1.0 {
            return r.length() / (0.5 * (self.size + other.size));
        }
        // `cells_along` of both cells at once.
        let squares = f64x2::new([self.square_along(r), other.square_along(r)]);
        let [a, b] = (squares.sqrt() / f64x2::new([self.size, other.size])).to_array();
        // Each ellipse cuts half a diameter out of the line: 1 / w = 1 / (2 a) + 1 / (2 b).
        2.0 * a * b / greater(a + b, f64::MIN_POSITIVE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_keep_the_area_whatever_the_aspect() {
        let particle = |kind, aspect| Particle {
            id: 0,
            centre: DVec2::new(3.0, 4.0),
            kind,
            size: 10.0,
            aspect,
            axis: DVec2::new(0.6, 0.8),
            fixed: false,
        };
        for (kind, aspect, area) in [
            (CellKind::Square, 1.0, 100.0),
            (CellKind::Rectangle, 3.0, 100.0),
            (CellKind::Circle, 1.0, 78.54),
            (CellKind::Ellipse, 3.0, 78.54),
        ] {
            let cell = particle(kind, aspect);
            let ring = cell.ring(1.0, 256);
            let found = crate::domain::signed_area(&ring);
            assert!((found - area).abs() < 0.02, "{kind:?}: {found}");
            let along = |p: &DVec2| (*p - cell.centre).dot(cell.axis).abs();
            let reach = ring.iter().map(along).fold(0.0, f64::max);
            assert!((reach - 5.0 * aspect.sqrt()).abs() < 1e-9, "{kind:?}");
        }
    }
}
