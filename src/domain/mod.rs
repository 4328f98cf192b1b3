//! The outline to be paved: islands and their holes, and the questions the later stages ask of it
//! (inside? how far is the boundary, and in which direction?).
//!
//! A ring inside an even number of other rings is an outer one, the rim of an island; inside an odd
//! number it is a hole. An island may lie in a hole of another. Nothing joins cells of two islands.
//!
//! All coordinates are picture units (pixels), x to the right, y down. An outer ring has a positive
//! shoelace area sum(x0 y1 - x1 y0) / 2 on these numbers (it runs clockwise on screen), holes a
//! negative one, so the paved side is always to the same hand of a segment: at its inward normal
//! (-dy, dx).
//!
//! ```
//! use bubblestone::domain::{Domain, Outline};
//! use glam::DVec2;
//!
//! // A square in a picture of 128, drawn the wrong way round.
//! let corners = [(14.0, 14.0), (14.0, 114.0), (114.0, 114.0), (114.0, 14.0)];
//! let rings = vec![corners.map(DVec2::from).to_vec()];
//! let drawn = Outline { rings, ..Outline::default() };
//! let (outline, _mended) = drawn.check(128.0).expect("no line crosses another");
//! let domain = Domain::from_checked(&outline);
//! assert_eq!(domain.area(), 10_000.0);
//!
//! let nearest = domain.nearest(DVec2::new(24.0, 64.0));
//! assert_eq!((nearest.distance, nearest.inward), (10.0, DVec2::X));
//! ```

mod candidates;
mod check;
mod clip;
mod crossing;
mod depth;
mod distance;
mod islands;
mod lines;
mod nesting;
mod parts;
mod ring;
mod segment_grid;
pub mod shape;
mod walls;

pub use check::{MAX_LINE_POINTS, MAX_POINTS, Ring, check_lines};
pub use distance::Nearest;
pub(crate) use ring::ring_contains;
pub use walls::{Projection, Walls};

pub use crate::planar::Space;
use candidates::CandidateGrid;
use glam::DVec2;
use islands::Islands;
use lines::Network;

/// Rings as they were given, unchecked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// The rings, outer ones and holes, not closed (the last point differs from the first).
    pub rings: Vec<Vec<DVec2>>,
    /// Constraint lines, which cells line up along: runs of points, closed where the last point is
    /// the first again. They may touch and cross the rings and each other; what lies outside does
    /// not count.
    pub lines: Vec<Vec<DVec2>>,
}

/// A checked outline with its look-up grid. See the module's doc for units and handedness.
#[derive(Clone, Debug)]
pub struct Domain {
    rings: Vec<Vec<DVec2>>,
    segments: Vec<[DVec2; 2]>,
    area: f64,
    /// The smallest and the largest corner of the box around it.
    bounds: (DVec2, DVec2),
    /// Nothing on a torus, which has no boundary.
    grid: Option<CandidateGrid>,
    space: Space,
    /// Nothing where there are no constraint lines: they cost nothing then.
    network: Option<Box<Network>>,
    /// Nothing where there is one island.
    islands: Option<Box<Islands>>,
}

impl Domain {
    /// Takes rings that are already checked: simple, disjoint, oriented as the module says. Rings of an
    /// unchecked [`Outline`] go through [`crate::domain::Outline::check`].
    pub fn from_checked(outline: &Outline) -> Self {
        let mut domain = Self::of_rings(outline.rings.clone(), None).with_lines(&outline.lines);
        domain.islands = Islands::new(&domain).map(Box::new);
        domain
    }

    /// One island, or several that are not told apart, without lines; or some rings of a `whole`, whose
    /// grid is fine enough for them.
    pub(super) fn of_rings(rings: Vec<Vec<DVec2>>, whole: Option<&Domain>) -> Self {
        let segments: Vec<[DVec2; 2]> = rings.iter().flat_map(|r| ring_segments(r)).collect();
        let area = rings.iter().map(|r| signed_area(r)).sum();
        let start = rings[0][0];
        let points = rings.iter().flatten();
        let bounds = points.fold((start, start), |(lo, hi), &p| (lo.min(p), hi.max(p)));
        let grid = whole.and_then(|whole| whole.grid.as_ref());
        let grid = Some(CandidateGrid::like(&segments, grid));
        Self {
            rings,
            segments,
            area,
            bounds,
            grid,
            space: Space::PLANE,
            network: None,
            islands: None,
        }
    }

    /// The whole picture of a side, periodic: its left edge is its right edge, its top its bottom.
    /// There are no rings, and the boundary is far away from everywhere. Lines that leave the picture
    /// come back in at the other edge; they must be checked.
    pub fn torus(side: f64, lines: &[Vec<DVec2>]) -> Self {
        Self {
            rings: Vec::new(),
            segments: Vec::new(),
            area: side * side,
            bounds: (DVec2::ZERO, DVec2::splat(side)),
            grid: None,
            space: Space::torus(side),
            network: None,
            islands: None,
        }
        .with_lines(lines)
    }

    pub(super) fn with_lines(mut self, lines: &[Vec<DVec2>]) -> Self {
        if !lines.is_empty() {
            self.network = Network::new(&self, lines).map(Box::new);
        }
        self
    }

    /// Where it lies: in the plane, or all over a torus.
    #[inline]
    pub fn space(&self) -> Space {
        self.space
    }

    /// The rings; none on a torus.
    pub fn rings(&self) -> &[Vec<DVec2>] {
        &self.rings
    }

    /// All boundary segments, ring after ring, each [from, to].
    pub fn segments(&self) -> &[[DVec2; 2]] {
        &self.segments
    }

    /// The paved area in square picture units.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The smallest and the largest corner of the box around the outline.
    #[inline]
    pub fn bounds(&self) -> (DVec2, DVec2) {
        self.bounds
    }

    /// Is a place inside the box around the outline, not on its edge?
    #[inline]
    pub(crate) fn is_in_box(&self, p: DVec2) -> bool {
        let (lo, hi) = self.bounds;
        p.cmpgt(lo).all() && p.cmplt(hi).all()
    }

    /// Is there a constraint line or the gap between two islands on the straight way between two
    /// places? On a torus as for [`Domain::crosses_line`].
    #[inline]
    pub fn is_parted(&self, a: DVec2, b: DVec2) -> bool {
        self.is_gap_between(a, b) || self.crosses_line(a, b)
    }
}

fn ring_segments(ring: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> {
    (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]])
}

/// Twice the signed area of the triangle a, b, c: positive where c lies at the inward hand of a to b.
pub fn cross(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// The shoelace area of a ring, positive where it runs clockwise on screen.
pub fn signed_area(ring: &[DVec2]) -> f64 {
    // Around the first point, so that rings far from the origin lose no digits.
    let Some(&origin) = ring.first() else {
        return 0.0;
    };
    let twice: f64 = ring
        .windows(2)
        .map(|w| (w[0] - origin).perp_dot(w[1] - origin))
        .sum();
    twice / 2.0
}
