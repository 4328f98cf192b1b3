//! The mean of a frame's samples, in linear light.

use crate::light::decoded;
use std::ops::Range;

/// Entries of the table from linear light to values of the screen.
const STEPS: usize = 1 << 14;

/// The mean of the samples so far at each pixel.
pub(super) struct Mean {
    /// Red, green and blue as shares of 65535, averaged over the samples that cover the pixel, and the number of these.
    pixels: Vec<[u16; 4]>,
    /// The linear light of each value of the screen (sRGB).
    linear: [u16; 256],
    /// The value of the screen (sRGB) for linear light, indexed by the upper bits of the light.
    screen: Vec<u8>,
}

impl Mean {
    pub fn new() -> Self {
        let linear = |v: f64| decoded(v / 255.0);
        let mut screen = Vec::with_capacity(STEPS);
        for v in 0..255u8 {
            let end = linear(f64::from(v) + 0.5) * STEPS as f64;
            screen.resize((end + 0.5) as usize, v);
        }
        screen.resize(STEPS, 255);
        Self {
            pixels: Vec::new(),
            linear: std::array::from_fn(|v| (65535.0 * linear(v as f64) + 0.5) as u16),
            screen,
        }
    }

    /// Starts again, for at most this many pixels.
    pub fn begin(&mut self, pixels: usize) {
        self.pixels.clear();
        self.pixels.reserve_exact(pixels);
    }

    /// Makes room for pixels up to `pixels`. All are needed before [`Mean::add`].
    pub fn make_room(&mut self, pixels: usize) {
        self.pixels.resize(pixels, [0; 4]);
    }

    /// Adds pixels (red, green, blue, alpha) of the next sample after `before` others, and replaces them by the mean.
    pub fn add(&mut self, span: Range<usize>, before: usize, rgba: &mut [u8]) {
        let pixels = rgba.as_chunks_mut::<4>().0.iter_mut();
        for (mean, pixel) in self.pixels[span].iter_mut().zip(pixels) {
            if pixel[3] > 0 {
                mean[3] += 1;
                for k in 0..3 {
                    mean[k] = nearer(mean[k], self.linear[usize::from(pixel[k])], mean[3]);
                }
            }
            for k in 0..3 {
                pixel[k] = self.screen[(usize::from(mean[k]) * STEPS) >> 16];
            }
            pixel[3] = (usize::from(mean[3]) * 255 / (before + 1)) as u8;
        }
    }
}

/// The mean of `count` numbers, from the mean of all but the last one.
#[inline(always)]
fn nearer(mean: u16, last: u16, count: u16) -> u16 {
    let (mean, last, count) = (i32::from(mean), i32::from(last), i32::from(count));
    let off = last - mean;
    let half = if off < 0 { -count / 2 } else { count / 2 };
    (mean + (off + half) / count) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mean_of(samples: &[[u8; 4]]) -> [u8; 4] {
        let mut mean = Mean::new();
        mean.begin(1);
        mean.make_room(1);
        let mut shown = [0; 4];
        for (before, sample) in samples.iter().enumerate() {
            shown = *sample;
            mean.add(0..1, before, &mut shown);
        }
        shown
    }

    #[test]
    fn light_is_averaged_and_not_its_values() {
        for v in 0..=255 {
            assert_eq!(mean_of(&[[v, v, 0, 255]; 7]), [v, v, 0, 255]);
        }
        // Half of the light is 188 of 255, whichever comes first.
        let (black, white) = ([0, 0, 0, 255], [255; 4]);
        assert_eq!(mean_of(&[black, white]), [188, 188, 188, 255]);
        let many: Vec<_> = (0..64).map(|k| [black, white][k % 2]).collect();
        assert_eq!(mean_of(&many), [188, 188, 188, 255]);
    }

    #[test]
    fn only_covered_samples_have_a_colour() {
        let (red, none) = ([200, 10, 10, 255], [9, 9, 9, 0]);
        assert_eq!(mean_of(&[none, red, none, red]), [200, 10, 10, 127]);
        assert_eq!(mean_of(&[none, none])[3], 0);
    }
}
