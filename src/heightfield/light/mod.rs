//! From data planes to a picture: Phong's shading (Miyata, Itoh, Shimada 2000, section 3.3) with a
//! parallel or a point light, height-field shadows and ambient occlusion.

mod parallel;
mod penumbra;
mod point;
mod scan_order;
mod shader;
mod shadow;
mod tone;

pub use shader::Shader;
pub(crate) use tone::decoded;

/// The lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// Light from far away.
    Parallel {
        /// Where the light comes from: radians from +x towards +y, so clockwise on screen.
        azimuth: f64,
        /// Radians above the horizon, 0 exclusive to a right angle.
        elevation: f64,
    },
    /// A lamp at a place, in fractions of the picture's side, z above the ground. There is one lamp only, so a
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

/// How the planes are lit.
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
