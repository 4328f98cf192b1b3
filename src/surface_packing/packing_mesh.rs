//! A mesh prepared for packing.

use super::walls::SurfaceWalls;
use crate::packing::packing_domain::MetricSpace;
use crate::trimesh::running_sums::RunningSums;
use crate::trimesh::spatial_hash::SurfaceHash;
use crate::trimesh::{SurfacePoint, Transport, TriMesh, log};
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// A mesh with its parts, areas and walls.
#[derive(Clone, Debug)]
pub struct PackingMesh {
    mesh: Arc<TriMesh>,
    /// For each triangle the part that it belongs to.
    part: Arc<Vec<u32>>,
    parts: usize,
    /// Running sums of the triangles' areas.
    areas: RunningSums,
    bounds: (DVec3, DVec3),
    pub(super) walls: SurfaceWalls,
}

/// A mesh that is being prepared for packing.
pub struct PackingMeshMaking {
    mesh: Arc<TriMesh>,
    /// For each triangle its part, and the number of parts.
    parts: Option<(Vec<u32>, usize)>,
    /// The prepared mesh, whose walls do not have all their lists yet.
    site: Option<PackingMesh>,
}

impl PackingMeshMaking {
    /// Starts with a mesh.
    pub fn new(mesh: impl Into<Arc<TriMesh>>) -> Self {
        Self {
            mesh: mesh.into(),
            parts: None,
            site: None,
        }
    }

    /// Does one more slice, for cells that are not longer than `longest`; returns the prepared mesh when it is done.
    pub fn advance(&mut self, longest: f64) -> Option<PackingMesh> {
        if let Some(mut site) = self.site.take() {
            if site.walls.advance() {
                return Some(site);
            }
            self.site = Some(site);
        } else if let Some(parts) = self.parts.take() {
            self.site = Some(PackingMesh::begin(&self.mesh, parts, longest));
        } else {
            self.parts = Some(self.mesh.parts());
        }
        None
    }
}

impl PackingMesh {
    /// Prepares a mesh on which no cell is longer than `longest`, at once.
    pub fn new(mesh: impl Into<Arc<TriMesh>>, longest: f64) -> Self {
        let mut making = PackingMeshMaking::new(mesh);
        loop {
            if let Some(site) = making.advance(longest) {
                return site;
            }
        }
    }

    fn begin(mesh: &Arc<TriMesh>, (part, parts): (Vec<u32>, usize), longest: f64) -> Self {
        let part = Arc::new(part);
        let reach = crate::packing::wall::reach(longest);
        Self {
            areas: RunningSums::of_areas(mesh),
            walls: SurfaceWalls::begin(mesh.clone(), part.clone(), reach),
            bounds: mesh.bounds(),
            part,
            parts,
            mesh: mesh.clone(),
        }
    }

    /// The mesh.
    pub fn mesh(&self) -> &TriMesh {
        &self.mesh
    }

    /// The part that a point belongs to.
    pub fn part(&self, p: &SurfacePoint) -> u32 {
        self.part[p.triangle as usize]
    }

    /// How many parts there are.
    pub fn parts(&self) -> usize {
        self.parts
    }

    /// The point whose triangle is reached at `share` of the total area, 0..1, at the place in it that `within`
    /// gives, 0..1 each.
    pub(super) fn point(&self, share: f64, within: DVec2) -> SurfacePoint {
        let triangle = self.areas.item(share * self.mesh.area()) as u32;
        let root = within.x.sqrt();
        let weights = DVec3::new(1.0 - root, root * (1.0 - within.y), root * within.y);
        SurfacePoint::new(&self.mesh, triangle, weights)
    }

    /// The middle of a part, and its area. The middle is that of the triangle nearest to the mean.
    pub(super) fn middle(&self, part: u32) -> (SurfacePoint, f64) {
        let own = |t: &u32| self.part[*t as usize] == part;
        let all = || (0..self.part.len() as u32).filter(own);
        let middle = |t: u32| self.mesh.corners(t).iter().sum::<DVec3>() / 3.0;
        let (mut sum, mut area) = (DVec3::ZERO, 0.0);
        for t in all() {
            sum += middle(t) * self.mesh.area_of(t);
            area += self.mesh.area_of(t);
        }
        let mean = sum / area.max(f64::MIN_POSITIVE);
        let mut best = (f64::INFINITY, 0);
        for t in all() {
            let far = middle(t).distance_squared(mean);
            if far < best.0 {
                best = (far, t);
            }
        }
        let third = DVec3::splat(1.0 / 3.0);
        (SurfacePoint::new(&self.mesh, best.1, third), area)
    }
}

impl MetricSpace for &PackingMesh {
    type Place = SurfacePoint;
    type Transport = Transport;
    type Hash = SurfaceHash;
    const WALKS: bool = true;

    fn area(self) -> f64 {
        self.mesh.area()
    }

    #[inline]
    fn log(self, from: SurfacePoint, to: SurfacePoint) -> Option<(DVec2, Transport)> {
        log(&from, &to).map(|way| (way.to, way.turn))
    }

    fn images(self, p: SurfacePoint, _: f64) -> impl Iterator<Item = SurfacePoint> {
        std::iter::once(p)
    }

    fn log_from(
        self,
        image: SurfacePoint,
        to: SurfacePoint,
        reach: f64,
    ) -> Option<(DVec2, Transport)> {
        self.log_within(image, to, reach)
    }

    #[inline]
    fn log_within(
        self,
        from: SurfacePoint,
        to: SurfacePoint,
        reach: f64,
    ) -> Option<(DVec2, Transport)> {
        // The path along the surface is never shorter than the straight line.
        let is_near = from.at.distance_squared(to.at) <= reach * reach;
        if is_near { self.log(from, to) } else { None }
    }

    fn exp(self, from: SurfacePoint, by: DVec2) -> (SurfacePoint, Transport) {
        let walked = self.mesh.walk(&from, by);
        (walked.to, walked.turn)
    }

    fn wrap(self, p: SurfacePoint) -> SurfacePoint {
        p
    }

    fn distance(self, from: SurfacePoint, to: SurfacePoint) -> f64 {
        from.at.distance(to.at)
    }

    fn has_left(self, from: SurfacePoint, to: SurfacePoint, square: f64) -> bool {
        from.at.distance_squared(to.at) >= square
    }

    fn is_parted(self, _: SurfacePoint, _: DVec2) -> bool {
        false
    }

    fn crosses_line(self, _: SurfacePoint, _: DVec2) -> bool {
        false
    }

    fn is_gap_between(self, p: SurfacePoint, q: SurfacePoint) -> bool {
        self.part(&p) != self.part(&q)
    }

    fn grid(self, step: f64) -> SurfaceHash {
        SurfaceHash::new(self.bounds, step)
    }

    fn grid_around(self, places: impl Iterator<Item = SurfacePoint>, step: f64) -> SurfaceHash {
        // In space, fewer and larger boxes are faster than in the plane.
        SurfaceHash::around(places.map(|p| p.at), 2.0 * step)
    }

    fn any_near(
        self,
        grid: &SurfaceHash,
        p: SurfacePoint,
        radius: f64,
        visit: impl FnMut(usize) -> bool,
    ) -> bool {
        grid.any_near(p.at, radius, visit)
    }
}
