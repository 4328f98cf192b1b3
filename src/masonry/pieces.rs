//! The convex pieces of a region and of its complement.

use super::footprint::Footprint;
use crate::planar::{Delaunay, orientation};
use glam::DVec2;
use std::collections::BTreeMap;

/// Coordinates are multiplied by this for the triangulation, which then rounds points to 6e-8 metres. The exact
/// coordinates are put back afterwards. A power of two, so that scaling itself rounds nothing.
pub(super) const SCALE: f64 = 256.0;

/// Convex pieces that are merged while they stay convex (Hertel, Mehlhorn 1983, Fast triangulation of simple
/// polygons).
pub(super) struct Pieces {
    places: Vec<DVec2>,
    /// Corners of each piece (indices in `places`), counter-clockwise; empty once the piece is part of another.
    rings: Vec<Vec<u32>>,
    /// Triangle sides that are no lines of the region: the ends, and the two triangles beside it. Each is listed once.
    diagonals: Vec<([u32; 2], [usize; 2])>,
    /// Whether each triangle lies inside of the region.
    is_inside: Vec<bool>,
    /// For each triangle, another one in the same piece; the last of such a chain points to itself and names the piece.
    joined: Vec<usize>,
    /// How many diagonals have been tried.
    tried: usize,
}

impl Pieces {
    /// Begins with a constrained triangulation of `lines`: the mesh, and the mesh edges that the lines have become.
    /// Each triangle is a piece.
    pub fn new(
        (mesh, walls): (Delaunay, Vec<[u32; 2]>),
        lines: &[[DVec2; 2]],
        is_inside: impl Fn(DVec2) -> bool,
    ) -> Self {
        let key = |p: DVec2| p.to_array().map(|v| (v * 4096.0).round() as i64);
        // Rounding moves a point by less than a cell of this grid. So the exact coordinates are in the same cell or in
        // one beside it.
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
    pub fn parts(self) -> [Vec<Footprint>; 2] {
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

    /// Whether each piece lies inside of the region. Pieces with no line between them lie on the same side, so one test
    /// serves them all.
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

    /// Removes each diagonal whose two pieces lie on the same side of the outline and are convex together. Each
    /// diagonal takes one off `amount`, and the work pauses at 0. True after the last diagonal.
    pub fn merge(&mut self, amount: &mut usize) -> bool {
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
        // The first piece from b round to a, then the second one from the corner after a to the one before b.
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

/// A ring turned to begin at a corner; none if the corner is not in it.
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
