//! Conversion between pixels and picture units: a picture may have several pixels for each unit.

/// Levels of noise finer than a unit: with more than one pixel for each unit, and with more than four.
const DOUBLINGS: [u32; 2] = [2, 3];

/// The number of pixels in a picture unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PixelScale {
    /// Pixels for each picture unit, along a side.
    per_unit: i32,
    /// Picture units for each pixel.
    unit: f32,
}

impl PixelScale {
    pub fn new(per_unit: usize) -> Self {
        Self {
            per_unit: per_unit as i32,
            unit: 1.0 / per_unit as f32,
        }
    }

    /// Pixels for each picture unit, along a side.
    pub fn per_unit(self) -> i32 {
        self.per_unit
    }

    /// The centre of a pixel in picture units, relative to the centre of the first pixel at one pixel a unit.
    #[inline(always)]
    pub fn centre(self, pixel: i32) -> f32 {
        (pixel as f32 + 0.5) * self.unit - 0.5
    }

    /// The noise has `2^doublings` values for each picture unit, along a side.
    pub fn noise_doublings(self) -> u32 {
        match self.per_unit {
            1 => 0,
            2..=4 => DOUBLINGS[0],
            _ => DOUBLINGS[1],
        }
    }

    /// The index of the noise value nearest to a pixel's centre.
    #[inline(always)]
    pub fn noise_value(self, pixel: i32) -> i32 {
        if self.per_unit == 1 {
            return pixel;
        }
        // centre(pixel) times the values for each unit, rounded.
        let (pixels, values) = (self.per_unit, 1 << self.noise_doublings());
        (values * (2 * pixel + 1) - (values - 1) * pixels).div_euclid(2 * pixels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_nearest_to_pixels() {
        assert_eq!(PixelScale::new(1).noise_value(-7), -7);
        for per_unit in 2..=8 {
            let scale = PixelScale::new(per_unit);
            let values = (1 << scale.noise_doublings()) as f32;
            for pixel in -40..40 {
                let off = scale.centre(pixel) * values - scale.noise_value(pixel) as f32;
                assert!(off.abs() <= 0.51, "{per_unit} {pixel} {off}");
            }
        }
    }
}
