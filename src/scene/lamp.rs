//! The light of a scene: the lamp of a recipe in space, its shadows, and Phong's shading of a place.

use super::met::Met;
use super::shadow::{Shadows, Spot};
use super::{Scene, Surfel};
use crate::light::{Finish, GAP, LAMP, Light, SHINE, SKY, STEEP, ShadeParams, Tone, lamp_from};
use crate::material::Material;
use crate::order::greater;
use glam::Vec3;

/// Texels along a side of the shadow map, and of the one while something moves.
const SIDES: [usize; 2] = [2048, 768];
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

/// What lights a scene, for all frames of it: it is kept while the camera moves.
pub struct Lighting {
    lamp: Lamp,
    params: ShadeParams,
    finishes: Vec<Finish>,
    tone: Tone,
    shadows: Shadows,
    is_ready: bool,
}

impl Lighting {
    /// The light of a scene whose surfaces are of these materials. Coarse, its shadows are softer, and of coarser bodies.
    pub fn new(
        scene: &Scene,
        lamp: Lamp,
        (params, materials): (&ShadeParams, &[Material]),
        is_coarse: bool,
    ) -> Self {
        let finish = |material| Finish::new(material, params);
        let side = SIDES[usize::from(is_coarse)];
        let side = match lamp {
            Lamp::Sun(_) => side,
            Lamp::Bulb { .. } => side / LAMP_SIDE,
        };
        Self {
            lamp,
            params: *params,
            finishes: materials.iter().map(finish).collect(),
            tone: Tone::new(),
            shadows: Shadows::new(scene, lamp, side, is_coarse),
            is_ready: params.shadow <= 0.0,
        }
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

    pub(super) fn tone(&self) -> &Tone {
        &self.tone
    }

    /// Where to look up how much of the lamp is seen from a place, as its triangles have it; none where they face
    /// away.
    #[inline(always)]
    pub(super) fn spot(&self, position: Vec3, met: &Met) -> Option<Spot> {
        let (to, _) = self.lamp.from(position);
        // Triangles that do not face the lamp may be part of a round surface that does.
        let is_flat = met.flat.dot(to) > TURNED;
        let normal = if is_flat { met.flat } else { met.normal };
        let faces = normal.dot(to) > 0.0;
        faces.then(|| self.spot_of(position, normal, met.spread))
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

    /// The light that a place gives off towards the eye, linear. `seen` is what [`Lighting::seen`] gave, `to_eye` the
    /// unit vector to the eye, `open` the part of the sky that is seen from there.
    pub(super) fn light(&self, surfel: &Surfel, seen: f32, to_eye: Vec3, open: f32) -> [f32; 3] {
        let normal = surfel.normal;
        let (to, strength) = self.lamp.from(surfel.position);
        let facing = greater(normal.dot(to), 0.0);
        let open = 1.0 - self.params.occlusion as f32 * (1.0 - open);
        let seen = if facing > 0.0 { seen } else { 1.0 };
        let seen = 1.0 - self.params.shadow as f32 * (1.0 - seen);
        let arrives = seen * strength * (1.0 - GAP * (1.0 - open));
        let upright = normal.y;
        let from_sky = match upright > 0.0 {
            true => STEEP + (1.0 - STEEP) * upright,
            false => STEEP * (1.0 + (1.0 - BELOW) * upright),
        };
        // Where the lamp is behind the surface there is no light to be mirrored.
        let mirrored = match facing > 0.0 {
            true => (2.0 * facing * normal.dot(to_eye) - to.dot(to_eye)).clamp(0.0, 1.0),
            false => 0.0,
        };
        let last = self.finishes.len().saturating_sub(1);
        let Some(finish) = self.finishes.get(usize::from(surfel.material).min(last)) else {
            return [0.0; 3];
        };
        let ambient = finish.ambient * open * from_sky;
        let diffuse = finish.diffuse * facing * arrives;
        let shine = finish.shine[(mirrored * SHINE as f32) as usize] * arrives;
        std::array::from_fn(|k| {
            let albedo = self.linear(surfel.colour[k]);
            albedo * (ambient * SKY[k] + diffuse * LAMP[k]) + shine * LAMP[k]
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
