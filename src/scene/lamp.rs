//! The light of a scene: the lamp of a recipe in space, its shadows, and Phong's shading of a place.

use super::shadow::{Shadows, Spot};
use super::{Order, Scene};
use crate::light::{Finish, GAP, LAMP, Light, SHINE, SKY, STEEP, ShadeParams, Tone, lamp_from};
use crate::material::Material;
use crate::order::{greater, lesser};
use glam::Vec3;

/// The sides of the cube around a lamp have so many parts of that.
const LAMP_SIDE: usize = 2;
/// The sky's light from below, mirrored by what lies there, of that on a vertical face.
const BELOW: f32 = 0.45;

/// Cosine below which a triangle is taken for a part of what its corners' normals say.
const TURNED: f32 = 0.05;

/// Where light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lamp {
    /// From far away: the unit vector to it.
    Sun(Vec3),
    /// From a place.
    Bulb {
        /// Where it is.
        at: Vec3,
        /// How high it is over the ground at `at.y - height`, greater than 0.
        height: f32,
    },
}

impl Lamp {
    /// The lamp of a picture, for a scene in which the picture's side is 1, its middle the origin, its y the
    /// scene's z, and `ground` the height of the ground.
    pub fn over_picture(light: Light, ground: f32) -> Self {
        match light {
            Light::Parallel { azimuth, elevation } => {
                let flat = libm::cos(elevation);
                let (x, z) = (libm::cos(azimuth) * flat, libm::sin(azimuth) * flat);
                let to = glam::DVec3::new(x, libm::sin(elevation), z);
                Self::Sun(to.normalize_or(glam::DVec3::Y).as_vec3())
            }
            Light::Point { x, y, z } => {
                let height = greater(z as f32, 1e-3);
                Self::Bulb {
                    at: Vec3::new(x as f32 - 0.5, ground + height, y as f32 - 0.5),
                    height,
                }
            }
        }
    }

    /// The unit vector from a point to it, and its strength there.
    #[inline(always)]
    fn from(&self, p: Vec3) -> (Vec3, f32) {
        match *self {
            Lamp::Sun(to) => (to, 1.0),
            Lamp::Bulb { at, height } => {
                let ground = at.y - height;
                let (to, strength) = lamp_from([p.x, p.z, p.y - ground], [at.x, at.z, height]);
                (Vec3::new(to[0], to[2], to[1]), strength)
            }
        }
    }
}

/// How finely shadows are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sharpness {
    /// While something moves: softer, and of coarser bodies.
    Coarse,
    /// For frames whose larger side has at most [`Sharpness::SMALL`] pixels.
    Small,
    /// For larger ones.
    Large,
}

impl Sharpness {
    /// What [`Sharpness::Small`] is for: a texel is no larger than a pixel where all bodies fill the frame.
    pub const SMALL: usize = 720;

    /// What a frame needs.
    pub fn of(order: &Order) -> Self {
        match order.size[0].max(order.size[1]) {
            _ if order.is_moving => Self::Coarse,
            0..=Self::SMALL => Self::Small,
            _ => Self::Large,
        }
    }

    /// Texels along a side of the shadow map.
    fn texels(self) -> usize {
        match self {
            Self::Coarse => 768,
            Self::Small => 1024,
            Self::Large => 2048,
        }
    }
}

/// What lights a scene, for all frames of it: it is kept while the camera moves.
pub struct Lighting {
    lamp: Lamp,
    params: ShadeParams,
    finishes: Vec<Finish>,
    tone: Tone,
    shadows: Shadows,
    sharpness: Sharpness,
    is_ready: bool,
}

/// Light that arrives at a place.
#[derive(Clone, Copy, Default)]
pub(super) struct Arriving {
    /// Of the sky.
    sky: f32,
    /// Of the lamp, straight on, and as the surface is turned to it.
    lamp: f32,
    facing: f32,
    /// The cosine between mirrored light and the way to the eye, 0..1.
    mirrored: f32,
}

impl Lighting {
    /// The light of a scene whose surfaces are of these materials.
    pub fn new(
        scene: &Scene,
        lamp: Lamp,
        (params, materials): (&ShadeParams, &[Material]),
        sharpness: Sharpness,
    ) -> Self {
        let finish = |material| Finish::new(material, params);
        let is_coarse = sharpness == Sharpness::Coarse;
        let side = match lamp {
            Lamp::Sun(_) => sharpness.texels(),
            Lamp::Bulb { .. } => sharpness.texels() / LAMP_SIDE,
        };
        Self {
            lamp,
            params: *params,
            finishes: materials.iter().map(finish).collect(),
            tone: Tone::new(),
            shadows: Shadows::new(scene, lamp, side, is_coarse),
            sharpness,
            is_ready: params.shadow <= 0.0,
        }
    }

    /// How finely its shadows are drawn.
    pub fn sharpness(&self) -> Sharpness {
        self.sharpness
    }

    /// Goes on with the shadows, for about the work of so many triangles; true when they are there.
    pub fn advance(&mut self, scene: &Scene, amount: usize) -> bool {
        if !self.is_ready {
            self.is_ready = self.shadows.advance(scene, amount);
        }
        self.is_ready
    }

    /// How much of the lamp is seen from a place, 0..1, `normal` being that of the surface's triangles.
    pub fn visible(&self, point: Vec3, normal: Vec3) -> f32 {
        let (to, _) = self.lamp.from(point);
        match normal.dot(to) > 0.0 {
            true => self.seen(&self.spot_of(point, normal, 0.0)),
            false if self.params.shadow <= 0.0 => 1.0,
            false => 0.0,
        }
    }

    /// Where to look up how much of the lamp is seen from a place; none where it faces away. `flat` is the normal of its
    /// triangle, and `spread` how far off it may be.
    #[inline(always)]
    pub(super) fn spot(
        &self,
        position: Vec3,
        [normal, flat]: [Vec3; 2],
        spread: f32,
    ) -> Option<Spot> {
        let (to, _) = self.lamp.from(position);
        // Triangles that do not face the lamp may be part of a round surface that does.
        let is_flat = flat.dot(to) > TURNED;
        let normal = if is_flat { flat } else { normal };
        let faces = normal.dot(to) > 0.0;
        faces.then(|| self.spot_of(position, normal, spread))
    }

    /// The same of a surface that faces the lamp and may be off by so much.
    #[inline(always)]
    fn spot_of(&self, point: Vec3, normal: Vec3, spread: f32) -> Spot {
        match self.params.shadow <= 0.0 {
            true => Spot::BESIDE,
            false => self.shadows.spot(point, normal, spread),
        }
    }

    /// How much of the lamp is seen there, 0..1.
    #[inline(always)]
    pub(super) fn seen(&self, spot: &Spot) -> f32 {
        self.shadows.visible(spot)
    }

    /// What light arrives at a place. `seen` is what [`Lighting::seen`] gave, `to_eye` the unit vector to the eye, `open`
    /// the part of the sky that is seen from there.
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
        // Where the lamp is behind the surface there is no light to be mirrored.
        let mirrored = if facing > 0.0 { mirrored } else { 0.0 };
        Arriving {
            sky: open * if up > 0.0 { above } else { below },
            lamp,
            facing: facing * lamp,
            mirrored: lesser(greater(mirrored, 0.0), 1.0),
        }
    }

    /// The colour on the screen of a surface of this colour and material.
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
        // Through i32: the cast to unsigned takes a detour on x86.
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
