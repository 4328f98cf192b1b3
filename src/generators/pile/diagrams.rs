//! Diagrams of a pile: darts with their disks, inner spheres, overlap, types, layers, and what was removed.

use super::components::Components;
use super::heap::place;
use super::made::Thrown;
use super::views::PileView;
use crate::component::Sphere;
use crate::pile::{Body as PiledBody, Fate, Kind};
use crate::scene::{Body, Cut, CutHow, Detail, Instance, Paint, Place, Scene, Surfel};
use crate::solid::Surface;
use crate::surface_stones::Fit;
use crate::surface_views::BareSurface;
use glam::{DVec3, Vec3};
use std::f64::consts::{PI, TAU};

/// Colours of types, and of layers.
const TYPES: [[u8; 3]; 5] = [
    [86, 146, 206],
    [226, 142, 62],
    [104, 172, 96],
    [196, 96, 134],
    [150, 122, 196],
];
/// Colours of the reasons why a body is not there: merged, walls, removed.
const REASONS: [[u8; 3]; 3] = [[86, 146, 206], [150, 122, 196], [214, 72, 56]];
/// The colour of darts whose bodies are kept.
const PALE: [u8; 3] = [206, 200, 190];
/// Colours of overlap: blue for bodies that are apart, green for touching ones, and red for deep overlap.
const APART: [f32; 3] = [70.0, 120.0, 210.0];
const TOUCHING: [f32; 3] = [90.0, 180.0, 90.0];
const DEEP: [f32; 3] = [216.0, 64.0, 48.0];
/// The colour of places outside all inner spheres.
const OUTSIDE: [f32; 3] = [196.0, 198.0, 202.0];
/// Depths between two lines, in R, and the width of a line as a share of that.
const STEP: f64 = 0.25;
const LINE: f64 = 0.1;
/// The plane that cuts bodies open where none is asked for: it is upright and faces the first camera.
pub(super) const MIDDLE: Cut = Cut {
    normal: Vec3::new(0.5, 0.0, 0.866_025_4),
    at: 0.0,
    how: CutHow::Through,
};
/// The row of plain bodies in the materials of views.
const SATIN: u8 = 2;
/// The row of the bare surface in the materials of views.
const BARE: u8 = 0;
/// The colour of the shape under its darts.
const CALM: [u8; 3] = [168, 162, 151];
/// The radius of a dart, and the thickness of its disk, in radii of the disk.
const POINT: f64 = 0.16;
const THICK: f32 = 0.04;
/// The share of a disk's radius that is drawn, so that neighbours can be told apart.
const DRAWN: f64 = 0.94;
/// Meridians and parallels of a ball, and corners of a disk.
const BALL: [usize; 2] = [20, 10];
const DISK: usize = 28;

/// The scene of a diagram, and the number in its caption.
pub(crate) struct Diagram {
    pub scene: Scene,
    /// The deepest overlap, in R (the radius of the largest inner sphere), if the diagram shows it.
    pub deepest: Option<f64>,
    /// Whether it shows the inside of bodies, which are cut open.
    pub is_inside: bool,
}

impl From<Scene> for Diagram {
    fn from(scene: Scene) -> Self {
        Self {
            scene,
            deepest: None,
            is_inside: false,
        }
    }
}

/// A settled pile.
pub(super) struct Piled<'a> {
    pub kinds: &'a [Kind],
    pub bodies: &'a [PiledBody],
    /// T and D, in R: overlap up to T counts as touching, and a body that overlaps by more than T + D is removed.
    pub offset: f64,
    pub removal: f64,
    pub components: &'a Components,
    pub fit: Fit,
}

/// The darts on the bare shape. The radius of a dart's disk is half the least distance to darts of its type.
pub(super) fn darts(ground: &BareSurface, thrown: &Thrown) -> Diagram {
    let mut scene = ground.scene();
    let fit = ground.fit();
    let first = scene.bodies.len() as u32;
    for kind in 0..thrown.kinds.len() {
        let colour = TYPES[kind % TYPES.len()];
        scene.bodies.push(Body::new(vec![disk(colour)], SATIN));
    }
    for (&(kind, at, normal), id) in thrown.darts.iter().zip(1..) {
        let radius = DRAWN * 0.5 * thrown.kinds[kind as usize].spacing();
        let u = normal.any_orthonormal_vector();
        let axes = [u, normal, u.cross(normal)];
        let scale = radius * fit.scale;
        scene.instances.push(Instance {
            body: first + kind,
            place: Place {
                axes: axes.map(|axis| (axis * scale).as_vec3()),
                origin: fit.place(at),
            },
            id,
            paint: None,
        });
    }
    scene.into()
}

/// A diagram of settled bodies, except [`overlap`].
pub(super) fn of_bodies(view: PileView, piled: &Piled, ground: &BareSurface) -> Diagram {
    match view {
        PileView::Spheres => spheres(piled),
        PileView::Fates => fates(piled, ground),
        PileView::Depth => depth(piled),
        PileView::Layers => coloured(piled, |body| TYPES[body.layer as usize % TYPES.len()]),
        _ => coloured(piled, |body| TYPES[body.kind as usize % TYPES.len()]),
    }
}

/// The bodies, each in one colour.
fn coloured(piled: &Piled, colour: impl Fn(&PiledBody) -> [u8; 3]) -> Diagram {
    let (mut scene, first) = plain(piled);
    for body in kept(piled) {
        let mesh = first[body.kind as usize] + body.shape;
        let place = place(body, piled.fit);
        scene
            .instances
            .push(painted(mesh, place, body.dart, colour(body)));
    }
    scene.into()
}

/// A scene with a white body for each variant, and the number of the first body of each type.
fn plain(piled: &Piled) -> (Scene, Vec<u32>) {
    let mut scene = Scene {
        reach: reach(piled),
        ..Scene::default()
    };
    let mut first = Vec::new();
    for variants in piled.components {
        first.push(scene.bodies.len() as u32);
        for component in &variants.all {
            let from = component.levels.len() - component.levels.len().min(2);
            let levels = component.levels[from..].iter();
            let levels = levels.map(|level| level.surface(component.crease, |_| [255; 3]));
            scene.bodies.push(Body::new(levels.collect(), SATIN));
        }
    }
    (scene, first)
}

fn kept<'a>(piled: &Piled<'a>) -> impl Iterator<Item = &'a PiledBody> + use<'a> {
    let bodies = piled.bodies.iter();
    bodies.filter(|body| body.fate == Fate::Kept)
}

fn reach(piled: &Piled) -> f32 {
    let sum: f64 = piled.kinds.iter().map(Kind::diagonal).sum();
    (0.35 * sum / piled.kinds.len().max(1) as f64 * piled.fit.scale) as f32
}

/// The inner spheres of all bodies.
fn spheres(piled: &Piled) -> Diagram {
    let mut scene = Scene {
        reach: reach(piled),
        ..Scene::default()
    };
    scene
        .bodies
        .push(Body::new(vec![ball([255; 3]), coarse_ball()], SATIN));
    for body in kept(piled) {
        let tint = TYPES[body.kind as usize % TYPES.len()];
        for sphere in body.spheres(piled.kinds) {
            let place = round(sphere, piled.fit);
            scene.instances.push(painted(0, place, body.dart, tint));
        }
    }
    scene.into()
}

/// A white mesh in its place, with the colour and the id of a dart's body.
fn painted(body: u32, place: Place, dart: u32, tint: [u8; 3]) -> Instance {
    Instance {
        body,
        place,
        id: dart + 1,
        paint: Some(Paint {
            tint,
            material: SATIN,
        }),
    }
}

/// The place that makes this sphere of a ball with radius 1.
fn round(sphere: Sphere, fit: Fit) -> Place {
    let scale = (sphere.radius * fit.scale) as f32;
    Place {
        axes: [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| axis * scale),
        origin: fit.place(sphere.centre),
    }
}

/// The darts on the bare shape: pale if the body is kept or waits, else in the colour of the reason.
fn fates(piled: &Piled, ground: &BareSurface) -> Diagram {
    let mut scene = Scene {
        reach: reach(piled),
        ..Scene::default()
    };
    ground.add_to(&mut scene, BARE, 0.0, CALM);
    let first = scene.bodies.len() as u32;
    scene.bodies.push(Body::new(vec![ball([255; 3])], SATIN));
    for body in piled.bodies {
        let (tint, size) = match body.fate {
            Fate::Merged => (REASONS[0], 1.6),
            Fate::Walls => (REASONS[1], 1.6),
            Fate::Removed => (REASONS[2], 1.6),
            Fate::Kept | Fate::Waiting => (PALE, 1.0),
        };
        let radius = size * POINT * piled.kinds[body.kind as usize].spacing();
        let sphere = Sphere {
            centre: body.at,
            radius,
        };
        let place = round(sphere, piled.fit);
        scene.instances.push(painted(first, place, body.dart, tint));
    }
    scene.into()
}

/// The bodies, blue where they are apart, green where they touch, and red where they overlap by more than T + D.
/// `deepest` has the deepest overlap of each body, in R.
pub(super) fn overlap(piled: &Piled, deepest: &[f64]) -> Diagram {
    let colour = |body: &PiledBody| {
        let own = deepest[body.dart as usize];
        bytes(between_three(own, (piled.offset, piled.removal)))
    };
    let most = deepest.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Diagram {
        deepest: most.is_finite().then_some(most),
        ..coloured(piled, colour)
    }
}

fn mix(a: [f32; 3], b: [f32; 3], part: f64) -> [f32; 3] {
    let part = part.clamp(0.0, 1.0) as f32;
    std::array::from_fn(|k| a[k] + (b[k] - a[k]) * part)
}

/// Blue up to -0.3, green from 0 to `offset`, red from `offset + more` on, and blended between these.
fn between_three(value: f64, (offset, more): (f64, f64)) -> [f32; 3] {
    match value {
        value if value < 0.0 => mix(APART, TOUCHING, 1.0 + value / 0.3),
        value => mix(TOUCHING, DEEP, (value - offset - 1e-6) / more.max(1e-6)),
    }
}

/// The colour of a depth in R: pale outside, blue at 0, green at 0.5 and red from 1 on. Each step of [`STEP`] ends in a
/// thin dark line, as on a map.
fn inside(depth: f64) -> [f32; 3] {
    if depth < -1e-6 {
        return mix(APART, OUTSIDE, -depth / 0.1);
    }
    let colour = match depth {
        depth if depth < 0.5 => mix(APART, TOUCHING, depth / 0.5),
        depth => mix(TOUCHING, DEEP, (depth - 0.5) / 0.5),
    };
    let part = depth / STEP - (depth / STEP).floor();
    match part < LINE && depth > 0.5 * STEP {
        true => colour.map(|v| 0.72 * v),
        false => colour,
    }
}

fn bytes(colour: [f32; 3]) -> [u8; 3] {
    colour.map(|v| (v.clamp(0.0, 255.0) + 0.5) as u8)
}

/// The bodies, coloured by the depth of eq. (2) at each place in the body's own spheres: blue on a sphere, green halfway
/// to the centre of the largest one, and red there. Places outside all spheres are pale. Bodies are cut open.
fn depth(piled: &Piled) -> Diagram {
    let mut diagram = coloured(piled, |_| [255; 3]);
    let count = piled.bodies.len();
    let mut owns: Vec<Option<Vec<Sphere>>> = vec![None; count];
    let mut radii = vec![1.0; count];
    for body in kept(piled) {
        let k = body.dart as usize;
        let to_scene = |s: Sphere| Sphere {
            centre: piled.fit.place(s.centre).as_dvec3(),
            radius: s.radius * piled.fit.scale,
        };
        owns[k] = Some(body.spheres(piled.kinds).map(to_scene).collect());
        radii[k] = body.radius(piled.kinds) * piled.fit.scale;
    }
    diagram.scene.detail = Some(Box::new(DepthDetail { owns, radii }));
    diagram.is_inside = true;
    diagram
}

/// Colours a body by the depth in the body's own spheres.
struct DepthDetail {
    owns: Vec<Option<Vec<Sphere>>>,
    radii: Vec<f64>,
}

impl Detail for DepthDetail {
    fn refine(&self, surfel: &mut Surfel, id: u32, _spread: f32) {
        let k = (id as usize).wrapping_sub(1);
        let Some(spheres) = self.owns.get(k).and_then(Option::as_ref) else {
            return;
        };
        let at = surfel.position.as_dvec3();
        let depth = |s: &Sphere| s.radius - at.distance(s.centre);
        let deepest = spheres.iter().map(depth).fold(f64::NEG_INFINITY, f64::max);
        surfel.colour = inside(deepest / self.radii[k]);
    }
}

/// A ball of radius 1 about the origin.
fn ball(colour: [u8; 3]) -> Surface {
    globe(BALL, colour)
}

fn coarse_ball() -> Surface {
    globe(BALL.map(|n| n / 2), [255; 3])
}

fn globe([around, down]: [usize; 2], colour: [u8; 3]) -> Surface {
    let mut surface = Surface::default();
    for k in 0..=down {
        let (sin, cos) = libm::sincos(PI * k as f64 / down as f64);
        for j in 0..around {
            let (s, c) = libm::sincos(TAU * j as f64 / around as f64);
            surface
                .positions
                .push(DVec3::new(sin * c, cos, sin * s).as_vec3());
        }
    }
    surface.normals = surface.positions.clone();
    surface.colours = vec![colour; surface.positions.len()];
    let at = |k: usize, j: usize| (k * around + j % around) as u32;
    for k in 0..down {
        for j in 0..around {
            let [a, b, c, d] = [at(k, j), at(k, j + 1), at(k + 1, j), at(k + 1, j + 1)];
            if k > 0 {
                surface.triangles.push([a, b, d]);
            }
            if k + 1 < down {
                surface.triangles.push([a, d, c]);
            }
        }
    }
    surface
}

/// A thin disk of radius 1 around the axis y, with a small ball in its middle.
fn disk(colour: [u8; 3]) -> Surface {
    let mut surface = globe([12, 6], [40, 38, 36]);
    for p in &mut surface.positions {
        *p *= POINT as f32;
    }
    let first = surface.positions.len() as u32;
    let push = |surface: &mut Surface, p: Vec3, n: Vec3| {
        surface.positions.push(p);
        surface.normals.push(n);
        surface.colours.push(colour);
    };
    push(&mut surface, Vec3::Y * THICK, Vec3::Y);
    for j in 0..DISK {
        let (s, c) = libm::sincos(TAU * j as f64 / DISK as f64);
        let out = Vec3::new(c as f32, 0.0, s as f32);
        push(&mut surface, out + Vec3::Y * THICK, Vec3::Y);
        push(&mut surface, out - Vec3::Y * THICK, out);
    }
    for j in 0..DISK {
        let top = |j: usize| first + 1 + 2 * (j % DISK) as u32;
        surface.triangles.push([first, top(j + 1), top(j)]);
        surface.triangles.push([top(j), top(j + 1), top(j + 1) + 1]);
        surface.triangles.push([top(j), top(j + 1) + 1, top(j) + 1]);
    }
    surface
}
