//! The corners of cells as shared vertices, and the freedom of each to move.

use super::{Cell, images};
use crate::csr::Csr;
use crate::domain::Domain;
use crate::order;
use glam::DVec2;

/// A turn of the boundary sharper than this (cosine of 30 degrees) is a corner of the cell.
pub(crate) const CORNER: f64 = 0.866;
/// Two pieces of the boundary count as one straight line if they turn by less than 1 degree; this is the cosine.
pub(super) const STRAIGHT: f64 = 0.9998;
/// The ends of a piece are rounded to the grain, so a shorter one (picture units) has no reliable direction.
const ROUGH: f64 = 1.0 / 64.0;

/// The freedom of a vertex to move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Freedom {
    /// It does not move: a corner of the outline, or a point on it with only one cell.
    Fixed,
    /// It moves along the boundary or a constraint line, on a straight piece where two cells meet. Holds the unit
    /// vector of that piece.
    Slides(DVec2),
    /// It moves in any direction.
    Free,
}

/// The cells' rings as shared vertices.
pub(super) struct Rings {
    pub points: Vec<DVec2>,
    pub free: Vec<Freedom>,
    /// Whether the point lies on a constraint line.
    pub on_line: Vec<bool>,
    /// For each cell, the vertices of its ring.
    pub rings: Vec<Vec<u32>>,
    /// For each cell with exactly four corners, the corners.
    pub quads: Vec<Option<[u32; 4]>>,
    /// For each vertex, its uses: (vertex, cell, position in the ring).
    uses: Csr<[u32; 3]>,
    /// See [`images::twins`].
    pub twins: Vec<(u32, u32, DVec2)>,
}

impl Rings {
    /// The vertices of these cells' rings; all are fixed at first.
    pub fn new(domain: &Domain, cells: &[Cell]) -> Self {
        let mut all: Vec<(u64, u64, u32, u32)> = Vec::new();
        for (cell, c) in cells.iter().enumerate() {
            for (place, p) in c.ring.iter().enumerate() {
                all.push((p.x.to_bits(), p.y.to_bits(), cell as u32, place as u32));
            }
        }
        order::sort(&mut all, |a| (a.0, a.1));
        let mut rings: Vec<Vec<u32>> = cells.iter().map(|c| vec![0; c.ring.len()]).collect();
        let (mut points, mut uses) = (Vec::new(), Csr::default());
        for same in all.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let vertex = points.len() as u32;
            points.push(DVec2::new(
                f64::from_bits(same[0].0),
                f64::from_bits(same[0].1),
            ));
            for &(_, _, cell, place) in same {
                rings[cell as usize][place as usize] = vertex;
            }
            uses.push(
                same.iter()
                    .map(|&(_, _, cell, place)| [vertex, cell, place]),
            );
        }
        Self {
            twins: images::twins(domain, &points),
            free: vec![Freedom::Fixed; points.len()],
            on_line: vec![false; points.len()],
            points,
            rings,
            quads: Vec::new(),
            uses,
        }
    }

    /// The uses of a vertex: (vertex, cell, position in its ring).
    pub fn uses_of(&self, vertex: usize) -> &[[u32; 3]] {
        self.uses.row(vertex)
    }

    /// The vertex after a position of a ring if `ahead`, else the vertex before it.
    pub fn neighbour(&self, [_, cell, place]: [u32; 3], ahead: bool) -> u32 {
        let ring = &self.rings[cell as usize];
        let step = if ahead { 1 } else { ring.len() - 1 };
        ring[(place as usize + step) % ring.len()]
    }

    /// The edges of rings without a counterpart in another ring, as (from, to).
    fn lone_edges(&self) -> impl Iterator<Item = [u32; 2]> {
        let edges = self.rings.iter().flat_map(|ring| {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|(&a, &b)| [a, b])
        });
        edges.filter(|&[a, b]| {
            let mut uses = self.uses_of(b as usize).iter();
            uses.all(|&u| self.neighbour(u, true) != a)
        })
    }

    /// Finds the freedom of each vertex. It is free if cells close a full turn around it. It slides if
    /// exactly one lone edge arrives and one leaves, on a straight piece of the boundary. Other lone edges
    /// (at a vertex of one ring on a side of another) fix their ends.
    pub fn find_free(&mut self, domain: &Domain) {
        let mut arriving: Vec<Vec<u32>> = vec![Vec::new(); self.points.len()];
        let mut leaving = arriving.clone();
        for [a, b] in self.lone_edges() {
            leaving[a as usize].push(b);
            arriving[b as usize].push(a);
        }
        for vertex in 0..self.points.len() {
            let p = self.points[vertex];
            let on_boundary = |q: DVec2| domain.nearest(q).distance.abs() < 0.01;
            let line = domain.nearest_line(p).filter(|near| near.distance < 0.01);
            self.on_line[vertex] = line.is_some();
            self.free[vertex] = match (&arriving[vertex][..], &leaving[vertex][..]) {
                ([], []) if on_boundary(p) => Freedom::Fixed,
                ([], []) => line.map_or(Freedom::Free, |near| {
                    self.along_line(domain, vertex, near.tangent)
                }),
                (&[a], &[b]) if line.is_none() && self.uses_of(vertex).len() > 1 => {
                    let (a, b) = (self.points[a as usize], self.points[b as usize]);
                    let (here, ahead) = ((p - a).normalize(), (b - p).normalize());
                    let straight = here.dot(ahead) > STRAIGHT;
                    if straight && on_boundary(p.midpoint(a)) && on_boundary(p.midpoint(b)) {
                        let is_rough = p.distance(b) < ROUGH.min(p.distance(a));
                        Freedom::Slides(if is_rough { here } else { ahead })
                    } else {
                        Freedom::Fixed
                    }
                }
                _ => Freedom::Fixed,
            };
        }
        for &(_, image, _) in &self.twins {
            self.free[image as usize] = Freedom::Fixed;
        }
    }

    /// A vertex on a constraint line slides if the line is straight and no other line meets it.
    fn along_line(&self, domain: &Domain, vertex: usize, along: DVec2) -> Freedom {
        let p = self.points[vertex];
        let (mut ahead, mut behind) = (false, false);
        for &u in self.uses_of(vertex) {
            for side in [true, false] {
                let q = self.points[self.neighbour(u, side) as usize];
                let middle = domain.nearest_line(p.midpoint(q));
                if middle.is_some_and(|near| near.distance < 0.01) {
                    let cosine = along.dot(q - p) / p.distance(q);
                    if cosine.abs() < STRAIGHT {
                        return Freedom::Fixed;
                    }
                    ahead |= cosine > 0.0;
                    behind |= cosine < 0.0;
                }
            }
        }
        if ahead && behind {
            Freedom::Slides(along)
        } else {
            Freedom::Fixed
        }
    }

    /// Finds the corners of cells with exactly four of them.
    pub fn find_corners(&mut self) {
        let cells = 0..self.rings.len();
        self.quads = cells.map(|cell| self.four_corners(cell)).collect();
    }

    /// The four corners of a cell: where three cells meet, where a side meets the boundary, or where the boundary
    /// itself turns. `None` if the cell has another number of corners.
    fn four_corners(&self, cell: usize) -> Option<[u32; 4]> {
        let ring = &self.rings[cell];
        let n = ring.len();
        let mut corners = Vec::new();
        for (k, &vertex) in ring.iter().enumerate() {
            let count = self.uses_of(vertex as usize).len();
            let free = self.free[vertex as usize] == Freedom::Free;
            let [a, b, c] =
                [ring[(k + n - 1) % n], vertex, ring[(k + 1) % n]].map(|v| self.points[v as usize]);
            let turn = (b - a).normalize().dot((c - b).normalize());
            // A meeting of cells across a constraint line is not a corner of this cell.
            let beyond = self.on_line[vertex as usize] && turn > STRAIGHT;
            let meets = count >= if free { 3 } else { 2 } && !beyond;
            let turns = turn < CORNER;
            if meets || turns {
                corners.push(vertex);
            }
        }
        corners.try_into().ok()
    }
}
