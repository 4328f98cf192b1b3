//! Points scattered over the outline and evened out, whose Voronoi cells stand beside the packed ones
//! for comparison.
//!
//! Lloyd (1982), Least squares quantization in PCM: every point moves to the centroid of its Voronoi
//! cell, again and again. The cells are cut by the outline, exactly.
//!
//! They go the same way as the dual of a mesh: the middles of the triangles' circles instead of the
//! elements' centres, a frame around the picture instead of ghosts, and nothing is joined or
//! straightened.

use super::ghosts::frame;
use crate::domain::Domain;
use crate::field::Fields;
use crate::mesh::triangulate;
use crate::order;
use crate::packing::Particle;
use crate::random::{Purpose, Random};
use glam::DVec2;

/// So often a point is drawn in the box around the outline until it falls inside. Where the outline
/// fills so little of its box, a point may be missing.
const MOST_TRIES: u32 = 4096;

/// About so many points lie across a row, for the order in which they are triangulated.
const POINTS_ACROSS: f64 = 2.0;

/// Images this far beyond the picture, in mean distances of points, are seen: two of random points
/// with a common side are hardly ever farther from each other.
const SIGHT: f64 = 6.0;

/// What points are scattered from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScatterParams {
    /// How many points.
    pub count: usize,
    /// Rounds of Lloyd's relaxation.
    pub rounds: u32,
    /// Draws the points.
    pub seed: u64,
}

/// Scattered points on their way.
#[derive(Clone, Debug)]
pub struct Scatter {
    points: Vec<DVec2>,
    left: u32,
}

impl Scatter {
    /// Draws the points, uniformly over the outline.
    pub fn new(domain: &Domain, params: ScatterParams) -> Self {
        let (lo, hi) = domain.bounds();
        let mut points = Vec::with_capacity(params.count);
        for id in 0..params.count {
            let mut random = Random::new(params.seed, Purpose::Scatter, id as u64);
            for _ in 0..MOST_TRIES {
                let point = lo + (hi - lo) * DVec2::new(random.unit(), random.unit());
                if domain.contains(point) {
                    points.push(point);
                    break;
                }
            }
        }
        points.extend(domain.empty_middles(&points));
        // Row by row, there and back: each point is found from the one before it.
        let rows = (params.count as f64).sqrt() / POINTS_ACROSS;
        order::sort(&mut points, |p| {
            let row = ((p.y - lo.y) / (hi.y - lo.y) * rows) as u64;
            (
                row,
                order::rank(if row.is_multiple_of(2) { p.x } else { -p.x }),
            )
        });
        Self {
            points,
            left: params.rounds,
        }
    }

    /// One round of Lloyd's relaxation where any is left; true when none is left.
    pub fn advance(&mut self, domain: &Domain) -> bool {
        if self.left > 0 {
            self.round(domain);
            self.left -= 1;
        }
        self.left == 0
    }

    /// The points as cells' centres, which ask for what the fields ask for at their place.
    pub fn particles(&self, fields: &Fields) -> Vec<Particle> {
        let points = self.points.iter().zip(0..);
        points
            .map(|(&centre, id)| Particle::new(id, centre, false, fields))
            .collect()
    }

    fn round(&mut self, domain: &Domain) {
        // Within the frame every point's triangles close a full turn.
        let mut vertices = self.points.clone();
        vertices.extend(images(domain, &self.points));
        vertices.extend(frame(domain));
        let triangles = triangulate(&vertices);
        let real = self.points.len();
        let mut cells = vec![Moments::default(); real];
        let mut reach = vec![0.0; real];
        for t in &triangles {
            let corners = t.map(|k| vertices[k as usize]);
            let centre = circumcentre(corners);
            for k in (0..3).filter(|&k| (t[k] as usize) < real) {
                // The triangle's part of the cell: a kite, inside out where the angle is obtuse.
                let (p, site) = (corners[k], t[k] as usize);
                let to = centre - p;
                cells[site].add((corners[(k + 1) % 3] - p) / 2.0, to);
                cells[site].add(to, (corners[(k + 2) % 3] - p) / 2.0);
                reach[site] = order::greater(reach[site], to.length());
            }
        }
        let links = Links::new(&triangles, real);
        let mut clip = Clip::default();
        for (site, &p) in self.points.iter().enumerate() {
            if domain.nearest(p).distance < reach[site] {
                let neighbours = links.of(site).map(|k| vertices[k]);
                let island = &domain.islands()[domain.island(p)];
                cells[site] = clip.moments(island, p, neighbours);
            }
        }
        for (p, cell) in self.points.iter_mut().zip(cells) {
            let to = *p + cell.centroid();
            // On a bend a cell's centroid can lie outside.
            if domain.contains(to) && !domain.is_gap_between(*p, to) {
                *p = domain.space().wrap(to);
            }
        }
    }
}

/// The images of points that lie a little beyond the picture's edges.
fn images(domain: &Domain, points: &[DVec2]) -> Vec<DVec2> {
    let sight = SIGHT * (domain.area() / points.len() as f64).sqrt();
    let space = domain.space();
    let mut images = Vec::new();
    for by in space.shifts(1).skip(1) {
        let shifted = points.iter().map(|&p| p + by);
        images.extend(shifted.filter(|&p| space.is_near_home([p; 2], sight)));
    }
    images
}

/// For each of the first points those that it shares a side of a triangle with.
struct Links {
    /// The last entry of a point's chain.
    last: Vec<u32>,
    /// (neighbour, the entry before).
    entries: Vec<[u32; 2]>,
}

impl Links {
    fn new(triangles: &[[u32; 3]], real: usize) -> Self {
        let mut links = Self {
            last: vec![u32::MAX; real],
            entries: Vec::with_capacity(3 * triangles.len()),
        };
        for t in triangles {
            for k in 0..3 {
                if let Some(last) = links.last.get_mut(t[k] as usize) {
                    let entry = [t[(k + 1) % 3], *last];
                    *last = links.entries.len() as u32;
                    links.entries.push(entry);
                }
            }
        }
        links
    }

    fn of(&self, site: usize) -> impl Iterator<Item = usize> + Clone {
        let mut at = self.last[site];
        std::iter::from_fn(move || {
            let [neighbour, before] = *self.entries.get(at as usize)?;
            at = before;
            Some(neighbour as usize)
        })
    }
}

/// The middle of the circle through three points; their mean where they lie on a line.
pub(super) fn circumcentre([a, b, c]: [DVec2; 3]) -> DVec2 {
    let (u, v) = (b - a, c - a);
    let from_a =
        (u.length_squared() * v.perp() - v.length_squared() * u.perp()) / (-2.0 * u.perp_dot(v));
    if from_a.is_finite() {
        a + from_a
    } else {
        (a + b + c) / 3.0
    }
}

/// The area and the first moments of a cell, around its point.
#[derive(Clone, Copy, Debug, Default)]
struct Moments {
    /// Twice the area.
    area: f64,
    /// Six times the moments.
    first: DVec2,
}

impl Moments {
    /// Adds the triangle of the point, a and b (both from the point).
    fn add(&mut self, a: DVec2, b: DVec2) {
        let twice = a.perp_dot(b);
        self.area += twice;
        self.first += twice * (a + b);
    }

    /// The centroid from the point; the point itself where there is no area.
    fn centroid(self) -> DVec2 {
        if self.area > 0.0 {
            self.first / (3.0 * self.area)
        } else {
            DVec2::ZERO
        }
    }
}

/// Room for clipping rings.
#[derive(Default)]
struct Clip {
    ring: Vec<DVec2>,
    next: Vec<DVec2>,
}

impl Clip {
    /// What a point's cell has inside the outline: the outline's rings, cut by the lines half way to
    /// the neighbours (Sutherland, Hodgman 1974). Where a ring falls apart, the double lines between
    /// its parts have no area.
    fn moments(
        &mut self,
        domain: &Domain,
        p: DVec2,
        neighbours: impl Iterator<Item = DVec2> + Clone,
    ) -> Moments {
        let mut moments = Moments::default();
        for ring in domain.rings() {
            self.ring.clear();
            self.ring.extend(ring.iter().map(|&q| q - p));
            for neighbour in neighbours.clone() {
                self.cut(neighbour - p);
            }
            if let Some(&last) = self.ring.last() {
                let mut a = last;
                for &b in &self.ring {
                    moments.add(a, b);
                    a = b;
                }
            }
        }
        moments
    }

    /// Keeps what is nearer to the origin than to `q`.
    fn cut(&mut self, q: DVec2) {
        let half = 0.5 * q.length_squared();
        let Some(&last) = self.ring.last() else {
            return;
        };
        self.next.clear();
        let (mut a, mut over) = (last, last.dot(q) - half);
        for &b in &self.ring {
            let beyond = b.dot(q) - half;
            if (over > 0.0) != (beyond > 0.0) {
                self.next.push(a + (b - a) * (over / (over - beyond)));
            }
            if beyond <= 0.0 {
                self.next.push(b);
            }
            (a, over) = (b, beyond);
        }
        std::mem::swap(&mut self.ring, &mut self.next);
    }
}
