//! T-junctions of a file's polygons: vertices of one polygon within a side of another.
//!
//! Modelling programs leave them where a wall is divided around its windows and the wall round the corner is not. The
//! side is divided there, so that both polygons meet along an edge.

use super::polygon_sides::{PlaneRing, sides};
use crate::order::{self, rank};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Vertices this near to a side lie on it (metres).
const ON: f64 = 2e-4;
/// Files with more open sides are left as they are: they have more faces than a building may have.
const MOST: usize = 20_000;
/// The vertices are sorted along this direction, in which hardly any two of a building are equal.
const SORTED: DVec3 = DVec3::new(0.6123, 0.4877, 0.6223);

/// A directed side, and the vertices that divide it.
type Divided = BTreeMap<(u32, u32), Vec<u32>>;

/// Divides the open sides of polygons at vertices of other open sides, where that joins two polygons.
pub(super) fn divide(rings: &mut [PlaneRing], positions: &[DVec3]) {
    let all: BTreeSet<(u32, u32)> = rings.iter().flat_map(|ring| sides(&ring.0)).collect();
    let open = all.iter().filter(|&&(a, b)| !all.contains(&(b, a)));
    let open: Vec<(u32, u32)> = open.copied().collect();
    if open.len() > MOST {
        return;
    }
    let mut divided = candidates(&open, positions);
    let parts = |side: &(u32, u32), within: &[u32]| {
        let ends = [&[side.0], within, &[side.1]].concat();
        ends.windows(2)
            .map(|pair| (pair[0], pair[1]))
            .collect::<Vec<_>>()
    };
    let mut new = all.clone();
    for (side, within) in &divided {
        new.extend(parts(side, within));
    }
    divided.retain(|side, within| {
        let parts = parts(side, within);
        // A part that is there already would have two polygons to its left.
        parts.iter().any(|&(a, b)| new.contains(&(b, a)))
            && !parts.iter().any(|part| all.contains(part))
    });
    for (ring, ..) in rings {
        let whole = std::mem::take(ring);
        for side in sides(&whole) {
            ring.push(side.0);
            ring.extend(divided.get(&side).into_iter().flatten());
        }
    }
}

/// The open sides with vertices of other open sides within them, in order from start to end.
fn candidates(open: &[(u32, u32)], positions: &[DVec3]) -> Divided {
    let place = |v: u32| positions[v as usize];
    let vertices: BTreeSet<u32> = open.iter().flat_map(|&(a, b)| [a, b]).collect();
    let mut sorted: Vec<(f64, u32)> = vertices
        .into_iter()
        .map(|v| (place(v).dot(SORTED), v))
        .collect();
    order::sort(&mut sorted, |&(at, v)| (rank(at), v.into()));
    let within = |&(a, b): &(u32, u32)| {
        let (from, to) = (place(a), place(b));
        let (along, length) = ((to - from).normalize_or_zero(), from.distance(to));
        let [low, high] = [from, to].map(|p| p.dot(SORTED));
        let (low, high) = (low.min(high) - ON, low.max(high) + ON);
        let near = &sorted[sorted.partition_point(|&(at, _)| at < low)..];
        let mut found: Vec<(f64, u32)> = Vec::new();
        for &(_, v) in near.iter().take_while(|&&(at, _)| at <= high) {
            let t = (place(v) - from).dot(along);
            let is_inner = v != a && v != b && t > ON && t < length - ON;
            if is_inner && (from + along * t).distance(place(v)) < ON {
                found.push((t, v));
            }
        }
        order::sort(&mut found, |&(t, v)| (rank(t), v.into()));
        found.into_iter().map(|(_, v)| v).collect::<Vec<u32>>()
    };
    let all = open.iter().map(|side| (*side, within(side)));
    all.filter(|(_, within)| !within.is_empty()).collect()
}
