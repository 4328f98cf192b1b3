//! The places of the boundary that face a point: where the distance to the boundary has a local
//! minimum, seen from the paved side.

use super::{Domain, closest_on_segment};
use crate::order;
use glam::DVec2;

/// A place of the boundary facing a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// The place.
    pub point: DVec2,
    /// Its distance, positive.
    pub distance: f64,
    /// Unit vector from the place to the point asked for, into the paved area.
    pub inward: DVec2,
}

/// Finds the feet of points within a fixed reach of the boundary, in constant time.
#[derive(Clone, Debug)]
pub struct Facing {
    reach: f64,
    origin: DVec2,
    step: f64,
    columns: usize,
    rows: usize,
    start: Vec<u32>,
    list: Vec<u32>,
    segments: Vec<[DVec2; 2]>,
    before: Vec<u32>,
}

/// Most squares along a side of the look-up grid.
const MOST_SQUARES: f64 = 256.0;

/// Feet whose directions differ by less than this (cosine of 30 degrees) are one wall.
const SAME_WALL: f64 = 0.866;

impl Facing {
    /// Prepares for points up to `reach` (picture units) away from the boundary.
    pub fn new(domain: &Domain, reach: f64) -> Self {
        let (lo, hi) = domain.bounds();
        let step = (reach / 2.0).max((hi - lo).max_element() / MOST_SQUARES);
        let origin = lo - DVec2::splat(reach);
        let span = (hi - origin + DVec2::splat(reach)) / step;
        let (columns, rows) = (span.x as usize + 1, span.y as usize + 1);
        let mut facing = Self {
            reach,
            origin,
            step,
            columns,
            rows,
            start: Vec::new(),
            list: Vec::new(),
            segments: domain.segments().to_vec(),
            before: before(domain),
        };
        facing.fill();
        facing
    }

    fn fill(&mut self) {
        let near = self.reach + 0.708 * self.step;
        let mut entries = Vec::new();
        for (index, &[a, b]) in self.segments.iter().enumerate() {
            let lo = ((a.min(b) - self.origin - DVec2::splat(near)) / self.step).max(DVec2::ZERO);
            let hi = (a.max(b) - self.origin + DVec2::splat(near)) / self.step;
            for row in lo.y as usize..(hi.y as usize + 1).min(self.rows) {
                for column in lo.x as usize..(hi.x as usize + 1).min(self.columns) {
                    let at = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                    let middle = self.origin + self.step * at;
                    if closest_on_segment(middle, a, b).distance(middle) <= near {
                        entries.push(((row * self.columns + column) as u32, index as u32));
                    }
                }
            }
        }
        order::sort(&mut entries, |&(square, index)| {
            (order::pair(square, index), 0)
        });
        self.start = vec![0; self.columns * self.rows + 1];
        for &(square, _) in &entries {
            self.start[square as usize + 1] += 1;
        }
        for k in 1..self.start.len() {
            self.start[k] += self.start[k - 1];
        }
        self.list = entries.into_iter().map(|(_, index)| index).collect();
    }

    fn segments_near(&self, p: DVec2) -> &[u32] {
        let at = (p - self.origin) / self.step;
        if !(at.x >= 0.0 && at.y >= 0.0 && at.x < self.columns as f64 && at.y < self.rows as f64) {
            return &[];
        }
        let square = at.y as usize * self.columns + at.x as usize;
        &self.list[self.start[square] as usize..self.start[square + 1] as usize]
    }

    /// May the boundary be within reach of the point? A quick no for most of the inside.
    pub fn is_near(&self, p: DVec2) -> bool {
        !self.segments_near(p).is_empty()
    }

    /// The feet of a point within `reach` (at most the reach prepared for), nearest first; of walls
    /// that lie in nearly the same direction only the nearest. `feet` is overwritten.
    pub fn feet(&self, p: DVec2, reach: f64, feet: &mut Vec<Foot>) {
        feet.clear();
        for &index in self.segments_near(p) {
            if let Some(point) = self.foot(p, index as usize) {
                let distance = point.distance(p);
                if distance > 1e-9 && distance <= reach {
                    let inward = (p - point) / distance;
                    feet.push(Foot {
                        point,
                        distance,
                        inward,
                    });
                }
            }
        }
        order::sort(feet, |foot| (order::rank(foot.distance), 0));
        let mut kept = 0;
        for k in 0..feet.len() {
            let foot = feet[k];
            if feet[..kept]
                .iter()
                .all(|other| other.inward.dot(foot.inward) < SAME_WALL)
            {
                feet[kept] = foot;
                kept += 1;
            }
        }
        feet.truncate(kept);
    }

    /// The foot on a segment's inside, or at its start where the ring turns away from the point.
    fn foot(&self, p: DVec2, index: usize) -> Option<DVec2> {
        let [a, b] = self.segments[index];
        let along = b - a;
        let t = along.dot(p - a);
        if t > 0.0 {
            let inside = t < along.length_squared() && along.perp_dot(p - a) > 0.0;
            return inside.then(|| a + along * (t / along.length_squared()));
        }
        let [a0, corner] = self.segments[self.before[index] as usize];
        let earlier = corner - a0;
        let past = earlier.dot(p - corner) >= 0.0;
        let paved = earlier.perp_dot(p - corner) > 0.0 || along.perp_dot(p - corner) > 0.0;
        (past && paved).then_some(corner)
    }
}

/// For each segment the one before it on its ring.
fn before(domain: &Domain) -> Vec<u32> {
    let mut before = Vec::new();
    for ring in domain.rings() {
        let (first, n) = (before.len(), ring.len());
        before.extend((0..n).map(|k| (first + (k + n - 1) % n) as u32));
    }
    before
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Outline;

    #[test]
    fn a_corner_faces_with_both_walls_and_a_reflex_corner_with_its_tip() {
        let p = |x: f64, y: f64| DVec2::new(x, y);
        let domain = Domain::from_checked(&Outline {
            outer: vec![
                p(0., 0.),
                p(50., 0.),
                p(50., 50.),
                p(100., 50.),
                p(100., 100.),
                p(0., 100.),
            ],
            holes: vec![],
        });
        let facing = Facing::new(&domain, 20.0);
        let mut feet = Vec::new();
        facing.feet(p(8., 10.), 20.0, &mut feet);
        let points: Vec<_> = feet.iter().map(|f| f.point).collect();
        assert_eq!(points, [p(0., 10.), p(8., 0.)]);
        facing.feet(p(47., 54.), 20.0, &mut feet);
        assert_eq!(
            feet.iter().map(|f| f.point).collect::<Vec<_>>(),
            [p(50., 50.)]
        );
        facing.feet(p(25., 75.), 20.0, &mut feet);
        assert!(feet.is_empty());
        assert!(!facing.is_near(p(25., 60.)) || facing.is_near(p(45., 60.)));
    }
}
