//! A closed triangle mesh whose edges can be split, collapsed and flipped.
//!
//! Half edge `3 t + k` goes from corner `k` of triangle `t` to the next one. In removed triangles it begins at
//! [`NONE`].

use crate::csr::Csr;
use crate::trimesh::NONE;
use glam::DVec3;

pub(super) struct Surgery {
    pub positions: Vec<DVec3>,
    /// The vertex where each half edge begins.
    pub from: Vec<u32>,
    /// For each half edge its opposite, in the neighbouring triangle.
    pub twin: Vec<u32>,
    /// For each vertex a half edge that begins there; [`NONE`] for removed vertices.
    pub out: Vec<u32>,
}

/// The next half edge in the same triangle.
pub(super) fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

/// The half edge before, in the same triangle.
pub(super) fn before(h: u32) -> u32 {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

impl Surgery {
    /// Builds the mesh; `None` unless the triangles close: each directed edge occurs once, and so does its reverse.
    pub fn new(positions: Vec<DVec3>, triangles: &[[u32; 3]]) -> Option<Self> {
        let mut surgery = Self {
            out: vec![NONE; positions.len()],
            from: triangles.iter().flatten().copied().collect(),
            twin: vec![NONE; 3 * triangles.len()],
            positions,
        };
        // Group half edges by their smaller vertex first, by counting: sorting all of them would take ten times as
        // long.
        let ends = |h: u32| {
            let (a, b) = (surgery.start(h), surgery.end(h));
            (a.min(b) as usize, a.max(b))
        };
        let edges = (0..surgery.from.len() as u32).map(|h| {
            let (a, b) = ends(h);
            (a, (b, h))
        });
        let mut edges = Csr::from_pairs(surgery.positions.len(), edges);
        for v in 0..surgery.positions.len() {
            let own = edges.row_mut(v);
            own.sort_unstable();
            let mut pairs = own.chunks_exact(2);
            for pair in &mut pairs {
                let (g, h) = (pair[0].1, pair[1].1);
                if pair[0].0 != pair[1].0 || surgery.start(g) == surgery.start(h) {
                    return None;
                }
                surgery.join(g, h);
            }
            if !pairs.remainder().is_empty() {
                return None;
            }
        }
        for h in 0..surgery.from.len() as u32 {
            let v = surgery.start(h);
            surgery.out[v as usize] = h;
        }
        (!triangles.is_empty()).then_some(surgery)
    }

    pub fn start(&self, h: u32) -> u32 {
        self.from[h as usize]
    }

    pub fn end(&self, h: u32) -> u32 {
        self.from[next(h) as usize]
    }

    pub fn is_alive(&self, h: u32) -> bool {
        self.from[h as usize] != NONE
    }

    pub fn at(&self, v: u32) -> DVec3 {
        self.positions[v as usize]
    }

    pub fn across(&self, h: u32) -> u32 {
        self.twin[h as usize]
    }

    /// The third vertex of the half edge's triangle.
    pub fn apex(&self, h: u32) -> u32 {
        self.from[before(h) as usize]
    }

    /// The vector from its start to its end.
    pub fn vector(&self, h: u32) -> DVec3 {
        self.at(self.end(h)) - self.at(self.start(h))
    }

    /// The half edges that begin at a vertex, clockwise.
    pub fn around(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let first = self.out[v as usize];
        let mut at = (first != NONE).then_some(first);
        std::iter::from_fn(move || {
            let h = at?;
            let beyond = next(self.across(h));
            at = (beyond != first).then_some(beyond);
            Some(h)
        })
    }

    pub fn valence(&self, v: u32) -> usize {
        self.around(v).count()
    }

    fn join(&mut self, g: u32, h: u32) {
        self.twin[g as usize] = h;
        self.twin[h as usize] = g;
    }

    fn set(&mut self, h: u32, from: u32) {
        self.from[h as usize] = from;
        self.out[from as usize] = h;
    }

    /// Splits an edge at a new vertex, and returns the vertex.
    pub fn split(&mut self, h: u32, p: DVec3) -> u32 {
        let g = self.across(h);
        let (hn, gp) = (next(h), before(g));
        let (b, c, d) = (self.end(h), self.apex(h), self.apex(g));
        let m = self.positions.len() as u32;
        self.positions.push(p);
        self.out.push(NONE);
        let n = self.from.len() as u32;
        self.from.extend([NONE; 6]);
        self.twin.extend([NONE; 6]);
        let q = n + 3;
        let (beyond_hn, beyond_gp) = (self.across(hn), self.across(gp));
        self.set(n, m);
        self.set(n + 1, b);
        self.set(n + 2, c);
        self.set(q, b);
        self.set(q + 1, m);
        self.set(q + 2, d);
        self.set(hn, m);
        self.set(g, m);
        self.join(n + 1, beyond_hn);
        self.join(n + 2, hn);
        self.join(q + 2, beyond_gp);
        self.join(q + 1, gp);
        self.join(n, q);
        m
    }

    /// Whether the start of an edge can be merged into its end without breaking the mesh, and with at most `most` edges
    /// there afterwards.
    pub fn can_collapse(&self, h: u32, most: usize) -> bool {
        let (a, b) = (self.start(h), self.end(h));
        let (c, d) = (self.apex(h), self.apex(self.across(h)));
        if self.valence(c) <= 3 || self.valence(d) <= 3 {
            return false;
        }
        if self.valence(a) + self.valence(b) > most + 4 {
            return false;
        }
        let around_b: Vec<u32> = self.around(b).map(|e| self.end(e)).collect();
        let shared = self.around(a).filter(|&e| around_b.contains(&self.end(e)));
        c != d && shared.count() == 2
    }

    /// Merges the start of an edge into its end, which stays where it is. See [`Self::can_collapse`].
    pub fn collapse(&mut self, h: u32) {
        let g = self.across(h);
        let (a, b) = (self.start(h), self.end(h));
        let (c, d) = (self.apex(h), self.apex(g));
        let [x, y, u, w] = [next(h), before(h), next(g), before(g)].map(|e| self.across(e));
        let all: Vec<u32> = self.around(a).collect();
        for e in all {
            self.from[e as usize] = b;
        }
        self.join(x, y);
        self.join(u, w);
        for t in [h / 3, g / 3] {
            for k in 0..3 {
                self.from[(3 * t + k) as usize] = NONE;
            }
        }
        self.out[a as usize] = NONE;
        self.out[b as usize] = y;
        self.out[c as usize] = x;
        self.out[d as usize] = u;
    }

    /// Whether the two vertices opposite an edge are not joined yet.
    pub fn can_flip(&self, h: u32) -> bool {
        let (c, d) = (self.apex(h), self.apex(self.across(h)));
        c != d && self.around(c).all(|e| self.end(e) != d)
    }

    /// Replaces an edge by the one between the two vertices opposite it.
    pub fn flip(&mut self, h: u32) {
        let g = self.across(h);
        let (hn, hp, gn, gp) = (next(h), before(h), next(g), before(g));
        let (a, b, c, d) = (self.start(h), self.end(h), self.apex(h), self.apex(g));
        let [x, y, u, w] = [hn, hp, gn, gp].map(|e| self.across(e));
        self.set(h, d);
        self.set(g, c);
        self.set(hn, c);
        self.set(hp, a);
        self.set(gn, d);
        self.set(gp, b);
        self.join(hn, y);
        self.join(hp, u);
        self.join(gn, w);
        self.join(gp, x);
    }

    /// A copy without removed triangles and vertices.
    pub fn compact(&self) -> Self {
        let numbers = |alive: &mut dyn Iterator<Item = bool>| {
            let mut count = 0;
            let number = alive.map(|is_alive| {
                let own = if is_alive { count } else { NONE };
                count += u32::from(is_alive);
                own
            });
            number.collect::<Vec<u32>>()
        };
        let vertex = numbers(&mut self.out.iter().map(|&h| h != NONE));
        let triangle = numbers(&mut self.from.iter().step_by(3).map(|&v| v != NONE));
        let edge = |h: u32| 3 * triangle[(h / 3) as usize] + h % 3;
        let kept = || (0..self.from.len()).filter(|&h| self.from[h] != NONE);
        let vertices = || (0..self.out.len()).filter(|&v| self.out[v] != NONE);
        Self {
            positions: vertices().map(|v| self.positions[v]).collect(),
            from: kept().map(|h| vertex[self.from[h] as usize]).collect(),
            twin: kept().map(|h| edge(self.twin[h])).collect(),
            out: vertices().map(|v| edge(self.out[v])).collect(),
        }
    }

    /// The vertices and triangles.
    pub fn finish(self) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let compact = self.compact();
        let triangles = compact.from.chunks_exact(3).map(|t| [t[0], t[1], t[2]]);
        let triangles = triangles.collect();
        (compact.positions, triangles)
    }

    /// Divides each triangle into four, with a vertex in the middle of each edge. No triangle may have been removed.
    pub fn divided(&self) -> Self {
        let mut positions = self.positions.clone();
        let mut middle = vec![NONE; self.from.len()];
        for h in 0..self.from.len() as u32 {
            let g = self.across(h);
            if h < g {
                let made = positions.len() as u32;
                positions.push(0.5 * (self.at(self.start(h)) + self.at(self.end(h))));
                middle[h as usize] = made;
                middle[g as usize] = made;
            }
        }
        // The parts of triangle t: 4 t + k is at corner k, and 4 t + 3 in the middle.
        let count = 4 * self.from.len();
        let (mut from, mut twin) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (t, (v, m)) in self
            .from
            .chunks_exact(3)
            .zip(middle.chunks_exact(3))
            .enumerate()
        {
            let t = t as u32;
            let edge = |part: u32, k: u32| 3 * (4 * t + part) + k;
            for k in 0..3 {
                let last = (k + 2) % 3;
                from.extend([v[k], m[k], m[last]]);
                let [own, before] = [k, last].map(|k| self.across(3 * t + k as u32));
                twin.extend([
                    3 * (4 * (own / 3) + (own + 1) % 3) + 2,
                    edge(3, last as u32),
                    3 * (4 * (before / 3) + before % 3),
                ]);
            }
            from.extend([m[0], m[1], m[2]]);
            twin.extend([edge(1, 1), edge(2, 1), edge(0, 1)]);
        }
        let mut divided = Self {
            out: vec![NONE; positions.len()],
            positions,
            from,
            twin,
        };
        for h in 0..divided.from.len() as u32 {
            let v = divided.start(h);
            divided.out[v as usize] = h;
        }
        divided
    }
}
