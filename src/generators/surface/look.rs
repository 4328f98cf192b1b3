//! Pictures of views, from where all of the model is seen.

use super::views::View;
use super::{SURFACE, Surface};
use crate::generators::{Clock, Engine, TurnOrder};

/// A view's picture.
#[derive(Default)]
pub(super) struct Looked {
    words: String,
    pixels: Vec<u8>,
}

impl Surface {
    /// The picture of a view; what was there before while it is not drawn yet.
    pub(super) fn look_at(&mut self, words: &str) -> &[u8] {
        let bytes = 4 * self.side() * self.side();
        if matches!(View::of_words(words), View::Auto | View::Picture) && self.at().is_none() {
            self.looked.pixels.clear();
            self.looked.pixels.extend_from_slice(self.made.picture());
        } else {
            while !self.draw_beforehand(words, &mut || 0.0, f64::INFINITY) {}
        }
        if self.looked.pixels.len() != bytes {
            self.looked.pixels = vec![255; bytes];
        }
        &self.looked.pixels
    }

    /// Draws some of a view; true when [`Surface::look_at`] has nothing to do that takes long.
    pub(super) fn draw_beforehand(&mut self, words: &str, clock: Clock, budget: f64) -> bool {
        if matches!(View::of_words(words), View::Auto | View::Picture) && self.at().is_none() {
            return true;
        }
        let order = TurnOrder {
            subject: String::new(),
            camera: SURFACE.camera(),
            size: [self.side(); 2],
            how: format!("{words}+floor"),
        };
        match self.turn_slice(&order, clock, budget) {
            Ok(slice) if !slice.done => false,
            Ok(_) => {
                let frame = self.shown.frame();
                let pixels = frame.map(|frame| frame.rgba().to_vec());
                self.looked.pixels = pixels.unwrap_or_default();
                self.looked.words = words.to_owned();
                true
            }
            Err(_) => true,
        }
    }
}
