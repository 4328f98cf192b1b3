//! Chains edges to rings, and finds tangled rings.

use crate::domain::signed_area;
use crate::order;
use crate::planar::crosses;
use glam::DVec2;

/// Chains directed edges to rings: outer ones have positive area, holes negative.
pub(super) fn rings(mut edges: Vec<[DVec2; 2]>) -> Vec<Vec<DVec2>> {
    let key = |p: DVec2| (p.x.to_bits(), p.y.to_bits());
    order::sort(&mut edges, |e| key(e[1]));
    order::sort(&mut edges, |e| key(e[0]));
    let mut used = vec![false; edges.len()];
    let mut rings = Vec::new();
    for first in 0..edges.len() {
        if used[first] {
            continue;
        }
        used[first] = true;
        let mut ring = vec![edges[first][0]];
        let mut at = edges[first];
        while at[1] != ring[0] {
            let from = edges.partition_point(|e| key(e[0]) < key(at[1]));
            let ahead = at[1] - at[0];
            // Where two parts touch in a point, the sharpest turn to the right keeps the ring
            // simple.
            let next = (from..edges.len())
                .take_while(|&k| edges[k][0] == at[1])
                .filter(|&k| !used[k])
                .max_by(|&a, &b| {
                    let turn = |k: usize| angle_rank(ahead, edges[k][1] - edges[k][0]);
                    turn(a).total_cmp(&turn(b))
                });
            let Some(next) = next else { break };
            used[next] = true;
            ring.push(at[1]);
            at = edges[next];
        }
        rings.push(ring);
    }
    rings
}

/// Grows with the turn from u to v: from -2 for half a turn to the left, to 2 for half a turn to
/// the right, on screen.
fn angle_rank(u: DVec2, v: DVec2) -> f64 {
    let (s, c) = (u.perp_dot(v), u.dot(v));
    let length = (s * s + c * c).sqrt().max(f64::MIN_POSITIVE);
    if s >= 0.0 {
        1.0 - c / length
    } else {
        c / length - 1.0
    }
}

/// Whether a ring is inside out or crosses itself.
pub(super) fn is_tangled(ring: &[DVec2]) -> bool {
    let n = ring.len();
    let side = |k: usize| (ring[k], ring[(k + 1) % n]);
    let cross = |i: usize, j: usize| {
        let ((a, b), (c, d)) = (side(i), side(j));
        // The last side meets the first one at a corner.
        (j + 1) % n != i && crosses(a, b, c, d)
    };
    signed_area(ring) <= 0.0 || (0..n).any(|i| (i + 2..n).any(|j| cross(i, j)))
}
