//! The mesh within an outline in the plane, island by island.

use super::constraints::{is_cut, lies_on_line};
use super::quads::{self, Faces};
use super::triangles::{NONE, Triangles};
use super::{Face, IncrementalDelaunay, Mesh, Node, Smoothing, requad};
use crate::domain::Domain;
use crate::packing::Particle;
use glam::DVec2;

/// A triangle with an obtuse angle is a sliver of the border if it is lower than this share of its longest side.
const SLIVER: f64 = 0.12;
/// A triangle without an obtuse angle is a sliver only if it is lower than this share of its longest side.
const NEEDLE: f64 = 0.01;
/// Cells at a wall are half their size away from it. A triangle whose centre is nearer to the wall than this, in sizes,
/// only bridges a bend.
const AT_WALL: f64 = 0.45;

/// Lone triangles are accepted up to this share of the elements, plus [`RIM_TRIANGLES`].
const FEW_TRIANGLES: f64 = 0.037;
/// The number of lone triangles accepted in addition to [`FEW_TRIANGLES`].
const RIM_TRIANGLES: f64 = 6.0;
/// The greatest share of lone triangles that is accepted.
const MOST_TRIANGLES: f64 = 0.08;
/// The meshes of all islands, in progress.
pub(super) struct IslandMeshing {
    particles: Vec<Particle>,
    /// The number of the current island; `own` are its cells, and `names` their indices in `particles`.
    island: usize,
    own: Vec<Particle>,
    names: Vec<usize>,
    /// The meshes of the islands so far; the vertices keep the order of the centres.
    whole: Mesh,
    step: Option<IslandPhase>,
}

/// The progress on the current island.
enum IslandPhase {
    Delaunay(IncrementalDelaunay),
    Triangles(Vec<Node>, Triangles),
    Faces(Vec<Node>, Faces),
}

impl IslandMeshing {
    /// Starts from these cells.
    pub fn new(particles: Vec<Particle>) -> Self {
        let whole = Mesh {
            vertices: particles.iter().map(|p| p.centre).collect(),
            ..Mesh::default()
        };
        Self {
            particles,
            island: 0,
            own: Vec::new(),
            names: Vec::new(),
            whole,
            step: None,
        }
    }

    /// Does one slice of the work; the last one gives the mesh.
    pub fn advance(&mut self, domain: &Domain) -> Option<Mesh> {
        let step = match self.step.take() {
            Some(step) => step,
            None => IslandPhase::Delaunay(IncrementalDelaunay::new(self.nodes(domain))),
        };
        let island = domain.islands().get(self.island).unwrap_or(domain);
        let next = match step {
            IslandPhase::Delaunay(mut delaunay) => {
                if delaunay.advance() {
                    let (nodes, triangles) = self.triangles(island, delaunay);
                    IslandPhase::Triangles(nodes, triangles)
                } else {
                    IslandPhase::Delaunay(delaunay)
                }
            }
            IslandPhase::Triangles(mut nodes, triangles) => {
                let faces = self.faces(island, &mut nodes, &triangles);
                IslandPhase::Faces(nodes, faces)
            }
            IslandPhase::Faces(nodes, faces) => {
                self.put(island, &nodes, faces);
                self.island += 1;
                let done = self.island == domain.islands().len();
                return done.then(|| std::mem::take(&mut self.whole));
            }
        };
        self.step = Some(next);
        None
    }

    /// The triangles within the island.
    fn triangles(&self, island: &Domain, delaunay: IncrementalDelaunay) -> (Vec<Node>, Triangles) {
        let (nodes, mut triangles) = delaunay.finish();
        triangles.flip_to_metric(&nodes, self.keep(island));
        triangles.retain(|t| {
            let [a, b, c] = t.map(|k| nodes[k as usize].at);
            island.nearest((a + b + c) / 3.0).distance > 0.0 && !is_cut(island, [a, b, c])
        });
        (nodes, triangles)
    }

    /// The elements made from an island's triangles.
    fn faces(&self, island: &Domain, nodes: &mut [Node], triangles: &Triangles) -> Faces {
        let keep = self.keep(island);
        let mut made = quads::pair(nodes, triangles, &keep, 0);
        made.leave_out(|face| is_sliver(face, nodes));
        // If no cell is fixed on the walls, the mesh ends short of them: it shows the rows but does not mesh
        // the outline.
        if self.own.iter().any(|p| p.fixed) {
            join_lone(nodes, &mut made, |k| self.own[k].fixed, keep);
        }
        made
    }

    /// A predicate for edges that must stay: those from cell to cell along a constraint line.
    fn keep(&self, island: &Domain) -> impl Fn([u32; 2]) -> bool {
        |side| lies_on_line(island, side.map(|k| &self.own[k as usize]))
    }

    /// Adds the island's mesh to the whole mesh, without slivers and elements outside.
    fn put(&mut self, island: &Domain, nodes: &[Node], mut made: Faces) {
        let vertices: Vec<DVec2> = nodes.iter().map(|n| n.at).collect();
        made.faces.retain(|face| {
            if face.sides == 0 {
                return false;
            }
            let depth = island.nearest(face.centroid(&vertices)).distance;
            depth > 0.0
                && !is_sliver(face, nodes)
                && !(face.sides == 3 && depth < at_wall(face, &self.own))
        });
        for (&name, vertex) in self.names.iter().zip(vertices) {
            self.whole.vertices[name] = vertex;
        }
        for node in made.faces.iter_mut().flat_map(|face| &mut face.nodes) {
            // A triangle's fourth entry is not a node.
            *node = self.names.get(*node as usize).map_or(0, |&k| k as u32);
        }
        self.whole.faces.extend(made.faces);
    }

    /// The nodes of the next island.
    fn nodes(&mut self, domain: &Domain) -> Vec<Node> {
        let particles = &self.particles;
        let here = |&k: &usize| domain.island(particles[k].centre) == self.island;
        self.names = (0..particles.len()).filter(here).collect();
        self.own = self.names.iter().map(|&k| particles[k]).collect();
        self.own.iter().map(Node::of).collect()
    }
}

/// Joins lone triangles through the elements between them while there are too many of them, first to good
/// quadrilaterals only, then also to worse ones. After each pass, movable nodes are smoothed, which makes room for
/// more.
pub(super) fn join_lone(
    nodes: &mut [Node],
    made: &mut Faces,
    is_fixed: impl Fn(usize) -> bool,
    keep: impl Fn([u32; 2]) -> bool,
) {
    let mut free: Vec<bool> = (0..nodes.len()).map(|k| !is_fixed(k)).collect();
    for (face, adjacent) in made.faces.iter().zip(&made.adjacent) {
        let corners = face.nodes();
        for k in 0..corners.len() {
            if adjacent[k] == NONE {
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
    for worst in requad::STANDARDS {
        if lone(nodes, made) <= few {
            break;
        }
        requad::requadrangulate(nodes, made, worst, few, &keep);
        Smoothing::new(&made.faces, free.clone()).advance(nodes, &made.faces, usize::MAX);
    }
}

/// A triangle is left out if its centre is nearer to the boundary than this: it only joins cells at a wall. 0 if one of
/// its cells is fixed.
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

/// Whether this is a flat triangle along the border. Needles in sharp tips are kept.
fn is_sliver(face: &Face, nodes: &[Node]) -> bool {
    let [a, b, c] = *face.nodes() else {
        return false;
    };
    let [p, q, r] = [a, b, c].map(|k| nodes[k as usize].at);
    let obtuse = |p: DVec2, q: DVec2, r: DVec2| (q - p).dot(r - p) < 0.0;
    let cap = obtuse(p, q, r) || obtuse(q, r, p) || obtuse(r, p, q);
    quads::height(nodes, [a, b, c]) < if cap { SLIVER } else { NEEDLE }
}
