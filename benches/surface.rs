//! Cells on a surface: from its mesh to their polygons.

use super::{Clock, Timing, shortest};
use bubblestone::packing::PackingParams;
use bubblestone::shapes::Shape;
use bubblestone::surface_cells::{Polish, SurfaceMesh};
use bubblestone::surface_field::{
    Amount, Bone, DirectionParams, SizeParams, SurfaceFieldBuilder, SurfaceFieldParams,
};
use bubblestone::surface_packing::{PackingMesh, SurfacePacking};
use bubblestone::trimesh::TriMesh;
use bubblestone::trimesh::refine::{Refining, SHARE};
use std::sync::Arc;

/// The leg as a mesh fine enough for this number of squares, with the parameters of its fields.
fn leg(cells: u32) -> Option<(Arc<TriMesh>, SurfaceFieldParams)> {
    let (positions, triangles) = Shape::Leg.build(&[], 0.02);
    let mesh = TriMesh::new(positions, triangles).ok()?;
    let size = (mesh.area() / f64::from(cells)).sqrt();
    let bones = Shape::Leg.bones(&[]).into_iter();
    let params = SurfaceFieldParams {
        size: SizeParams {
            amount: Amount::Size(size),
            ..SizeParams::default()
        },
        direction: DirectionParams {
            bones: 1.0,
            ..DirectionParams::default()
        },
        bones: bones
            .map(|bone| Bone {
                points: bone.points,
                radii: bone.radii,
            })
            .collect(),
        ..SurfaceFieldParams::default()
    };
    let refined = Refining::evenly(mesh, SHARE * size).finish_all().ok()?;
    Some((Arc::new(refined.mesh), params))
}

/// Times the way from the leg's mesh to about `cells` cells with their polygons, and the parts of it.
pub fn whole_way(cells: u32, clock: Clock, timings: &mut Vec<Timing>) {
    let Some((mesh, params)) = leg(cells) else {
        return;
    };
    let mut runs = Vec::new();
    for _ in 0..7 {
        let start = clock();
        let fields = SurfaceFieldBuilder::build(mesh.clone(), params.clone());
        let directed = clock();
        let site = PackingMesh::new(mesh.clone(), fields.size_range().1);
        let packing = SurfacePacking::build(&site, &fields, PackingParams::default());
        let packed = clock();
        let made = SurfaceMesh::build(&mesh, packing.particles(), Polish::default());
        let all = clock() - start;
        // The result is used, so that no compiler drops the work.
        assert!(made.rings.len() > 1);
        runs.push([all, directed - start, packed - directed]);
    }
    let names = ["mesh to cells", "fields of these", "packing of these"];
    for (k, name) in names.into_iter().enumerate() {
        timings.push(Timing {
            name: format!("{name}, leg, {cells} cells"),
            ms: shortest(runs.iter().map(|run| run[k])),
        });
    }
}
