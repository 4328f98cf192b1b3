//! The floor under a scene: where it lies and where it fades.

use super::Scene;
use crate::order::lesser;
use glam::Vec3;

/// Points of a surface whose heights cost about as much as drawing a triangle.
const POINTS: usize = 8;

/// The plane of the floor, at the lowest y of all bodies. It fades with the distance from their
/// bounding ball's middle.
#[derive(Clone, Copy, Default)]
pub(super) struct FloorPlane {
    pub middle: Vec3,
    pub radius: f32,
    pub height: f32,
}

/// The search for the floor of a scene, in slices.
#[derive(Clone)]
pub(super) struct FloorSearch {
    plane: FloorPlane,
    /// The index of the next instance to look at.
    at: usize,
}

impl FloorSearch {
    pub fn new(scene: &Scene) -> Self {
        let (middle, radius) = scene.ball();
        let height = match scene.instances.is_empty() {
            true => 0.0,
            false => f32::MAX,
        };
        Self {
            plane: FloorPlane {
                middle,
                radius,
                height,
            },
            at: 0,
        }
    }

    /// Does the work of about this many triangles; true when finished.
    pub fn advance(&mut self, scene: &Scene, amount: usize) -> bool {
        let mut work = 0;
        while work < amount {
            let Some(instance) = scene.instances.get(self.at) else {
                return true;
            };
            let (low, points) = scene.lowest_of(instance, self.plane.height);
            self.plane.height = lesser(self.plane.height, low);
            self.at += 1;
            work += 1 + points / POINTS;
        }
        false
    }

    /// The plane, once it is found.
    pub fn plane(&self) -> FloorPlane {
        self.plane
    }
}
