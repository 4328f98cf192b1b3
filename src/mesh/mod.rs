//! Joins the cells' centres to a mesh of mostly quadrilaterals.
//!
//! Itoh, Miyata, Shimada (2003), section 5.2: Delaunay triangulation (spade), then pairs of triangles become
//! quadrilaterals in the order of their quality; lone triangles may remain.
//!
//! ```
//! # use bubblestone::domain::{Domain, Outline};
//! # use bubblestone::field::{FieldBuilder, FieldParams};
//! # use bubblestone::packing::{Packing, PackingParams};
//! use bubblestone::mesh::Mesh;
//!
//! # let corners = [(14.0, 14.0), (114.0, 14.0), (114.0, 114.0), (14.0, 114.0)];
//! # let rings = vec![corners.map(glam::DVec2::from).to_vec()];
//! # let domain = Domain::from_checked(&Outline { rings, ..Outline::default() });
//! # let params = FieldParams { size: 12.5, ..FieldParams::default() };
//! # let fields = FieldBuilder::build(&domain, params);
//! # let mut packing = Packing::new(&domain, &fields, PackingParams::default()).expect("not too many cells");
//! # while !packing.done() {
//! #     packing.step(&domain, &fields);
//! # }
//! # let particles = packing.particles();
//! // `particles` are 8 by 8 squares at rest: 7 by 7 quadrilaterals join their centres.
//! let mesh = Mesh::build(&domain, &particles);
//! assert_eq!((mesh.vertices.len(), mesh.faces.len()), (64, 49));
//! assert!(mesh.faces.iter().all(|face| face.nodes().len() == 4));
//! ```

mod constraints;
mod division;
mod island;
mod meshing;
mod metric;
mod nodes;
pub(crate) mod patch;
pub(crate) mod quads;
pub(crate) mod requad;
pub(crate) mod seams;
mod smooth;
pub(crate) mod triangles;

pub use meshing::Meshing;
pub use metric::Metric;
pub(crate) use nodes::Nodes;
pub(crate) use smooth::Smoothing;
#[cfg(house)]
pub(crate) use smooth::{Movable, from_middle};

use crate::csr::Csr;
use crate::domain::Domain;
use crate::order;
use crate::packing::Particle;
use glam::DVec2;
pub(crate) use triangles::IncrementalDelaunay;

/// A point to be joined into a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Its position, in picture units.
    pub at: DVec2,
    /// Unit vector along a side of its cell; zero if it has no direction.
    pub axis: DVec2,
    /// The local metric.
    pub metric: Metric,
    /// Whether the node may be a corner of quadrilaterals, because its cell has corners.
    pub corners: bool,
}

impl Node {
    /// A point with the Euclidean metric and the corners of a square.
    pub fn plain(at: DVec2) -> Self {
        Self {
            at,
            axis: DVec2::ZERO,
            metric: Metric::EUCLIDEAN,
            corners: true,
        }
    }

    /// The centre of a packed cell, with the cell's axis and metric.
    pub fn of(p: &Particle) -> Self {
        Self {
            at: p.centre,
            axis: p.axis,
            metric: Metric::new(p.axis, p.aspect),
            corners: p.kind.has_corners(),
        }
    }
}

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

    /// Whether this is an emptied slot.
    #[cfg(house)]
    pub(crate) fn is_none(&self) -> bool {
        self.sides == 0
    }

    /// Indices of the vertices, with positive shoelace area (clockwise on screen).
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
    /// On a torus, the last vertices are images: for each of them, the vertex it is an image of.
    pub images: Vec<u32>,
}

impl Mesh {
    /// The mesh of the cells' centres within the outline. It omits elements whose centre lies outside,
    /// slivers along the border, and triangles between the outermost cells and the wall they stand at.
    ///
    /// On a torus every element occurs once, and images follow the centres where elements cross a seam, so
    /// the mesh closes over the seams. Lone triangles are kept.
    pub fn build(domain: &Domain, particles: &[Particle]) -> Self {
        let mut meshing = Meshing::new(domain, particles.to_vec());
        loop {
            if let Some(mesh) = meshing.advance(domain) {
                return mesh;
            }
        }
    }

    /// The mesh of all points over their convex hull. Edges for which `keep` holds are never dissolved, and
    /// at least `least` edges stay around each inner node. Points that coincide with an earlier one get no
    /// element.
    pub(crate) fn whole(
        delaunay: IncrementalDelaunay,
        keep: impl Fn([u32; 2]) -> bool,
        least: u32,
    ) -> Self {
        let (nodes, mut triangles) = delaunay.finish();
        triangles.flip_to_metric(&nodes, &keep);
        let faces = quads::pair(&nodes[..], &triangles, &keep, least).faces;
        Self {
            vertices: nodes.iter().map(|n| n.at).collect(),
            faces,
            images: Vec::new(),
        }
    }

    /// For each vertex, the elements around it in clockwise order on screen; empty if they do not close a full turn,
    /// as at the border.
    pub(crate) fn fans(&self) -> Csr<u32> {
        // (vertex, next vertex in the element, previous vertex, element)
        let mut corners: Vec<[u32; 4]> = Vec::new();
        for (index, face) in self.faces.iter().enumerate() {
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
        let mut fans = Csr::default();
        let mut at = 0;
        for vertex in 0..self.vertices.len() as u32 {
            let from = at;
            while at < corners.len() && corners[at][0] == vertex {
                at += 1;
            }
            fans.push(closed_fan(&corners[from..at]));
        }
        fans
    }
}

/// Delaunay triangles with positive shoelace area, in an order that depends on the points only.
pub(crate) fn triangulate(points: &[DVec2]) -> Vec<[u32; 3]> {
    let nodes: Vec<Node> = points.iter().copied().map(Node::plain).collect();
    IncrementalDelaunay::new(nodes).finish().1.nodes
}

/// The elements around a vertex, found by walking over shared edges; empty if they do not close a full turn.
fn closed_fan(corners: &[[u32; 4]]) -> Vec<u32> {
    let Some(&[_, start, mut edge, face]) = corners.first() else {
        return Vec::new();
    };
    let mut faces = vec![face];
    while edge != start && faces.len() <= corners.len() {
        let Some(corner) = corners.iter().find(|c| c[1] == edge) else {
            return Vec::new();
        };
        faces.push(corner[3]);
        edge = corner[2];
    }
    if edge != start || faces.len() != corners.len() {
        faces.clear();
    }
    faces
}

#[cfg(test)]
mod tests;
