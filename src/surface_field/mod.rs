//! Fields on a surface: size, direction and aspect ratio of cells, the flow from head to tail, and the curvature.
//!
//! All fields are computed at the mesh's vertices ([`SurfaceFieldBuilder`], in slices) and interpolated within its
//! triangles. Directions are interpolated as representation vectors (see `crate::field`), which are carried from the
//! corners to the point. Squares have directions of symmetry 4, rectangles and ellipses of symmetry 2, and circles of
//! symmetry 6, so that honeycombs may turn by a sixth about a singular point.
//!
//! ```
//! use bubblestone::surface_field::{Amount, SizeParams, SurfaceFieldBuilder, SurfaceFieldParams};
//! use bubblestone::trimesh::{SurfacePoint, TriMesh};
//! use glam::DVec3;
//! use std::sync::Arc;
//!
//! let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
//! let sides = vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
//! let mesh = Arc::new(TriMesh::new(corners.to_vec(), sides).unwrap());
//! let size = SizeParams {
//!     amount: Amount::Size(0.2),
//!     ..SizeParams::default()
//! };
//! let params = SurfaceFieldParams {
//!     size,
//!     ..SurfaceFieldParams::default()
//! };
//! let fields = SurfaceFieldBuilder::build(mesh.clone(), params);
//! let place = SurfacePoint::new(&mesh, 3, DVec3::splat(1.0 / 3.0));
//! assert_eq!(fields.size(&place), 0.2);
//! assert!((fields.axis(&place).length() - 1.0).abs() < 1e-9);
//! // As on every surface of the topology of a sphere, the sum is eight quarter turns.
//! assert_eq!(fields.singular_points().iter().map(|s| s.turns).sum::<i32>(), 8);
//! ```

mod bones;
mod builder;
mod cell_fields;
mod cycle;
pub mod fit;
mod gradients;
mod paint;
mod params;
mod shares;
mod singular;
mod sizes;
mod smoothing;
mod sources;
mod stroke;
mod system;
#[cfg(test)]
mod tests;

pub use bones::{AlongBones, Bone};
pub use builder::SurfaceFieldBuilder;
pub use params::{
    Along, Amount, AspectParams, ByCurvature, DirectionParams, FlowParams, SizeParams,
    SurfaceFieldParams, SurfaceSpot, Taper,
};
pub use shares::{Bent, Thickness};
pub use singular::SurfaceSingularity;
pub use stroke::Stroke;

use crate::field::symmetry::{direction_of, representation};
use crate::field::{ASPECT_RANGE, CellKind};
use crate::trimesh::adjacency::carried;
use crate::trimesh::curvature::{self, Curvature};
use crate::trimesh::{SurfacePoint, TangentFrame, TriMesh};
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// The symmetry of a cell's direction: the number of turns in a full circle after which it looks alike. On a surface
/// circles have symmetry 6.
fn symmetry_of(kind: CellKind) -> u32 {
    match kind {
        CellKind::Circle => 6,
        other => other.symmetry(),
    }
}

/// The fields of a surface, for queries at any of its points.
#[derive(Clone, Debug)]
pub struct SurfaceFields {
    mesh: Arc<TriMesh>,
    kind: CellKind,
    size: f64,
    aspect: f64,
    /// Values at the vertices. Sizes and aspect ratios are empty if they are the same everywhere; the flow is empty
    /// if there is none.
    sizes: Vec<f64>,
    aspects: Vec<f64>,
    axes: Vec<DVec3>,
    flows: Vec<DVec3>,
    curvature: Vec<Curvature>,
    /// Rounds over which curvatures were averaged.
    curvature_reach: usize,
    /// Iterations of conjugate gradients on the finest level.
    iterations: usize,
}

/// The size and shape wanted for a cell at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// See [`SurfaceFields::size`].
    pub size: f64,
    /// See [`SurfaceFields::aspect`].
    pub aspect: f64,
    /// See [`SurfaceFields::axis`].
    pub axis: DVec2,
}

impl SurfaceFields {
    fn empty(mesh: Arc<TriMesh>, params: &SurfaceFieldParams) -> Self {
        let aspect = params.aspect.aspect;
        let stretched = params.kind.is_stretched() && aspect.is_finite();
        Self {
            kind: params.kind,
            size: sizes::mean_size(params, &mesh),
            aspect: if stretched {
                aspect.clamp(ASPECT_RANGE.0, ASPECT_RANGE.1)
            } else {
                1.0
            },
            mesh,
            sizes: Vec::new(),
            aspects: Vec::new(),
            axes: Vec::new(),
            flows: Vec::new(),
            curvature: Vec::new(),
            curvature_reach: 0,
            iterations: 0,
        }
    }

    /// The mean size for which about `count` cells of a kind cover the area.
    pub fn size_for(kind: CellKind, count: f64, area: f64) -> f64 {
        (area / (count.max(1.0) * sizes::cell_area(kind))).sqrt()
    }

    /// The size at each vertex.
    pub fn sizes(&self) -> Vec<f64> {
        (0..self.mesh.positions().len())
            .map(|v| self.size_of(v))
            .collect()
    }

    /// The mesh on which the fields are defined.
    pub fn mesh(&self) -> &Arc<TriMesh> {
        &self.mesh
    }

    /// The kind of the cells.
    pub fn kind(&self) -> CellKind {
        self.kind
    }

    /// The number of directions in a full circle that mean the same: 4, 2 or, for circles, 6.
    pub fn symmetry(&self) -> u32 {
        symmetry_of(self.kind)
    }

    /// The mean size, before spots, tapers and curvature change it.
    pub fn mean_size(&self) -> f64 {
        self.size
    }

    /// The smallest and the largest size.
    pub fn size_range(&self) -> (f64, f64) {
        let each = || self.sizes.iter().copied();
        if self.sizes.is_empty() {
            return (self.size, self.size);
        }
        (
            each().fold(f64::INFINITY, f64::min),
            each().fold(0.0, f64::max),
        )
    }

    /// The smallest and the largest aspect ratio.
    pub fn aspect_range(&self) -> (f64, f64) {
        let each = || self.aspects.iter().copied();
        if self.aspects.is_empty() {
            return (self.aspect, self.aspect);
        }
        (
            each().fold(f64::INFINITY, f64::min),
            each().fold(0.0, f64::max),
        )
    }

    fn size_of(&self, vertex: usize) -> f64 {
        self.sizes.get(vertex).copied().unwrap_or(self.size)
    }

    /// The size and shape wanted for a cell at this point.
    pub fn at(&self, p: &SurfacePoint) -> Wanted {
        let weights = p.weights(&self.mesh);
        Wanted {
            size: self.mixed(&self.sizes, self.size, p, weights),
            aspect: self.mixed(&self.aspects, self.aspect, p, weights),
            axis: self.direction(&self.axes, self.symmetry(), p, weights),
        }
    }

    /// The side that a cell at this point should have; a stretched cell has the area of a square of this side.
    pub fn size(&self, p: &SurfacePoint) -> f64 {
        if self.sizes.is_empty() {
            return self.size;
        }
        self.mixed(&self.sizes, self.size, p, p.weights(&self.mesh))
    }

    /// Length over width of a cell at this point: 1 for squares and circles, 1 to 5 for others.
    pub fn aspect(&self, p: &SurfacePoint) -> f64 {
        if self.aspects.is_empty() {
            return self.aspect;
        }
        self.mixed(&self.aspects, self.aspect, p, p.weights(&self.mesh))
    }

    /// Unit vector along a side of a cell at this point, in the point's tangent frame; zero where the field vanishes.
    /// Turning it by a multiple of 2 pi over the symmetry gives an equivalent direction.
    pub fn axis(&self, p: &SurfacePoint) -> DVec2 {
        self.direction(&self.axes, self.symmetry(), p, p.weights(&self.mesh))
    }

    /// Unit vector of the flow at this point, from head to tail, in the point's tangent frame; zero where there is no
    /// flow.
    pub fn flow(&self, p: &SurfacePoint) -> DVec2 {
        self.direction(&self.flows, 1, p, p.weights(&self.mesh))
    }

    /// The curvature at this point, averaged over about a cell.
    pub fn curvature(&self, p: &SurfacePoint) -> Curvature {
        curvature::interpolated(&self.curvature, &self.mesh, p)
    }

    /// About how many cells there will be, from the area that dense cells of these sizes cover.
    pub fn about_cells(&self) -> f64 {
        let mut sum = 0.0;
        for (t, corners) in self.mesh.triangles().iter().enumerate() {
            let third = self.mesh.area_of(t as u32) / 3.0;
            for &v in corners {
                let size = self.size_of(v as usize);
                sum += third / (size * size);
            }
        }
        sum / sizes::cell_area(self.kind)
    }

    fn mixed(&self, values: &[f64], plain: f64, p: &SurfacePoint, weights: DVec3) -> f64 {
        if values.is_empty() {
            return plain;
        }
        let [a, b, c] = self.mesh.triangles()[p.triangle as usize].map(|v| values[v as usize]);
        a * weights.x + b * weights.y + c * weights.z
    }

    fn direction(
        &self,
        vectors: &[DVec3],
        symmetry: u32,
        p: &SurfacePoint,
        weights: DVec3,
    ) -> DVec2 {
        if vectors.is_empty() {
            return DVec2::ZERO;
        }
        let frame = TangentFrame::of(p.normal);
        let mut sum = DVec2::ZERO;
        let corners = self.mesh.triangles()[p.triangle as usize];
        // Among equivalent directions take the one nearest to an edge, so that the choice turns with the mesh.
        let [a, b] = [corners[0], corners[1]].map(|v| self.mesh.positions()[v as usize]);
        let edge = frame.within(b - a).normalize_or(DVec2::X);
        let told = representation(edge, symmetry);
        for (v, weight) in corners.into_iter().zip(weights.to_array()) {
            let (vector, normal) = (vectors[v as usize], self.mesh.normals()[v as usize]);
            let here = frame.within(carried(vector, normal, p.normal));
            sum += weight * representation(here, symmetry);
        }
        let beside = DVec2::new(told.x, -told.y).rotate(sum.normalize_or_zero());
        direction_of(beside, symmetry).rotate(edge)
    }
}
