//! The one triangulation of the program (spade), and the grain its points are rounded to.

use glam::DVec2;
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

/// Adds a point; nothing where it has no finite place. Kept as one function for the same reason.
#[inline(never)]
pub(crate) fn insert(mesh: &mut Delaunay, p: Point2<f64>) -> Option<FixedVertexHandle> {
    mesh.insert(p).ok()
}

/// Lays lines between points of the grain into an empty triangulation, divided where they cross.
pub(crate) fn lay(lines: impl Iterator<Item = [DVec2; 2]>) -> Delaunay {
    let mut mesh = Delaunay::new();
    let mut ends: Vec<[FixedVertexHandle; 2]> = Vec::new();
    for line in lines {
        let [a, b] = line.map(grain);
        if let (Some(a), Some(b)) = (insert(&mut mesh, a), insert(&mut mesh, b))
            && a != b
        {
            ends.push([a, b]);
        }
    }
    for [a, b] in ends {
        mesh.add_constraint_and_split(a, b, |v| v);
    }
    mesh
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
