//! Pairs triangles to quadrilaterals (Itoh, Miyata, Shimada 2003, section 5.2).

use super::Face;
use crate::order;
use glam::DVec2;

/// A pair scores the least sine of its four corners; worse ones stay two triangles.
const WORST_SCORE: f64 = 0.5;

struct Candidate {
    score: f64,
    triangles: [u32; 2],
    nodes: [u32; 4],
}

/// The best pairs first; ties by the triangles' order. Edges for which `keep` holds stay.
pub(super) fn pair(
    vertices: &[DVec2],
    triangles: &[[u32; 3]],
    keep: impl Fn([u32; 2]) -> bool,
) -> Vec<Face> {
    let mut candidates = candidates(vertices, triangles, keep);
    order::sort(&mut candidates, |c| {
        let [a, b] = c.triangles;
        (!order::rank(c.score), order::pair(a, b))
    });
    let mut used = vec![false; triangles.len()];
    let mut faces = Vec::new();
    for candidate in candidates {
        let [a, b] = candidate.triangles.map(|t| t as usize);
        if !used[a] && !used[b] {
            used[a] = true;
            used[b] = true;
            faces.push(Face::quad(candidate.nodes));
        }
    }
    let lone = triangles.iter().zip(used).filter(|(_, used)| !used);
    faces.extend(lone.map(|(&nodes, _)| Face::triangle(nodes)));
    faces
}

fn candidates(
    vertices: &[DVec2],
    triangles: &[[u32; 3]],
    keep: impl Fn([u32; 2]) -> bool,
) -> Vec<Candidate> {
    // Every side as (lower node, higher node, triangle, opposite node): partners become neighbours.
    let mut sides: Vec<[u32; 4]> = Vec::with_capacity(3 * triangles.len());
    for (index, nodes) in triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (nodes[(k + 1) % 3], nodes[(k + 2) % 3]);
            sides.push([a.min(b), a.max(b), index as u32, nodes[k]]);
        }
    }
    order::sort(&mut sides, |&[a, b, t, c]| {
        (order::pair(a, b), order::pair(t, c))
    });
    let mut candidates = Vec::new();
    for w in sides.windows(2) {
        let [[a, b, t, c], [a2, b2, u, d]] = [w[0], w[1]];
        if (a, b) != (a2, b2) || keep([a, b]) {
            continue;
        }
        // Around the quadrilateral: c, one end of the side, d, the other end.
        let turn = |k: u32| vertices[k as usize] - vertices[c as usize];
        let nodes = if turn(a).perp_dot(turn(b)) > 0.0 {
            [c, a, d, b]
        } else {
            [c, b, d, a]
        };
        let score = least_sine(nodes.map(|k| vertices[k as usize]));
        if score >= WORST_SCORE {
            candidates.push(Candidate {
                score,
                triangles: [t, u],
                nodes,
            });
        }
    }
    candidates
}

/// The least sine of the corners' angles; 1 for a rectangle, negative where it is not convex.
fn least_sine(corners: [DVec2; 4]) -> f64 {
    let mut least = 1.0_f64;
    for k in 0..4 {
        let u = corners[(k + 1) % 4] - corners[k];
        let v = corners[(k + 3) % 4] - corners[k];
        least = least.min(u.perp_dot(v) / (u.length() * v.length()));
    }
    least
}
