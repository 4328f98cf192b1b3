//! Intersections of eye rays with visible triangles.

use super::Scene;
use super::tile::{BAND, SQUARE, Tile, Vectors, get};
use super::visibility::{AS_DOT, FLOOR, NOTHING, VisibilityBuffer, has_no_triangle};
use crate::order::greater;
use crate::solid::Surface;
use glam::Vec3;

/// A hit: a point of a surface with its interpolated attributes.
#[derive(Clone, Copy)]
pub(super) struct PixelHit {
    /// Interpolated outward normal, of any length, possibly zero.
    pub normal: Vec3,
    /// The triangle's unit normal.
    pub flat: Vec3,
    /// The height of the curved surface that the vertex normals imply, over the flat triangle at the hit, in the world.
    pub lift: f32,
    /// Red, green, blue, 0..255 (sRGB).
    pub colour: [f32; 3],
}

impl PixelHit {
    /// A hit on the floor.
    pub const FLOOR: Self = Self {
        normal: Vec3::Y,
        flat: Vec3::Y,
        lift: 0.0,
        colour: [0.0; 3],
    };
}

/// The visible triangles of a tile, each listed once.
pub(super) struct Facets {
    raw: Vec<Raw>,
    corners: Vec<Corners>,
    /// For each pixel the index of its triangle in the lists; `None` if it shows no triangle.
    of: [Option<u8>; SQUARE],
}

/// Attributes at the corners of a triangle, as in memory.
struct Raw {
    instance: u32,
    positions: [Vec3; 3],
    normals: [Vec3; 3],
    colours: [[u8; 3]; 3],
}

impl Facets {
    pub fn new() -> Self {
        Self {
            raw: Vec::with_capacity(SQUARE),
            corners: Vec::with_capacity(SQUARE),
            of: [None; SQUARE],
        }
    }

    /// Looks up the visible triangles of a tile. It first reads everything from memory, then computes: so the
    /// processor can load the next triangles while it waits, which takes most of the time here.
    pub fn look_up(&mut self, scene: &Scene, sight: &VisibilityBuffer, square: Tile) {
        self.raw.clear();
        self.corners.clear();
        self.of = [None; SQUARE];
        let view = sight.view();
        let mut seen = [(NOTHING, AS_DOT); SQUARE];
        for (k, [_, _, at]) in square.pixels(view) {
            let this = (sight.owner[at], sight.triangle[at]);
            if this.0 >= FLOOR || has_no_triangle(this.1) {
                continue;
            }
            seen[k] = this;
            // Most pixels show the same triangle as the one to the left or above.
            let beside = [1, BAND, BAND - 1].map(|back| k.wrapping_sub(back));
            let same = beside.into_iter().find(|&k| seen.get(k) == Some(&this));
            self.of[k] = same.map(|k| self.of[k]).unwrap_or_else(|| {
                self.raw.push(Raw::new(scene, sight, this));
                Some(self.raw.len() as u8 - 1)
            });
        }
        let corners = |raw: &Raw| Corners::new(raw, scene, view.eye);
        self.corners.extend(self.raw.iter().map(corners));
    }

    /// A hit on the cap of a body that is cut.
    pub fn cap(scene: &Scene, owner: u32, normal: Vec3) -> PixelHit {
        let body = scene.instances[owner as usize].body;
        PixelHit {
            normal,
            flat: normal,
            lift: 0.0,
            colour: scene.bodies[body as usize].colour.map(f32::from),
        }
    }

    /// The intersection of a pixel's ray with the body visible there.
    #[inline(always)]
    pub fn met(&self, scene: &Scene, owner: u32, rays: &Vectors, k: usize) -> PixelHit {
        let ray = get(rays, k);
        let Some(corners) = self.of[k].map(|place| &self.corners[usize::from(place)]) else {
            let normal = -ray.normalize_or(Vec3::NEG_Y);
            let body = scene.instances[owner as usize].body;
            return PixelHit {
                normal,
                flat: normal,
                lift: 0.0,
                colour: scene.bodies[body as usize].colour.map(f32::from),
            };
        };
        let weights = corners.weights(ray);
        let mut normal = Vec3::ZERO;
        let mut colour = [0.0; 3];
        for (k, weight) in weights.into_iter().enumerate() {
            normal += corners.normals[k] * weight;
            for (sum, part) in colour.iter_mut().zip(corners.colours[k]) {
                *sum += weight * part;
            }
        }
        PixelHit {
            normal,
            flat: corners.flat,
            lift: corners.lift(weights),
            colour,
        }
    }
}

impl Raw {
    #[inline(always)]
    fn new(scene: &Scene, sight: &VisibilityBuffer, (instance, triangle): (u32, u32)) -> Self {
        let body = &scene.bodies[scene.instances[instance as usize].body as usize];
        let level = usize::from(sight.levels[instance as usize]);
        let surface: &Surface = &body.levels[level];
        let corners = surface.triangles[triangle as usize].map(|v| v as usize);
        Self {
            instance,
            positions: corners.map(|v| surface.positions[v]),
            normals: corners.map(|v| surface.normals[v]),
            colours: corners.map(|v| surface.colours[v]),
        }
    }
}

/// A triangle, in the world.
struct Corners {
    /// The weights of the last two corners: the dot product of an eye ray with each part, over that with `whole`.
    parts: [Vec3; 2],
    whole: Vec3,
    normals: [Vec3; 3],
    colours: [[f32; 3]; 3],
    /// The triangle's normal.
    flat: Vec3,
    /// For the tangent plane at each corner: how far the next corner and the one after that lie below it, in the world.
    below: [[f32; 2]; 3],
}

impl Corners {
    #[inline(always)]
    fn new(raw: &Raw, scene: &Scene, eye: Vec3) -> Self {
        let place = &scene.instances[raw.instance as usize].place;
        let [a, b, c] = raw.positions.map(|p| place.of(p));
        // Differences first: f32 would lose most digits of corners that are far away and near each other
        // (Möller and Trumbore 1997, Fast, Minimum Storage Ray/Triangle Intersection; here everything
        // independent of the ray).
        let (ab, ac, from) = (b - a, c - a, eye - a);
        let whole = ac.cross(ab);
        let [na, nb, nc] = raw.normals.map(|normal| place.turned(normal));
        let one = 1.0 / place.scale();
        Self {
            parts: [ac.cross(from), from.cross(ab)],
            whole,
            normals: [na, nb, nc],
            below: [
                [-na.dot(ab), -na.dot(ac)],
                [-nb.dot(ac - ab), nb.dot(ab)],
                [nc.dot(ac), nc.dot(ac - ab)],
            ]
            .map(|pair| pair.map(|v| v * one)),
            colours: raw.colours.map(|colour| colour.map(f32::from)),
            flat: (-whole).normalize_or(Vec3::Y),
        }
    }

    /// The barycentric weights of the intersection of an eye ray with the triangle's plane. They add up to 1,
    /// and none is far outside the triangle.
    #[inline(always)]
    fn weights(&self, ray: Vec3) -> [f32; 3] {
        let whole = ray.dot(self.whole);
        if whole <= 0.0 {
            return [1.0 / 3.0; 3];
        }
        let [b, c] = self.parts.map(|part| ray.dot(part));
        let [a, b, c] = [whole - b - c, b, c].map(|part| greater(part, 0.0));
        let one = 1.0 / (a + b + c);
        [a * one, b * one, c * one]
    }

    /// How far the tangent planes at the corners lie above the triangle at a place with these weights, each weighted
    /// by its corner (Hanika 2021, Hacking the Shadow Terminator). It is 0 at corners, and where the surface is
    /// hollow.
    #[inline(always)]
    fn lift(&self, [a, b, c]: [f32; 3]) -> f32 {
        let above = |[next, last]: [f32; 2], w: [f32; 2]| greater(next * w[0] + last * w[1], 0.0);
        a * above(self.below[0], [b, c])
            + b * above(self.below[1], [c, a])
            + c * above(self.below[2], [a, b])
    }
}
