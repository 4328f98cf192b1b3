//! Where a ray from the eye meets what is seen at a pixel.

use super::sight::{AS_DOT, Sight};
use super::{Scene, View};
use crate::order::greater;
use glam::Vec3;

/// A place of a surface, as its triangles have it.
pub(super) struct Met {
    /// Unit vector outwards.
    pub normal: Vec3,
    /// Red, green, blue, 0..255 (sRGB).
    pub colour: [f32; 3],
}

impl Met {
    /// On the body that is seen at a pixel, which the ray goes through.
    pub fn new(sight: &Sight, scene: &Scene, at: usize, ray: Vec3) -> Self {
        let place = sight.owner[at] as usize;
        let instance = &scene.instances[place];
        let body = &scene.bodies[instance.body as usize];
        let triangle = sight.triangle[at];
        if triangle == AS_DOT {
            return Self {
                normal: -ray.normalize_or(Vec3::NEG_Y),
                colour: body.colour.map(f32::from),
            };
        }
        let surface = &body.levels[usize::from(sight.levels[place])];
        let corners = surface.triangles[triangle as usize].map(|v| v as usize);
        let [a, b, c] = corners.map(|v| instance.place.of(surface.positions[v]));
        let weights = weights(sight.view(), ray, [a, b, c]);
        let mut normal = Vec3::ZERO;
        let mut colour = [0.0; 3];
        for (v, weight) in corners.into_iter().zip(weights) {
            normal += surface.normals[v] * weight;
            for (sum, part) in colour.iter_mut().zip(surface.colours[v]) {
                *sum += weight * f32::from(part);
            }
        }
        let flat = (b - a).cross(c - a).normalize_or(Vec3::Y);
        Self {
            normal: instance.place.turned(normal).normalize_or(flat),
            colour,
        }
    }
}

/// The parts that the corners of a triangle have in the place where a ray from the eye meets its plane; they add
/// up to 1, and none is far outside the triangle.
fn weights(view: &View, ray: Vec3, [a, b, c]: [Vec3; 3]) -> [f32; 3] {
    let (a, b, c) = (a - view.eye, b - view.eye, c - view.eye);
    // Volumes that the ray spans with the sides.
    let parts = [b.cross(c), c.cross(a), a.cross(b)].map(|v| v.dot(ray));
    let parts = parts.map(|part| greater(-part, 0.0));
    let sum = parts[0] + parts[1] + parts[2];
    if sum <= 0.0 {
        return [1.0 / 3.0; 3];
    }
    parts.map(|part| part / sum)
}
