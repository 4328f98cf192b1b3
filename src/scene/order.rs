//! The order for one frame.

use super::{Backdrop, Camera, Cut};

/// The frame to be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// The camera.
    pub camera: Camera,
    /// Width and height in pixels, 1 to 8192.
    pub size: [usize; 2],
    /// Whether each pixel is the mean of two by two samples instead of one.
    pub is_fine: bool,
    /// Whether something moves: bodies are then one level coarser, without occlusion.
    pub is_moving: bool,
    /// The background.
    pub backdrop: Backdrop,
    /// The plane that cuts away bodies, if any. The light must be cut by the same one ([`super::Lighting::cut_by`]).
    pub cut: Option<Cut>,
}
