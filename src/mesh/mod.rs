//! Joins the cells' centres into a mesh of mostly quadrilaterals.
//!
//! Itoh, Miyata, Shimada (2003), section 5.2: Delaunay triangulation (spade), then pairs of
//! triangles become quadrilaterals in the order of their quality; lone triangles may stay.

mod metric;
mod patch;
mod quads;
mod relax;
pub(crate) mod torus;
mod triangles;

pub use metric::Metric;

use crate::domain::Domain;
use crate::order;
use crate::packing::Particle;
use glam::DVec2;
use quads::Faces;
use triangles::NONE;
pub(crate) use triangles::Weave;

/// A point to be joined into a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Where it is, in picture units.
    pub at: DVec2,
    /// Unit vector along a side of its cell; zero where it has no direction.
    pub axis: DVec2,
    /// How lengths are measured here.
    pub metric: Metric,
    /// Its cell has corners: it may be a corner of quadrilaterals.
    pub corners: bool,
}

impl Node {
    /// A point that stands for a square.
    pub fn plain(at: DVec2) -> Self {
        Self {
            at,
            axis: DVec2::ZERO,
            metric: Metric::EVEN,
            corners: true,
        }
    }

    /// That of a packed cell.
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
    /// On a torus the last vertices are images: for each of them the vertex that it is an image of.
    pub images: Vec<u32>,
}

/// A triangle whose height is less than this share of its longest side is a sliver of the rim.
const SLIVER: f64 = 0.12;
/// Without an obtuse angle it is one if its height is less than this share.
const NEEDLE: f64 = 0.01;
/// Cells at a wall stand half their size from it; a triangle whose middle is nearer than this, in
/// sizes, only bridges a bend.
const AT_WALL: f64 = 0.45;

/// Lone triangles are let be where they are at most this share of the elements ...
const FEW_TRIANGLES: f64 = 0.037;
/// ... and this many more, but ...
const RIM_TRIANGLES: f64 = 6.0;
/// ... at most this share.
const MOST_TRIANGLES: f64 = 0.08;
/// The least score of quadrilaterals that replace lone triangles, falling.
const STANDARDS: [f64; 6] = [0.5, 0.4, 0.3, 0.2, 0.2, 0.15];

/// A side is looked at without this share of it at both ends: those may stand on a constraint line.
const SHRINK: f64 = 0.02;
/// A point nearer to a constraint line than this (in sizes) lies on it.
const ON_LINE: f64 = 0.05;

impl Mesh {
    /// The mesh of the cells' centres within the outline: elements whose middle lies outside,
    /// slivers along the rim, and triangles that lie between the outermost cells and the wall they
    /// stand at, are left out.
    ///
    /// On a torus every element is there once, and images follow the centres where elements reach
    /// over a seam: the mesh closes over the seams. Lone triangles stay as they are.
    pub fn build(domain: &Domain, particles: &[Particle]) -> Self {
        let mut meshing = Meshing::new(domain, particles.to_vec());
        loop {
            if let Some(mesh) = meshing.advance(domain) {
                return mesh;
            }
        }
    }

    /// The mesh of one island, of the particles' triangles.
    fn within(domain: &Domain, particles: &[Particle], weave: Weave) -> Self {
        let (mut nodes, mut triangles) = weave.finish();
        let vertices: Vec<DVec2> = particles.iter().map(|p| p.centre).collect();
        // Sides from cell to cell along a constraint line are not dissolved.
        let keep = |side: [u32; 2]| lies_on_line(domain, side.map(|k| &particles[k as usize]));
        triangles.stretch(&nodes, keep);
        triangles.retain(|t| {
            let [a, b, c] = t.map(|k| vertices[k as usize]);
            domain.nearest((a + b + c) / 3.0).distance > 0.0 && !is_cut(domain, [a, b, c])
        });
        let mut made = quads::pair(&nodes, &triangles, keep);
        made.leave_out(|face| is_sliver(face, &nodes));
        // Of cells that stand at the walls it is no mesh of the outline, only a picture of the rows.
        if particles.iter().any(|p| p.fixed) {
            join_lone(&mut nodes, &mut made, |k| particles[k].fixed, keep);
        }
        let vertices: Vec<DVec2> = nodes.iter().map(|n| n.at).collect();
        let mut faces = made.faces;
        faces.retain(|face| {
            if face.sides == 0 {
                return false;
            }
            let depth = domain.nearest(face.centroid(&vertices)).distance;
            depth > 0.0
                && !is_sliver(face, &nodes)
                && !(face.sides == 3 && depth < at_wall(face, particles))
        });
        Self {
            vertices,
            faces,
            images: Vec::new(),
        }
    }

    /// The mesh of all points over their convex hull. Edges for which `keep` holds are never
    /// dissolved into a quadrilateral. Points that coincide with an earlier one get no element.
    pub(crate) fn whole(weave: Weave, keep: impl Fn([u32; 2]) -> bool) -> Self {
        let (nodes, mut triangles) = weave.finish();
        triangles.stretch(&nodes, &keep);
        let faces = quads::pair(&nodes, &triangles, &keep).faces;
        Self {
            vertices: nodes.iter().map(|n| n.at).collect(),
            faces,
            images: Vec::new(),
        }
    }

    /// For every vertex the elements around it in order, where they close a full turn; empty for
    /// vertices on the rim of the mesh.
    pub(crate) fn fans(&self) -> Fans {
        Fans::new(self)
    }
}

/// A mesh in the making.
pub struct Meshing {
    particles: Vec<Particle>,
    /// On a torus, at which try it is.
    seams: Option<torus::Seams>,
    /// Elsewhere the island at work, and the numbers of its cells.
    island: usize,
    names: Vec<usize>,
    /// The meshes of the islands so far, side by side; the vertices keep the order of the centres.
    whole: Mesh,
    weave: Option<Weave>,
}

impl Meshing {
    /// Of these cells, nothing made yet: see [`Mesh::build`].
    pub fn new(domain: &Domain, mut particles: Vec<Particle>) -> Self {
        let seams = domain.period().map(|side| {
            for p in &mut particles {
                p.centre = domain.wrap(p.centre);
            }
            torus::Seams::new(side)
        });
        let whole = Mesh {
            vertices: particles.iter().map(|p| p.centre).collect(),
            ..Mesh::default()
        };
        Self {
            particles,
            seams,
            island: 0,
            names: Vec::new(),
            whole,
            weave: None,
        }
    }

    /// One slice of the work; the mesh with the last one.
    pub fn advance(&mut self, domain: &Domain) -> Option<Mesh> {
        let mut weave = match self.weave.take() {
            Some(weave) => weave,
            None => Weave::new(self.nodes(domain)),
        };
        if !weave.advance() {
            self.weave = Some(weave);
            return None;
        }
        if let Some(seams) = &self.seams {
            return seams.mesh(domain, &self.particles, weave);
        }
        let own: Vec<Particle> = self.names.iter().map(|&k| self.particles[k]).collect();
        let mut mesh = Mesh::within(&domain.islands()[self.island], &own, weave);
        for (&name, vertex) in self.names.iter().zip(mesh.vertices) {
            self.whole.vertices[name] = vertex;
        }
        for node in mesh.faces.iter_mut().flat_map(|face| &mut face.nodes) {
            // A triangle's fourth number is none.
            *node = self.names.get(*node as usize).map_or(0, |&k| k as u32);
        }
        self.whole.faces.extend(mesh.faces);
        self.island += 1;
        (self.island == domain.islands().len()).then(|| std::mem::take(&mut self.whole))
    }

    /// Those of the next try, or of the next island.
    fn nodes(&mut self, domain: &Domain) -> Vec<Node> {
        if let Some(seams) = &mut self.seams {
            return seams.nodes(&self.particles);
        }
        let particles = &self.particles;
        let here = |&k: &usize| domain.island(particles[k].centre) == self.island;
        self.names = (0..particles.len()).filter(here).collect();
        let own = self.names.iter().map(|&k| Node::of(&particles[k]));
        own.collect()
    }
}

/// Joins lone triangles over the elements between them while there are too many, first to good
/// quadrilaterals only; in between the nodes that may move relax, which makes room for more.
fn join_lone(
    nodes: &mut [Node],
    made: &mut Faces,
    is_fixed: impl Fn(usize) -> bool,
    keep: impl Fn([u32; 2]) -> bool,
) {
    let mut free: Vec<bool> = (0..nodes.len()).map(|k| !is_fixed(k)).collect();
    for (face, beside) in made.faces.iter().zip(&made.beside) {
        let corners = face.nodes();
        for k in 0..corners.len() {
            if beside[k] == NONE {
                free[corners[k] as usize] = false;
                free[corners[(k + 1) % corners.len()] as usize] = false;
            }
        }
    }
    let lone = |nodes: &[Node], made: &Faces| {
        let faces = made.faces.iter();
        faces.filter(|f| quads::is_lone(nodes, f)).count()
    };
    let quads = made.faces.iter().filter(|f| f.sides == 4).count();
    let count = (quads + lone(nodes, made)) as f64;
    let few = (FEW_TRIANGLES * count + RIM_TRIANGLES).min(MOST_TRIANGLES * count) as usize;
    for worst in STANDARDS {
        if lone(nodes, made) <= few {
            break;
        }
        patch::better(nodes, made, worst, few, &keep);
        relax::relax(nodes, &made.faces, &free);
    }
}

/// Does a constraint line cross a side of the triangle?
fn is_cut(domain: &Domain, [a, b, c]: [DVec2; 3]) -> bool {
    [[a, b], [b, c], [c, a]]
        .iter()
        .any(|&[p, q]| domain.crosses_line(p.lerp(q, SHRINK), q.lerp(p, SHRINK)))
}

/// Do both cells stand on a constraint line, and what is between them, too?
fn lies_on_line(domain: &Domain, [a, b]: [&Particle; 2]) -> bool {
    let on = |p: DVec2| {
        let near = domain.nearest_line(p);
        near.is_some_and(|near| near.distance < ON_LINE * a.size)
    };
    on(a.centre.midpoint(b.centre)) && on(a.centre) && on(b.centre)
}

/// How deep a triangle of cells that all stand at a wall has to lie; 0 where one is fixed on it.
fn at_wall(triangle: &Face, particles: &[Particle]) -> f64 {
    let nodes = triangle.nodes().iter().map(|&k| &particles[k as usize]);
    let depth = nodes.map(|p| {
        if p.fixed {
            0.0
        } else {
            AT_WALL * p.size / p.aspect.sqrt()
        }
    });
    depth.fold(f64::INFINITY, f64::min)
}

/// Is this a triangle so flat that it only lies along the rim? The needles of sharp tips stay.
fn is_sliver(face: &Face, nodes: &[Node]) -> bool {
    let [a, b, c] = *face.nodes() else {
        return false;
    };
    let [p, q, r] = [a, b, c].map(|k| nodes[k as usize].at);
    let obtuse = |p: DVec2, q: DVec2, r: DVec2| (q - p).dot(r - p) < 0.0;
    let cap = obtuse(p, q, r) || obtuse(q, r, p) || obtuse(r, p, q);
    quads::height(nodes, [a, b, c]) < if cap { SLIVER } else { NEEDLE }
}

/// Delaunay triangles, each of positive shoelace area, in an order that depends on the points only.
pub(crate) fn triangulate(points: &[DVec2]) -> Vec<[u32; 3]> {
    let nodes: Vec<Node> = points.iter().copied().map(Node::plain).collect();
    Weave::new(nodes).finish().1.nodes
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
mod tests;
