//! Joins the cells' centres into a mesh of mostly quadrilaterals.
//!
//! Itoh, Miyata, Shimada (2003), section 5.2: Delaunay triangulation (spade), then pairs of
//! triangles become quadrilaterals in the order of their quality; lone triangles may stay.

mod quads;

use crate::domain::Domain;
use crate::order;
use crate::packing::Particle;
use crate::planar::{Delaunay, insert};
use glam::DVec2;
use spade::{Point2, Triangulation as _};

/// A mesh element: a triangle or a quadrilateral.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    nodes: [u32; 4],
    sides: u8,
}

impl Face {
    /// A triangle.
    pub fn triangle(nodes: [u32; 3]) -> Self {
        Self {
            nodes: [nodes[0], nodes[1], nodes[2], 0],
            sides: 3,
        }
    }

    /// A quadrilateral.
    pub fn quad(nodes: [u32; 4]) -> Self {
        Self { nodes, sides: 4 }
    }

    /// Indices of the vertices, of positive shoelace area (clockwise on screen).
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..usize::from(self.sides)]
    }

    /// The mean of the corners.
    pub fn centroid(&self, vertices: &[DVec2]) -> DVec2 {
        let nodes = self.nodes();
        let sum: DVec2 = nodes.iter().map(|&k| vertices[k as usize]).sum();
        sum / nodes.len() as f64
    }
}

/// Vertices and the elements between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions in picture units.
    pub vertices: Vec<DVec2>,
    /// Elements, each with at least three different vertices.
    pub faces: Vec<Face>,
}

/// A triangle whose height is less than this share of its longest side is a sliver of the rim.
const SLIVER: f64 = 0.12;
/// Cells at a wall stand half their size from it; a triangle whose middle is nearer than this, in
/// sizes, only bridges a bend.
const AT_WALL: f64 = 0.45;

impl Mesh {
    /// The mesh of the cells' centres within the outline: elements whose middle lies outside,
    /// slivers along the rim, and triangles that lie between the outermost cells and the wall they
    /// stand at, are left out.
    pub fn build(domain: &Domain, particles: &[Particle]) -> Self {
        let centres = particles.iter().map(|p| p.centre).collect();
        let round = |[a, b]: [u32; 2]| {
            [a, b].map(|k| {
                particles
                    .get(k as usize)
                    .is_some_and(|p| !p.kind.has_corners())
            }) != [false; 2]
        };
        let mut mesh = Self::whole(centres, round);
        let vertices = &mesh.vertices;
        mesh.faces.retain(|face| {
            let depth = domain.nearest(face.centroid(vertices)).distance;
            depth > 0.0
                && !is_sliver(face, vertices)
                && !(face.sides == 3 && depth < at_wall(face, particles))
        });
        mesh
    }

    /// The mesh of all points over their convex hull. Edges for which `keep` holds are never
    /// dissolved into a quadrilateral. Points that coincide with an earlier one get no element.
    pub(crate) fn whole(vertices: Vec<DVec2>, keep: impl Fn([u32; 2]) -> bool) -> Self {
        let triangles = triangulate(&vertices);
        let faces = quads::pair(&vertices, &triangles, keep);
        Self { vertices, faces }
    }

    /// For every vertex the elements around it in order, where they close a full turn; empty for
    /// vertices on the rim of the mesh.
    pub(crate) fn fans(&self) -> Fans {
        Fans::new(self)
    }
}

/// How deep a triangle of cells that all stand at a wall has to lie; 0 where one is fixed on it.
fn at_wall(triangle: &Face, particles: &[Particle]) -> f64 {
    let nodes = triangle.nodes().iter().map(|&k| &particles[k as usize]);
    let depth = nodes.map(|p| if p.fixed { 0.0 } else { AT_WALL * p.size });
    depth.fold(f64::INFINITY, f64::min)
}

fn is_sliver(face: &Face, vertices: &[DVec2]) -> bool {
    let [a, b, c] = *face.nodes() else {
        return false;
    };
    let [a, b, c] = [a, b, c].map(|k| vertices[k as usize]);
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    crate::domain::cross(a, b, c) < SLIVER * longest * longest
}

/// Delaunay triangles, each of positive shoelace area, in an order that depends on the points only.
pub(crate) fn triangulate(points: &[DVec2]) -> Vec<[u32; 3]> {
    let mut mesh = Delaunay::default();
    // One after the other in the order given: coinciding points are told apart by their handles.
    let mut name = Vec::with_capacity(points.len());
    for (k, p) in points.iter().enumerate() {
        if let Some(handle) = insert(&mut mesh, Point2::new(p.x, p.y))
            && handle.index() == name.len()
        {
            name.push(k as u32);
        }
    }
    // Spade winds counter-clockwise with y up: a positive shoelace area on the same numbers.
    mesh.inner_faces()
        .map(|face| face.vertices().map(|v| name[v.fix().index()]))
        .collect()
}

/// The elements around each vertex.
pub(crate) struct Fans {
    start: Vec<u32>,
    faces: Vec<u32>,
}

impl Fans {
    fn new(mesh: &Mesh) -> Self {
        // (vertex, next vertex in the element, previous vertex, element)
        let mut corners: Vec<[u32; 4]> = Vec::new();
        for (index, face) in mesh.faces.iter().enumerate() {
            let nodes = face.nodes();
            for k in 0..nodes.len() {
                let next = nodes[(k + 1) % nodes.len()];
                let previous = nodes[(k + nodes.len() - 1) % nodes.len()];
                corners.push([nodes[k], next, previous, index as u32]);
            }
        }
        order::sort(&mut corners, |&[a, b, c, d]| {
            (order::pair(a, b), order::pair(c, d))
        });
        let mut fans = Self {
            start: vec![0],
            faces: Vec::new(),
        };
        let mut at = 0;
        for vertex in 0..mesh.vertices.len() as u32 {
            let from = at;
            while at < corners.len() && corners[at][0] == vertex {
                at += 1;
            }
            fans.push_closed(&corners[from..at]);
            fans.start.push(fans.faces.len() as u32);
        }
        fans
    }

    /// Walks from element to element over shared edges; a fan that does not close stays empty.
    fn push_closed(&mut self, corners: &[[u32; 4]]) {
        let first = self.faces.len();
        let Some(&[_, start, mut edge, face]) = corners.first() else {
            return;
        };
        self.faces.push(face);
        while edge != start {
            let Some(corner) = corners.iter().find(|c| c[1] == edge) else {
                break;
            };
            self.faces.push(corner[3]);
            edge = corner[2];
            if self.faces.len() - first > corners.len() {
                break;
            }
        }
        if edge != start || self.faces.len() - first != corners.len() {
            self.faces.truncate(first);
        }
    }

    /// The elements around a vertex, clockwise on screen; empty where they do not close.
    pub fn around(&self, vertex: usize) -> &[u32] {
        &self.faces[self.start[vertex] as usize..self.start[vertex + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(n: u32) -> Vec<DVec2> {
        (0..n * n)
            .map(|k| DVec2::new(f64::from(k % n), f64::from(k / n)))
            .collect()
    }

    #[test]
    fn a_lattice_becomes_quads_with_four_around_each_inner_node() {
        let mesh = Mesh::whole(lattice(6), |_| false);
        assert_eq!(mesh.faces.len(), 25);
        assert!(mesh.faces.iter().all(|f| f.nodes().len() == 4));
        let fans = mesh.fans();
        for k in 0..36 {
            let (x, y) = (k % 6, k / 6);
            let inner = x > 0 && x < 5 && y > 0 && y < 5;
            assert_eq!(fans.around(k).len(), if inner { 4 } else { 0 });
        }
    }

    #[test]
    fn fans_run_clockwise_on_screen() {
        let mut points = lattice(5);
        points[12] += DVec2::new(0.21, -0.13);
        let mesh = Mesh::whole(points, |_| false);
        let ring: Vec<DVec2> = mesh
            .fans()
            .around(12)
            .iter()
            .map(|&f| mesh.faces[f as usize].centroid(&mesh.vertices))
            .collect();
        assert!(crate::domain::signed_area(&ring) > 0.5);
    }

    #[test]
    fn degenerate_points_give_no_elements() {
        let line: Vec<DVec2> = (0..9).map(|k| DVec2::new(f64::from(k), 0.0)).collect();
        assert!(Mesh::whole(line, |_| false).faces.is_empty());
        assert!(Mesh::whole(vec![], |_| false).faces.is_empty());
        assert!(Mesh::whole(vec![DVec2::ONE; 4], |_| false).faces.is_empty());
    }
}
