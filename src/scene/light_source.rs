//! The lamp of a scene.

use super::four_lanes::{FourVectors, all};
use crate::light::{FALL_OFF, Light, lamp_from};
use crate::order::{greater, lesser};
use glam::Vec3;
use wide::f32x4;

/// The sine of the least elevation of a sun that is moved on its disc.
const LOWEST: f32 = 0.03;

/// The source of light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lamp {
    /// At infinity: the unit vector to it.
    Sun(Vec3),
    /// At a place.
    Bulb {
        /// Its position.
        at: Vec3,
        /// Height over the ground, greater than 0. The ground lies at `at.y - height`.
        height: f32,
    },
}

impl Lamp {
    /// The lamp of a picture, for a scene in which the picture's side is 1, its centre the origin and its y
    /// the scene's z; `ground` is the height of the ground.
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

    /// The lamp at another place of its disc: `x` and `y` are shares of the radius, and `wide` is the radius over the
    /// distance. A sun stays above the horizon; a bulb stays as high as it is.
    pub(super) fn moved(self, [x, y]: [f64; 2], wide: f64) -> Self {
        let (x, y) = ((x * wide) as f32, (y * wide) as f32);
        match self {
            Lamp::Sun(to) => {
                let across = to.any_orthonormal_vector();
                let mut moved = to + across * x + to.cross(across) * y;
                // The limit is the sun's own height if that is lower.
                moved.y = greater(moved.y, lesser(to.y, LOWEST));
                Lamp::Sun(moved.normalize_or(to))
            }
            Lamp::Bulb { at, height } => Lamp::Bulb {
                at: at + Vec3::new(x * height, 0.0, y * height),
                height,
            },
        }
    }

    /// The unit vector from a point to the lamp, and the lamp's strength there.
    #[inline(always)]
    pub(super) fn from(&self, p: Vec3) -> (Vec3, f32) {
        match *self {
            Lamp::Sun(to) => (to, 1.0),
            Lamp::Bulb { at, height } => {
                let ground = at.y - height;
                let (to, strength) = lamp_from([p.x, p.z, p.y - ground], [at.x, at.z, height]);
                (Vec3::new(to[0], to[2], to[1]), strength)
            }
        }
    }

    /// The same as `from`, for four points.
    #[inline(always)]
    pub(super) fn towards(&self, p: FourVectors) -> (FourVectors, f32x4) {
        match *self {
            Lamp::Sun(to) => (FourVectors::all(to.to_array()), f32x4::ONE),
            Lamp::Bulb { at, height } => {
                let way = FourVectors::all(at.to_array()) - p;
                let square = way.dot(way);
                let loss = square * all(FALL_OFF / (height * height));
                let strength = f32x4::ONE / (all(1.0 - FALL_OFF) + loss).fast_max(all(0.05));
                let away = square.sqrt().fast_max(all(1e-3));
                (way * (f32x4::ONE / away), strength.fast_min(all(2.0)))
            }
        }
    }
}
