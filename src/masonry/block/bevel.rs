//! Polyhedra with cut edges.

use super::polyhedron::Polyhedron;
use glam::DVec3;

/// The bevels at the two ends of a side's edge take at most this share of its length.
const MOST_SHARE: f64 = 0.6;

/// A closed triangle mesh with shared vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockMesh {
    /// The vertices (metres).
    pub positions: Vec<DVec3>,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl BlockMesh {
    /// Area-weighted unit normals of the vertices; upwards where they cancel out.
    pub fn normals(&self) -> Vec<DVec3> {
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        for t in &self.triangles {
            let [a, b, c] = t.map(|v| self.positions[v as usize]);
            let normal = (b - a).cross(c - a);
            t.iter().for_each(|&v| sums[v as usize] += normal);
        }
        let units = sums.into_iter();
        units
            .map(|n| n.try_normalize().unwrap_or(DVec3::Y))
            .collect()
    }

    /// Adds the triangles of a convex ring, as a fan from its first corner.
    fn fan(&mut self, ring: &[u32]) {
        for pair in ring[1..].windows(2) {
            self.triangles.push([ring[0], pair[0], pair[1]]);
        }
    }

    /// Adds the mean of a ring's corners as a vertex, and the triangles between it and the ring.
    fn star(&mut self, ring: &[u32]) {
        let middle: DVec3 = ring.iter().map(|&v| self.positions[v as usize]).sum();
        self.positions.push(middle / ring.len() as f64);
        let centre = self.positions.len() as u32 - 1;
        for (k, &v) in ring.iter().enumerate() {
            self.triangles.push([v, ring[(k + 1) % ring.len()], centre]);
        }
    }

    /// The volume, in cubic metres.
    pub fn volume(&self) -> f64 {
        let origin = self.positions.first().copied().unwrap_or_default();
        let six = self.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| self.positions[v as usize] - origin);
            a.dot(b.cross(c))
        });
        six.sum::<f64>() / 6.0
    }
}

/// A polyhedron whose edges and vertices are cut: a smaller ring in each side, a strip along each edge, and a polygon,
/// the knot, at each vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct Bevelled {
    positions: Vec<DVec3>,
    /// The ring of each side.
    rings: Vec<Vec<u32>>,
    strips: Vec<[u32; 4]>,
    knots: Vec<Vec<u32>>,
}

impl Bevelled {
    /// Bevels all edges of a body. The cuts lie at `width` from each edge, measured on the sides (metres, at least 0).
    /// Sides too narrow for that get a narrower bevel.
    pub fn new(body: &Polyhedron, width: f64) -> Self {
        let mut positions = Vec::new();
        let rings: Vec<Vec<u32>> = body
            .sides()
            .iter()
            .map(|side| {
                let start = positions.len() as u32;
                let ring: Vec<DVec3> = body.ring(side).collect();
                positions.extend(inset_ring(&ring, width));
                (start..positions.len() as u32).collect()
            })
            .collect();
        let corners = SideCorners::new(body, &rings);
        Self {
            strips: corners.strips(),
            knots: corners.knots(body.vertices().len()),
            positions,
            rings,
        }
    }

    /// The mesh of a plain block: the ring of each side becomes a fan.
    pub fn facets(self) -> BlockMesh {
        let mut facets = self.edges_and_knots();
        for ring in &self.rings {
            facets.fan(ring);
        }
        facets
    }

    /// The control mesh of a rounded block: each side has one more ring, `further` inside of the bevel (metres), and a
    /// centre. The rings keep the side flat and the body large, where Loop's scheme would shrink a bare box.
    pub fn supported(self, further: f64) -> BlockMesh {
        let mut facets = self.edges_and_knots();
        for ring in &self.rings {
            let places: Vec<DVec3> = ring.iter().map(|&v| facets.positions[v as usize]).collect();
            let start = facets.positions.len() as u32;
            facets.positions.extend(inset_ring(&places, further));
            let inner: Vec<u32> = (start..facets.positions.len() as u32).collect();
            for k in 0..ring.len() {
                let next = (k + 1) % ring.len();
                facets.fan(&[ring[k], ring[next], inner[next], inner[k]]);
            }
            facets.star(&inner);
        }
        facets
    }

    fn edges_and_knots(&self) -> BlockMesh {
        let mut facets = BlockMesh {
            positions: self.positions.clone(),
            triangles: Vec::new(),
        };
        self.strips.iter().for_each(|strip| facets.fan(strip));
        self.knots.iter().for_each(|knot| facets.fan(knot));
        facets
    }
}

/// A convex ring moved inwards by `width` from all its edges, in its plane, or by less if an edge is too short.
fn inset_ring(ring: &[DVec3], width: f64) -> Vec<DVec3> {
    let count = ring.len();
    let corner = |k: usize| {
        let at = ring[k];
        let back = (ring[(k + count - 1) % count] - at).normalize();
        let on = (ring[(k + 1) % count] - at).normalize();
        let sine = back.cross(on).length().max(1e-6);
        // For each unit of width: the length that the corner takes off its edges, and its displacement.
        ((1.0 + back.dot(on)) / sine, (back + on) / sine)
    };
    let corners: Vec<(f64, DVec3)> = (0..count).map(corner).collect();
    let widest = (0..count).map(|k| {
        let next = (k + 1) % count;
        MOST_SHARE * ring[k].distance(ring[next]) / (corners[k].0 + corners[next].0)
    });
    let width = widest.fold(width, f64::min);
    ring.iter()
        .zip(corners)
        .map(|(&at, (_, way))| at + width * way)
        .collect()
}

/// A corner of a side: its vertex, and those before it and after it (`behind`) in the side. `number` is the index of
/// the new corner in `positions`.
struct SideCorner {
    vertex: u32,
    before: u32,
    behind: u32,
    number: u32,
    /// The `number` of the next corner in the ring.
    next: u32,
}

struct SideCorners(Vec<SideCorner>);

impl SideCorners {
    fn new(body: &Polyhedron, rings: &[Vec<u32>]) -> Self {
        let corners = body.sides().iter().zip(rings).flat_map(|(side, ring)| {
            let count = ring.len();
            (0..count).map(move |k| SideCorner {
                vertex: side.corners[k],
                before: side.corners[(k + count - 1) % count],
                behind: side.corners[(k + 1) % count],
                number: ring[k],
                next: ring[(k + 1) % count],
            })
        });
        Self(corners.collect())
    }

    /// The corner at the same vertex in the neighbouring side, across the edge from `vertex` to `behind`.
    fn beyond(&self, corner: &SideCorner) -> Option<&SideCorner> {
        let is_it =
            |other: &&SideCorner| other.vertex == corner.vertex && other.before == corner.behind;
        self.0.iter().find(is_it)
    }

    /// A quadrilateral along each edge, between the rings of its two sides.
    fn strips(&self) -> Vec<[u32; 4]> {
        let edges = self.0.iter().filter(|corner| corner.vertex < corner.behind);
        let strips = edges.filter_map(|corner| {
            let back = |other: &&SideCorner| {
                other.vertex == corner.behind && other.behind == corner.vertex
            };
            let other = self.0.iter().find(back)?;
            Some([corner.next, corner.number, other.next, other.number])
        });
        strips.collect()
    }

    /// A polygon at each vertex: the new corners of the sides around it.
    fn knots(&self, vertices: usize) -> Vec<Vec<u32>> {
        let around = (0..vertices as u32).filter_map(|vertex| {
            let first = self.0.iter().find(|corner| corner.vertex == vertex)?;
            let mut knot = vec![first.number];
            let mut at = self.beyond(first)?;
            while at.number != first.number && knot.len() <= self.0.len() {
                knot.push(at.number);
                at = self.beyond(at)?;
            }
            // The sides follow each other clockwise, seen from outside.
            knot.reverse();
            Some(knot)
        });
        around.collect()
    }
}
