//! Bodies in light: instances of triangle surfaces, seen from a camera.
//!
//! All is software, and gives the same bits on every machine. A frame goes through three stages, each in slices:
//! which triangle of which body is seen at each pixel, how much of the sky is seen from there, and how it is lit
//! (Phong's shading, with the light, materials and tone that the height field has). Shadow maps depend on bodies and
//! light only and are kept while the camera moves; the planes of depth, normals and ids come with the frame.
//!
//! The world is right-handed with y up. What lies in a picture's plane has the picture's x, its y as z, and the
//! picture's side is 1 with the middle at the origin, as in the files of [`crate::export`].

mod backdrop;
mod body;
mod camera;
mod clip;
mod cut;
mod digest;
mod fill;
mod four;
mod frame;
mod lamp;
mod lines;
mod met;
mod occlusion;
mod raster;
mod shade;
mod shadow;
mod sight;
mod square;
mod surfel;

pub use backdrop::Backdrop;
pub use body::{Body, Instance, Paint, Place, Scene};
pub use camera::{Camera, LIMITS, View};
pub use cut::{Cut, CutHow};
pub use frame::{Frame, Order};
pub use lamp::{Lamp, Lighting, Sharpness};
pub use surfel::{Detail, Surfel};
