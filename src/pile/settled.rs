//! The bodies that have settled.

use super::{Body, Kind};
use crate::component::Sphere;
use crate::trimesh::TriMesh;
use crate::trimesh::spatial_hash::SurfaceHash;
use glam::DVec3;

/// The bodies that have settled, found by place.
pub(super) struct Settled {
    hash: SurfaceHash,
    /// The greatest distance of a surface from its body's origin, over all types.
    reach: f64,
    bodies: Vec<SettledBody>,
    spheres: Vec<Sphere>,
}

struct SettledBody {
    place: DVec3,
    bound: f64,
    radius: f64,
    /// Its part of the list of all spheres.
    spheres: std::ops::Range<usize>,
}

/// A settled body near one that looks for its place.
pub(super) struct Neighbour<'a> {
    /// Its origin.
    pub place: DVec3,
    /// R, the radius of its largest inner sphere.
    pub radius: f64,
    /// Its inner spheres.
    pub spheres: &'a [Sphere],
}

impl Settled {
    /// Starts without bodies.
    pub fn new(mesh: &TriMesh, kinds: &[Kind]) -> Self {
        let reach = kinds.iter().map(Kind::bound).fold(0.0, f64::max);
        let (lo, hi) = mesh.bounds();
        let margin = DVec3::splat(reach);
        Self {
            hash: SurfaceHash::new((lo - margin, hi + margin), reach),
            reach,
            bodies: Vec::new(),
            spheres: Vec::new(),
        }
    }

    /// Adds a body in its place.
    pub fn add(&mut self, body: &Body, kinds: &[Kind]) {
        let first = self.spheres.len();
        self.spheres.extend(body.spheres(kinds));
        self.hash.push_at(body.place());
        self.bodies.push(SettledBody {
            place: body.place(),
            bound: body.shape(kinds).bound * body.scale,
            radius: body.radius(kinds),
            spheres: first..self.spheres.len(),
        });
    }

    /// The settled bodies that a body may meet in a range of its normal, in the order in which they settled.
    pub fn near(&self, body: &Body, bound: f64, (lo, hi): (f64, f64)) -> Vec<Neighbour<'_>> {
        let middle = body.at + 0.5 * (lo + hi) * body.normal;
        let half = 0.5 * (hi - lo);
        let mut near = Vec::new();
        self.hash.any_near(middle, half + bound + self.reach, |k| {
            let other = &self.bodies[k];
            let away = other.place - middle;
            let along = away.dot(body.normal).clamp(-half, half);
            let reach = bound + other.bound;
            if away.distance_squared(along * body.normal) < reach * reach {
                near.push(k as u32);
            }
            false
        });
        near.sort_unstable();
        near.into_iter().map(|k| self.neighbour(k)).collect()
    }

    fn neighbour(&self, k: u32) -> Neighbour<'_> {
        let body = &self.bodies[k as usize];
        Neighbour {
            place: body.place,
            radius: body.radius,
            spheres: &self.spheres[body.spheres.clone()],
        }
    }
}
