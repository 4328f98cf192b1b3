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
use crate::surface_stones::Fit;
use crate::surface_views::BareSurface;
use std::rc::Rc;

/// The reach of ambient occlusion, in mean diagonals of the types.
const REACH: f64 = 0.35;
/// The colour of ground, ...
const SOIL: [u8; 3] = [112, 96, 76];
/// ... and of another shape that is seen.
const BARE: [u8; 3] = [150, 143, 132];
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
    /// The number of bodies of the scene before those of the types.
    base: u32,
    owns: Vec<Option<Own>>,
    noise: Rc<PileNoise>,
    water: Option<f32>,
    /// How many bodies' turns have come.
    shown: usize,
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
        let fit = site.fit();
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
        }
    }

    /// Adds the bodies that have settled since the last call. `history` has the numbers of all bodies whose turn has
    /// come, in that order.
    pub(super) fn update(&mut self, parts: HeapParts, bodies: &[Piled], history: &[u32]) {
        self.owns.resize(bodies.len(), None);
        for &number in &history[self.shown.min(history.len())..] {
            let body = &bodies[number as usize];
            if body.fate == Fate::Kept {
                self.add(parts, body);
            }
        }
        self.shown = history.len();
        let kinds = 0..parts.kinds.len();
        self.scene.detail = Some(Box::new(PileDetail {
            noise: self.noise.clone(),
            owns: Rc::new(self.owns.clone()),
            textures: parts.dress.finishes.iter().map(|f| f.texture).collect(),
            water: self.water,
            wet_rows: kinds.map(|kind| row(kind, false, true)).collect(),
        }));
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
        self.scene.instances.push(Instance {
            body: self.base + parts.dressed.first[kind] + body.shape,
            place,
            id: body.dart + 1,
            paint: Some(Paint {
                tint: finish.tint(seed, u64::from(body.dart), parts.look.vary),
                material: row(kind, false, false),
            }),
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
    scene.instances.push(Instance {
        body: scene.bodies.len() as u32,
        place: Place::default(),
        id: if is_wood { BOX_ID } else { 0 },
        paint: None,
    });
    let row = if is_wood { WOOD_ROW } else { CHINA_ROW };
    scene.bodies.push(Body::new(vec![surface], row));
}
