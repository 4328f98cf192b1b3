//! Pictures of views, seen by the generator's camera.

use super::picture::{SceneSource, turn};
use crate::generators::{Clock, TurnOrder};

/// The picture of a view; white until the first one is finished.
pub(crate) fn view<'a, S: SceneSource>(source: &'a mut S, words: &str) -> &'a [u8] {
    let side = source.still().side;
    match source.finished(words).map(<[u8]>::to_vec) {
        Some(pixels) => source.scene_picture().view = pixels,
        None => while !prepare(source, words, &mut || 0.0, f64::INFINITY) {},
    }
    let pixels = &mut source.scene_picture().view;
    if pixels.len() != 4 * side * side {
        *pixels = vec![255; 4 * side * side];
    }
    pixels
}

/// Works on the picture of a view for about `budget` milliseconds; true if [`view`] has no long work left.
pub(crate) fn prepare<S: SceneSource>(
    source: &mut S,
    words: &str,
    clock: Clock,
    budget: f64,
) -> bool {
    if source.finished(words).is_some() {
        return true;
    }
    let still = source.still();
    let order = TurnOrder {
        subject: String::new(),
        camera: still.camera,
        size: [still.side; 2],
        how: format!("{words}+floor"),
    };
    let Ok(slice) = turn(source, &order, clock, budget) else {
        return true;
    };
    if slice.done {
        let picture = source.scene_picture();
        let pixels = picture.frame().map(|frame| frame.rgba().to_vec());
        picture.view = pixels.unwrap_or_default();
    }
    slice.done
}

/// The view of the first known word among words joined by '+'; the first view if there is none. `words` and `views`
/// are in the same order.
pub(crate) fn view_of<const N: usize, V: Copy>(asked: &str, words: [&str; N], views: [V; N]) -> V {
    let place = |word: &str| words.iter().position(|own| *own == word);
    asked
        .split('+')
        .find_map(place)
        .map_or(views[0], |at| views[at])
}
