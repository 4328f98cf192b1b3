//! Runs the whole chain from a mesh to the figures of its cells.

use crate::field::Kind;
use crate::packing::{PackingParams, StepReport};
use crate::shapes::Shape;
use crate::surface_cells::metrics::SurfaceMetrics;
use crate::surface_cells::{Polish, SurfaceMesh};
use crate::surface_field::{
    Amount, AspectParams, Bone, DirectionParams, SizeParams, SurfaceFieldBuilder,
    SurfaceFieldParams, SurfaceFields,
};
use crate::surface_packing::{Site, SurfacePacking};
use crate::trimesh::refine::{Refining, SHARE};
use crate::trimesh::repair::{Filling, Mending};
use crate::trimesh::{Soup, TriMesh, testing};
use glam::DVec3;
use std::sync::Arc;

/// A surface for cells, with its bones.
#[derive(Clone)]
pub struct Body {
    pub name: String,
    pub mesh: TriMesh,
    pub bones: Vec<Bone>,
    pub main: DVec3,
}

/// The cells that are wanted.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    pub kind: Kind,
    pub aspect: f64,
    pub cells: f64,
}

/// The results of a run.
pub struct Whole {
    pub fields: SurfaceFields,
    pub report: StepReport,
    pub figures: SurfaceMetrics,
}

/// A shape by rule, with its default numbers.
pub fn by_rule(shape: Shape) -> Body {
    let (positions, triangles) = shape.build(&[], 0.015);
    let bones = shape.bones(&[]).into_iter().map(|bone| {
        let ends = if bone.closed { 1 } else { 0 };
        let around = |k: usize| k % bone.points.len();
        let all = 0..bone.points.len() + ends;
        Bone {
            points: all.clone().map(|k| bone.points[around(k)]).collect(),
            radii: all.map(|k| bone.radii[around(k)]).collect(),
        }
    });
    Body {
        name: shape.word().to_owned(),
        mesh: TriMesh::new(positions, triangles).expect("a mesh"),
        bones: bones.collect(),
        main: shape.main(),
    }
}

/// As from a file: mended, and with holes closed that are small beside the cells.
pub fn from_file(name: &str, (positions, triangles): testing::Soup, asked: Asked) -> Body {
    let soup = Soup {
        positions,
        triangles,
    };
    let mesh = Mending::mend(soup).expect("a surface").mesh;
    let mut body = Body {
        name: name.to_owned(),
        mesh,
        bones: Vec::new(),
        main: DVec3::Y,
    };
    let size = body.mean_size(asked);
    let filled = Filling::fill_all(body.mesh, size);
    body.mesh = filled.expect("a surface").mesh;
    body
}

impl Body {
    /// Parameters for cells along its bones, if it has any, and along its borders.
    pub fn params(&self, asked: Asked) -> SurfaceFieldParams {
        let has_bones = !self.bones.is_empty();
        SurfaceFieldParams {
            kind: asked.kind,
            size: SizeParams {
                amount: Amount::Count(asked.cells),
                ..SizeParams::default()
            },
            aspect: AspectParams {
                aspect: asked.aspect,
                ..AspectParams::default()
            },
            direction: DirectionParams {
                bones: f64::from(u8::from(has_bones)),
                axis: f64::from(u8::from(!has_bones)),
                towards: self.main,
                borders: 1.0,
                curvature: 1.0,
                ..DirectionParams::default()
            },
            bones: self.bones.clone(),
            ..SurfaceFieldParams::default()
        }
    }

    /// Its mesh with edges short enough for the cells.
    pub fn refined(&self, asked: Asked) -> TriMesh {
        let edges = SHARE * self.mean_size(asked);
        let refining = Refining::evenly(self.mesh.clone(), edges);
        refining.finish_all().expect("a mesh").mesh
    }

    fn mean_size(&self, asked: Asked) -> f64 {
        let mesh = Arc::new(self.mesh.clone());
        let fields = SurfaceFieldBuilder::new(mesh, self.params(asked));
        fields.finish().mean_size()
    }

    /// Scaled, and turned about a slanting axis.
    pub fn moved(&self, scale: f64, angle: f64) -> Self {
        let about = DVec3::new(0.6, 0.0, 0.8);
        let (sin, cos) = libm::sincos(angle);
        let turn = |v: DVec3| {
            let along = about * about.dot(v);
            along + cos * (v - along) + sin * about.cross(v)
        };
        let mesh = &self.mesh;
        let places = mesh.positions().iter().map(|&p| scale * turn(p));
        let bones = self.bones.iter().map(|bone| Bone {
            points: bone.points.iter().map(|&p| scale * turn(p)).collect(),
            radii: bone.radii.iter().map(|r| scale * r).collect(),
        });
        Self {
            name: self.name.clone(),
            mesh: TriMesh::new(places.collect(), mesh.triangles().to_vec()).expect("a mesh"),
            bones: bones.collect(),
            main: turn(self.main),
        }
    }

    pub fn whole(&self, asked: Asked) -> Whole {
        run(self.refined(asked), self.params(asked))
    }
}

/// Runs from a mesh with short edges to the figures.
pub fn run(mesh: TriMesh, params: SurfaceFieldParams) -> Whole {
    let mesh = Arc::new(mesh);
    let fields = SurfaceFieldBuilder::build(mesh.clone(), params);
    let longest = fields.size_range().1 * fields.aspect_range().1.sqrt();
    let site = Site::new(mesh, longest);
    let packing = SurfacePacking::build(&site, &fields, PackingParams::default());
    let made = SurfaceMesh::build(site.mesh(), packing.particles(), Polish::default());
    Whole {
        figures: SurfaceMetrics::new(site.mesh(), &made),
        report: packing.report(),
        fields,
    }
}
