//! Inside test and exact nearest boundary point, by a grid of candidate segments.

use super::candidates::CandidateGrid;
use super::islands::Islands;
use super::lines::Network;
use super::{Outline, signed_area};
use crate::order;
use crate::planar::Space;
use glam::DVec2;

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

/// How far the boundary is where there is none.
const NOWHERE: f64 = 1e30;

/// Places along a side of the raster on which the deepest one is looked for, a power of two.
const RASTER: u32 = 64;
/// What rounding may do to a distance (picture units), and more.
const ROUNDING: f64 = 1e-9;

/// The boundary as seen from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Distance to the boundary, positive inside, negative outside.
    pub distance: f64,
    /// The nearest point of the boundary.
    pub point: DVec2,
    /// Unit vector along which `distance` grows.
    pub inward: DVec2,
    /// Unit tangent of the nearest segment, the paved side at its right on screen.
    pub tangent: DVec2,
    /// Index of the nearest segment in [`Domain::segments`].
    pub segment: usize,
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

    /// What lies inside of the constraint lines: each a run of points, closed where the first is
    /// repeated at the end. Lines meet and touch the outline only at points of these.
    pub fn lines(&self) -> &[Vec<DVec2>] {
        self.network.as_ref().map_or(&[], |n| &n.lines)
    }

    /// The segments of [`Domain::lines`], line after line.
    pub fn line_segments(&self) -> &[[DVec2; 2]] {
        self.network.as_ref().map_or(&[], |n| &n.segments)
    }

    /// Where constraint lines meet the outline: the number of the outline's segment, and the place.
    pub fn touches(&self) -> &[(usize, DVec2)] {
        self.network.as_ref().map_or(&[], |n| &n.touches)
    }

    /// The nearest place of a constraint line: `distance` is positive on both sides and `inward`
    /// points away from the line, `segment` counts [`Domain::line_segments`]. Nothing without lines.
    pub fn nearest_line(&self, p: DVec2) -> Option<Nearest> {
        let network = self.network.as_ref()?;
        let wrapped = self.space.wrap(p);
        let (square, point, segment) = network.nearest(wrapped);
        let [a, b] = network.images[segment];
        let (distance, tangent) = (square.sqrt(), (b - a).normalize());
        let inward = if distance > 1e-9 {
            (wrapped - point) / distance
        } else {
            tangent.perp()
        };
        Some(Nearest {
            distance,
            point: point + (p - wrapped),
            inward,
            tangent,
            segment: segment % network.segments.len(),
        })
    }

    /// Does the straight way from a to b cross a constraint line? On a torus b is the image that is
    /// meant ([`Space::shortest`]), at most half a side away.
    #[inline]
    pub fn crosses_line(&self, a: DVec2, b: DVec2) -> bool {
        let Some(network) = &self.network else {
            return false;
        };
        let from = self.space.wrap(a);
        network.crosses(from, b - (a - from))
    }

    /// The islands, each as a domain of its own with the constraint lines inside; from the top, at equal
    /// heights from the left. Where there is one it is this domain itself.
    pub fn islands(&self) -> &[Domain] {
        match &self.islands {
            Some(islands) => &islands.domains,
            None => std::slice::from_ref(self),
        }
    }

    /// The number of the island that a point lies in; outside, of the nearest.
    pub fn island(&self, p: DVec2) -> usize {
        let islands = self.islands.as_ref();
        islands.map_or(0, |i| i.of[self.nearest(p).segment] as usize)
    }

    /// The middle of each island that holds none of these places.
    pub(crate) fn empty_middles(&self, places: &[DVec2]) -> Vec<DVec2> {
        let mut empty = vec![true; self.islands().len()];
        for &p in places {
            empty[self.island(p)] = false;
        }
        let islands = self.islands().iter().zip(empty);
        let empty = islands.filter_map(|(island, empty)| empty.then_some(island));
        empty.filter_map(Self::deepest).collect()
    }

    /// The island of a segment of the outline.
    pub(super) fn island_of(&self, segment: usize) -> u32 {
        self.islands.as_ref().map_or(0, |i| i.of[segment])
    }

    /// Do two places lie on different islands?
    #[inline]
    pub fn is_gap_between(&self, a: DVec2, b: DVec2) -> bool {
        let islands = self.islands.as_ref();
        islands.is_some_and(|i| i.is_near(a, b) && self.island(a) != self.island(b))
    }

    /// Is there a constraint line or the gap between two islands on the straight way between two
    /// places? On a torus as for [`Domain::crosses_line`].
    #[inline]
    pub fn is_parted(&self, a: DVec2, b: DVec2) -> bool {
        self.is_gap_between(a, b) || self.crosses_line(a, b)
    }

    /// The segment of a constraint line that the straight way from a to b crosses first.
    pub(crate) fn line_between(&self, a: DVec2, b: DVec2) -> Option<[DVec2; 2]> {
        let network = self.network.as_ref()?;
        let from = self.space.wrap(a);
        let shift = a - from;
        let index = network.first_crossed(from, b - shift)?;
        Some(network.images[index].map(|p| p + shift))
    }

    /// How many parts there are: the islands, and what constraint lines cut them into.
    pub fn parts(&self) -> usize {
        let network = self.network.as_ref();
        network.map_or(self.islands().len(), |n| n.parts.count().max(1))
    }

    /// The part that a point lies in, numbered from 0 by their topmost points, at equal heights from
    /// the left. A point on a line counts to the first part there, one outside to the nearest.
    pub fn part(&self, p: DVec2) -> usize {
        let Some(network) = &self.network else {
            return self.island(p);
        };
        let p = self.space.wrap(p);
        if let Some(part) = network.parts.at(p) {
            return part;
        }
        let near = self.nearest(p);
        let inside = [1e-3, 1e-2, 0.1].map(|step| near.point + step * near.inward);
        inside
            .into_iter()
            .find_map(|q| network.parts.at(q))
            .unwrap_or(0)
    }

    /// Adds the constraint lines' segments, with their images on a torus, to a list of walls; gives
    /// for each whether its ends lie on the outline.
    pub(super) fn line_walls(&self, walls: &mut Vec<[DVec2; 2]>) -> Vec<[bool; 2]> {
        let Some(network) = &self.network else {
            return Vec::new();
        };
        walls.extend(&network.images);
        let on_outline = |p: DVec2| network.touches.iter().any(|&(_, at)| at == p);
        let ends = network.images.iter().map(|s| s.map(on_outline));
        ends.collect()
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

    /// How far one can go from a place of the boundary along its inward normal, `most` at the farthest,
    /// until another place of the boundary is nearer: up to the medial axis.
    pub(crate) fn medial_depth(&self, place: DVec2, inward: DVec2, most: f64) -> f64 {
        let stays = |t: f64| self.nearest(place + inward * t).distance >= 0.99 * t;
        if stays(most) {
            return most;
        }
        let (mut low, mut high) = (0.0, most);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            if stays(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }

    /// The innermost place of a coarse raster: where the only cell of a narrow island goes.
    pub(crate) fn deepest(&self) -> Option<DVec2> {
        let (lo, hi) = self.bounds();
        let step = (hi - lo) / f64::from(RASTER);
        // A square of places: its first column and row, how many along a side, and what is in its middle.
        let square = |column: u32, row: u32, side: u32| {
            let at = |k: u32| f64::from(k) + f64::from(side) / 2.0;
            let middle = lo + step * DVec2::new(at(column), at(row));
            (column, row, side, middle, self.nearest(middle).distance)
        };
        let mut best = (0.0, 0, None);
        let mut open = vec![square(0, 0, RASTER)];
        while let Some((column, row, side, middle, depth)) = open.pop() {
            // Nowhere is it deeper than here by more than the way there.
            let most = depth + step.length() * f64::from(side - 1) / 2.0;
            if most + ROUNDING < best.0 {
                continue;
            }
            if side > 1 {
                let half = side / 2;
                let corners = [(half, half), (0, half), (half, 0), (0, 0)];
                let mut four = corners.map(|(x, y)| square(column + x, row + y, half));
                order::sort(&mut four, |&(_, _, _, _, depth)| (order::rank(depth), 0));
                open.extend(four);
                continue;
            }
            let index = row * RASTER + column;
            // Of equal ones the first, row by row.
            if depth > best.0 || (depth == best.0 && index < best.1) {
                best = (depth, index, Some(middle));
            }
        }
        best.2
    }

    /// Is the point inside? Points on the boundary may count either way.
    pub fn contains(&self, p: DVec2) -> bool {
        self.nearest(p).distance > 0.0
    }

    /// The exact nearest boundary point; on a torus the boundary is very far away.
    pub fn nearest(&self, p: DVec2) -> Nearest {
        let Some(grid) = &self.grid else {
            return Nearest {
                distance: NOWHERE,
                point: p - DVec2::X * NOWHERE,
                inward: DVec2::X,
                tangent: DVec2::NEG_Y,
                segment: 0,
            };
        };
        let (square, point, segment) = grid.nearest(&self.segments, p);
        let [a, b] = self.segments[segment];
        let tangent = (b - a).normalize();
        let inside = self.side(p, segment, point);
        let distance = square.sqrt();
        let away = if distance > 1e-9 {
            (p - point) / distance
        } else {
            tangent.perp()
        };
        let sign = if inside { 1.0 } else { -1.0 };
        Nearest {
            distance: sign * distance,
            point,
            inward: if distance > 1e-9 { sign * away } else { away },
            tangent,
            segment,
        }
    }

    /// Which side of the boundary, by the nearest segment; at a corner by both segments that meet.
    fn side(&self, p: DVec2, segment: usize, foot: DVec2) -> bool {
        let [a, b] = self.segments[segment];
        let side = (b - a).perp_dot(p - a);
        let ends = foot == a || foot == b;
        if !ends {
            return side > 0.0;
        }
        let (before, after) = self.around(segment, foot == a);
        let ([a0, corner], [_, b1]) = (before, after);
        let (u, v) = (corner - a0, b1 - corner);
        let (su, sv) = (u.perp_dot(p - corner), v.perp_dot(p - corner));
        if u.perp_dot(v) >= 0.0 {
            su > 0.0 && sv > 0.0
        } else {
            su > 0.0 || sv > 0.0
        }
    }

    /// The two segments that meet at the start (or the end) of a segment, in ring order.
    fn around(&self, segment: usize, at_start: bool) -> ([DVec2; 2], [DVec2; 2]) {
        let mut first = 0;
        for ring in &self.rings {
            if segment < first + ring.len() {
                let (k, n) = (segment - first, ring.len());
                let other = if at_start {
                    (k + n - 1) % n
                } else {
                    (k + 1) % n
                };
                let (this, other) = (self.segments[segment], self.segments[first + other]);
                return if at_start {
                    (other, this)
                } else {
                    (this, other)
                };
            }
            first += ring.len();
        }
        unreachable!("a segment belongs to a ring")
    }
}

fn ring_segments(ring: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> {
    (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    fn square_with_hole() -> Domain {
        let p = |x: f64, y: f64| DVec2::new(x, y);
        Domain::from_checked(&Outline {
            rings: vec![
                vec![p(0., 0.), p(100., 0.), p(100., 100.), p(0., 100.)],
                vec![p(40., 40.), p(40., 60.), p(60., 60.), p(60., 40.)],
            ],
            ..Outline::default()
        })
    }

    #[test]
    fn distance_is_signed_and_exact() {
        let domain = square_with_hole();
        assert_eq!(domain.area(), 9600.0);
        let near = domain.nearest(DVec2::new(10.0, 50.0));
        assert_eq!(near.distance, 10.0);
        assert_eq!(near.inward, DVec2::X);
        assert_eq!(domain.nearest(DVec2::new(50.0, 45.0)).distance, -5.0);
        assert_eq!(domain.nearest(DVec2::new(-3.0, -4.0)).distance, -5.0);
        assert_eq!(domain.nearest(DVec2::new(37.0, 36.0)).distance, 5.0);
        assert_eq!(domain.nearest(DVec2::new(-300.0, 50.0)).distance, -300.0);
    }

    #[test]
    fn on_a_torus_lines_part_what_the_way_to_an_image_crosses() {
        let p = |x: f64, y: f64| DVec2::new(x, y);
        let torus = Domain::torus(100.0, &[vec![p(50.0, 5.0), p(50.0, 95.0)]]);
        assert!(torus.crosses_line(p(45.0, 20.0), p(55.0, 20.0)));
        assert!(torus.crosses_line(p(145.0, 20.0), p(155.0, 20.0)));
        let (a, b) = (p(4.0, 20.0), p(96.0, 20.0));
        assert!(!torus.crosses_line(a, a + torus.space().shortest(b - a)));
        assert_eq!(torus.line_between(a, p(-4.0, 20.0)), None);
        let [a, b] = torus.line_between(p(145.0, 20.0), p(155.0, 20.0)).unwrap();
        assert_eq!((a.x, b.x), (150.0, 150.0));
    }

    #[test]
    fn inward_points_to_growing_distance() {
        let domain = square_with_hole();
        for k in 0..400 {
            let p = DVec2::new((k * 37 % 113) as f64 - 6.3, (k * 53 % 109) as f64 - 4.1);
            let near = domain.nearest(p);
            let further = domain.nearest(p + 1e-4 * near.inward);
            assert!(further.distance > near.distance, "{p}");
        }
    }

    #[test]
    fn the_deepest_place_is_that_of_the_whole_raster() {
        for seed in 0..40 {
            let mut random = Random::new(seed, Purpose::Placement, 0);
            let corners = 3 + random.below(9);
            // Sometimes even, where many places are equally deep.
            let spread = [0.0, 40.0][random.below(2)];
            let ring = (0..corners).map(|k| {
                let turn = std::f64::consts::TAU * k as f64 / corners as f64;
                let radius = 50.0 - spread * random.unit();
                DVec2::new(
                    60.0 + radius * libm::cos(turn),
                    60.0 + radius * libm::sin(turn),
                )
            });
            let domain = Domain::of_rings(vec![ring.collect()], None);
            let (lo, hi) = domain.bounds();
            let raster = f64::from(RASTER);
            let (mut most, mut place) = (0.0, None);
            for k in 0..RASTER * RASTER {
                let at = DVec2::new(f64::from(k % RASTER) + 0.5, f64::from(k / RASTER) + 0.5);
                let p = lo + (hi - lo) * (at / raster);
                let depth = domain.nearest(p).distance;
                if depth > most {
                    (most, place) = (depth, Some(p));
                }
            }
            assert_eq!(domain.deepest(), place, "{corners} corners of seed {seed}");
        }
    }
}
