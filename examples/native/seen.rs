//! Pictures of the views that links and presets describe.

use super::{make, opaque, write_rgb};
use bubblestone::generators::{TurnOrder, Viewing};
use bubblestone::scene::{Camera, SAMPLES};
use bubblestone::studio::Studio;
use std::path::Path;

/// The page's camera for one body.
const BODY: &str = "80,30,4.2,35";

/// Writes a view as seen.png. Returns its pixels, opaque RGBA.
pub fn write_seen(
    studio: &mut Studio,
    viewing: &Viewing,
    clock: &mut dyn FnMut() -> f64,
    dir: &Path,
) -> Result<Vec<u8>, String> {
    let pixels = seen(studio, viewing, clock)?;
    make(dir)?;
    write_rgb(dir, "seen.png", studio.side(), opaque(&pixels))?;
    Ok(pixels)
}

/// The pixels of a view. If it stops at a step, the work is done again up to there, and stays unfinished.
pub fn seen(
    studio: &mut Studio,
    viewing: &Viewing,
    clock: &mut dyn FnMut() -> f64,
) -> Result<Vec<u8>, String> {
    if let Some(step) = viewing.step {
        studio.restart();
        studio.tick(clock, f64::INFINITY, 0);
        while studio.at_work().is_some() && studio.progress().steps < step {
            studio.tick(clock, f64::INFINITY, 1);
        }
    }
    let (generator, side) = (studio.generator(), studio.side());
    if viewing.camera.is_none() && viewing.body.is_empty() && !generator.offers.contains(&"frames")
    {
        return Ok(studio.engine_mut().view(&viewing.view).to_vec());
    }
    let Viewing {
        view, cut, body, ..
    } = viewing;
    let order = TurnOrder {
        subject: body.clone(),
        camera: match body.as_str() {
            "" => viewing.camera.unwrap_or_else(|| generator.camera()),
            _ => Camera::default().read(BODY).0,
        },
        size: [side, side],
        how: format!("{view}+samples={SAMPLES}+{cut}"),
    };
    let frames = studio.frames()?;
    while !frames.turn(&order, clock, f64::INFINITY)?.done {}
    let frame = frames.frame().ok_or("There is nothing to see.")?;
    Ok(frame.rgba().to_vec())
}
