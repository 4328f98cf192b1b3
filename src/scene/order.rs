//! The order for one frame.

use super::{Backdrop, Camera, Cut};

/// The greatest [`Order::aperture`].
pub const WIDEST: f64 = 0.5;

/// The frame to be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// The camera.
    pub camera: Camera,
    /// Width and height in pixels, 1 to 8192.
    pub size: [usize; 2],
    /// The number of samples of which the frame is the mean, 1 to [`super::MOST_SAMPLES`].
    pub samples: usize,
    /// The diameter of the lens, as a share of the distance in focus, 0 to [`WIDEST`]: what is nearer or farther is blurred.
    /// At 0 all is sharp. The visible surface in the middle of the frame is in focus, or else the camera's target.
    pub aperture: f64,
    /// Whether something moves: bodies are then one level coarser, without occlusion.
    pub is_moving: bool,
    /// The background.
    pub backdrop: Backdrop,
    /// The plane that cuts away bodies, if any. The light must be cut by the same one ([`super::Lighting::cut_by`]).
    pub cut: Option<Cut>,
}
