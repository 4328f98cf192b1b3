//! From the cells' centres to the mesh, in slices.

use super::Mesh;
use super::island::IslandMeshing;
use super::seams::SeamMeshing;
use crate::domain::Domain;
use crate::packing::Particle;

/// A mesh in the making.
pub struct Meshing(Way);

/// In the plane the mesh ends at the walls, lone triangles and slivers there are mended, and islands
/// come one by one; on a torus it has to agree with itself over the seams, and nothing ends.
enum Way {
    Plane(IslandMeshing),
    Torus(SeamMeshing),
}

impl Meshing {
    /// Of these cells, nothing made yet: see [`Mesh::build`].
    pub fn new(domain: &Domain, particles: Vec<Particle>) -> Self {
        Self(match domain.space().period() {
            Some(side) => Way::Torus(SeamMeshing::new(side, particles)),
            None => Way::Plane(IslandMeshing::new(particles)),
        })
    }

    /// One slice of the work; the mesh with the last one.
    pub fn advance(&mut self, domain: &Domain) -> Option<Mesh> {
        match &mut self.0 {
            Way::Plane(meshing) => meshing.advance(domain),
            Way::Torus(meshing) => meshing.advance(domain),
        }
    }
}
