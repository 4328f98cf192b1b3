//! The outline to be filled: islands with their holes, and the queries of later stages (is a point inside,
//! and how far and in which direction is the boundary).
//!
//! A ring inside an even number of other rings is an outer ring, the rim of an island; a ring inside an odd
//! number is a hole. An island may lie in a hole of another. Cells of two islands are never joined.
//!
//! All coordinates are picture units (pixels), x to the right, y down. An outer ring has a positive shoelace
//! area sum(x0 y1 - x1 y0) / 2 in these coordinates (it runs clockwise on screen) and a hole a negative one.
//! So the inside is always on the same side of a segment: at its inward normal (-dy, dx).
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
#[cfg(house)]
pub(crate) use crossing::{Contact, first_contact};
pub use distance::Nearest;
pub(crate) use ring::ring_contains;
#[cfg(house)]
pub(crate) use walls::SAME_WALL;
pub use walls::{Projection, Walls};

pub use crate::planar::Space;
use candidates::CandidateGrid;
use glam::DVec2;
use islands::Islands;
use lines::Network;

/// Rings and lines as given, unchecked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// The rings, outer ones and holes, not closed (the last point differs from the first).
    pub rings: Vec<Vec<DVec2>>,
    /// Constraint lines, which cells line up along: polylines, closed if the last point equals the first.
    /// They may touch and cross the rings and each other; parts outside are ignored.
    pub lines: Vec<Vec<DVec2>>,
}

/// A checked outline with its search grid. See the module's doc for units and handedness.
#[derive(Clone, Debug)]
pub struct Domain {
    rings: Vec<Vec<DVec2>>,
    segments: Vec<[DVec2; 2]>,
    area: f64,
    /// The corners of the bounding box, the smallest and the largest.
    bounds: (DVec2, DVec2),
    /// `None` on a torus, which has no boundary.
    grid: Option<CandidateGrid>,
    space: Space,
    /// `None` without constraint lines, so that they cost nothing.
    network: Option<Box<Network>>,
    /// `None` if there is one island.
    islands: Option<Box<Islands>>,
}

impl Domain {
    /// Takes rings that are already checked: simple, disjoint and oriented as the module says. Unchecked
    /// rings go through [`crate::domain::Outline::check`] first.
    pub fn from_checked(outline: &Outline) -> Self {
        let mut domain = Self::of_rings(outline.rings.clone(), None).with_lines(&outline.lines);
        domain.islands = Islands::new(&domain).map(Box::new);
        domain
    }

    /// A domain without lines, treated as one island. If the rings are only some rings of a `whole`, the search grid
    /// has the spacing of the whole one, which is fine enough.
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

    /// The whole picture as a torus: the left edge continues at the right one, the top at the bottom. It has
    /// no rings, and the boundary is far away everywhere. Lines that leave the picture re-enter at the
    /// opposite edge; they must be checked.
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

    /// The space of the domain: the plane, or a torus that the domain covers.
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

    /// The area inside, in square picture units.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The corners of the bounding box, the smallest and the largest.
    #[inline]
    pub fn bounds(&self) -> (DVec2, DVec2) {
        self.bounds
    }

    /// Whether a point is strictly inside the bounding box.
    #[inline]
    pub(crate) fn is_in_box(&self, p: DVec2) -> bool {
        let (lo, hi) = self.bounds;
        p.cmpgt(lo).all() && p.cmplt(hi).all()
    }

    /// Whether a constraint line or the gap between two islands separates two places. On a torus b has to be the image
    /// nearest to a, as for [`Domain::crosses_line`].
    #[inline]
    pub fn is_parted(&self, a: DVec2, b: DVec2) -> bool {
        self.is_gap_between(a, b) || self.crosses_line(a, b)
    }
}

fn ring_segments(ring: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> {
    (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]])
}

/// Twice the signed area of the triangle a, b, c: positive if c lies on the inward side of a to b.
pub fn cross(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// The shoelace area of a ring, positive where it runs clockwise on screen.
pub fn signed_area(ring: &[DVec2]) -> f64 {
    // Relative to the first point, so that rings far from the origin keep their digits.
    let Some(&origin) = ring.first() else {
        return 0.0;
    };
    let twice: f64 = ring
        .windows(2)
        .map(|w| (w[0] - origin).perp_dot(w[1] - origin))
        .sum();
    twice / 2.0
}
