//! Views of small surfaces.

mod bars;
mod bubbles;
mod faces;
mod maps;

use super::*;
use crate::draw::Tones;
use crate::field::CellKind;
use crate::heightfield::TextureParams;
use crate::mesh::Face;
use crate::packing::stress_on;
use crate::scene::{Scene, Surfel};
use crate::surface_cells::SurfaceCell;
use crate::surface_cells::SurfaceMesh;
use crate::surface_field::{
    Along, Amount, DirectionParams, SizeParams, Stroke, SurfaceFieldBuilder, SurfaceFieldParams,
    SurfaceFields, Taper,
};
use crate::surface_packing::{PackingMesh, SurfaceParticle};
use crate::surface_stones::Fit;
use crate::trimesh::{Search, SurfacePoint, TangentFrame, TriMesh, samples};
use glam::DVec2;
use std::sync::Arc;

fn grounded(mesh: &TriMesh) -> BareSurface {
    BareSurface::build(mesh, Fit::new(mesh))
}

fn fields(mesh: &Arc<TriMesh>, kind: CellKind, size: SizeParams) -> SurfaceFields {
    let direction = DirectionParams {
        curvature: 1.0,
        ..DirectionParams::default()
    };
    let params = SurfaceFieldParams {
        kind,
        size,
        direction,
        ..SurfaceFieldParams::default()
    };
    SurfaceFieldBuilder::build(mesh.clone(), params)
}

fn even(size: f64) -> SizeParams {
    SizeParams {
        amount: Amount::Size(size),
        ..SizeParams::default()
    }
}

fn tapered(size: f64) -> SizeParams {
    let taper = Taper {
        along: Along::Axis(DVec3::X),
        first: 0.5,
        last: 2.0,
    };
    SizeParams {
        taper: Some(taper),
        ..even(size)
    }
}

fn tones() -> Tones {
    Tones::new(&TextureParams::default())
}

/// The colour of a body with this colour at a place, before light.
fn seen(scene: &Scene, id: u32, colour: [f32; 3], [position, normal]: [Vec3; 2]) -> [f32; 3] {
    let mut surfel = Surfel {
        position,
        normal,
        colour,
        material: 0,
        open: 1.0,
    };
    let detail = scene.detail.as_ref().expect("colours");
    detail.refine(&mut surfel, id, 1e-4);
    surfel.colour
}

fn tint(scene: &Scene, id: u32) -> [f32; 3] {
    seen(scene, id, [1.0; 3], [Vec3::ZERO, Vec3::Y])
}
