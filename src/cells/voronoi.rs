//! Random points, evened out, whose Voronoi cells stand beside the packed ones for comparison.
//!
//! Lloyd (1982), Least squares quantization in PCM: every point moves repeatedly to the centroid of its
//! Voronoi cell. The cells are clipped to the outline exactly.
//!
//! The cells are made like the dual of a mesh, with circumcentres of the triangles instead of the elements'
//! centres and a frame around the picture instead of ghosts. Nothing is joined or straightened.

use super::ghosts::frame;
use crate::csr::Csr;
use crate::domain::Domain;
use crate::field::Fields;
use crate::mesh::triangulate;
use crate::order;
use crate::packing::Particle;
use crate::planar::cut_polygon;
use crate::random::{Purpose, Random};
use glam::DVec2;

/// Most draws in the bounding box for a point inside the outline. If the outline fills little of its box, a
/// point may be missing.
const MOST_TRIES: u32 = 4096;

/// Points are triangulated row by row; a row is about this many points high.
const POINTS_ACROSS: f64 = 2.0;

/// Images this far beyond the picture, in mean distances of points, are used: two random points with a common
/// side are hardly ever farther apart.
const SIGHT: f64 = 6.0;

/// Parameters of the scattered points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScatterParams {
    /// Number of points.
    pub count: usize,
    /// Rounds of Lloyd's relaxation.
    pub rounds: u32,
    /// Seed of the points.
    pub seed: u64,
}

/// Scattered points in progress.
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
        // Row by row, alternating the direction, so that spade locates each point from the previous one.
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

    /// Does one round of Lloyd's relaxation if any is left; true when none is left.
    pub fn advance(&mut self, domain: &Domain) -> bool {
        if self.left > 0 {
            self.round(domain);
            self.left -= 1;
        }
        self.left == 0
    }

    /// The points as cells' centres, with the fields' values at their place.
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
                // The triangle's part of the cell: a kite, inside out if the angle is obtuse.
                let (p, site) = (corners[k], t[k] as usize);
                let to = centre - p;
                cells[site].add((corners[(k + 1) % 3] - p) / 2.0, to);
                cells[site].add(to, (corners[(k + 2) % 3] - p) / 2.0);
                reach[site] = order::greater(reach[site], to.length());
            }
        }
        let links = links(&triangles, real);
        let mut clip = Clip::default();
        for (site, &p) in self.points.iter().enumerate() {
            if domain.nearest(p).distance < reach[site] {
                // The neighbours with the highest numbers come first.
                let neighbours = links.row(site).iter().rev();
                let neighbours = neighbours.map(|&k| vertices[k as usize]);
                let island = &domain.islands()[domain.island(p)];
                cells[site] = clip.moments(island, p, neighbours);
            }
        }
        for (p, cell) in self.points.iter_mut().zip(cells) {
            let to = *p + cell.centroid();
            // On a bend, the centroid of a cell can lie outside.
            if domain.contains(to) && !domain.is_gap_between(*p, to) {
                *p = domain.space().wrap(to);
            }
        }
    }
}

/// The images of points slightly beyond the picture's edges.
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

/// For each of the first `real` points, its neighbours in the triangulation.
fn links(triangles: &[[u32; 3]], real: usize) -> Csr<u32> {
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [(a as usize, b), (b as usize, c), (c as usize, a)]);
    Csr::from_pairs(real, sides.filter(|&(from, _)| from < real))
}

/// The circumcentre of three points; their mean if they are collinear.
pub(crate) fn circumcentre([a, b, c]: [DVec2; 3]) -> DVec2 {
    let (u, v) = (b - a, c - a);
    let from_a =
        (u.length_squared() * v.perp() - v.length_squared() * u.perp()) / (-2.0 * u.perp_dot(v));
    if from_a.is_finite() {
        a + from_a
    } else {
        (a + b + c) / 3.0
    }
}

/// Area and first moments of a cell, relative to its point.
#[derive(Clone, Copy, Debug, Default)]
struct Moments {
    /// Twice the area.
    area: f64,
    /// Six times the moments.
    first: DVec2,
}

impl Moments {
    /// Adds the triangle of the point, a and b, both given relative to the point.
    fn add(&mut self, a: DVec2, b: DVec2) {
        let twice = a.perp_dot(b);
        self.area += twice;
        self.first += twice * (a + b);
    }

    /// The centroid relative to the point; zero if there is no area.
    fn centroid(self) -> DVec2 {
        if self.area > 0.0 {
            self.first / (3.0 * self.area)
        } else {
            DVec2::ZERO
        }
    }
}

/// Scratch space for clipping rings.
#[derive(Default)]
struct Clip {
    ring: Vec<DVec2>,
    next: Vec<DVec2>,
}

impl Clip {
    /// The area and moments of a point's cell inside the outline: the outline's rings, cut by the bisectors to the
    /// neighbours. If a ring falls apart, the double lines between its parts enclose no area.
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

    /// Keeps the points nearer to the origin than to `q`.
    fn cut(&mut self, q: DVec2) {
        let half = 0.5 * q.length_squared();
        self.next.clear();
        cut_polygon(
            &self.ring,
            |p| half - p.dot(q),
            |(a, here), (b, there)| a + (b - a) * (here / (here - there)),
            |p| self.next.push(p),
        );
        std::mem::swap(&mut self.ring, &mut self.next);
    }
}
