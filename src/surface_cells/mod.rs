//! From cells at rest on a surface to polygons that share their corners.
//!
//! Labels flood the domain from the cells (`flood`); where three meet is a triangle between cells (`junctions`), made
//! Delaunay by flips (`flips`). Triangles are paired to quadrilaterals by the rules of the plane (`crate::mesh`), the few
//! nodes concerned laid into one plane each time (`nodes`). Each cell's polygon is the chain of the elements around it
//! and of its part of the border (`rings`), so that single rows and lone cells have one, too.
//!
//! Itoh, Miyata, Shimada (2003), section 5.2, has the Delaunay triangulation and the pairs; on surfaces it has none.

mod bends;
mod borders;
mod cell;
mod divided;
mod flips;
mod flood;
mod junctions;
mod meshing;
#[cfg(test)]
mod metrics;
mod middles;
mod nodes;
#[cfg(test)]
mod quality;
mod rings;
mod smooth;
mod straighten;
#[cfg(test)]
mod tests;

pub use cell::SurfaceCell;
pub use meshing::{Polish, SurfaceMeshing};

use crate::mesh::Face;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::{SurfacePoint, TriMesh};

/// The cells' mesh and their polygons.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceMesh {
    /// The cells, by rising ids.
    pub cells: Vec<SurfaceParticle>,
    /// The mesh's nodes, in the order of the cells: their centres, moved a little where that betters elements.
    pub nodes: Vec<SurfacePoint>,
    /// The mesh: elements between cells, counter-clockwise seen from outside, by their places in `cells`.
    pub elements: Vec<Face>,
    /// What polygons have as corners: first places where three or four cells meet or a rim turns between two, then those where two meet on the border,
    /// then corners of the border that one cell has.
    pub corners: Vec<SurfacePoint>,
    /// How many there are of the first.
    pub inner: usize,
    /// Of each cell its polygon, by places in `corners`, counter-clockwise seen from outside; empty where it has none: a
    /// cell that goes all around, or between two others.
    pub rings: Vec<Vec<u32>>,
}

impl SurfaceMesh {
    /// All at once; see [`SurfaceMeshing`].
    pub fn build(mesh: &TriMesh, cells: Vec<SurfaceParticle>, polish: Polish) -> Self {
        let mut meshing = SurfaceMeshing::new(cells, polish);
        loop {
            if let Some(made) = meshing.advance(mesh) {
                return made;
            }
        }
    }

    /// Does a corner lie on the border?
    pub fn is_on_border(&self, corner: u32) -> bool {
        corner as usize >= self.inner
    }

    /// The cells that have a polygon.
    pub fn surface_cells(&self) -> Vec<SurfaceCell> {
        let with_rings = self.cells.iter().zip(&self.rings);
        let with_rings = with_rings.filter(|(_, ring)| !ring.is_empty());
        let made = with_rings.map(|(cell, ring)| {
            let corners = ring.iter().map(|&k| &self.corners[k as usize]);
            SurfaceCell {
                id: cell.id,
                kind: cell.kind,
                centre: cell.centre,
                axis: cell.axis,
                size: cell.size,
                aspect: cell.aspect,
                ring: corners.clone().map(|c| c.at).collect(),
                normals: corners.map(|c| c.normal).collect(),
                on_border: ring.iter().any(|&k| self.is_on_border(k)),
            }
        });
        made.collect()
    }
}
