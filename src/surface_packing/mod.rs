//! Packs cells on a surface: the packing of the plane with a surface as its domain.
//!
//! Miyata, Itoh, Shimada (2001), section 4; Itoh, Miyata, Shimada (2003), section 5. Places are points of the mesh's
//! triangles, moves are walks, and the vector between two cells lies in the plane of their mean normal. Forces,
//! motion and population control are those of [`crate::packing`], compiled for this domain.

mod border;
#[cfg(test)]
pub(crate) mod fixture;
mod ground;
mod packing_mesh;
#[cfg(test)]
mod tests;
mod walls;

pub use packing_mesh::{PackingMesh, PackingMeshMaking};

use crate::packing::cell_fields::CellFields;
use crate::packing::placed::Placed;
use crate::packing::population::PopulationScan;
use crate::packing::{Kept, PackingParams, Particle, Sample, StepReport, front::Front, run::Run};
use crate::surface_field::SurfaceFields;
use crate::trimesh::SurfacePoint;
use crate::trimesh::spatial_hash::SurfaceHash;
use ground::SurfaceDomain;

/// A packed cell of a surface: its centre is a point of the mesh, its axis lies in the frame there.
pub type SurfaceParticle = Particle<SurfacePoint>;

/// Places to look at in a slice.
const PLACES: usize = 200;

/// Cells to move, or to compute forces for, in a slice of a step.
const PORTION: usize = 2000;

/// Places the first cells of a packing, in slices.
pub struct SurfacePlacing {
    params: PackingParams,
    placed: Placed<SurfacePoint, SurfaceHash>,
    border: border::Border,
    front: Option<Front>,
}

impl SurfacePlacing {
    /// Starts with nothing placed.
    pub(crate) fn new<F: CellFields<Place = SurfacePoint>>(
        site: &PackingMesh,
        fields: F,
        params: PackingParams,
    ) -> Self {
        Self {
            params,
            placed: Placed::new(SurfaceDomain { site, fields }),
            border: border::Border::new(site),
            front: None,
        }
    }

    /// Does one more slice; true when all places are filled.
    pub(crate) fn advance<F: CellFields<Place = SurfacePoint>>(
        &mut self,
        site: &PackingMesh,
        fields: F,
    ) -> bool {
        let ground = SurfaceDomain { site, fields };
        let placed = &mut self.placed;
        (0..site.walls.portion(PLACES)).any(|_| {
            if let Some(front) = &mut self.front {
                return front.grow(placed, ground);
            }
            if self.border.grow(placed, ground) {
                self.front = Some(Front::new(placed, ground, self.params.seed));
            }
            false
        })
    }

    /// Starts the packing with the cells placed so far.
    pub(crate) fn finish<F: CellFields<Place = SurfacePoint>>(
        mut self,
        site: &PackingMesh,
        fields: F,
    ) -> SurfacePacking {
        self.placed.fill_empty_parts(SurfaceDomain { site, fields });
        let cells = self.placed.cells.iter().map(|&centre| (centre, false));
        SurfacePacking {
            run: Run::of(cells, fields, self.params),
            survey: None,
            in_a_step: false,
        }
    }
}

/// A packing on a surface that is under way.
#[derive(Clone, Debug)]
pub struct SurfacePacking {
    run: Run<SurfacePoint>,
    survey: Option<PopulationScan<SurfacePoint, SurfaceHash>>,
    in_a_step: bool,
}

impl SurfacePacking {
    /// Does all the work at once, until the cells are at rest; see [`SurfacePlacing`].
    pub fn build(site: &PackingMesh, fields: &SurfaceFields, params: PackingParams) -> Self {
        let mut placing = SurfacePlacing::new(site, fields, params);
        while !placing.advance(site, fields) {}
        let mut packing = placing.finish(site, fields);
        while !packing.advance(site, fields) {}
        packing
    }

    /// The cells in the order of their ids.
    pub fn particles(&self) -> Vec<SurfaceParticle> {
        self.run.particles()
    }

    /// The report of the last step.
    pub fn report(&self) -> StepReport {
        self.run.report()
    }

    /// The record of the run, by rising steps.
    pub fn samples(&self) -> &[Sample] {
        &self.run.samples
    }

    /// The potential energy between the cells, in units of the mean cell's k0.
    pub fn energy(&mut self, site: &PackingMesh) -> f64 {
        self.run.energy(site)
    }

    /// Does one more slice of a step, of the equation of motion or, now and then, of population control; true when
    /// the packing has ended.
    pub(crate) fn advance<F: CellFields<Place = SurfacePoint>>(
        &mut self,
        site: &PackingMesh,
        fields: F,
    ) -> bool {
        self.advance_by(site, fields, site.walls.portion(PORTION))
    }

    fn advance_by<F: CellFields<Place = SurfacePoint>>(
        &mut self,
        site: &PackingMesh,
        fields: F,
        portion: usize,
    ) -> bool {
        let ground = SurfaceDomain { site, fields };
        self.in_a_step = !self.run.advance(ground, &mut self.survey, portion);
        self.run.report().done
    }
}

impl Kept for SurfacePacking {
    fn steps(&self) -> u32 {
        self.run.report.step
    }

    fn is_over(&self) -> bool {
        self.run.report.done
    }

    fn is_in_a_step(&self) -> bool {
        self.in_a_step
    }

    fn cell_count(&self) -> usize {
        self.run.bodies.len()
    }

    fn compact(&self) -> Self {
        Self {
            run: self.run.compact(),
            survey: None,
            in_a_step: false,
        }
    }

    fn take_records(&mut self, later: &Self) {
        self.run.take_records(&later.run);
    }
}
