//! Turns cells at rest on a surface into polygons that share their corners.
//!
//! Labels flood the domain from the cells (`flood`). Where three labels meet lies a triangle between cells
//! (`junctions`); flips make the triangles Delaunay (`flips`). The rules of the plane (`crate::mesh`) pair triangles
//! to quadrilaterals, each time in a plane for the few nodes concerned (`nodes`). Each cell's polygon is the chain of
//! the elements around it and of its part of the border (`rings`), so single rows and lone cells have a polygon, too.
//!
//! Itoh, Miyata, Shimada (2003), section 5.2, gives the Delaunay triangulation and the pairs. It has no construction
//! on surfaces.

mod bends;
mod borders;
mod cell;
mod divided;
mod flips;
mod flood;
mod junctions;
mod meshing;
#[cfg(test)]
pub(crate) mod metrics;
mod middles;
mod nodes;
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

/// The mesh of cells and their polygons.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceMesh {
    /// The cells, by rising ids.
    pub cells: Vec<SurfaceParticle>,
    /// The mesh's nodes, in the order of the cells: their centres, moved a little where that improves elements.
    pub nodes: Vec<SurfacePoint>,
    /// The mesh: elements between cells, counter-clockwise seen from outside, as indices into `cells`.
    pub elements: Vec<Face>,
    /// The corners of polygons, in three groups: points where three or four cells meet or a rim turns between two
    /// cells; points where two cells meet on the border; corners of the border within one cell.
    pub corners: Vec<SurfacePoint>,
    /// The number of corners in the first group.
    pub inner: usize,
    /// For each cell its polygon, as indices into `corners`, counter-clockwise seen from outside. Empty if there is
    /// none: for a cell that goes all around the surface, or lies between two others.
    pub rings: Vec<Vec<u32>>,
}

impl SurfaceMesh {
    /// Does all the work at once; see [`SurfaceMeshing`].
    pub fn build(mesh: &TriMesh, cells: Vec<SurfaceParticle>, polish: Polish) -> Self {
        let mut meshing = SurfaceMeshing::new(cells, polish);
        loop {
            if let Some(made) = meshing.advance(mesh) {
                return made;
            }
        }
    }

    /// Whether a corner lies on the border.
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
