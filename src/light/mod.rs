//! Light, independent of the surface it falls on: the lamp and the sky, the response of a material (Phong
//! 1975, Illumination for Computer Generated Pictures; Miyata, Itoh, Shimada 2000, section 3.3), and tone
//! mapping from linear light to values of the screen.

mod finish;
mod tone;

#[cfg(house)]
pub(crate) use finish::SMOOTH;
pub(crate) use finish::{Finish, SHINE};
pub(crate) use tone::{Tone, decoded};

use crate::order::greater;

/// Colour of the lamp, linear.
pub(crate) const LAMP: [f32; 3] = [1.44, 1.38, 1.28];
/// Colour of the sky, linear.
pub(crate) const SKY: [f32; 3] = [0.33, 0.35, 0.38];
/// Share of the sky's light that reaches a vertical face.
pub(crate) const STEEP: f32 = 0.72;
/// Share of the lamp's light lost where the sky is hidden: little is reflected there.
pub(crate) const GAP: f32 = 0.35;
/// The point lamp's light is 1 at its foot. This share of the light's inverse grows with the square of the distance;
/// the rest of it is constant.
pub(crate) const FALL_OFF: f32 = 0.55;

/// The lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// A light at infinity.
    Parallel {
        /// The direction the light comes from: radians from +x towards +y, so clockwise on screen.
        azimuth: f64,
        /// Radians above the horizon, from 0 (exclusive) to a right angle.
        elevation: f64,
    },
    /// A lamp at a place, in fractions of the picture's side, z above the ground. It is a single lamp, so a
    /// tile does not repeat.
    Point {
        /// From the left edge, any number.
        x: f64,
        /// From the top edge, any number.
        y: f64,
        /// Height, greater than 0.
        z: f64,
    },
}

/// Parameters of the lighting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadeParams {
    /// The lamp.
    pub light: Light,
    /// Factor of the ambient attribute A, 0..2.
    pub ambient: f64,
    /// Factor of the diffuse attribute D, 0..2.
    pub diffuse: f64,
    /// Factor of the specular attribute S, 0..2.
    pub specular: f64,
    /// Factor of the exponent N, 0.25..4.
    pub shininess: f64,
    /// Strength of shadows, 0..1.
    pub shadow: f64,
    /// Strength of ambient occlusion, 0..1.
    pub occlusion: f64,
}

impl Light {
    /// The default azimuth of parallel light, in degrees: from the upper left.
    pub const AZIMUTH: f64 = 225.0;
    /// The default elevation of parallel light, in degrees above the horizon.
    pub const ELEVATION: f64 = 42.0;
}

impl ShadeParams {
    /// Parallel light, and factors of 1 for materials.
    pub const DEFAULT: Self = Self {
        light: Light::Parallel {
            azimuth: Light::AZIMUTH.to_radians(),
            elevation: Light::ELEVATION.to_radians(),
        },
        ambient: 1.0,
        diffuse: 1.0,
        specular: 1.0,
        shininess: 1.0,
        shadow: 1.0,
        occlusion: 1.0,
    };
}

impl Default for ShadeParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The unit vector from a point to a lamp, and the lamp's strength there; the third coordinate is the height.
#[inline(always)]
pub(crate) fn lamp_from(p: [f32; 3], lamp: [f32; 3]) -> ([f32; 3], f32) {
    let d = [lamp[0] - p[0], lamp[1] - p[1], lamp[2] - p[2]];
    let square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    let inverse = 1.0 / greater(square.sqrt(), 1e-3);
    let loss = square / (lamp[2] * lamp[2]);
    let strength = 1.0 / greater(1.0 - FALL_OFF + FALL_OFF * loss, 0.05);
    let strength = if strength > 2.0 { 2.0 } else { strength };
    (d.map(|v| v * inverse), strength)
}
