//! Packing reads the sizes and directions of its cells from the fields of a surface.

use super::SurfaceFields;
use crate::field::Kind;
use crate::packing::cell_fields::Asks;
use crate::trimesh::SurfacePoint;
use glam::DVec2;

impl Asks for &SurfaceFields {
    type Place = SurfacePoint;

    fn kind(self, _: SurfacePoint) -> Kind {
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
