//! Projects points onto the walls (the boundary and the constraint lines): the places where the distance to
//! the point has a local minimum, seen from the inside.
//!
//! Each wall that a point sees gives one projection: a cell in a corner feels both walls, a cell at a reflex corner
//! feels the corner's tip. The packing's soft wall pushes from these places, and the ghosts of the fitted cells are
//! mirrored in them.

use super::Domain;
use super::segment_grid::SegmentGrid;
use crate::order;
use crate::planar::{Space, crosses};
use glam::DVec2;

/// A locally closest point of the walls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// The closest point.
    pub point: DVec2,
    /// Its distance, positive.
    pub distance: f64,
    /// Unit vector from the closest point to the query point, into the inside.
    pub inward: DVec2,
    /// Whether it lies on a constraint line.
    pub on_line: bool,
    /// The number of the island it belongs to.
    island: u32,
}

/// Projects points within a fixed reach of the walls, in constant time.
#[derive(Clone, Debug)]
pub struct Walls {
    grid: SegmentGrid,
    /// The segments of the outline, then those of the constraint lines.
    segments: Vec<[DVec2; 2]>,
    /// For each segment of the outline, the previous one on its ring.
    before: Vec<u32>,
    /// For each segment of a line, whether each of its ends lies on the outline.
    blunt: Vec<[bool; 2]>,
    /// For each segment its island; empty if there is only one.
    island: Vec<u32>,
    space: Space,
    reach: f64,
}

/// Most squares along a side of the look-up grid.
const MOST_SQUARES: f64 = 256.0;

/// Projections whose directions differ by less than this (cosine of 30 degrees) belong to one wall.
pub(crate) const SAME_WALL: f64 = 0.866;

impl Walls {
    /// Prepares for points up to `reach` (picture units) away from the walls.
    pub fn new(domain: &Domain, reach: f64) -> Self {
        let (lo, hi) = domain.bounds();
        let step = (reach / 2.0).max((hi - lo).max_element() / MOST_SQUARES);
        let mut segments = domain.segments().to_vec();
        let blunt = domain.line_walls(&mut segments);
        let outline = domain.segments().len();
        let island = |(k, [a, b]): (usize, &[DVec2; 2])| match k < outline {
            true => domain.island_of(k),
            false => domain.island(a.midpoint(*b)) as u32,
        };
        let island = match domain.islands() {
            [_] => Vec::new(),
            _ => segments.iter().enumerate().map(island).collect(),
        };
        Self {
            grid: SegmentGrid::new((lo, hi), reach, step, &segments, reach),
            island,
            segments,
            before: before(domain),
            blunt,
            space: domain.space(),
            reach,
        }
    }

    /// How far from the walls points are projected (picture units).
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// Whether a wall may be within reach of the point: a quick no for most of the inside.
    pub fn is_near(&self, p: DVec2) -> bool {
        !self.grid.at(p - self.space.tile(p)).is_empty()
    }

    /// The projections of a point within `reach` (at most the prepared reach), nearest first. If several
    /// walls lie in nearly the same direction, only the nearest counts. Walls behind a constraint line do
    /// not count. Overwrites `found`.
    pub fn project(&self, p: DVec2, reach: f64, found: &mut Vec<Projection>) {
        found.clear();
        let shift = self.space.tile(p);
        let p = p - shift;
        let near = self.grid.at(p);
        for &index in near {
            if let Some(point) = self.onto(p, index as usize, near) {
                let distance = point.distance(p);
                if distance > 1e-9 && distance <= reach {
                    let inward = (p - point) / distance;
                    found.push(Projection {
                        point,
                        distance,
                        inward,
                        on_line: index as usize >= self.before.len(),
                        island: self.island.get(index as usize).copied().unwrap_or(0),
                    });
                }
            }
        }
        order::sort(found, |p| (order::rank(p.distance), 0));
        // Walls beyond a gap belong to other islands and do not count.
        let Some(own) = found.first().map(|nearest| nearest.island) else {
            return;
        };
        found.retain(|p| p.island == own);
        let mut kept = 0;
        for k in 0..found.len() {
            let next = found[k];
            if found[..kept]
                .iter()
                .all(|other| other.inward.dot(next.inward) < SAME_WALL)
                && !self.is_hidden(p, next.point, near)
            {
                found[kept] = next;
                found[kept].point += shift;
                kept += 1;
            }
        }
        found.truncate(kept);
    }

    /// The point of a segment that is nearest to a place. `None` if it is an end of the segment at which another wall
    /// comes nearer to the place.
    fn onto(&self, p: DVec2, index: usize, near: &[u32]) -> Option<DVec2> {
        if index < self.before.len() {
            return self.onto_outline(p, index);
        }
        let [a, b] = self.segments[index];
        let along = b - a;
        let t = along.dot(p - a) / along.length_squared();
        if t > 0.0 && t < 1.0 {
            return Some(a + along * t);
        }
        let end = usize::from(t >= 1.0);
        let tip = [a, b][end];
        let blunt = self.blunt[index - self.before.len()][end];
        // A tip counts if no other segment that ends there comes nearer.
        let faces = |&other: &u32| {
            let [a, b] = self.segments[other as usize];
            let nearer = |end: DVec2, to: DVec2| end == tip && (to - end).dot(p - end) > 0.0;
            (other as usize) < self.before.len() || !(nearer(a, b) || nearer(b, a))
        };
        (!blunt && near.iter().all(faces)).then_some(tip)
    }

    /// Whether a constraint line stands between a point and a place.
    fn is_hidden(&self, p: DVec2, place: DVec2, near: &[u32]) -> bool {
        if self.blunt.is_empty() {
            return false;
        }
        // Stops short of the place, which may itself lie on a line.
        let place = place + (p - place) * 1e-6;
        let lines = near.iter().filter(|&&k| k as usize >= self.before.len());
        lines.into_iter().any(|&k| {
            let [a, b] = self.segments[k as usize];
            crosses(p, place, a, b)
        })
    }

    /// The projection onto a segment of the outline, or onto its start where the ring turns away from the
    /// point.
    fn onto_outline(&self, p: DVec2, index: usize) -> Option<DVec2> {
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

/// For each segment, the previous one on its ring.
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
            rings: vec![vec![
                p(0., 0.),
                p(50., 0.),
                p(50., 50.),
                p(100., 50.),
                p(100., 100.),
                p(0., 100.),
            ]],
            ..Outline::default()
        });
        let walls = Walls::new(&domain, 20.0);
        let mut found = Vec::new();
        walls.project(p(8., 10.), 20.0, &mut found);
        let points: Vec<_> = found.iter().map(|p| p.point).collect();
        assert_eq!(points, [p(0., 10.), p(8., 0.)]);
        walls.project(p(47., 54.), 20.0, &mut found);
        assert_eq!(
            found.iter().map(|p| p.point).collect::<Vec<_>>(),
            [p(50., 50.)]
        );
        walls.project(p(25., 75.), 20.0, &mut found);
        assert!(found.is_empty());
        assert!(walls.is_near(p(45., 60.)));
        let square = [p(0., 0.), p(400., 0.), p(400., 400.), p(0., 400.)];
        let wide = Domain::from_checked(&Outline {
            rings: vec![square.to_vec()],
            ..Outline::default()
        });
        let walls = Walls::new(&wide, 20.0);
        assert!(walls.is_near(p(10., 200.)) && !walls.is_near(p(200., 200.)));
    }
}
