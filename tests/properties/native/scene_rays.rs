//! The reference for scenes: rays against all triangles, in f64; and the bodies that scenes consist of.

use bubblestone::light::{Light, ShadeParams};
use bubblestone::material::Material;
use bubblestone::scene::Backdrop;
use bubblestone::scene::{
    Body, Camera, Frame, Instance, Lamp, Lighting, Order, Place, Scene, Sharpness, View,
};
use bubblestone::solid::Surface;
use glam::{DVec3, Vec3};
use std::f64::consts::{PI, TAU};

/// The first triangle that a ray meets from its front; backs are invisible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hit {
    pub instance: usize,
    pub triangle: usize,
    /// The distance, in lengths of the ray's direction.
    pub away: f64,
    /// The barycentric coordinates.
    pub parts: [f64; 3],
}

/// All triangles of a scene at the finest level of detail.
pub(super) struct Rays {
    triangles: Vec<(usize, usize, [DVec3; 3])>,
}

impl Rays {
    pub fn new(scene: &Scene) -> Self {
        let mut triangles = Vec::new();
        for (at, instance) in scene.instances.iter().enumerate() {
            let surface = &scene.bodies[instance.body as usize].levels[0];
            for (number, triangle) in surface.triangles.iter().enumerate() {
                let corners = triangle.map(|v| of(&instance.place, surface.positions[v as usize]));
                triangles.push((at, number, corners));
            }
        }
        Self { triangles }
    }

    /// The first front face that a ray meets.
    pub fn nearest(&self, from: DVec3, way: DVec3) -> Option<Hit> {
        let hits = self.hits(from, way);
        let fronts = hits.filter_map(|(hit, is_front)| is_front.then_some(hit));
        fronts.min_by(|a, b| a.away.total_cmp(&b.away))
    }

    /// Whether a ray begins inside a body: the first face that it meets is a back.
    pub fn leaves(&self, from: DVec3, way: DVec3) -> bool {
        let first = self
            .hits(from, way)
            .min_by(|a, b| a.0.away.total_cmp(&b.0.away));
        first.is_some_and(|(_, is_front)| !is_front)
    }

    /// All triangles that a ray meets, with whether it meets their front (Möller and Trumbore 1997, Fast,
    /// Minimum Storage Ray/Triangle Intersection).
    fn hits(&self, from: DVec3, way: DVec3) -> impl Iterator<Item = (Hit, bool)> {
        self.triangles
            .iter()
            .filter_map(move |&(instance, triangle, [a, b, c])| {
                let (ab, ac, s) = (b - a, c - a, from - a);
                let h = way.cross(ac);
                let twice = ab.dot(h);
                let u = s.dot(h) / twice;
                if twice == 0.0 || !(0.0..=1.0).contains(&u) {
                    return None;
                }
                let q = s.cross(ab);
                let v = way.dot(q) / twice;
                let away = ac.dot(q) / twice;
                let is_met = v >= 0.0 && u + v <= 1.0 && away > 0.0;
                let parts = [1.0 - u - v, u, v];
                let hit = Hit {
                    instance,
                    triangle,
                    away,
                    parts,
                };
                is_met.then_some((hit, twice > 0.0))
            })
    }

    /// The hit at a place of a frame.
    pub fn seen(&self, view: &View, x: f64, y: f64) -> Option<Hit> {
        self.nearest(view.eye.as_dvec3(), ray(view, x, y))
    }
}

/// The direction from the eye through a place of the frame, with depth 1.
pub(super) fn ray(view: &View, x: f64, y: f64) -> DVec3 {
    let focal = f64::from(view.focal);
    let across = (x - f64::from(view.middle[0])) / focal;
    let down = (y - f64::from(view.middle[1])) / focal;
    view.ahead.as_dvec3() + view.right.as_dvec3() * across - view.up.as_dvec3() * down
}

/// A point of a body in the world, in f64.
fn of(place: &Place, p: Vec3) -> DVec3 {
    let axes = place.axes.map(Vec3::as_dvec3);
    let p = p.as_dvec3();
    place.origin.as_dvec3() + axes[0] * p.x + axes[1] * p.y + axes[2] * p.z
}

/// The interpolated normal of the vertices at a hit.
pub(super) fn normal_at(scene: &Scene, hit: &Hit) -> Vec3 {
    let instance = &scene.instances[hit.instance];
    let surface = &scene.bodies[instance.body as usize].levels[0];
    let corners = surface.triangles[hit.triangle].map(|v| surface.normals[v as usize]);
    let sum = (0..3).fold(Vec3::ZERO, |sum, k| sum + corners[k] * hit.parts[k] as f32);
    instance.place.turned(sum).normalize()
}

/// A surface of points and triangles, with vertex normals from the triangles.
pub(super) fn surface(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>, colour: [u8; 3]) -> Surface {
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for triangle in &triangles {
        let [a, b, c] = triangle.map(|v| positions[v as usize]);
        for &v in triangle {
            normals[v as usize] += (b - a).cross(c - a);
        }
    }
    Surface {
        normals: normals.iter().map(|n| n.normalize_or(Vec3::Y)).collect(),
        colours: vec![colour; positions.len()],
        positions,
        triangles,
    }
}

/// A closed grid of `across` times `down` squares as triangles, such as a torus.
fn wound(across: u32, down: u32, at: impl Fn(f64, f64) -> DVec3) -> Surface {
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for (j, i) in (0..down).flat_map(|j| (0..across).map(move |i| (j, i))) {
        let parts = [
            f64::from(i) / f64::from(across),
            f64::from(j) / f64::from(down),
        ];
        positions.push(at(parts[0] * TAU, parts[1] * TAU).as_vec3());
        let v = |i: u32, j: u32| (j % down) * across + i % across;
        triangles.push([v(i, j), v(i, j + 1), v(i + 1, j + 1)]);
        triangles.push([v(i, j), v(i + 1, j + 1), v(i + 1, j)]);
    }
    surface(positions, triangles, [180, 150, 120])
}

pub(super) fn torus(across: u32, down: u32) -> Surface {
    wound(across, down, |i, j| {
        let out = 0.7 + 0.3 * libm::cos(j);
        DVec3::new(out * libm::cos(i), 0.3 * libm::sin(j), out * libm::sin(i))
    })
}

/// A ball of radius 1 with this number of rings of triangles.
pub(super) fn ball(rings: u32) -> Surface {
    let around = 2 * rings;
    let mut positions = vec![Vec3::Y];
    for (j, i) in (1..rings).flat_map(|j| (0..around).map(move |i| (j, i))) {
        let (down, turn) = (
            f64::from(j) / f64::from(rings) * PI,
            f64::from(i) / f64::from(around) * TAU,
        );
        let flat = libm::sin(down);
        let p = DVec3::new(
            flat * libm::cos(turn),
            libm::cos(down),
            flat * libm::sin(turn),
        );
        positions.push(p.as_vec3());
    }
    positions.push(Vec3::NEG_Y);
    let (last, mut triangles) = (positions.len() as u32 - 1, Vec::new());
    let v = |j: u32, i: u32| match j {
        0 => 0,
        j if j == rings => last,
        j => 1 + (j - 1) * around + i % around,
    };
    for (j, i) in (0..rings).flat_map(|j| (0..around).map(move |i| (j, i))) {
        for t in [
            [v(j, i), v(j + 1, i + 1), v(j + 1, i)],
            [v(j, i), v(j, i + 1), v(j + 1, i + 1)],
        ] {
            if t[0] != t[1] && t[1] != t[2] && t[2] != t[0] {
                triangles.push(t);
            }
        }
    }
    surface(positions, triangles, [120, 160, 200])
}

/// A box with sharp edges: each face has corners of its own.
pub(super) fn block(half: Vec3) -> Surface {
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for (u, v) in [(Vec3::X, Vec3::Y), (Vec3::Y, Vec3::Z), (Vec3::Z, Vec3::X)] {
        for sign in [1.0, -1.0] {
            let (u, n) = (u * sign, u.cross(v) * sign);
            let first = positions.len() as u32;
            for (a, b) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                positions.push((n + u * a + v * b) * half);
            }
            triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|v| first + v)));
        }
    }
    surface(positions, triangles, [200, 190, 170])
}

/// A rod whose sides are long thin triangles, like those of control meshes.
pub(super) fn rod(sides: u32) -> Surface {
    let ring = |y: f32| {
        (0..sides).map(move |k| {
            let turn = f64::from(k) / f64::from(sides) * TAU;
            Vec3::new(
                0.2 * libm::cos(turn) as f32,
                y,
                0.2 * libm::sin(turn) as f32,
            )
        })
    };
    let mut positions: Vec<Vec3> = ring(-1.0).chain(ring(1.0)).collect();
    positions.extend([Vec3::new(0.0, -1.1, 0.0), Vec3::new(0.05, 1.05, 0.0)]);
    let mut triangles = Vec::new();
    for k in 0..sides {
        let (a, b) = (k, (k + 1) % sides);
        let (c, d) = (a + sides, b + sides);
        triangles.extend([
            [a, c, d],
            [a, d, b],
            [2 * sides, a, b],
            [2 * sides + 1, d, c],
        ]);
    }
    surface(positions, triangles, [90, 140, 90])
}

/// A square in the plane y = 0 that faces up.
pub(super) fn square(half: f32) -> Surface {
    let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]];
    let positions = corners.map(|[x, z]| Vec3::new(x * half, 0.0, z * half));
    surface(positions.to_vec(), vec![[0, 1, 2], [0, 2, 3]], [150; 3])
}

/// A place that rotates about an axis by degrees, scales, and moves.
pub(super) fn place(axis: [f32; 3], degrees: f64, scale: f32, origin: [f32; 3]) -> Place {
    let axis = Vec3::from(axis).normalize();
    let (sin, cos) = (
        libm::sin(degrees.to_radians()) as f32,
        libm::cos(degrees.to_radians()) as f32,
    );
    let turn = |v: Vec3| v * cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - cos));
    Place {
        axes: [Vec3::X, Vec3::Y, Vec3::Z].map(|v| turn(v) * scale),
        origin: Vec3::from(origin),
    }
}

/// A scene of surfaces, each once; ids count from 1.
pub(super) fn scene(parts: Vec<(Surface, Place)>) -> Scene {
    let mut scene = Scene {
        reach: 0.3,
        ..Scene::default()
    };
    for (k, (surface, place)) in (0..).zip(parts) {
        scene.bodies.push(Body::new(vec![surface], 0));
        scene.instances.push(Instance {
            body: k,
            place,
            id: k + 1,
            paint: None,
        });
    }
    assert_eq!(scene.fault(), None);
    scene
}

/// A ball, a torus, a rod and a block over a slab, turned and scaled.
pub(super) fn still_life() -> Scene {
    scene(vec![
        (
            block(Vec3::new(1.0, 0.1, 1.0)),
            place([0.0, 1.0, 0.0], 20.0, 1.0, [0.0, -0.1, 0.0]),
        ),
        (ball(8), place([1.0, 0.2, 0.0], 50.0, 0.3, [0.3, 0.3, -0.2])),
        (
            torus(16, 8),
            place([0.3, 0.4, 1.0], 35.0, 0.35, [-0.4, 0.25, 0.3]),
        ),
        (rod(12), place([1.0, 0.0, 0.4], 60.0, 0.4, [0.2, 0.4, 0.5])),
        (
            block(Vec3::new(0.6, 0.3, 0.2)),
            place([0.1, 1.0, 0.5], 130.0, 0.4, [-0.4, 0.4, -0.4]),
        ),
    ])
}

pub(super) const MATT: Material = Material::new(1.0, 0.9, 0.1, 12.0);

/// Shading with all factors 1.
pub(super) const PARAMS: ShadeParams = ShadeParams {
    light: Light::Parallel {
        azimuth: 3.9,
        elevation: 0.7,
    },
    ..ShadeParams::DEFAULT
};

pub(super) fn sun(x: f32, y: f32, z: f32) -> Lamp {
    Lamp::Sun(Vec3::new(x, y, z).normalize())
}

pub(super) fn camera(angle: f64, height: f64, distance: f64, lens: f64) -> Camera {
    Camera {
        angle,
        height,
        distance,
        lens,
        target: [0.0; 3],
    }
}

/// One sample for each pixel, and no backdrop.
pub(super) fn order(camera: Camera, size: [usize; 2]) -> Order {
    Order {
        camera,
        size,
        samples: 1,
        aperture: 0.0,
        is_moving: false,
        backdrop: Backdrop::Nothing,
        cut: None,
    }
}

/// The finished light of a scene.
pub(super) fn lighting(scene: &Scene, lamp: Lamp, params: &ShadeParams, amount: usize) -> Lighting {
    let mut light = Lighting::new(scene, lamp, (params, &[MATT]), Sharpness::Large);
    while !light.advance(scene, amount) {}
    light
}

/// A frame made in slices of this amount of work.
pub(super) fn frame(scene: &Scene, light: &Lighting, order: Order, amount: usize) -> Frame {
    let mut frame = Frame::new(order);
    while !frame.advance(scene, light, amount) {}
    frame
}

/// A frame with the cheapest light.
pub(super) fn plain(scene: &Scene, order: Order) -> Frame {
    let params = ShadeParams {
        shadow: 0.0,
        ..PARAMS
    };
    let light = lighting(scene, sun(0.2, 1.0, 0.1), &params, 1_000_000_000);
    frame(scene, &light, order, 1_000_000)
}

/// Pseudo-random numbers in 0..1, the same on every run.
pub(super) struct Chance(pub u64);

impl Chance {
    pub fn next(&mut self) -> f32 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / (1u64 << 24) as f32
    }
}

/// A lamp over the plane y = 0.
pub(super) fn bulb(at: [f32; 3]) -> Lamp {
    Lamp::Bulb {
        at: Vec3::from(at),
        height: at[1],
    }
}

/// The edges of all bodies.
pub(super) fn edges(scene: &Scene) -> Vec<[Vec3; 2]> {
    let mut lines = Vec::new();
    for instance in &scene.instances {
        let surface = &scene.bodies[instance.body as usize].levels[0];
        for &[a, b, _] in &surface.triangles {
            lines.push([a, b].map(|v| instance.place.of(surface.positions[v as usize])));
        }
    }
    lines
}
