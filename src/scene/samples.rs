//! The samples of a frame. Each sample is a picture with the camera moved by a part of a pixel, and the lamp moved on a
//! disc. Their mean has smooth edges, and shadows that are sharp where bodies touch and soft far away. The camera may
//! move on a disc, too: then all is blurred that is not in focus (Haeberli, Akeley 1990, The Accumulation Buffer:
//! Hardware Support for High-Quality Rendering).
//!
//! The places come from sequences that fill their squares and discs evenly after any number of samples, so a mean may be
//! shown before it is complete. The first sample is not moved at all. Between the places of the lamp, the floor is lit by
//! [`super::penumbra`].

use std::f64::consts::TAU;

/// The samples of a picture at rest.
pub const SAMPLES: usize = 12;
/// The most samples of a frame.
pub const MOST_SAMPLES: usize = 64;

/// Steps of a sequence in the square (Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences): the first
/// and the second power of the inverse of the plastic number.
const SQUARE: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];
/// The golden section of a turn.
const TURN: f64 = 0.381_966_011_250_105_1;

/// The place of a sample in its pixel, from the middle: -0.5..0.5 to the right and down.
pub(super) fn in_pixel(sample: usize) -> [f32; 2] {
    SQUARE.map(|step| (part_of(0.5 + sample as f64 * step) - 0.5) as f32)
}

/// The place of a sample's lamp on the unit disc.
pub(super) fn on_lamp(sample: usize) -> [f64; 2] {
    on_disc(reversed(sample, 2), sample as f64 * TURN)
}

/// The place of a sample's camera on the unit disc.
pub(super) fn on_lens(sample: usize) -> [f32; 2] {
    on_disc(reversed(sample, 3), reversed(sample, 5)).map(|v| v as f32)
}

/// A place on the unit disc: the share of the disc's area within its distance, and the direction in turns.
fn on_disc(within: f64, turns: f64) -> [f64; 2] {
    let (angle, away) = (TAU * part_of(turns), libm::sqrt(within));
    [libm::cos(angle) * away, libm::sin(angle) * away]
}

fn part_of(v: f64) -> f64 {
    v - libm::floor(v)
}

/// The digits of a number in this base, mirrored at the point (van der Corput 1935): 0..1.
fn reversed(mut number: usize, base: usize) -> f64 {
    let (mut digits, mut unit) = (0.0, 1.0 / base as f64);
    while number > 0 {
        digits += (number % base) as f64 * unit;
        (number, unit) = (number / base, unit / base as f64);
    }
    digits
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No two samples share a place, the first is in the middle, and the mean of any usual number lies near the middle.
    #[test]
    fn samples_fill_pixel_and_discs() {
        let all = |of: fn(usize) -> [f64; 2]| (0..MOST_SAMPLES).map(of).collect::<Vec<_>>();
        let pixels = all(|k| in_pixel(k).map(f64::from));
        let discs = [all(on_lamp), all(|k| on_lens(k).map(f64::from))];
        assert!(pixels.iter().flatten().all(|v| (-0.5..=0.5).contains(v)));
        for list in discs.iter().chain([&pixels]) {
            assert_eq!(list[0], [0.0; 2]);
            for (k, [x, y]) in list.iter().enumerate() {
                assert!(libm::hypot(*x, *y) < 1.0);
                let apart = list[..k].iter().map(|[u, v]| libm::hypot(x - u, y - v));
                assert!(apart.fold(f64::INFINITY, f64::min) > 0.01, "{k}");
            }
            for count in [SAMPLES, 16, 32, MOST_SAMPLES] {
                let sum = |axis: usize| list[..count].iter().map(|p| p[axis]).sum::<f64>();
                let off = libm::hypot(sum(0), sum(1)) / count as f64;
                assert!(off < 0.15, "{off} after {count}");
            }
        }
    }
}
