//! The scene of a pile: bodies in their places, the shape and its container.

use super::detail::{BOX_ID, Own, PileDetail, PileNoise};
use super::dress::Dressed;
use super::materials::{CHINA_ROW, SHAPE_ROW, WOOD_ROW, row};
use super::params::{BodyParams, CoreShown, DressParams};
use super::site::Site;
use crate::order::lesser;
use crate::pile::{Body as Piled, Fate, Kind};
use crate::random::{Purpose, Random};
use crate::scene::{Body, Instance, Paint, Place, Scene};
use crate::solid::Surface;
use crate::surface_stones::Fit;
use crate::surface_views::BareSurface;
use glam::DVec3;
use std::rc::Rc;

/// The reach of ambient occlusion, in mean diagonals of the types.
const REACH: f64 = 0.35;
/// The colour of ground.
const SOIL: [u8; 3] = [112, 96, 76];
/// The colour of a shape that is no ground, if it is seen.
const BARE: [u8; 3] = [150, 143, 132];
/// The tint of bodies that are removed.
const REMOVED: [u8; 3] = [255, 72, 60];
/// Removed bodies are shown if at most this many bodies are new: an eye cannot follow more.
const FOLLOWED: usize = 24;
/// The word of wooden containers, their colour, and how much boards differ.
const WOOD: &str = "wood";
const OAK: [f32; 3] = [186.0, 146.0, 98.0];
const BOARDS: f32 = 0.08;
/// The colour of china.
const CHINA: [u8; 3] = [226, 228, 226];

/// Everything that a pile's scene is made of.
#[derive(Clone, Copy)]
pub(super) struct HeapParts<'a> {
    pub site: &'a Site,
    pub ground: &'a BareSurface,
    pub kinds: &'a [Kind],
    pub dressed: &'a Dressed,
    pub dress: &'a DressParams,
    pub look: &'a BodyParams,
}

/// A scene to which bodies are added as they settle.
pub(crate) struct Heap {
    scene: Scene,
    fit: Fit,
    /// The number of the scene's bodies (meshes) before those of the types.
    base: u32,
    owns: Vec<Option<Own>>,
    noise: Rc<PileNoise>,
    water: Option<f32>,
    /// The number of bodies handled so far.
    shown: usize,
    /// The number of instances at the end of the scene that are bodies just removed.
    blinking: usize,
}

impl Heap {
    /// Starts with the shape and its container.
    pub(super) fn new(parts: HeapParts) -> Self {
        let HeapParts {
            site,
            ground,
            kinds,
            dressed,
            look,
            ..
        } = parts;
        let fit = ground.fit();
        let mean = kinds.iter().map(Kind::diagonal).sum::<f64>() / kinds.len().max(1) as f64;
        let mut scene = Scene {
            reach: (REACH * mean * fit.scale) as f32,
            ..Scene::default()
        };
        let is_seen = match look.core {
            CoreShown::Suits => site.is_ground,
            CoreShown::Seen => true,
            CoreShown::Hidden => false,
        };
        if is_seen {
            let colour = if site.is_ground { SOIL } else { BARE };
            ground.add_to(&mut scene, SHAPE_ROW, 0.0, colour);
            add_skirt(&mut scene, site, fit, colour);
        }
        add_vessel(&mut scene, site, fit, look.seed);
        let base = scene.bodies.len() as u32;
        scene.bodies.extend(dressed.bodies.iter().cloned());
        Self {
            scene,
            fit,
            base,
            owns: Vec::new(),
            noise: Rc::new(PileNoise::new(look.seed)),
            water: water(site, fit, look.wet),
            shown: 0,
            blinking: 0,
        }
    }

    /// Adds the bodies that have settled since the last call. `history` lists all bodies that were handled, in order.
    /// Removed bodies that [`Self::update_seen`] showed disappear.
    pub(super) fn update(&mut self, parts: HeapParts, bodies: &[Piled], history: &[u32]) {
        self.owns.resize(bodies.len(), None);
        let left = self.scene.instances.len() - std::mem::take(&mut self.blinking);
        self.scene.instances.truncate(left);
        for &number in &history[self.shown.min(history.len())..] {
            let body = &bodies[number as usize];
            if body.fate == Fate::Kept {
                self.add(parts, body);
            }
        }
        self.shown = history.len();
        self.scene.detail = Some(Box::new(PileDetail {
            noise: self.noise.clone(),
            owns: Rc::new(self.owns.clone()),
            finishes: parts.dress.finishes.clone(),
            water: self.water,
        }));
    }

    /// Like [`Self::update`]. Until the next call it also shows, at their darts, the bodies that were removed since the
    /// last call. If there are more than [`FOLLOWED`] new bodies, no removed one is shown, because they would only
    /// flicker.
    pub(super) fn update_seen(&mut self, parts: HeapParts, bodies: &[Piled], history: &[u32]) {
        let before = self.shown.min(history.len());
        self.update(parts, bodies, history);
        let new = &history[before..];
        if new.len() > FOLLOWED {
            return;
        }
        for &number in new {
            let body = &bodies[number as usize];
            if body.fate == Fate::Removed {
                let paint = Paint {
                    tint: REMOVED,
                    material: row(body.kind as usize, false, false),
                };
                self.push_body(parts, body, paint);
                self.blinking += 1;
            }
        }
    }

    fn add(&mut self, parts: HeapParts, body: &Piled) {
        let place = place(body, self.fit);
        let (kind, seed) = (body.kind as usize, parts.look.seed);
        let finish = parts.dress.finishes[kind];
        let mut random = Random::new(seed, Purpose::Attribute, u64::from(body.dart));
        let offset = [random.unit(), random.unit()].map(|v| 100.0 * v as f32);
        self.owns[body.dart as usize] = Some(Own {
            place,
            kind: body.kind,
            offset,
        });
        let paint = Paint {
            tint: finish.tint(seed, u64::from(body.dart), parts.look.vary),
            material: row(kind, false, false),
        };
        self.push_body(parts, body, paint);
    }

    fn push_body(&mut self, parts: HeapParts, body: &Piled, paint: Paint) {
        self.scene.instances.push(Instance {
            body: self.base + parts.dressed.first[body.kind as usize] + body.shape,
            place: place(body, self.fit),
            id: body.dart + 1,
            paint: Some(paint),
        });
    }

    /// The scene so far.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The scene, to keep.
    pub fn finish(self) -> Scene {
        self.scene
    }
}

/// The placement of a body in the scene.
pub(super) fn place(body: &Piled, fit: Fit) -> Place {
    let scale = body.scale * fit.scale;
    let axes = [body.turn.x_axis, body.turn.y_axis, body.turn.z_axis];
    Place {
        axes: axes.map(|axis| (axis * scale).as_vec3()),
        origin: fit.place(body.place()),
    }
}

/// The height in the scene up to which the pile is wet.
fn water(site: &Site, fit: Fit, wet: f32) -> Option<f32> {
    let (low, high) = site.mesh.bounds();
    let [low, high] = [low, high].map(|p| fit.place(p).y);
    (wet > 0.0).then_some(low + wet * (high - low))
}

/// Adds walls from the borders of ground down to a floor, so that it stands.
fn add_skirt(scene: &mut Scene, site: &Site, fit: Fit, colour: [u8; 3]) {
    if !site.is_ground {
        return;
    }
    let mesh = &site.mesh;
    let floor = site.floor();
    let mut surface = Surface::default();
    for ring in mesh.borders() {
        for (k, &v) in ring.iter().enumerate() {
            let next = ring[(k + 1) % ring.len()];
            // The surface lies on the left of its border.
            let [a, b] = [v, next].map(|v| mesh.positions()[v as usize]);
            let along = b - a;
            let out = DVec3::new(-along.z, 0.0, along.x)
                .normalize_or_zero()
                .as_vec3();
            let first = surface.positions.len() as u32;
            for p in [a, b] {
                let below = DVec3::new(p.x, floor, p.z);
                surface.positions.extend([p, below].map(|p| fit.place(p)));
            }
            surface.normals.extend([out; 4]);
            surface.colours.extend([colour; 4]);
            let corners = [[0, 1, 2], [2, 1, 3]];
            let corners = corners.map(|t| t.map(|k| first + k));
            surface.triangles.extend(corners);
        }
    }
    push(scene, surface, SHAPE_ROW, 0);
}

/// Adds a surface in the scene's own coordinates.
fn push(scene: &mut Scene, surface: Surface, row: u8, id: u32) {
    scene.instances.push(Instance {
        body: scene.bodies.len() as u32,
        place: Place::default(),
        id,
        paint: None,
    });
    scene.bodies.push(Body::new(vec![surface], row));
}

/// Adds the container; its boards differ in tone.
fn add_vessel(scene: &mut Scene, site: &Site, fit: Fit, seed: u64) {
    let Some(vessel) = &site.vessel else {
        return;
    };
    let is_wood = vessel.material == WOOD;
    let mut surface = match is_wood {
        true => vessel.clone().coloured(|board, _| {
            let mut random = Random::new(seed, Purpose::Ground, u64::from(board));
            let tone = 1.0 + BOARDS * random.signed() as f32;
            OAK.map(|v| lesser(v * tone, 255.0) as u8)
        }),
        false => vessel.clone().coloured(|_, _| CHINA),
    }
    .surface;
    for p in &mut surface.positions {
        *p = fit.place(p.as_dvec3());
    }
    let (row, id) = match is_wood {
        true => (WOOD_ROW, BOX_ID),
        false => (CHINA_ROW, 0),
    };
    push(scene, surface, row, id);
}
