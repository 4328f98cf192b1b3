//! What all geometry stands on: the space that places lie in, the grain they are rounded to, and the
//! one triangulation of the program (spade).
//!
//! Points go into a triangulation one after the other, in the order of their ids. spade's bulk load
//! would be quicker, but it sorts with an unstable sort, whose ties may fall differently where `usize`
//! has another width; the result would then depend on the machine.

mod rtree;
mod segment;
mod snap;
mod space;

pub(crate) use segment::{closest_on_segment, crosses, divided};
pub use space::Space;

use crate::order;
use glam::DVec2;
use robust::{Coord, orient2d};
use snap::snap;
use spade::handles::FixedVertexHandle;
use spade::{
    ConstrainedDelaunayTriangulation, Point2, PositionInTriangulation, Triangulation as _,
};

/// A triangulation, with or without constraints: two types would bring two copies of spade into the
/// WebAssembly.
pub(crate) type Delaunay = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// Points that are to be equal where they nearly are get rounded to this (picture units); a power
/// of two, so that whole steps and pictures' sides add without rounding.
const GRAIN: f64 = 1.0 / 65536.0;

/// Lines are taken as far as this from the origin, along each axis (picture units): nothing that
/// counts is farther, and products of three such ways, in steps of the grain, have 126 bits.
const FAR: f64 = 8_388_608.0;

/// Adds a point; nothing where it has no finite place.
pub(crate) fn insert(mesh: &mut Delaunay, p: Point2<f64>) -> Option<FixedVertexHandle> {
    mesh.insert(p).ok()
}

/// The constrained Delaunay triangulation of lines, rounded to the grain and divided where they cross,
/// and the edges that the first `walls` of them have become: the numbers of two vertices, the smaller
/// first, in rising order.
pub(crate) fn triangulate_lines(
    lines: impl Iterator<Item = [DVec2; 2]>,
    walls: usize,
) -> (Delaunay, Vec<[u32; 2]>) {
    let lines: Vec<[DVec2; 2]> = lines.filter_map(clipped).map(|l| l.map(on_grain)).collect();
    let snapped = snap(&lines);
    let mut mesh = Delaunay::new();
    let points = snapped.points.iter();
    let handles: Vec<Option<FixedVertexHandle>> = points
        .map(|p| insert(&mut mesh, Point2::new(p.x, p.y)))
        .collect();
    let mut edges = Vec::new();
    for (line, piece) in snapped.pieces {
        if let [Some(a), Some(b)] = piece.map(|k| handles[k as usize]) {
            mesh.add_constraint(a, b);
            if (line as usize) < walls {
                edges.push(edge_of(a, b));
            }
        }
    }
    order::sort(&mut edges, |e| (order::pair(e[0], e[1]), 0));
    (mesh, edges)
}

/// The numbers of two vertices, the smaller first.
pub(crate) fn edge_of(a: FixedVertexHandle, b: FixedVertexHandle) -> [u32; 2] {
    let [a, b] = [a, b].map(|v| v.index() as u32);
    [a.min(b), a.max(b)]
}

/// What lies nearer than [`FAR`] of a line; nothing where its ends have no finite place.
fn clipped([a, b]: [DVec2; 2]) -> Option<[DVec2; 2]> {
    if a.abs().max(b.abs()).max_element() <= FAR {
        return Some([a, b]);
    }
    // The parts of the way at which the box's sides are met; none where the line runs beside them.
    let (way, far) = (b - a, DVec2::splat(FAR));
    let (s, t) = ((-far - a) / way, (far - a) / way);
    let (from, to) = (
        s.min(t).max_element().max(0.0),
        s.max(t).min_element().min(1.0),
    );
    let ends = [a + way * from, a + way * to];
    (from < to && ends.iter().all(|p| p.is_finite())).then_some(ends)
}

/// Rounds a point to the grain.
pub(crate) fn on_grain(p: DVec2) -> DVec2 {
    // Halves always up, so that images of a place are rounded alike.
    (p / GRAIN + 0.5).floor() * GRAIN
}

/// A point as spade has it, rounded to the grain.
pub(crate) fn grain(p: DVec2) -> Point2<f64> {
    let q = on_grain(p);
    Point2::new(q.x, q.y)
}

/// Positive where a, b, c run clockwise on screen, negative where they run the other way, 0 on one
/// line: exact.
pub(crate) fn orientation(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let coord = |p: DVec2| Coord { x: p.x, y: p.y };
    orient2d(coord(a), coord(b), coord(c))
}

/// A point of spade's.
pub(crate) fn position(p: Point2<f64>) -> DVec2 {
    DVec2::new(p.x, p.y)
}

/// The numbers of the triangles that a point lies in: more than one where it lies between them.
pub(crate) fn triangles_at(mesh: &Delaunay, p: DVec2) -> Vec<usize> {
    // Inner faces are numbered from 1: 0 is the outer face.
    match mesh.locate(grain(p)) {
        PositionInTriangulation::OnFace(face) => vec![face.index() - 1],
        PositionInTriangulation::OnEdge(edge) => {
            let edge = mesh.directed_edge(edge);
            let faces = [edge, edge.rev()].map(|e| e.face().as_inner());
            faces
                .iter()
                .flatten()
                .map(|f| f.fix().index() - 1)
                .collect()
        }
        PositionInTriangulation::OnVertex(vertex) => {
            let edges = mesh.vertex(vertex).out_edges();
            let faces = edges.filter_map(|e| e.face().as_inner());
            faces.map(|f| f.fix().index() - 1).collect()
        }
        _ => Vec::new(),
    }
}
