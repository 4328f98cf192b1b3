//! Fields for tests.

use crate::field::CellKind;
use crate::packing::cell_fields::CellFields;
use crate::trimesh::SurfacePoint;
use glam::{DVec2, DVec3};

/// Fields of cells with one size and aspect ratio, along an axis in space.
#[derive(Clone, Copy)]
pub(crate) struct AxisFields {
    pub kind: CellKind,
    pub size: f64,
    pub axis: DVec3,
    pub aspect: f64,
}

impl CellFields for AxisFields {
    type Place = SurfacePoint;

    fn kind(self, _: SurfacePoint) -> CellKind {
        self.kind
    }

    fn size(self, _: SurfacePoint) -> f64 {
        self.size
    }

    fn aspect(self, _: SurfacePoint) -> f64 {
        self.aspect
    }

    fn direction(self, p: SurfacePoint) -> DVec2 {
        p.frame().within(self.axis).normalize_or_zero()
    }

    fn mean_size(self) -> f64 {
        self.size
    }
}
