//! Where a ray from the eye meets what is seen at a pixel.

use super::sight::{AS_DOT, Sight};
use super::{Scene, View};
use crate::order::greater;
use glam::Vec3;

/// A place of a surface, as its triangles have it.
pub(super) struct Met {
    /// Unit vector outwards, between those of the corners.
    pub normal: Vec3,
    /// That of the triangle itself.
    pub flat: Vec3,
    /// Red, green, blue, 0..255 (sRGB).
    pub colour: [f32; 3],
    /// How far off it may be, in the world.
    pub spread: f32,
}

impl Met {
    /// On the floor.
    pub fn floor(colour: [f32; 3]) -> Self {
        Self {
            normal: Vec3::Y,
            flat: Vec3::Y,
            colour,
            spread: 0.0,
        }
    }

    /// On the body that is seen at a pixel, which the ray goes through.
    pub fn new(sight: &Sight, scene: &Scene, at: usize, ray: Vec3) -> Self {
        let place = sight.owner[at] as usize;
        let instance = &scene.instances[place];
        let body = &scene.bodies[instance.body as usize];
        let triangle = sight.triangle[at];
        let spread = sight.spread() / (sight.view().focal * sight.inverse[at]);
        if triangle == AS_DOT {
            let normal = -ray.normalize_or(Vec3::NEG_Y);
            return Self {
                normal,
                flat: normal,
                colour: body.colour.map(f32::from),
                spread,
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
            flat,
            colour,
            spread,
        }
    }
}

/// The parts that the corners of a triangle have in the place where a ray from the eye meets its plane; they add
/// up to 1, and none is far outside the triangle.
fn weights(view: &View, ray: Vec3, [a, b, c]: [Vec3; 3]) -> [f32; 3] {
    // Differences first: of corners that are far away and near each other little else would be left in f32
    // (Möller and Trumbore 1997, Fast, Minimum Storage Ray/Triangle Intersection).
    let (ab, ac, from) = (b - a, c - a, view.eye - a);
    let across = ray.cross(ac);
    let twice = ab.dot(across);
    if twice <= 0.0 {
        return [1.0 / 3.0; 3];
    }
    let (u, v) = (from.dot(across) / twice, ray.dot(from.cross(ab)) / twice);
    let parts = [1.0 - u - v, u, v].map(|part| greater(part, 0.0));
    let sum = parts[0] + parts[1] + parts[2];
    parts.map(|part| part / sum)
}
