//! Pictures of views, seen by the generator's camera.

use super::picture::{ScenePicture, SceneSource};
use super::still::StillParams;
use crate::generators::{Clock, TurnOrder};

impl<S: SceneSource> ScenePicture<S> {
    /// Works on the picture of a view for about `budget` milliseconds; true if no work is left.
    pub fn prepare(
        &mut self,
        (source, still): (&mut S, &StillParams),
        words: &str,
        clock: Clock,
        budget: f64,
    ) -> bool {
        let order = TurnOrder {
            subject: String::new(),
            camera: still.camera,
            size: [still.side; 2],
            how: format!("{words}+floor"),
        };
        let Ok(slice) = self.turn((source, still), &order, clock, budget) else {
            return true;
        };
        if slice.done {
            let pixels = self.frame().map(|frame| frame.rgba().to_vec());
            self.view = pixels.unwrap_or_default();
        }
        slice.done
    }

    /// The picture of a view. All work on it is done in this call, except if `finished` is the picture. It is white if
    /// there is nothing to show yet.
    pub fn view(
        &mut self,
        (source, still): (&mut S, &StillParams),
        words: &str,
        finished: Option<Vec<u8>>,
    ) -> &[u8] {
        match finished {
            Some(pixels) => self.view = pixels,
            None => while !self.prepare((source, still), words, &mut || 0.0, f64::INFINITY) {},
        }
        let length = 4 * still.side * still.side;
        if self.view.len() != length {
            self.view = vec![255; length];
        }
        &self.view
    }
}

/// The index in `words` of the first known word of `asked`, whose words are joined by '+'.
pub(super) fn first_known(asked: &str, words: &[&str]) -> Option<usize> {
    let place = |word: &str| words.iter().position(|own| *own == word);
    asked.split('+').find_map(place)
}

/// The view of the first known word among words joined by '+'; the first view if there is none. `words` and `views`
/// are in the same order.
pub(crate) fn view_of<const N: usize, V: Copy>(asked: &str, words: [&str; N], views: [V; N]) -> V {
    views[first_known(asked, &words).unwrap_or(0)]
}
