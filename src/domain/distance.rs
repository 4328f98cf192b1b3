//! Inside test and exact nearest boundary point, by a grid of candidate segments.

use super::{Outline, signed_area};
use glam::DVec2;

/// A checked outline with its look-up grid. See the module's doc for units and handedness.
#[derive(Clone, Debug)]
pub struct Domain {
    rings: Vec<Vec<DVec2>>,
    segments: Vec<[DVec2; 2]>,
    area: f64,
    grid: CandidateGrid,
}

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
    /// Takes rings that are already checked: simple, disjoint, holes inside, oriented as the module
    /// says. Rings of an unchecked [`Outline`] go through [`crate::domain::Outline::check`].
    pub fn from_checked(outline: &Outline) -> Self {
        let mut rings = vec![outline.outer.clone()];
        rings.extend(outline.holes.iter().cloned());
        let segments: Vec<[DVec2; 2]> = rings.iter().flat_map(|r| ring_segments(r)).collect();
        let area = rings.iter().map(|r| signed_area(r)).sum();
        let grid = CandidateGrid::new(&segments);
        Self {
            rings,
            segments,
            area,
            grid,
        }
    }

    /// The rings, the outer one first.
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
    pub fn bounds(&self) -> (DVec2, DVec2) {
        self.rings[0]
            .iter()
            .fold((self.rings[0][0], self.rings[0][0]), |(lo, hi), &p| {
                (lo.min(p), hi.max(p))
            })
    }

    /// Is the point inside? Points on the boundary may count either way.
    pub fn contains(&self, p: DVec2) -> bool {
        self.nearest(p).distance > 0.0
    }

    /// The exact nearest boundary point.
    pub fn nearest(&self, p: DVec2) -> Nearest {
        let mut best = (f64::INFINITY, DVec2::ZERO, 0usize);
        for &index in self.grid.candidates(p) {
            let [a, b] = self.segments[index as usize];
            let point = closest_on_segment(p, a, b);
            let square = point.distance_squared(p);
            if square < best.0 {
                best = (square, point, index as usize);
            }
        }
        let (square, point, segment) = best;
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

/// The point of the segment a to b nearest to p.
pub(crate) fn closest_on_segment(p: DVec2, a: DVec2, b: DVec2) -> DVec2 {
    let ab = b - a;
    let square = ab.length_squared();
    if square == 0.0 {
        return a;
    }
    let t = (p - a).dot(ab) / square;
    if t <= 0.0 {
        a
    } else if t >= 1.0 {
        b
    } else {
        a + ab * t
    }
}

/// For each square of a grid, the segments that can be the nearest to some point of it: those not
/// farther from its middle than the nearest one by more than the square's diagonal.
#[derive(Clone, Debug)]
struct CandidateGrid {
    origin: DVec2,
    step: f64,
    columns: usize,
    rows: usize,
    start: Vec<u32>,
    list: Vec<u32>,
    all: Vec<u32>,
}

/// Squares along the longer side of the box around the outline.
const SQUARES: f64 = 64.0;
/// Squares along the side of a block, for which segments are sorted out first.
const BLOCK: usize = 8;

impl CandidateGrid {
    fn new(segments: &[[DVec2; 2]]) -> Self {
        let all: Vec<u32> = (0..segments.len() as u32).collect();
        let (lo, hi) = segments
            .iter()
            .flatten()
            .fold((segments[0][0], segments[0][0]), |(lo, hi), &p| {
                (lo.min(p), hi.max(p))
            });
        let step = (hi - lo).max_element() / SQUARES;
        // A margin of a few squares: the packing asks about points a little outside, too.
        let origin = lo - DVec2::splat(4.0 * step);
        let columns = ((hi.x - lo.x) / step) as usize + 9;
        let rows = ((hi.y - lo.y) / step) as usize + 9;
        let mut grid = Self {
            origin,
            step,
            columns,
            rows,
            start: vec![0],
            list: Vec::new(),
            all,
        };
        grid.fill(segments);
        grid
    }

    /// Blocks of squares first, so that each square tries few segments.
    fn fill(&mut self, segments: &[[DVec2; 2]]) {
        let mut lists = vec![Vec::new(); self.columns * self.rows];
        for top in (0..self.rows).step_by(BLOCK) {
            for left in (0..self.columns).step_by(BLOCK) {
                let corner = DVec2::new(left as f64, top as f64);
                let middle = self.origin + self.step * (corner + DVec2::splat(BLOCK as f64 / 2.0));
                let block = nearest_to(segments, &self.all, middle, BLOCK as f64 * self.step);
                for row in top..(top + BLOCK).min(self.rows) {
                    for column in left..(left + BLOCK).min(self.columns) {
                        let at = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                        let middle = self.origin + self.step * at;
                        lists[row * self.columns + column] =
                            nearest_to(segments, &block, middle, self.step);
                    }
                }
            }
        }
        for list in lists {
            self.list.extend(list);
            self.start.push(self.list.len() as u32);
        }
    }

    fn candidates(&self, p: DVec2) -> &[u32] {
        let at = (p - self.origin) / self.step;
        if !(at.x >= 0.0 && at.y >= 0.0 && at.x < self.columns as f64 && at.y < self.rows as f64) {
            return &self.all;
        }
        let square = at.y as usize * self.columns + at.x as usize;
        &self.list[self.start[square] as usize..self.start[square + 1] as usize]
    }
}

/// Those of the segments in `among` that can be the nearest to a point of a square with this middle
/// and side.
fn nearest_to(segments: &[[DVec2; 2]], among: &[u32], middle: DVec2, side: f64) -> Vec<u32> {
    let distance: Vec<f64> = among
        .iter()
        .map(|&i| {
            let [a, b] = segments[i as usize];
            closest_on_segment(middle, a, b).distance(middle)
        })
        .collect();
    let least = distance.iter().fold(f64::INFINITY, |m, &d| m.min(d));
    // From the middle to a corner and back is a diagonal.
    let reach = least + 1.415 * side;
    let near = among.iter().zip(distance).filter(|&(_, d)| d <= reach);
    near.map(|(&i, _)| i).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square_with_hole() -> Domain {
        let p = |x: f64, y: f64| DVec2::new(x, y);
        Domain::from_checked(&Outline {
            outer: vec![p(0., 0.), p(100., 0.), p(100., 100.), p(0., 100.)],
            holes: vec![vec![p(40., 40.), p(40., 60.), p(60., 60.), p(60., 40.)]],
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
    fn inward_points_to_growing_distance() {
        let domain = square_with_hole();
        for k in 0..400 {
            let p = DVec2::new((k * 37 % 113) as f64 - 6.3, (k * 53 % 109) as f64 - 4.1);
            let near = domain.nearest(p);
            let further = domain.nearest(p + 1e-4 * near.inward);
            assert!(further.distance > near.distance, "{p}");
        }
    }
}
