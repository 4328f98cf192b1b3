//! The two ways in which packed centres divide the picture into cells, and all that differs between them.

use super::ghosts;
use crate::domain::Domain;
use crate::mesh::Node;
use crate::packing::Particle;

/// How centres divide the picture into cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tessellation {
    /// The pseudo-Voronoi cells of Itoh, Miyata, Shimada (2003), section 5.2: the dual of a mesh that follows the
    /// stretch of the cells and the walls.
    PseudoVoronoi,
    /// The plain Voronoi diagram: only the centres matter. The outline cuts it; small cells are kept and corners not
    /// straightened.
    Voronoi,
}

impl Tessellation {
    /// Separates the particles that get a cell from those that end the cells of others.
    pub fn split(self, particles: Vec<Particle>) -> (Vec<Particle>, Vec<Particle>) {
        match self {
            Self::PseudoVoronoi => split_fixed(particles),
            Self::Voronoi => (particles, Vec::new()),
        }
    }

    /// A particle as a node of the mesh.
    pub fn node(self, p: &Particle) -> Node {
        match self {
            Self::PseudoVoronoi => Node::of(p),
            Self::Voronoi => Node::plain(p.centre),
        }
    }

    /// The nodes outside the outline, at which the mesh ends. Fixed cells end the cells at the walls themselves.
    pub fn ghosts(self, domain: &Domain, cells: &[Particle], fixed: &[Particle]) -> Vec<Node> {
        if self == Self::PseudoVoronoi && fixed.is_empty() {
            ghosts::ghosts(domain, cells)
        } else {
            ghosts::frame(domain).into_iter().map(Node::plain).collect()
        }
    }

    /// Whether the mesh keeps all its triangles, as Delaunay's does, instead of joining pairs to quadrilaterals.
    pub fn keeps_triangles(self) -> bool {
        self == Self::Voronoi
    }

    /// Whether vertices of cells move onto walls that are near.
    pub fn moves_to_walls(self) -> bool {
        self == Self::PseudoVoronoi
    }

    /// Whether constraint lines divide the elements of the mesh.
    pub fn has_lines(self, domain: &Domain) -> bool {
        self == Self::PseudoVoronoi && !domain.lines().is_empty()
    }

    /// Whether small cells are joined to a neighbour, and corners straightened.
    pub fn is_tidied(self) -> bool {
        self == Self::PseudoVoronoi
    }
}

/// Separates the free cells from the cells fixed on walls (the outline and constraint lines). Fixed cells get no
/// polygon (Itoh, Miyata, Shimada 2003, section 5.2): the polygons of free cells end at them. If all are fixed, all
/// count as free.
pub(super) fn split_fixed(particles: Vec<Particle>) -> (Vec<Particle>, Vec<Particle>) {
    let (fixed, cells): (Vec<Particle>, Vec<Particle>) = particles.iter().partition(|p| p.fixed);
    if cells.is_empty() {
        (fixed, cells)
    } else {
        (cells, fixed)
    }
}
