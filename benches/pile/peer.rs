//! A pile of pebbles for a physics engine: its bodies, their hulls and their bowl.

use super::{Bowl, kind, variants};
use bubblestone::component::Component;
use bubblestone::pile::{Body, Kind, OverlapWork};
use bubblestone::solid::Surface;
use glam::{DMat3, DQuat, DVec3};
use std::f64::consts::PI;

/// The most points of a hull.
const HULL: usize = 64;

/// Pebbles in a bowl.
pub struct Pebbles {
    bowl: Surface,
    variants: Vec<Component>,
    kind: Kind,
    /// All pebbles that are kept.
    pub bodies: Vec<Body>,
}

impl Pebbles {
    /// Fills the bowl.
    pub fn new() -> Option<Self> {
        let bowl = Bowl::new()?;
        let variants = variants();
        let kind = kind(&variants);
        Some(Self {
            bodies: bowl.filled(&kind),
            bowl: bowl.shape.vessel?.surface,
            kind,
            variants,
        })
    }

    /// The bowl.
    pub fn bowl(&self) -> &Surface {
        &self.bowl
    }

    /// The greatest distance of a surface from its pebble's origin.
    pub fn bound(&self) -> f64 {
        self.kind.bound()
    }

    /// Points of each variant, whose convex hull is nearly the pebble: the farthest ones in even directions.
    pub fn hulls(&self) -> impl Iterator<Item = Vec<[f32; 3]>> {
        self.variants.iter().map(hull)
    }

    /// The same pebbles at other places: x, y, z, and a quaternion.
    pub fn moved(mut self, places: &[[f64; 7]]) -> Self {
        for (body, &[x, y, z, a, b, c, w]) in self.bodies.iter_mut().zip(places) {
            body.at = DVec3::new(x, y, z);
            body.t = 0.0;
            body.turn = DMat3::from_quat(DQuat::from_xyzw(a, b, c, w).normalize());
        }
        self
    }

    /// The depth to which inner spheres of different pebbles overlap, in R of the smaller one: the deepest of all, and
    /// the mean of each pebble's deepest.
    pub fn overlaps(&self) -> [f64; 2] {
        let mut kind = self.kind.clone();
        for (shape, component) in kind.shapes.iter_mut().zip(&self.variants) {
            shape.spheres.clone_from(&component.spheres);
        }
        let kinds = [kind];
        let mut work = OverlapWork::new(&self.bodies, &kinds);
        while !work.advance(&self.bodies, &kinds) {}
        let depths = work.deepest.iter().map(|depth| depth.max(0.0));
        let mean = depths.clone().sum::<f64>() / self.bodies.len() as f64;
        [depths.fold(0.0, f64::max), mean]
    }
}

fn hull(component: &Component) -> Vec<[f32; 3]> {
    let places = component.levels[0].mesh.positions();
    let mut chosen: Vec<usize> = Vec::new();
    for k in 0..HULL {
        // Points of a spiral from pole to pole.
        let height = 1.0 - (2 * k + 1) as f64 / HULL as f64;
        let (sin, cos) = libm::sincos(PI * (3.0 - 5.0_f64.sqrt()) * k as f64);
        let across = (1.0 - height * height).sqrt();
        let towards = DVec3::new(across * cos, height, across * sin);
        let far = |k: &usize| places[*k].dot(towards);
        let farthest = (0..places.len()).max_by(|a, b| far(a).total_cmp(&far(b)));
        chosen.extend(farthest);
    }
    chosen.sort_unstable();
    chosen.dedup();
    let place = |k: usize| places[k].as_vec3().to_array();
    chosen.into_iter().map(place).collect()
}
