//! Planar geometry: the space of places (plane or torus), the grid that points are rounded to, and the
//! program's one triangulation (spade).
//!
//! Points are inserted one by one, in the order of their ids. spade's bulk load is quicker, but it sorts with
//! an unstable sort: ties may fall differently where `usize` has another width, and the result would depend
//! on the machine.

mod angle;
mod half_plane;
mod rtree;
mod segment;
mod snap;
mod space;

pub(crate) use angle::{signed_angle, unit_vector};
pub(crate) use half_plane::cut_polygon;
pub(crate) use segment::{closest_on_segment, crosses, divided};
pub use space::Space;

use crate::order;
use glam::DVec2;
use robust::{Coord, orient2d};
use snap::{Snapped, snap};
use spade::handles::FixedVertexHandle;
use spade::{
    ConstrainedDelaunayTriangulation, Point2, PositionInTriangulation, Triangulation as _,
};

/// A triangulation, with or without constraints. One type for both keeps a second copy of spade out of the
/// WebAssembly.
pub(crate) type Delaunay = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// Step of the grid that points are rounded to, so that nearly equal points become equal (picture units). It
/// is a power of two: whole steps and sides of pictures add without rounding.
const GRAIN: f64 = 1.0 / 65536.0;

/// Lines are clipped this far from the origin along each axis (picture units). Nothing farther out matters,
/// and products of three coordinates, in steps of the grain, fit in 126 bits.
const FAR: f64 = 8_388_608.0;

/// Inserts a point; `None` if a coordinate is not finite.
pub(crate) fn insert(mesh: &mut Delaunay, p: Point2<f64>) -> Option<FixedVertexHandle> {
    mesh.insert(p).ok()
}

/// The constrained Delaunay triangulation of lines, rounded to the grain and split where they cross. Also
/// gives the edges that the first `walls` lines have become, as pairs of vertex numbers, the smaller first,
/// in rising order.
pub(crate) fn triangulate_lines(
    lines: impl Iterator<Item = [DVec2; 2]>,
    walls: usize,
) -> (Delaunay, Vec<[u32; 2]>) {
    let mut work = LineTriangulation::new(lines, walls);
    work.advance(&mut { usize::MAX });
    work.finish()
}

/// Does the work of [`triangulate_lines`] in slices.
pub(crate) struct LineTriangulation {
    snapped: Snapped,
    walls: usize,
    mesh: Delaunay,
    /// The vertices of the points that are inserted by now.
    handles: Vec<Option<FixedVertexHandle>>,
    /// How many pieces of lines are constraints by now.
    pieces: usize,
    edges: Vec<[u32; 2]>,
}

impl LineTriangulation {
    /// Starts with all lines, of which the first `walls` give edges.
    pub fn new(lines: impl Iterator<Item = [DVec2; 2]>, walls: usize) -> Self {
        let lines: Vec<[DVec2; 2]> = lines.filter_map(clipped).map(|l| l.map(on_grain)).collect();
        Self {
            snapped: snap(&lines),
            walls,
            mesh: Delaunay::new(),
            handles: Vec::new(),
            pieces: 0,
            edges: Vec::new(),
        }
    }

    /// Inserts points, then pieces of lines. Each takes one off `amount`, and the work pauses when that is 0. True when
    /// nothing is left to insert.
    pub fn advance(&mut self, amount: &mut usize) -> bool {
        loop {
            let point = self.snapped.points.get(self.handles.len());
            let piece = self.snapped.pieces.get(self.pieces);
            if *amount == 0 {
                return point.is_none() && piece.is_none();
            }
            *amount -= 1;
            if let Some(p) = point {
                let handle = insert(&mut self.mesh, Point2::new(p.x, p.y));
                self.handles.push(handle);
                continue;
            }
            let Some(&(line, ends)) = piece else {
                return true;
            };
            if let [Some(a), Some(b)] = ends.map(|k| self.handles[k as usize]) {
                self.mesh.add_constraint(a, b);
                if (line as usize) < self.walls {
                    self.edges.push(edge_of(a, b));
                }
            }
            self.pieces += 1;
        }
    }

    /// The triangulation and the edges, see [`triangulate_lines`].
    pub fn finish(mut self) -> (Delaunay, Vec<[u32; 2]>) {
        order::sort(&mut self.edges, |e| (order::pair(e[0], e[1]), 0));
        (self.mesh, self.edges)
    }
}

/// The numbers of two vertices, the smaller first.
pub(crate) fn edge_of(a: FixedVertexHandle, b: FixedVertexHandle) -> [u32; 2] {
    let [a, b] = [a, b].map(|v| v.index() as u32);
    [a.min(b), a.max(b)]
}

/// The part of a line within [`FAR`] of the origin; `None` if an end is not finite.
fn clipped([a, b]: [DVec2; 2]) -> Option<[DVec2; 2]> {
    if a.abs().max(b.abs()).max_element() <= FAR {
        return Some([a, b]);
    }
    // Line parameters at the sides of the box; infinite where the line runs parallel to a side.
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
    // Halves round up, so that all images of a place are rounded alike.
    (p / GRAIN + 0.5).floor() * GRAIN
}

/// The point as spade's type, rounded to the grain.
pub(crate) fn grain(p: DVec2) -> Point2<f64> {
    let q = on_grain(p);
    Point2::new(q.x, q.y)
}

/// Orientation of three points, exact: positive if a, b, c run clockwise on screen, negative if
/// anticlockwise, 0 if collinear.
pub(crate) fn orientation(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let coord = |p: DVec2| Coord { x: p.x, y: p.y };
    orient2d(coord(a), coord(b), coord(c))
}

/// The coordinates of a spade point.
pub(crate) fn position(p: Point2<f64>) -> DVec2 {
    DVec2::new(p.x, p.y)
}

/// The numbers of the triangles that contain a point; more than one if it lies on an edge or a vertex.
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
