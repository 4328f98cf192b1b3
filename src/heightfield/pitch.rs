//! How pixels lie in picture units: a picture may have more than one of them for each unit.

/// Doublings of the noises of pictures with more than one pixel for each unit.
const DOUBLINGS: u32 = 2;

/// The size of pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pitch {
    /// Pixels for each picture unit, along a side.
    fine: i32,
    /// Picture units for each pixel.
    unit: f32,
}

impl Pitch {
    pub fn new(fine: usize) -> Self {
        Self {
            fine: fine as i32,
            unit: 1.0 / fine as f32,
        }
    }

    /// Pixels for each picture unit, along a side.
    pub fn fine(self) -> i32 {
        self.fine
    }

    /// Where a pixel's middle is, in picture units from that of the first pixel of one unit.
    #[inline(always)]
    pub fn place(self, pixel: i32) -> f32 {
        (pixel as f32 + 0.5) * self.unit - 0.5
    }

    /// So often is the distance of a noise's values halved, from one picture unit on.
    pub fn doublings(self) -> u32 {
        if self.fine == 1 { 0 } else { DOUBLINGS }
    }

    /// Which value of a noise so doubled lies nearest to a pixel's middle.
    #[inline(always)]
    pub fn value(self, pixel: i32) -> i32 {
        if self.fine == 1 {
            return pixel;
        }
        // place(pixel) times the values for each unit, rounded.
        let (fine, dense) = (self.fine, 1 << DOUBLINGS);
        (dense * (2 * pixel + 1) - (dense - 1) * fine).div_euclid(2 * fine)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_nearest_to_pixels() {
        assert_eq!(Pitch::new(1).value(-7), -7);
        for fine in 2..=4 {
            let pitch = Pitch::new(fine);
            for pixel in -40..40 {
                let off = pitch.place(pixel) * 4.0 - pitch.value(pixel) as f32;
                assert!(off.abs() <= 0.51, "{fine} {pixel} {off}");
            }
        }
    }
}
