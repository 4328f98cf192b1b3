//! Smoothing: moves nodes so that the quadrilaterals around irregular places become more rectangular.
//!
//! Where rows end the packed centres are in equilibrium, but the elements between them lean. Each
//! quadrilateral proposes for its corners the rectangle that fits it best: around its centre, with diagonals
//! made equally long. A node moves to the mean of the proposals if its elements gain by that, so nothing is
//! ever turned inside out.

use super::quads::{height, score};
use super::{Face, Metric, Node};
use glam::DVec2;

/// Passes over the nodes.
const ROUNDS: u32 = 8;
/// A node whose proposed move is smaller than this (in lengths of the side it belongs to) stays.
const LEAST_MOVE: f64 = 0.01;
/// Cost of a side at 45 degrees to its cell's axis.
const TURNED: f64 = 0.3;
/// A triangle lower than this share of its longest side has no value in a move.
const FLAT: f64 = 0.4;

/// Smooths the nodes marked in `free`. Nodes on the border should not be marked.
pub(super) fn smooth(nodes: &mut [Node], faces: &[Face], free: &[bool]) {
    let mut start = vec![0u32; nodes.len() + 1];
    for &k in faces.iter().flat_map(Face::nodes) {
        start[k as usize + 1] += 1;
    }
    for k in 1..start.len() {
        start[k] += start[k - 1];
    }
    let mut uses = vec![0u32; start[nodes.len()] as usize];
    let mut at = start.clone();
    for (f, face) in faces.iter().enumerate() {
        for &k in face.nodes() {
            uses[at[k as usize] as usize] = f as u32;
            at[k as usize] += 1;
        }
    }
    // Nodes beside one that moved in the last pass.
    let mut awake = free.to_vec();
    for _ in 0..ROUNDS {
        let mut next = vec![false; nodes.len()];
        for k in 0..nodes.len() {
            if !awake[k] || !free[k] {
                continue;
            }
            let around = &uses[start[k] as usize..start[k + 1] as usize];
            if move_one(nodes, faces, around, k as u32) {
                for &near in around.iter().flat_map(|&f| faces[f as usize].nodes()) {
                    next[near as usize] = true;
                }
            }
        }
        awake = next;
    }
}

/// Moves a node if that improves its elements.
fn move_one(nodes: &mut [Node], faces: &[Face], around: &[u32], k: u32) -> bool {
    let old = nodes[k as usize].at;
    let (mut sum, mut count, mut longest) = (DVec2::ZERO, 0u32, 0.0_f64);
    for &f in around {
        if let [a, b, c, d] = *faces[f as usize].nodes() {
            let corners = [a, b, c, d];
            let place = corners.iter().position(|&c| c == k).unwrap_or(0);
            let [p, q, r, s] = [0, 1, 2, 3].map(|j| &nodes[corners[(place + j) % 4] as usize]);
            let metric = Metric::mean([p.metric, q.metric, r.metric, s.metric]);
            let (own, other) = (p.at - r.at, q.at - s.at);
            let (length, other) = (metric.length(own), metric.length(other));
            sum += (p.at + q.at + r.at + s.at) / 4.0 + own * (0.25 * (length + other) / length);
            longest = longest.max(length);
            count += 1;
        }
    }
    if count == 0 {
        return false;
    }
    let by = sum / f64::from(count) - old;
    if by.length() < LEAST_MOVE * longest {
        return false;
    }
    let before = worth(nodes, faces, around);
    for pace in [1.0, 0.4] {
        nodes[k as usize].at = old + pace * by;
        if worth(nodes, faces, around) > before {
            return true;
        }
    }
    nodes[k as usize].at = old;
    false
}

/// The sum of the elements' quality; bad elements weigh more.
fn worth(nodes: &[Node], faces: &[Face], around: &[u32]) -> f64 {
    let mut sum = 0.0;
    for &f in around {
        match *faces[f as usize].nodes() {
            [a, b, c, d] => {
                let lack = 1.0 - score(nodes, [a, b, c, d]);
                sum -= lack + lack * lack;
                for j in 0..4 {
                    let [p, q] = [j, (j + 1) % 4].map(|j| &nodes[[a, b, c, d][j] as usize]);
                    let (side, e) = (q.at - p.at, p.axis);
                    let turned = 2.0 * side.dot(e) * side.perp_dot(e) / side.length_squared();
                    sum -= TURNED * turned * turned;
                }
            }
            [a, b, c] => {
                sum -= 4.0 * (FLAT - height(nodes, [a, b, c])).max(0.0);
            }
            _ => {}
        }
    }
    sum
}
