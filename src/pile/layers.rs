//! Darts of inner layers.

use super::darts::{Dart, anywhere};
use crate::random::{Purpose, Random};
use crate::trimesh::running_sums::RunningSums;
use crate::trimesh::spatial_hash::SurfaceHash;
use crate::trimesh::{Search, TriMesh};

/// Darts thrown for each square of the least distance.
const THROWN: f64 = 14.0;
/// The least distance of a dart from the surface, as a share of its layer's depth.
const CLEAR: f64 = 0.97;

/// Throws the darts of one inner layer: points at a depth below the surface, at least a spacing apart.
///
/// The paper offsets conical meshes by hand (section 5, fig. 14). Offset meshes flip where the surface bends more than
/// the depth. Here a point is moved inwards, and kept only if no other part of the surface is nearer. So it lies on the
/// offset surface without these faults.
pub struct LayerDarting {
    kind: u32,
    layer: u32,
    depth: f64,
    spacing: f64,
    random: Random,
    sums: RunningSums,
    left: usize,
    darts: Vec<Dart>,
    hash: SurfaceHash,
}

impl LayerDarting {
    /// Begins layer number `layer`, from 1, of a type, at a depth below the surface.
    pub fn new(
        mesh: &TriMesh,
        (kind, layer): (u32, u32),
        depth: f64,
        spacing: f64,
        seed: u64,
    ) -> Self {
        let item = 1 << 32 | u64::from(layer) << 16 | u64::from(kind);
        let sums = RunningSums::of_areas(mesh);
        Self {
            kind,
            layer,
            depth,
            spacing,
            random: Random::new(seed, Purpose::Dart, item),
            left: (THROWN * sums.total() / (spacing * spacing)).ceil() as usize,
            sums,
            darts: Vec::new(),
            hash: SurfaceHash::new(mesh.bounds(), spacing),
        }
    }

    /// Throws at most `amount` darts. Returns whether all are thrown.
    pub fn advance(&mut self, mesh: &TriMesh, search: &Search, amount: usize) -> bool {
        let now = self.left.min(amount.max(1));
        for _ in 0..now {
            self.throw(mesh, search);
        }
        self.left -= now;
        self.left == 0
    }

    /// The darts so far.
    pub fn darts(&self) -> &[Dart] {
        &self.darts
    }

    fn throw(&mut self, mesh: &TriMesh, search: &Search) {
        let above = anywhere(mesh, &self.sums, &mut self.random);
        let at = above.at - self.depth * above.normal;
        let (darts, square) = (&self.darts, self.spacing * self.spacing);
        let is_near = |k: usize| darts[k].at.distance_squared(at) < square;
        if self.hash.any_near(at, self.spacing, is_near) {
            return;
        }
        let nearest = search.closest(mesh, at);
        let is_inside = nearest.normal.dot(at - nearest.at) < 0.0;
        if is_inside && nearest.at.distance(at) >= CLEAR * self.depth {
            self.hash.push_at(at);
            self.darts.push(Dart {
                kind: self.kind,
                layer: self.layer,
                at,
                normal: above.normal,
                triangle: above.triangle,
            });
        }
    }
}
