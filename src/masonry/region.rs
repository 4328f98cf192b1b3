//! A face's outline with holes, and its parts and complement as convex polygons.

use super::footprint::Footprint;
use super::pieces::{Pieces, SCALE};
use crate::planar::LineTriangulation;
use glam::DVec2;

/// Rectangles with a side up to this are triangulated, as rounding might join their corners (metres).
const PLAIN: f64 = 0.01;

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

    /// The region as a single convex part, if it is a rectangle along s and t. The part begins with the loop's third
    /// corner, as it would after a triangulation: that merges the two triangles beside the diagonal from the first
    /// corner.
    fn rectangle(&self) -> Option<Footprint> {
        let [low, high] = self.bounds()?;
        let [ring] = &self.loops[..] else { return None };
        let &[a, b, c, d] = &ring[..] else {
            return None;
        };
        let along = |[a, b, c, d]: [f64; 4]| a == b && c == d;
        let is_right = along([a.y, b.y, c.y, d.y]) && along([b.x, c.x, a.x, d.x])
            || along([a.x, b.x, c.x, d.x]) && along([b.y, c.y, a.y, d.y]);
        let is_left = (b - a).perp_dot(c - b) > 0.0;
        let is_wide = (high - low).min_element() > PLAIN;
        let corners = [c, d, a, b].map(|p| DVec2::select(p.cmpeq(low), low, high));
        let part = Footprint::new(&corners).ok();
        part.filter(|_| is_right && is_left && is_wide)
    }

    /// All sides, from start to end in the direction of their loops.
    pub fn sides(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        self.loops.iter().flat_map(|ring| {
            let last = ring.last().zip(ring.first()).map(|(&a, &b)| [a, b]);
            ring.windows(2).map(|pair| [pair[0], pair[1]]).chain(last)
        })
    }

    /// How far a ray goes from a place along a unit vector until it meets the border; none if it never does.
    /// Borders nearer than `skip` do not count (metres).
    pub fn ray(&self, from: DVec2, way: DVec2, skip: f64) -> Option<f64> {
        // Most sides do not cross the ray's line, so their places along it are found only when needed.
        let off = |p: DVec2| (p - from).perp_dot(way);
        let along = |p: DVec2| (p - from).dot(way);
        let places = self.sides().filter_map(|[a, b]| {
            let (off_a, off_b) = (off(a), off(b));
            let is_cut = (off_a > 0.0) != (off_b > 0.0);
            is_cut.then(|| along(a) + (along(b) - along(a)) * (off_a / (off_a - off_b)))
        });
        places.filter(|&x| x > skip).reduce(f64::min)
    }

    /// Convex polygons that do not overlap: those of the region, then those of its complement in a box. A convex hole
    /// is one polygon. The box is the bounding box, wider by `margin` along s and t (metres, at least 0).
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
    /// The region is a single part, without a margin.
    Plain(Footprint),
    /// The lines are being triangulated.
    Lines(LineTriangulation),
    /// Triangles are being merged.
    Merge(Pieces),
    /// Nothing is left.
    Done,
}

impl PartsWork {
    /// Begins with a region, in a box that is wider by `margin` along s and t (metres, at least 0).
    pub fn new(region: &Region, margin: DVec2) -> Self {
        match region.rectangle().filter(|_| margin == DVec2::ZERO) {
            Some(part) => Self {
                lines: Vec::new(),
                step: PartsStep::Plain(part),
            },
            None => Self::triangulated(region, margin),
        }
    }

    /// Begins with the triangulation of the region's sides and of the box around it.
    fn triangulated(region: &Region, margin: DVec2) -> Self {
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

    /// Goes on with the same region. Each point, line or diagonal takes one off `amount`, and the work pauses at 0.
    /// Returns the parts at the end, once.
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
            PartsStep::Plain(part) => Some([vec![part], Vec::new()]),
            _ => Some([Vec::new(), Vec::new()]),
        }
    }
}

/// Whether the ray from `p` along +s crosses a side; the upper end of a side does not belong to it.
fn crosses_ray(a: DVec2, b: DVec2, p: DVec2) -> bool {
    (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))
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

    /// The parts of a region by way of a triangulation, even if it is a rectangle.
    fn triangulated(region: &Region) -> [Vec<Footprint>; 2] {
        let mut work = PartsWork::triangulated(region, DVec2::ZERO);
        let parts = work.advance(region, &mut { usize::MAX });
        parts.expect("parts")
    }

    #[test]
    fn rectangles_have_the_part_of_their_triangulation() {
        let mut random = crate::random::Random::new(1, crate::random::Purpose::Scatter, 0);
        for k in 0..200 {
            let [x, y] = [0; 2].map(|_| 9.0 * random.signed());
            let [w, h] = [0; 2].map(|_| 0.02 + 5.0 * random.unit() * random.unit());
            let mut corners = ring(&[(x, y), (x + w, y), (x + w, y + h), (x, y + h)]);
            corners.rotate_left(k % 4);
            let region = Region {
                loops: vec![corners],
            };
            let parts = region.convex_parts(DVec2::ZERO);
            assert!(region.rectangle().is_some() && parts == triangulated(&region));
        }
        // A hole, and a turned square.
        let mut hole = ring(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
        hole.reverse();
        let turned = ring(&[(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)]);
        for corners in [hole, turned] {
            let region = Region {
                loops: vec![corners],
            };
            assert_eq!(region.rectangle(), None);
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
