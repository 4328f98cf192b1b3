//! A face's outline with holes, and its parts and complement as convex polygons.

use super::footprint::Footprint;
use crate::planar::{Delaunay, LineTriangulation, orientation};
use glam::DVec2;
use std::collections::BTreeMap;

/// Lines are triangulated at this scale, so that points are rounded to 6e-8 metres. Their own coordinates are then put
/// back. It is a power of two, so that the scale itself rounds nothing.
const SCALE: f64 = 256.0;

/// The outline of a face in (s, t): loops that do not cross, the face to the left of each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Region {
    /// Outer loops counter-clockwise, holes clockwise; curves as chords (metres).
    pub loops: Vec<Vec<DVec2>>,
}

impl Region {
    /// Whether a point lies inside; points on the outline may go to either side.
    pub fn contains(&self, p: DVec2) -> bool {
        let sides = self.sides().filter(|&[a, b]| crosses_ray(a, b, p));
        sides.count() % 2 == 1
    }

    /// The area, in square metres.
    pub fn area(&self) -> f64 {
        let twice = self.sides().map(|[a, b]| a.perp_dot(b));
        0.5 * twice.sum::<f64>()
    }

    /// The bounding box; none without corners.
    pub fn bounds(&self) -> Option<[DVec2; 2]> {
        let grow = |[low, high]: [DVec2; 2], [p, _]: [DVec2; 2]| [low.min(p), high.max(p)];
        self.loops.iter().flatten().map(|&p| [p, p]).reduce(grow)
    }

    /// All sides in their direction.
    pub fn sides(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        self.loops.iter().flat_map(|ring| {
            let last = ring.last().zip(ring.first()).map(|(&a, &b)| [a, b]);
            ring.windows(2).map(|pair| [pair[0], pair[1]]).chain(last)
        })
    }

    /// How far a ray goes from a place along a unit vector until it meets the border; none if it never does.
    /// Borders nearer than `skip` do not count (metres).
    pub fn ray(&self, from: DVec2, way: DVec2, skip: f64) -> Option<f64> {
        // Most sides lie off the ray's line: their places along it are not needed.
        let off = |p: DVec2| (p - from).perp_dot(way);
        let along = |p: DVec2| (p - from).dot(way);
        let places = self.sides().filter_map(|[a, b]| {
            let (off_a, off_b) = (off(a), off(b));
            let is_cut = (off_a > 0.0) != (off_b > 0.0);
            is_cut.then(|| along(a) + (along(b) - along(a)) * (off_a / (off_a - off_b)))
        });
        places.filter(|&x| x > skip).reduce(f64::min)
    }

    /// The region as convex polygons that do not overlap, and its complement in a box as others. A convex hole is one
    /// polygon. The box is the bounding box, wider by `margin` along s and t (metres, at least 0).
    pub fn convex_parts(&self, margin: DVec2) -> [Vec<Footprint>; 2] {
        let mut work = PartsWork::new(self, margin);
        loop {
            if let Some(parts) = work.advance(self, &mut { usize::MAX }) {
                return parts;
            }
        }
    }
}

/// The convex parts of a region and of its complement, made in slices: see [`Region::convex_parts`].
pub struct PartsWork {
    lines: Vec<[DVec2; 2]>,
    step: PartsStep,
}

/// The progress of the work.
enum PartsStep {
    /// The lines are triangulated.
    Lines(LineTriangulation),
    /// Triangles are merged.
    Merge(Pieces),
    /// Nothing is left.
    Done,
}

impl PartsWork {
    /// Begins with a region, in a box that is wider by `margin` along s and t (metres, at least 0).
    pub fn new(region: &Region, margin: DVec2) -> Self {
        let Some([low, high]) = region.bounds() else {
            let (lines, step) = (Vec::new(), PartsStep::Done);
            return Self { lines, step };
        };
        let (low, high) = (low - margin, high + margin);
        let frame = [
            low,
            DVec2::new(high.x, low.y),
            high,
            DVec2::new(low.x, high.y),
        ];
        let around = (0..4).map(|k| [frame[k], frame[(k + 1) % 4]]);
        let lines: Vec<[DVec2; 2]> = region.sides().chain(around).collect();
        let scaled = lines.iter().map(|line| line.map(|p| p * SCALE));
        let step = PartsStep::Lines(LineTriangulation::new(scaled, lines.len()));
        Self { lines, step }
    }

    /// Goes on with the same region. Each point, line or diagonal takes one off `amount`, and the work pauses when nothing is
    /// left of it. Returns the parts at the end, once.
    pub fn advance(&mut self, region: &Region, amount: &mut usize) -> Option<[Vec<Footprint>; 2]> {
        if let PartsStep::Lines(lines) = &mut self.step {
            if !lines.advance(amount) {
                return None;
            }
            if let PartsStep::Lines(lines) = std::mem::replace(&mut self.step, PartsStep::Done) {
                let pieces = Pieces::new(lines.finish(), &self.lines, |p| region.contains(p));
                self.step = PartsStep::Merge(pieces);
            }
        }
        if let PartsStep::Merge(pieces) = &mut self.step
            && !pieces.merge(amount)
        {
            return None;
        }
        match std::mem::replace(&mut self.step, PartsStep::Done) {
            PartsStep::Merge(pieces) => Some(pieces.parts()),
            _ => Some([Vec::new(), Vec::new()]),
        }
    }
}

/// Whether the ray from `p` along +s crosses a side; the upper end of a side does not belong to it.
fn crosses_ray(a: DVec2, b: DVec2, p: DVec2) -> bool {
    (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))
}

/// Convex pieces that are merged while they stay convex (Hertel, Mehlhorn 1983, Fast triangulation of simple
/// polygons).
struct Pieces {
    places: Vec<DVec2>,
    /// Corners of each piece, counter-clockwise; empty once it is part of another.
    rings: Vec<Vec<u32>>,
    /// Sides between two triangles that are no lines, each in one direction.
    diagonals: Vec<([u32; 2], [usize; 2])>,
    /// Whether each triangle lies inside of the region.
    is_inside: Vec<bool>,
    /// For each triangle, one whose piece it belongs to; the last of such a chain is itself.
    joined: Vec<usize>,
    /// How many diagonals have been tried.
    tried: usize,
}

impl Pieces {
    /// The triangles of a constrained triangulation of these lines, with the edges that these have become.
    fn new(
        (mesh, walls): (Delaunay, Vec<[u32; 2]>),
        lines: &[[DVec2; 2]],
        is_inside: impl Fn(DVec2) -> bool,
    ) -> Self {
        let key = |p: DVec2| p.to_array().map(|v| (v * 4096.0).round() as i64);
        // Rounding moves a point by less than a cell of this grid, so its own coordinates are in this cell or beside
        // it.
        let exact: BTreeMap<[i64; 2], DVec2> = lines
            .iter()
            .flatten()
            .map(|&p| (key(p * SCALE), p))
            .collect();
        use spade::Triangulation as _;
        let places = mesh.vertices().map(|v| {
            let p = DVec2::new(v.position().x, v.position().y);
            exact_near(&exact, key(p)).unwrap_or(p / SCALE)
        });
        let places: Vec<DVec2> = places.collect();
        let mut rings = Vec::new();
        let mut owners: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        for face in mesh.inner_faces() {
            let ring = face.vertices().map(|v| v.fix().index() as u32);
            for k in 0..3 {
                owners.insert([ring[k], ring[(k + 1) % 3]], rings.len());
            }
            rings.push(ring.to_vec());
        }
        let is_wall = |[a, b]: [u32; 2]| walls.binary_search(&[a.min(b), a.max(b)]).is_ok();
        let pairs = owners
            .iter()
            .filter(|&(&[a, b], _)| a < b && !is_wall([a, b]));
        let diagonals =
            pairs.filter_map(|(&[a, b], &one)| Some(([a, b], [one, *owners.get(&[b, a])?])));
        let mut pieces = Self {
            diagonals: diagonals.collect(),
            is_inside: Vec::new(),
            joined: (0..rings.len()).collect(),
            tried: 0,
            places,
            rings,
        };
        pieces.is_inside = pieces.sides_of(is_inside);
        pieces
    }

    /// The pieces inside of the region, and those outside.
    fn parts(self) -> [Vec<Footprint>; 2] {
        let mut parts = [Vec::new(), Vec::new()];
        for (ring, inside) in self.rings.iter().zip(self.is_inside) {
            let places: Vec<DVec2> = ring.iter().map(|&v| self.places[v as usize]).collect();
            parts[usize::from(!inside)].extend(Footprint::new(&places));
        }
        parts
    }

    fn middle(&self, ring: &[u32]) -> DVec2 {
        let sum: DVec2 = ring.iter().map(|&v| self.places[v as usize]).sum();
        sum / ring.len() as f64
    }

    /// Whether each piece lies inside, by one place of those that no line divides.
    fn sides_of(&self, is_inside: impl Fn(DVec2) -> bool) -> Vec<bool> {
        let mut beside = vec![Vec::new(); self.rings.len()];
        for (_, [one, other]) in &self.diagonals {
            beside[*one].push(*other);
            beside[*other].push(*one);
        }
        let mut found: Vec<Option<bool>> = vec![None; self.rings.len()];
        for first in 0..self.rings.len() {
            if found[first].is_some() {
                continue;
            }
            let side = Some(is_inside(self.middle(&self.rings[first])));
            let mut due = vec![first];
            while let Some(k) = due.pop() {
                if found[k] != side {
                    found[k] = side;
                    due.extend(&beside[k]);
                }
            }
        }
        found.into_iter().map(|side| side == Some(true)).collect()
    }

    /// Removes each diagonal whose pieces lie on one side and make a convex polygon together. Each takes one off `amount`,
    /// until nothing is left of it; true after the last one.
    fn merge(&mut self, amount: &mut usize) -> bool {
        while self.tried < self.diagonals.len() && *amount > 0 {
            let (side, owners) = self.diagonals[self.tried];
            *amount -= 1;
            self.tried += 1;
            let [one, other] = owners.map(|k| self.piece(k));
            if one == other || self.is_inside[one] != self.is_inside[other] {
                continue;
            }
            if let Some(ring) = self.union(side, one, other) {
                self.rings[one] = ring;
                self.rings[other].clear();
                self.joined[other] = one;
            }
        }
        self.tried == self.diagonals.len()
    }

    /// The piece that a triangle belongs to.
    fn piece(&self, mut k: usize) -> usize {
        while self.joined[k] != k {
            k = self.joined[k];
        }
        k
    }

    /// Two pieces as one, without the side between them; none if that is not convex.
    fn union(&self, [a, b]: [u32; 2], one: usize, other: usize) -> Option<Vec<u32>> {
        // The first piece from b round to a, then the second one from behind a to before b.
        let mut ring = from(&self.rings[one], b)?;
        let rest = from(&self.rings[other], a)?;
        ring.extend(&rest[1..rest.len() - 1]);
        let count = ring.len();
        let turn = |k: usize| {
            let corners = [k + count - 1, k, k + 1].map(|k| self.places[ring[k % count] as usize]);
            orientation(corners[0], corners[1], corners[2])
        };
        let ends = (0..count).filter(|&k| [a, b].contains(&ring[k]));
        ends.into_iter().all(|k| turn(k) >= 0.0).then_some(ring)
    }
}

/// A ring that begins at a corner.
fn from(ring: &[u32], corner: u32) -> Option<Vec<u32>> {
    let at = ring.iter().position(|&v| v == corner)?;
    Some([&ring[at..], &ring[..at]].concat())
}

/// The coordinates kept in a cell of the grid or in one beside it.
fn exact_near(exact: &BTreeMap<[i64; 2], DVec2>, [x, y]: [i64; 2]) -> Option<DVec2> {
    let offsets = [0, -1, 1];
    let cells = offsets
        .iter()
        .flat_map(|&i| offsets.iter().map(move |&j| [x + i, y + j]));
    cells.into_iter().find_map(|cell| exact.get(&cell).copied())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[(f64, f64)]) -> Vec<DVec2> {
        points.iter().map(|&p| p.into()).collect()
    }

    /// A wall with a window that has an arched head, and a door that cuts the outline.
    fn wall() -> Region {
        let outer = [
            (0.0, 0.0),
            (1.1, 0.0),
            (1.1, 2.05),
            (1.9, 2.05),
            (1.9, 0.0),
            (5.0, 0.0),
            (5.0, 3.0),
            (0.0, 3.0),
        ];
        let arch = (0..=12).map(|k| {
            let turn = std::f64::consts::PI * f64::from(k) / 12.0;
            DVec2::new(3.2 + 0.5 * libm::cos(turn), 1.7 + 0.5 * libm::sin(turn))
        });
        let mut hole: Vec<DVec2> = ring(&[(2.7, 0.9), (3.7, 0.9)])
            .into_iter()
            .chain(arch)
            .collect();
        hole.reverse();
        Region {
            loops: vec![ring(&outer), hole],
        }
    }

    #[test]
    fn parts_and_complement_fill_the_box_without_overlap() {
        let region = wall();
        let margin = DVec2::new(0.25, 0.5);
        let parts = region.convex_parts(margin);
        let [inside, outside] = parts
            .each_ref()
            .map(|list| list.iter().map(Footprint::area).sum::<f64>());
        assert!((inside - region.area()).abs() < 1e-9, "{inside}");
        let whole = (5.0 + 0.5) * (3.0 + 1.0);
        assert!((inside + outside - whole).abs() < 1e-9, "{outside}");
        let all: Vec<&Footprint> = parts.iter().flatten().collect();
        for (k, a) in all.iter().enumerate() {
            assert!(all[..k].iter().all(|b| a.shared_area(b) < 1e-9));
        }
    }

    #[test]
    fn slices_do_not_matter() {
        let corner = |k: usize| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / 200.0);
            (cos, sin)
        };
        let disc = Region {
            loops: vec![ring(&(0..200).map(corner).collect::<Vec<_>>())],
        };
        for (region, least) in [(wall(), 40), (disc, 600), (Region::default(), 1)] {
            let whole = region.convex_parts(DVec2::splat(0.5));
            let mut work = PartsWork::new(&region, DVec2::splat(0.5));
            let mut slices = 1;
            let parts = loop {
                match work.advance(&region, &mut { 1 }) {
                    Some(parts) => break parts,
                    None => slices += 1,
                }
            };
            assert_eq!(parts, whole);
            assert!(slices >= least, "{slices}");
        }
    }

    #[test]
    fn a_convex_hole_is_one_polygon_with_its_own_coordinates() {
        let region = wall();
        let [_, outside] = region.convex_parts(DVec2::splat(0.5));
        let corners = &region.loops[1];
        let hole = outside
            .iter()
            .find(|part| part.contains(DVec2::new(3.2, 1.5)))
            .unwrap();
        assert_eq!(hole.corners().len(), corners.len());
        assert!(hole.places().all(|p| corners.contains(&p)));
    }

    #[test]
    fn points_are_inside_or_outside() {
        let region = wall();
        let is_inside = |s, t| region.contains(DVec2::new(s, t));
        assert!(is_inside(0.5, 0.5) && is_inside(1.5, 2.5) && is_inside(4.9, 0.1));
        assert!(!is_inside(1.5, 1.0) && !is_inside(3.2, 1.0) && !is_inside(-0.1, 1.0));
        let ray = |s, t, way: DVec2| region.ray(DVec2::new(s, t), way, 1e-3).unwrap_or(f64::MAX);
        for (found, wanted) in [
            (ray(0.5, 1.0, DVec2::X), 0.6),
            (ray(2.5, 1.0, DVec2::NEG_X), 0.6),
            (ray(3.2, 0.5, DVec2::Y), 0.4),
            (ray(4.0, 1.5, DVec2::NEG_Y), 1.5),
        ] {
            assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
        }
        assert_eq!(region.ray(DVec2::new(6.0, 1.5), DVec2::X, 1e-3), None);
        assert_eq!(Region::default().convex_parts(DVec2::ONE), [vec![], vec![]]);
    }
}
