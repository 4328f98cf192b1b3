//! Triangles over a region of a face: a constrained Delaunay triangulation of its rings and of the lines at which the
//! face bends.

use super::region::SpotRing;
use crate::domain::signed_area;
use crate::order::{self, SortKey, rank};
use crate::planar::{self, Delaunay, position};
use glam::DVec2;
use spade::Triangulation as _;
use std::collections::{BTreeMap, BTreeSet};

/// Units of the triangulation per metre. Its grid then has steps of 60 nanometres, and reaches over 32 kilometres.
const UNITS: f64 = 256.0;
/// The relative tolerance between the area of the triangles and that of the rings.
const SAME_AREA: f64 = 1e-5;

/// The rings run the wrong way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct WrongWay;

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum TriangleCorner {
    /// A vertex of a ring.
    Vertex(u32),
    /// A new place inside of the region.
    Inner(DVec2),
}

/// Triangulates the region of rings that do not touch. `strips` are values of s whose lines no triangle crosses.
///
/// # Errors
/// If outer rings are not counter-clockwise, or holes are not clockwise.
pub(super) fn triangulate(
    rings: &[SpotRing],
    strips: &[f64],
) -> Result<Vec<[TriangleCorner; 3]>, WrongWay> {
    let spots = || rings.iter().flatten();
    let bounds = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    let [low, high] = spots().fold(bounds, |[lo, hi], p| [lo.min(p.at), hi.max(p.at)]);
    // Turns -0 into 0: the order of the lines below tells the two apart, and the `min` of both depends on the machine.
    let scaled = |p: DVec2| (p - low) * UNITS + DVec2::ZERO;
    let mut lines: Vec<[DVec2; 2]> = Vec::new();
    for ring in rings {
        let next = ring.iter().cycle().skip(1);
        lines.extend(
            ring.iter()
                .zip(next)
                .map(|(a, b)| [a, b].map(|spot| scaled(spot.at))),
        );
    }
    let walls = lines.len();
    // Points are inserted in this order, a sweep along s, which changes few triangles at a time. Ring by ring, each
    // point of the second ring would change all triangles at the first one again.
    order::sort(&mut lines, |[a, b]| {
        (rank(a.x.min(b.x)), rank(a.y.min(b.y)))
    });
    let within = strips.iter().filter(|&&s| s > low.x && s < high.x);
    lines.extend(within.map(|&s| [low.y, high.y].map(|t| scaled(DVec2::new(s, t)))));
    let (mesh, edges) = planar::triangulate_lines(lines.into_iter(), walls);
    let known: BTreeMap<SortKey, u32> = spots()
        .filter_map(|spot| Some((grid_key(planar::on_grain(scaled(spot.at))), spot.vertex?)))
        .collect();
    let inside = inside(&mesh, edges.into_iter().collect());
    let corner = |p: DVec2| match known.get(&grid_key(p)) {
        Some(&vertex) => TriangleCorner::Vertex(vertex),
        None => TriangleCorner::Inner(low + p / UNITS),
    };
    let (mut triangles, mut area) = (Vec::new(), 0.0);
    for face in mesh
        .inner_faces()
        .filter(|face| inside[face.fix().index() - 1])
    {
        let corners = face.positions().map(position);
        area += signed_area(&corners);
        triangles.push(corners.map(corner));
    }
    let rings = rings
        .iter()
        .map(|ring| ring.iter().map(|spot| scaled(spot.at)).collect());
    let wanted: f64 = rings.map(|ring: Vec<DVec2>| signed_area(&ring)).sum();
    let is_right = wanted > 0.0 && (area.abs() - wanted).abs() <= SAME_AREA * wanted;
    is_right.then_some(triangles).ok_or(WrongWay)
}

fn grid_key(p: DVec2) -> SortKey {
    // Zero and minus zero are one place.
    (rank(p.x + 0.0), rank(p.y + 0.0))
}

/// For each triangle whether it lies inside: from the outer face on, each wall crossed leads in or out.
fn inside(mesh: &Delaunay, walls: BTreeSet<[u32; 2]>) -> Vec<bool> {
    let is_wall = |ends: [u32; 2]| walls.contains(&ends);
    // The triangle beyond each side, and whether a wall is between.
    let mut across: Vec<[(Option<usize>, bool); 3]> = Vec::with_capacity(mesh.num_inner_faces());
    for face in mesh.inner_faces() {
        across.push(face.adjacent_edges().map(|edge| {
            // Inner faces are numbered from 1: 0 is the outer face.
            let other = edge.rev().face().as_inner().map(|f| f.fix().index() - 1);
            let ends = planar::edge_of(edge.from().fix(), edge.to().fix());
            (other, is_wall(ends))
        }));
    }
    let mut inside: Vec<Option<bool>> = vec![None; across.len()];
    let mut open: Vec<(usize, bool)> = Vec::new();
    for (at, sides) in across.iter().enumerate() {
        let outer = sides.iter().filter(|side| side.0.is_none());
        open.extend(outer.map(|side| (at, side.1)));
    }
    while let Some((at, is_inside)) = open.pop() {
        if inside[at].is_none() {
            inside[at] = Some(is_inside);
            let beyond = across[at].iter();
            open.extend(beyond.filter_map(|&(next, wall)| Some((next?, is_inside != wall))));
        }
    }
    inside
        .into_iter()
        .map(|state| state == Some(true))
        .collect()
}
