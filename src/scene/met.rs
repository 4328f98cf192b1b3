//! Where a ray from the eye meets what is seen at a pixel.

use super::sight::{AS_DOT, NOTHING, Sight};
use super::{Instance, Scene, View};
use crate::order::greater;
use crate::solid::Surface;
use glam::Vec3;

/// A place of a surface, as its triangles have it.
#[derive(Clone, Copy)]
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

    /// On the body that is seen at a pixel, which the ray goes through. `part` is the triangle there, and `last` that
    /// met before, often the same one.
    #[inline(always)]
    pub fn new(
        sight: &Sight,
        scene: &Scene,
        at: usize,
        ray: Vec3,
        part: &Part,
        last: &mut Corners,
    ) -> Self {
        let place = sight.owner[at];
        let spread = sight.spread() / (sight.view().focal * sight.inverse[at]);
        let instance = &scene.instances[place as usize];
        let Some(surface) = part.surface else {
            let normal = -ray.normalize_or(Vec3::NEG_Y);
            let body = &scene.bodies[instance.body as usize];
            return Self {
                normal,
                flat: normal,
                colour: body.colour.map(f32::from),
                spread,
            };
        };
        if last.of != (place, part.corners) {
            *last = Corners::new(surface, instance, (place, part.corners));
        }
        let weights = weights(sight.view(), ray, last.places);
        let mut normal = Vec3::ZERO;
        let mut colour = [0.0; 3];
        for (k, weight) in weights.into_iter().enumerate() {
            normal += last.normals[k] * weight;
            for (sum, part) in colour.iter_mut().zip(last.colours[k]) {
                *sum += weight * f32::from(part);
            }
        }
        Self {
            normal: instance.place.turned(normal).normalize_or(last.flat),
            flat: last.flat,
            colour,
            spread,
        }
    }
}

/// A triangle that is seen, without anything of its corners.
#[derive(Clone, Copy)]
pub(super) struct Part<'a> {
    /// None where nothing is, or a dot.
    surface: Option<&'a Surface>,
    corners: [u32; 3],
}

impl<'a> Part<'a> {
    pub const NONE: Self = Self {
        surface: None,
        corners: [0; 3],
    };

    /// Of the body at a pixel.
    #[inline(always)]
    pub fn at(sight: &Sight, scene: &'a Scene, at: usize) -> Self {
        let (place, triangle) = (sight.owner[at] as usize, sight.triangle[at]);
        if triangle == AS_DOT {
            return Self::NONE;
        }
        let body = &scene.bodies[scene.instances[place].body as usize];
        let surface = &body.levels[usize::from(sight.levels[place])];
        Self {
            surface: Some(surface),
            corners: surface.triangles[triangle as usize],
        }
    }
}

/// What a surface has at the corners of a triangle.
#[derive(Clone, Copy)]
pub(super) struct Corners {
    /// The instance and the corners.
    of: (u32, [u32; 3]),
    /// In the world.
    places: [Vec3; 3],
    /// In the body.
    normals: [Vec3; 3],
    colours: [[u8; 3]; 3],
    /// The normal of the triangle, in the world.
    flat: Vec3,
}

impl Corners {
    /// Of no triangle.
    pub const NONE: Self = Self {
        of: (NOTHING, [0; 3]),
        places: [Vec3::ZERO; 3],
        normals: [Vec3::ZERO; 3],
        colours: [[0; 3]; 3],
        flat: Vec3::Y,
    };

    #[inline(always)]
    fn new(surface: &Surface, instance: &Instance, of: (u32, [u32; 3])) -> Self {
        let corners = of.1.map(|v| v as usize);
        let places = corners.map(|v| instance.place.of(surface.positions[v]));
        let [a, b, c] = places;
        Self {
            of,
            places,
            normals: corners.map(|v| surface.normals[v]),
            colours: corners.map(|v| surface.colours[v]),
            flat: (b - a).cross(c - a).normalize_or(Vec3::Y),
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
