//! A closed triangle mesh whose edges can be split, collapsed and flipped.
//!
//! Half edge `3 t + k` goes from corner `k` of triangle `t` to the next one. Triangles that are no more begin at
//! [`NONE`].

use crate::order;
use crate::surface::NONE;
use glam::DVec3;

pub(super) struct Surgery {
    pub positions: Vec<DVec3>,
    /// Where each half edge begins.
    pub from: Vec<u32>,
    /// The half edge on the other side.
    pub twin: Vec<u32>,
    /// Of each vertex a half edge that begins there; none where the vertex is no more.
    pub out: Vec<u32>,
}

/// The next half edge of its triangle.
pub(super) fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

/// The one before it.
pub(super) fn before(h: u32) -> u32 {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

impl Surgery {
    /// Of triangles that close, each directed edge once.
    pub fn new(positions: Vec<DVec3>, triangles: &[[u32; 3]]) -> Self {
        let mut surgery = Self {
            out: vec![NONE; positions.len()],
            from: triangles.iter().flatten().copied().collect(),
            twin: vec![NONE; 3 * triangles.len()],
            positions,
        };
        let mut edges: Vec<(u64, u32)> = (0..surgery.from.len() as u32)
            .map(|h| {
                let (a, b) = (surgery.start(h), surgery.end(h));
                (order::pair(a.min(b), a.max(b)), h)
            })
            .collect();
        edges.sort_unstable();
        for pair in edges.chunks_exact(2) {
            debug_assert_eq!(pair[0].0, pair[1].0, "an edge of one triangle");
            surgery.join(pair[0].1, pair[1].1);
        }
        for h in 0..surgery.from.len() as u32 {
            let v = surgery.start(h);
            surgery.out[v as usize] = h;
        }
        surgery
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

    /// The vertex of its triangle that a half edge does not touch.
    pub fn apex(&self, h: u32) -> u32 {
        self.from[before(h) as usize]
    }

    /// From its start to its end.
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

    /// Puts a new vertex on an edge; answers with it.
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

    /// Can the start of an edge be put into its end without a fault of the mesh?
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

    /// Puts the start of an edge into its end, which stays where it is. See [`Self::can_collapse`].
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

    /// Are the two vertices beside an edge joined already?
    pub fn can_flip(&self, h: u32) -> bool {
        let (c, d) = (self.apex(h), self.apex(self.across(h)));
        c != d && self.around(c).all(|e| self.end(e) != d)
    }

    /// Joins the two vertices beside an edge instead of its own.
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

    /// The triangles that there are, and the vertices that they use.
    pub fn finish(&self) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let mut number = vec![NONE; self.positions.len()];
        let mut positions = Vec::new();
        let alive = self.from.chunks_exact(3).filter(|t| t[0] != NONE);
        let triangles = alive.map(|t| {
            [0, 1, 2].map(|k| {
                let v = t[k] as usize;
                if number[v] == NONE {
                    number[v] = positions.len() as u32;
                    positions.push(self.positions[v]);
                }
                number[v]
            })
        });
        let triangles = triangles.collect();
        (positions, triangles)
    }

    /// Each triangle in four, with a vertex in the middle of each edge; no triangle may be gone.
    pub fn divided(&self) -> (Vec<DVec3>, Vec<[u32; 3]>) {
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
        let parts = self.from.chunks_exact(3).zip(middle.chunks_exact(3));
        let triangles = parts.flat_map(|(v, m)| {
            [
                [v[0], m[0], m[2]],
                [v[1], m[1], m[0]],
                [v[2], m[2], m[1]],
                [m[0], m[1], m[2]],
            ]
        });
        let triangles = triangles.collect();
        (positions, triangles)
    }
}
