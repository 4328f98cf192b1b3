//! Frames of the bodies by a camera.

use super::{opaque, write_png, write_rgb};
use bubblestone::export::{FramePlane, frame_map};
use bubblestone::generators::TurnOrder;
use bubblestone::scene::Camera;
use bubblestone::studio::Studio;
use std::path::Path;

/// Writes the view of a camera as slant.png, the mean of `samples` samples through a lens of this `aperture`, and its
/// planes as slant-depth.png, slant-normal.png and slant-id.png. Returns the hash of the still.
pub fn write_slant(
    studio: &mut Studio,
    camera: Camera,
    (samples, aperture): (usize, f64),
    clock: &mut dyn FnMut() -> f64,
    dir: &Path,
) -> Result<String, String> {
    let side = studio.side();
    let mut order = TurnOrder {
        subject: String::new(),
        camera,
        size: [side, side],
        how: "still".into(),
    };
    let frame = studio.finish_frame(&order, clock)?;
    let hash = frame.hash();
    for (plane, word) in FramePlane::ALL {
        write_png(dir, &format!("slant-{word}.png"), &frame_map(frame, plane))?;
    }
    order.how = format!("samples={samples}+aperture={aperture}");
    let frame = studio.finish_frame(&order, clock)?;
    write_rgb(dir, "slant.png", side, opaque(frame.rgba()))?;
    Ok(hash)
}
