//! Pairs triangles to quadrilaterals (Itoh, Miyata, Shimada 2003, section 5.2).

use super::triangles::{NONE, Triangles};
use super::{Face, Metric, Nodes};
use crate::domain::cross;
use crate::order;

/// Least score (sine of the worst corner) of a pair; worse pairs stay two triangles.
pub(crate) const WORST_SCORE: f64 = 0.5;

/// Elements and their adjacency.
#[derive(Clone, Debug, Default)]
pub(crate) struct Faces {
    pub faces: Vec<Face>,
    /// The element across the side from each node to the next; [`NONE`] at the border.
    pub adjacent: Vec<[u32; 4]>,
}

impl Faces {
    /// Sets `other` as the element across a side of `element`: the side between these two nodes, in this order.
    pub(super) fn put_across(&mut self, element: u32, side: [u32; 2], other: u32) {
        let corners = self.faces[element as usize];
        let corners = corners.nodes();
        let count = corners.len();
        for k in 0..count {
            if [corners[k], corners[(k + 1) % count]] == side {
                self.adjacent[element as usize][k] = other;
            }
        }
    }
}

impl Faces {
    /// Empties the slots of bad elements.
    pub fn leave_out(&mut self, bad: impl Fn(&Face) -> bool) {
        for (f, face) in self.faces.iter_mut().enumerate() {
            if !bad(face) {
                continue;
            }
            face.sides = 0;
            let around = std::mem::replace(&mut self.adjacent[f], [NONE; 4]);
            for other in around.into_iter().filter(|&other| other != NONE) {
                for side in &mut self.adjacent[other as usize] {
                    if *side == f as u32 {
                        *side = NONE;
                    }
                }
            }
        }
    }
}

struct Candidate {
    score: f64,
    triangles: [u32; 2],
    nodes: [u32; 4],
    /// The triangles across the quadrilateral's four sides.
    adjacent: [u32; 4],
}

/// Pairs triangles, best pairs first; ties go by the triangles' order. Edges for which `keep` holds stay, as
/// do triangles with a node without corners, and at least `least` edges around each inner node.
pub(super) fn pair<N: Nodes + ?Sized>(
    nodes: &N,
    triangles: &Triangles,
    keep: impl Fn([u32; 2]) -> bool,
    least: u32,
) -> Faces {
    let mut pairing = Pairing::default();
    while !pairing.advance(nodes, triangles, &keep, usize::MAX) {}
    pairing.finish(nodes.count(), triangles, |_| least)
}

/// A pairing of triangles, in progress.
#[derive(Default)]
pub(crate) struct Pairing {
    candidates: Vec<Candidate>,
    /// The number of triangles done.
    done: usize,
}

impl Pairing {
    /// Scores the pairs of the next `count` triangles; true when finished.
    pub fn advance<N: Nodes + ?Sized>(
        &mut self,
        nodes: &N,
        triangles: &Triangles,
        keep: impl Fn([u32; 2]) -> bool,
        count: usize,
    ) -> bool {
        let end = triangles.nodes.len().min(self.done.saturating_add(count));
        for t in self.done..end {
            self.look(nodes, triangles, &keep, t);
        }
        self.done = end;
        end == triangles.nodes.len()
    }

    /// Makes the elements. `least` gives, for a pair's score, the number of edges that the pair must leave at each
    /// inner node.
    pub fn finish(
        mut self,
        nodes: usize,
        triangles: &Triangles,
        least: impl Fn(f64) -> u32,
    ) -> Faces {
        order::sort(&mut self.candidates, |c| {
            let [a, b] = c.triangles;
            (!order::rank(c.score), order::pair(a, b))
        });
        // The element that each triangle becomes.
        let mut into = vec![NONE; triangles.nodes.len()];
        let mut made = Faces::default();
        let mut valence = valences(nodes, triangles);
        for candidate in self.candidates {
            let [a, b] = candidate.triangles.map(|t| t as usize);
            let ends = [candidate.nodes[1], candidate.nodes[3]].map(|k| k as usize);
            let least = least(candidate.score);
            let to_spare = ends.iter().all(|&k| valence[k] > least);
            if into[a] == NONE && into[b] == NONE && to_spare {
                ends.into_iter().for_each(|k| valence[k] -= 1);
                into[a] = made.faces.len() as u32;
                into[b] = into[a];
                made.faces.push(Face::quad(candidate.nodes));
                made.adjacent.push(candidate.adjacent);
            }
        }
        for (t, (&[a, b, c], &[x, y, z])) in
            triangles.nodes.iter().zip(&triangles.adjacent).enumerate()
        {
            if into[t] == NONE {
                into[t] = made.faces.len() as u32;
                made.faces.push(Face::triangle([a, b, c]));
                made.adjacent.push([z, x, y, NONE]);
            }
        }
        for t in made.adjacent.iter_mut().flatten() {
            if *t != NONE {
                *t = into[*t as usize];
            }
        }
        made
    }

    fn look<N: Nodes + ?Sized>(
        &mut self,
        nodes: &N,
        triangles: &Triangles,
        keep: impl Fn([u32; 2]) -> bool,
        t: usize,
    ) {
        let (corners, sides) = (&triangles.nodes[t], &triangles.adjacent[t]);
        for k in 0..3 {
            let u = sides[k];
            let [c, a, b] = [0, 1, 2].map(|s| corners[(k + s) % 3]);
            // Each pair once, from its first triangle.
            if u == NONE || u < t as u32 || keep([a.min(b), a.max(b)]) {
                continue;
            }
            let j = triangles.side_towards(u, t as u32);
            let (d, other) = (
                triangles.nodes[u as usize][j],
                triangles.adjacent[u as usize],
            );
            let quad = [c, a, d, b];
            let score = score(nodes, quad);
            if score >= WORST_SCORE {
                self.candidates.push(Candidate {
                    score,
                    triangles: [t as u32, u],
                    nodes: quad,
                    adjacent: [
                        sides[(k + 2) % 3],
                        other[(j + 1) % 3],
                        other[(j + 2) % 3],
                        sides[(k + 1) % 3],
                    ],
                });
            }
        }
    }
}

/// The number of edges at each node; unlimited at the border.
fn valences(nodes: usize, triangles: &Triangles) -> Vec<u32> {
    let mut valence = vec![0; nodes];
    for corners in &triangles.nodes {
        for &k in corners {
            valence[k as usize] += 1;
        }
    }
    for (corners, sides) in triangles.nodes.iter().zip(&triangles.adjacent) {
        for k in (0..3).filter(|&k| sides[k] == NONE) {
            // The side between the next two corners.
            for s in [1, 2] {
                valence[corners[(k + s) % 3] as usize] = u32::MAX;
            }
        }
    }
    valence
}

/// The least sine of a quadrilateral's angles, in the mean metric of its nodes: 1 for a rectangle, negative
/// if it is not convex or a node has no corners.
pub(crate) fn score<N: Nodes + ?Sized>(nodes: &N, quad: [u32; 4]) -> f64 {
    if quad.iter().any(|&k| !nodes.has_corners(k)) {
        return -1.0;
    }
    let corners = nodes.laid(quad);
    let metric = Metric::mean(corners.map(|node| node.metric));
    let mut least = 1.0_f64;
    let sides = [0, 1, 2, 3].map(|k| corners[(k + 1) % 4].at - corners[k].at);
    let lengths = sides.map(|side| metric.length(side));
    for k in 0..4 {
        let before = (k + 3) % 4;
        let sine = sides[before].perp_dot(sides[k]) / (lengths[before] * lengths[k]);
        least = least.min(sine);
    }
    least
}

/// A triangle's height over its longest side in the mean metric of its nodes: 0.866 if equilateral, negative
/// if inverted.
pub(crate) fn height<N: Nodes + ?Sized>(nodes: &N, triangle: [u32; 3]) -> f64 {
    let [a, b, c] = nodes.laid(triangle);
    let metric = Metric::mean([a.metric, b.metric, c.metric, c.metric]);
    let sides = [b.at - a.at, c.at - b.at, a.at - c.at];
    let longest = sides.map(|side| metric.dot(side, side));
    let longest = longest[0].max(longest[1]).max(longest[2]);
    cross(a.at, b.at, c.at) / longest
}

/// Whether this is a triangle that could be part of a quadrilateral.
pub(crate) fn is_lone<N: Nodes + ?Sized>(nodes: &N, face: &Face) -> bool {
    face.sides == 3 && face.nodes().iter().all(|&k| nodes.has_corners(k))
}
