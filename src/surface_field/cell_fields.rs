//! Packing reads the sizes and directions of its cells from the fields of a surface.

use super::SurfaceFields;
use crate::field::CellKind;
use crate::packing::cell_fields::CellFields;
use crate::trimesh::SurfacePoint;
use glam::DVec2;

impl CellFields for &SurfaceFields {
    type Place = SurfacePoint;

    fn kind(self, _: SurfacePoint) -> CellKind {
        self.kind
    }

    fn size(self, p: SurfacePoint) -> f64 {
        SurfaceFields::size(self, &p)
    }

    fn aspect(self, p: SurfacePoint) -> f64 {
        SurfaceFields::aspect(self, &p)
    }

    fn direction(self, p: SurfacePoint) -> DVec2 {
        self.axis(&p)
    }

    fn mean_size(self) -> f64 {
        self.size
    }
}
