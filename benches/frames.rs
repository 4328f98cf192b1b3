//! Frames of a generator's bodies, as the page asks for them.

use super::{Clock, Timing, shortest};
use bubblestone::generators::TurnOrder;
use bubblestone::scene::Camera;
use bubblestone::studio::Studio;

/// Milliseconds of a slice of a frame, about as on the page.
const SLICE: f64 = 10.0;

/// Works until all bodies are in the scene, without the picture.
pub fn place(studio: &mut Studio, clock: Clock) {
    while !["light", "done", "error"].contains(&studio.stage()) {
        studio.tick(clock, 0.0, u32::MAX);
    }
}

/// Times a frame, seen from the generator's first camera turned by some degrees. `how` is that of [`TurnOrder`].
pub fn frame(studio: &mut Studio, turn: f64, side: usize, how: &str, clock: Clock) -> f64 {
    let camera = studio.generator().camera();
    let order = TurnOrder {
        subject: String::new(),
        camera: Camera {
            angle: camera.angle + turn,
            ..camera
        },
        size: [side; 2],
        how: how.to_owned(),
    };
    let start = clock();
    while let Ok(frames) = studio.frames() {
        match frames.turn(&order, clock, SLICE) {
            Ok(slice) if !slice.done => {}
            Ok(_) => break,
            Err(_) => return f64::NAN,
        }
    }
    clock() - start
}

/// Times frames while the bodies turn, and at rest with new shadows. `with` gives the studio another value of one
/// parameter.
pub fn timings(
    name: &str,
    mut studio: Studio,
    with: impl Fn(&mut Studio, &str),
    clock: Clock,
) -> Vec<Timing> {
    place(&mut studio, clock);
    // The first frames make the scene and its light.
    let turning: Vec<f64> = (0..18)
        .map(|k| frame(&mut studio, f64::from(k), 256, "moving", clock))
        .collect();
    let still: Vec<f64> = (0..6)
        .map(|k| {
            with(&mut studio, &format!("&az={}", 40 * k));
            frame(&mut studio, 0.0, 512, "still", clock)
        })
        .collect();
    vec![
        Timing {
            name: format!("{name} of 256 x 256, turning"),
            ms: shortest(turning[3..].iter().copied()),
        },
        Timing {
            name: format!("{name} of 512 x 512, still with its shadows"),
            ms: shortest(still[1..].iter().copied()),
        },
    ]
}
