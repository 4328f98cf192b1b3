//! The light of a scene: a recipe's lamp in space, its shadows, and Phong's shading of a point.

use super::shadow::{ShadowMaps, ShadowSample};
use super::{Cut, Lamp, Order, Scene};
use crate::light::{Finish, GAP, LAMP, SHINE, SKY, STEEP, ShadeParams, Tone};
use crate::material::Material;
use crate::order::{greater, lesser};
use glam::Vec3;

/// The ratio of the shadow map's side to the side of one of the six maps around a lamp.
const LAMP_SIDE: usize = 2;
/// Share of the sky's light that comes from below by reflection, relative to that on a vertical face.
const BELOW: f32 = 0.45;

/// Cosine below which a triangle's own normal is ignored in favour of its corners' normals.
const TURNED: f32 = 0.05;

/// Resolution of shadows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sharpness {
    /// For moving views: softer, and with coarser bodies.
    Coarse,
    /// For frames whose larger side has at most [`Sharpness::SMALL`] pixels.
    Small,
    /// For frames whose larger side has at most [`Sharpness::LARGE`] pixels.
    Large,
    /// For frames with a larger side.
    Huge,
}

impl Sharpness {
    /// Limit of [`Sharpness::Small`]: a texel is no larger than a pixel if all bodies fill the frame.
    pub const SMALL: usize = 720;
    /// Limit of [`Sharpness::Large`], in the same way.
    pub const LARGE: usize = 2 * Self::SMALL;

    /// The sharpness that a frame needs.
    pub fn of(order: &Order) -> Self {
        match order.size[0].max(order.size[1]) {
            _ if order.is_moving => Self::Coarse,
            ..=Self::SMALL => Self::Small,
            ..=Self::LARGE => Self::Large,
            _ => Self::Huge,
        }
    }

    /// Texels along a side of the shadow map.
    fn texels(self) -> usize {
        match self {
            Self::Coarse => 768,
            Self::Small => 1024,
            Self::Large => 2048,
            Self::Huge => 4096,
        }
    }

    /// Shadow maps that are still to be drawn.
    fn shadows(self, scene: &Scene, lamp: Lamp) -> ShadowMaps {
        let side = match lamp {
            Lamp::Sun(_) => self.texels(),
            Lamp::Bulb { .. } => self.texels() / LAMP_SIDE,
        };
        ShadowMaps::new(scene, lamp, side, self == Self::Coarse)
    }
}

/// The lighting of a scene, kept for all frames while the camera moves.
pub struct Lighting {
    lamp: Lamp,
    params: ShadeParams,
    finishes: Vec<Finish>,
    tone: Tone,
    shadows: ShadowMaps,
    sharpness: Sharpness,
    is_ready: bool,
}

/// The light that arrives at a point.
#[derive(Clone, Copy, Default)]
pub(super) struct Arriving {
    /// From the sky.
    sky: f32,
    /// From the lamp: at normal incidence, and with the cosine of incidence.
    lamp: f32,
    facing: f32,
    /// The cosine between the mirrored light and the direction to the eye, 0..1.
    mirrored: f32,
}

impl Lighting {
    /// The lighting of a scene with these materials.
    pub fn new(
        scene: &Scene,
        lamp: Lamp,
        (params, materials): (&ShadeParams, &[Material]),
        sharpness: Sharpness,
    ) -> Self {
        let finish = |material| Finish::new(material, params);
        Self {
            lamp,
            params: *params,
            finishes: materials.iter().map(finish).collect(),
            tone: Tone::new(),
            shadows: sharpness.shadows(scene, lamp),
            sharpness,
            is_ready: params.shadow <= 0.0,
        }
    }

    /// The same with the lamp at another place.
    pub(super) fn with_lamp(&self, scene: &Scene, lamp: Lamp) -> Self {
        let light = Self {
            lamp,
            params: self.params,
            finishes: self.finishes.clone(),
            tone: self.tone.clone(),
            shadows: self.sharpness.shadows(scene, lamp),
            sharpness: self.sharpness,
            is_ready: self.params.shadow <= 0.0,
        };
        light.cut_by(self.cut())
    }

    /// Its lamp.
    pub(super) fn lamp(&self) -> Lamp {
        self.lamp
    }

    /// The same for a scene that is cut by a plane.
    pub fn cut_by(mut self, cut: Option<Cut>) -> Self {
        self.shadows.cut = cut;
        self
    }

    /// The plane that cuts its scene.
    pub fn cut(&self) -> Option<Cut> {
        self.shadows.cut
    }

    /// The resolution of its shadows.
    pub fn sharpness(&self) -> Sharpness {
        self.sharpness
    }

    /// Draws the shadow maps, for the work of about this many triangles; true when finished.
    pub fn advance(&mut self, scene: &Scene, amount: usize) -> bool {
        if !self.is_ready {
            self.is_ready = self.shadows.advance(scene, amount);
        }
        self.is_ready
    }

    /// The visible share of the lamp at a point, 0..1; `normal` is that of the triangle.
    pub fn visible(&self, point: Vec3, normal: Vec3) -> f32 {
        let (to, _) = self.lamp.from(point);
        match normal.dot(to) > 0.0 {
            true => self.seen(&self.spot_of(point, normal, 0.0)),
            false if self.params.shadow <= 0.0 => 1.0,
            false => 0.0,
        }
    }

    /// The shadow map position for a point; `None` if it faces away from the lamp. `flat` is the normal of
    /// its triangle, and `slack` how far the body's own surface may lie off the point, in the world.
    #[inline(always)]
    pub(super) fn spot(
        &self,
        position: Vec3,
        [normal, flat]: [Vec3; 2],
        slack: f32,
    ) -> Option<ShadowSample> {
        let (to, _) = self.lamp.from(position);
        // A triangle turned away from the lamp may be part of a round surface that faces it.
        let is_flat = flat.dot(to) > TURNED;
        let normal = if is_flat { flat } else { normal };
        let faces = normal.dot(to) > 0.0;
        faces.then(|| self.spot_of(position, normal, slack))
    }

    /// The same for a surface that faces the lamp, with a tolerance.
    #[inline(always)]
    fn spot_of(&self, point: Vec3, normal: Vec3, slack: f32) -> ShadowSample {
        match self.params.shadow <= 0.0 {
            true => ShadowSample::BESIDE,
            false => self.shadows.spot(point, normal, slack),
        }
    }

    /// The visible share of the lamp there, 0..1.
    #[inline(always)]
    pub(super) fn seen(&self, spot: &ShadowSample) -> f32 {
        self.shadows.visible(spot)
    }

    /// The light that arrives at a point. `seen` is the result of [`Lighting::seen`], `to_eye` the unit
    /// vector to the eye, `open` the visible share of the sky.
    #[inline(always)]
    pub(super) fn arriving(
        &self,
        [position, normal, to_eye]: [Vec3; 3],
        [seen, open]: [f32; 2],
    ) -> Arriving {
        let (to, strength) = self.lamp.from(position);
        let facing = greater(normal.dot(to), 0.0);
        let open = 1.0 - self.params.occlusion as f32 * (1.0 - open);
        let seen = if facing > 0.0 { seen } else { 1.0 };
        let seen = 1.0 - self.params.shadow as f32 * (1.0 - seen);
        let lamp = seen * strength * (1.0 - GAP * (1.0 - open));
        let up = normal.y;
        let above = STEEP + (1.0 - STEEP) * up;
        let below = STEEP * (1.0 + (1.0 - BELOW) * up);
        let mirrored = 2.0 * facing * normal.dot(to_eye) - to.dot(to_eye);
        // With the lamp behind the surface there is no mirrored light.
        let mirrored = if facing > 0.0 { mirrored } else { 0.0 };
        Arriving {
            sky: open * if up > 0.0 { above } else { below },
            lamp,
            facing: facing * lamp,
            mirrored: lesser(greater(mirrored, 0.0), 1.0),
        }
    }

    /// The colour on the screen of a surface with this colour and material.
    #[inline(always)]
    pub(super) fn reflected(
        &self,
        (colour, material): ([f32; 3], u8),
        arriving: &Arriving,
    ) -> [u8; 3] {
        let last = self.finishes.len().saturating_sub(1);
        let Some(finish) = self.finishes.get(usize::from(material).min(last)) else {
            return [0; 3];
        };
        let ambient = finish.ambient * arriving.sky;
        let diffuse = finish.diffuse * arriving.facing;
        // Through i32: a cast to unsigned is slower on x86.
        let shine = finish.shine[(arriving.mirrored * SHINE as f32) as i32 as usize];
        let shine = shine * arriving.lamp;
        std::array::from_fn(|k| {
            let albedo = self.linear(colour[k]);
            let light = albedo * (ambient * SKY[k] + diffuse * LAMP[k]) + shine * LAMP[k];
            self.tone.screen(light)
        })
    }

    /// Linear light of a screen value between two whole ones.
    #[inline(always)]
    fn linear(&self, value: f32) -> f32 {
        let low = (value as i32).clamp(0, 254);
        let part = value - low as f32;
        let [a, b] = [low, low + 1].map(|v| self.tone.linear(v as u8));
        a + (b - a) * part
    }
}
