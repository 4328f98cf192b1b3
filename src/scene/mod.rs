//! Software rendering of a scene: instances of triangle surfaces, seen by a camera.
//!
//! Frames have the same bits on every machine. A frame goes through three stages, each in slices. They find which
//! triangle of which body is visible at each pixel, how much of the sky is visible from there, and how the point is
//! lit (Phong's shading, with the light, materials and tone of height fields). Shadow maps depend on bodies and light
//! only, so they are kept while the camera moves. The planes of depth, normals and ids come with the frame. A frame at
//! rest is the mean of several samples, each with the camera and the lamp moved a little.
//!
//! The world is right-handed with y up. For a picture in a plane, the world's x is the picture's x, its z is the
//! picture's y, the picture's side is 1, and its middle is the origin, as in the files of [`crate::export`].

mod backdrop;
mod body;
mod camera;
mod clip;
mod contact;
mod cut;
mod digest;
mod fill;
mod floor;
mod four_lanes;
mod four_pixels;
mod frame;
mod hit;
mod light_source;
mod lighting;
mod lines;
mod mean;
mod occlusion;
mod order;
mod penumbra;
mod raster;
mod reflection;
mod samples;
mod shade;
mod shadow;
mod soft_light;
mod surfel;
mod tile;
mod tile_light;
mod visibility;

pub use backdrop::Backdrop;
pub use body::{Body, Instance, Paint, Place, Scene};
pub use camera::{Camera, LIMITS, View};
pub use cut::{Cut, CutHow};
pub use digest::SceneDigest;
pub use frame::Frame;
pub use light_source::Lamp;
pub use lighting::{Lighting, Sharpness};
pub use order::{Order, WIDEST};
pub use samples::{MOST_SAMPLES, SAMPLES};
pub use soft_light::SoftLight;
pub use surfel::{Detail, Surfel};
