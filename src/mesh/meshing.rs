//! Builds the mesh of the cells' centres, in slices.

use super::Mesh;
use super::island::IslandMeshing;
use super::seams::SeamMeshing;
use crate::domain::Domain;
use crate::packing::Particle;

/// A mesh in progress.
pub struct Meshing(MeshingSpace);

/// In the plane, islands are meshed one by one, the mesh ends at the walls, and lone triangles and slivers
/// there are repaired. On a torus the mesh must agree with itself over the seams and has no border.
enum MeshingSpace {
    Plane(IslandMeshing),
    Torus(SeamMeshing),
}

impl Meshing {
    /// Starts from these cells; see [`Mesh::build`].
    pub fn new(domain: &Domain, particles: Vec<Particle>) -> Self {
        Self(match domain.space().period() {
            Some(side) => MeshingSpace::Torus(SeamMeshing::new(side, particles)),
            None => MeshingSpace::Plane(IslandMeshing::new(particles)),
        })
    }

    /// Does one slice of the work; the last one gives the mesh.
    pub fn advance(&mut self, domain: &Domain) -> Option<Mesh> {
        match &mut self.0 {
            MeshingSpace::Plane(meshing) => meshing.advance(domain),
            MeshingSpace::Torus(meshing) => meshing.advance(domain),
        }
    }
}
