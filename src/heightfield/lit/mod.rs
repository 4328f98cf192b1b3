//! Renders data planes to a picture: Phong's shading (Miyata, Itoh, Shimada 2000, section 3.3) with a
//! parallel or a point light, height-field shadows and ambient occlusion.

mod parallel;
mod penumbra;
mod point;
mod scan_order;
mod shader;
mod shadow;

pub use shader::Shader;
