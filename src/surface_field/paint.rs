//! Constraints from painted strokes at the vertices around them.

use super::Stroke;
use super::stroke::distance;
use crate::field::symmetry::representation;
use crate::trimesh::adjacency::Adjacency;
use crate::trimesh::{SurfacePoint, TriMesh};
use glam::{DVec2, DVec3};
use std::collections::{BTreeMap, BTreeSet};

/// A stroke reaches this many widths.
const REACH: f64 = 2.2;
/// Pieces of a stroke are at least this many widths long.
const PIECE: f64 = 0.25;

/// For each vertex near a stroke: its share (0..1), and the share times the representation vector.
pub(super) type Paint = BTreeMap<u32, (f64, DVec2)>;

/// Paints a stroke over what is there, with the share exp(-(d / width)^2) at distance d from its line. The search
/// spreads over the surface, so a stroke does not reach the other side of a thin sheet. `least` is a lower bound of
/// the width.
pub(super) fn add(
    paint: &mut Paint,
    stroke: &Stroke,
    symmetry: u32,
    mesh: &TriMesh,
    links: &Adjacency,
    least: f64,
) {
    let width = if stroke.width.is_finite() {
        stroke.width.max(least)
    } else {
        least
    };
    let mut sums: BTreeMap<u32, (f64, DVec2)> = BTreeMap::new();
    for (from, to) in pieces(stroke, PIECE * width) {
        piece(&mut sums, (&from, &to), width, symmetry, mesh, links);
    }
    for (v, (share, said)) in sums {
        let said = share * said.normalize_or_zero();
        let entry = paint.entry(v).or_insert((0.0, DVec2::ZERO));
        entry.0 = entry.0 * (1.0 - share) + share;
        entry.1 = entry.1 * (1.0 - share) + said;
    }
}

/// The segments of a stroke, short ones joined.
fn pieces(stroke: &Stroke, least: f64) -> Vec<(SurfacePoint, SurfacePoint)> {
    let mut pieces: Vec<(SurfacePoint, SurfacePoint)> = Vec::new();
    let Some((&first, rest)) = stroke.points.split_first() else {
        return pieces;
    };
    let mut from = first;
    for (k, &to) in rest.iter().enumerate() {
        let far = from.at.distance(to.at);
        if far >= least || (k + 1 == rest.len() && far > 0.0) {
            pieces.push((from, to));
            from = to;
        }
    }
    pieces
}

fn piece(
    sums: &mut BTreeMap<u32, (f64, DVec2)>,
    (from, to): (&SurfacePoint, &SurfacePoint),
    width: f64,
    symmetry: u32,
    mesh: &TriMesh,
    links: &Adjacency,
) {
    let by = to.at - from.at;
    let normal = from.normal + to.normal;
    let corners = [from, to].map(|p| mesh.triangles()[p.triangle as usize]);
    let mut open: Vec<u32> = corners.as_flattened().to_vec();
    let mut met: BTreeSet<u32> = open.iter().copied().collect();
    // The stroke reaches all corners of the triangles that it lies in, however large the triangles are.
    let edges = [from, to].map(|p| longest_edge(mesh, p.triangle));
    let near: BTreeSet<u32> = met.clone();
    while let Some(v) = open.pop() {
        let mut d = distance(mesh.positions()[v as usize], from.at, by);
        if near.contains(&v) {
            d = (d - edges[0].max(edges[1])).max(0.0).max(d.min(width));
        }
        if d > REACH * width || mesh.normals()[v as usize].dot(normal) <= 0.0 {
            continue;
        }
        hear(sums, v, d / width, by, symmetry, links);
        for &other in &links.to[links.of(v as usize)] {
            if met.insert(other) {
                open.push(other);
            }
        }
    }
}

fn hear(
    sums: &mut BTreeMap<u32, (f64, DVec2)>,
    v: u32,
    d: f64,
    by: DVec3,
    symmetry: u32,
    links: &Adjacency,
) {
    let share = libm::exp(-d * d);
    let along = links.frames[v as usize].within(by).normalize_or_zero();
    let entry = sums.entry(v).or_insert((0.0, DVec2::ZERO));
    entry.0 = entry.0.max(share);
    // The square of the share counts, so that the nearest of several pieces counts most.
    entry.1 += share * share * representation(along, symmetry);
}

fn longest_edge(mesh: &TriMesh, triangle: u32) -> f64 {
    let [a, b, c] = mesh.corners(triangle);
    a.distance(b).max(b.distance(c)).max(c.distance(a))
}
