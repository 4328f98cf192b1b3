//! Cuts convex polyhedra by planes.

use super::plane::Plane;
use super::polyhedron::{LEAST_VOLUME, Polyhedron, Side, SideCorners};
use smallvec::{SmallVec, smallvec};

/// Vertices this near to a plane lie on it (metres).
const ON: f64 = 1e-9;

impl Polyhedron {
    /// The part on the inner side of a plane; the new side gets this inset (metres). None if no volume is left.
    pub fn cut(&self, plane: Plane, inset: f64) -> Option<Self> {
        let on_plane = |distance: f64| if distance.abs() < ON { 0.0 } else { distance };
        let inwards: SmallVec<[f64; 16]> = self
            .vertices
            .iter()
            .map(|&p| on_plane(-plane.distance(p)))
            .collect();
        if inwards.iter().all(|&d| d >= 0.0) {
            return Some(self.clone());
        }
        if inwards.iter().all(|&d| d <= 0.0) {
            return None;
        }
        let mut vertices = Vec::with_capacity(2 * self.vertices.len());
        vertices.extend_from_slice(&self.vertices);
        let mut cutting = Cutting {
            inwards,
            body: Self {
                vertices,
                sides: Vec::with_capacity(self.sides.len() + 1),
            },
            crossings: SmallVec::new(),
        };
        cutting.cut_sides(&self.sides);
        let rim = cutting.rim();
        if rim.len() > 2 {
            cutting.body.sides.push(Side {
                corners: rim,
                inset,
                roughness: 0.0,
            });
        }
        let body = cutting.body.compacted();
        (body.sides.len() > 3 && body.volume() > LEAST_VOLUME).then_some(body)
    }

    /// The body without unused vertices.
    fn compacted(mut self) -> Self {
        let mut numbers: SmallVec<[Option<u32>; 24]> = smallvec![None; self.vertices.len()];
        let mut kept = Vec::with_capacity(self.vertices.len());
        for v in self.sides.iter_mut().flat_map(|side| &mut side.corners) {
            *v = *numbers[*v as usize].get_or_insert_with(|| {
                kept.push(self.vertices[*v as usize]);
                kept.len() as u32 - 1
            });
        }
        self.vertices = kept;
        self
    }
}

/// A body that is being cut.
struct Cutting {
    body: Polyhedron,
    /// Distance of each old vertex from the plane, positive where it stays.
    inwards: SmallVec<[f64; 16]>,
    /// For each new vertex: the ends of the old edge on which it lies, the smaller number first, and its own number.
    crossings: SmallVec<[([u32; 2], u32); 8]>,
}

impl Cutting {
    /// Cuts each side and drops those without a corner inside.
    fn cut_sides(&mut self, sides: &[Side]) {
        for side in sides {
            let has = |test: fn(f64) -> bool| {
                let mut distances = side.corners.iter().map(|&v| self.inwards[v as usize]);
                distances.any(test)
            };
            if !has(|d| d > 0.0) {
                continue;
            }
            if !has(|d| d < 0.0) {
                self.body.sides.push(side.clone());
                continue;
            }
            let corners = self.cut_ring(&side.corners);
            if corners.len() > 2 {
                self.body.sides.push(Side { corners, ..*side });
            }
        }
    }

    /// The ring of a side clipped by the plane: the corners inside, and those where edges cross the plane (Sutherland,
    /// Hodgman 1974, Reentrant polygon clipping).
    fn cut_ring(&mut self, ring: &[u32]) -> SideCorners {
        let is_inside = |all: &Self, v: u32| all.inwards[v as usize] >= 0.0;
        let mut corners = SideCorners::new();
        let mut from = ring[ring.len() - 1];
        for &to in ring {
            if is_inside(self, from) != is_inside(self, to) {
                let corner = self.corner([from, to]);
                corners.push(corner);
            }
            if is_inside(self, to) {
                corners.push(to);
            }
            from = to;
        }
        corners.dedup();
        if corners.first() == corners.last() {
            corners.pop();
        }
        corners
    }

    /// The number of the vertex where an edge meets the plane.
    fn corner(&mut self, [a, b]: [u32; 2]) -> u32 {
        let [da, db] = [a, b].map(|v| self.inwards[v as usize]);
        if let Some((_, v)) = [(da, a), (db, b)].into_iter().find(|&(d, _)| d == 0.0) {
            return v;
        }
        let edge = [a.min(b), a.max(b)];
        if let Some(&(_, v)) = self.crossings.iter().find(|(known, _)| *known == edge) {
            return v;
        }
        let [p, q] = [a, b].map(|v| self.body.vertices[v as usize]);
        let v = self.body.vertices.len() as u32;
        self.body.vertices.push(p + (q - p) * (da / (da - db)));
        self.crossings.push((edge, v));
        v
    }

    /// The ring of the new side: the edges in the plane that belong to one side only, each reversed.
    fn rim(&self) -> SideCorners {
        let edges = self.body.sides.iter().flat_map(|side| {
            let next = side.corners.iter().cycle().skip(1);
            side.corners.iter().zip(next).map(|(&a, &b)| [a, b])
        });
        let is_on = |v: u32| self.inwards.get(v as usize).is_none_or(|&d| d == 0.0);
        let edges = edges.filter(|&[a, b]| is_on(a) && is_on(b));
        let edges: SmallVec<[[u32; 2]; 16]> = edges.collect();
        let mut open: SmallVec<[[u32; 2]; 16]> = edges
            .iter()
            .filter(|&&[a, b]| !edges.contains(&[b, a]))
            .map(|&[a, b]| [b, a])
            .collect();
        let Some([first, mut at]) = open.pop() else {
            return SmallVec::new();
        };
        let mut rim: SideCorners = smallvec![first];
        while at != first {
            rim.push(at);
            let Some(k) = open.iter().position(|edge| edge[0] == at) else {
                break;
            };
            at = open.swap_remove(k)[1];
        }
        rim
    }
}
