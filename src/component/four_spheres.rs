//! Four spheres at once, in single precision: a quick test before the exact one.

use std::array::from_fn;
use wide::f32x4;

/// The greatest error of squares in single precision, for lengths of about one unit.
pub(crate) const COARSE: f32 = 1e-4;

/// Four spheres, in a unit that is about as long as the body.
pub(crate) struct FourSpheres {
    centre: [f32x4; 3],
    radius: f32x4,
}

/// Four numbers in single precision.
pub(crate) fn four(number: impl Fn(usize) -> f64) -> f32x4 {
    f32x4::new(from_fn(|k| number(k) as f32))
}

/// One number in single precision, four times.
pub(crate) fn fourfold(number: f64) -> f32x4 {
    f32x4::splat(number as f32)
}

impl FourSpheres {
    /// The spheres with these centres and radii, by their numbers from 0.
    pub fn new(centre: impl Fn(usize) -> [f64; 3], radius: impl Fn(usize) -> f64) -> Self {
        Self {
            centre: from_fn(|axis| four(|k| centre(k)[axis])),
            radius: four(radius),
        }
    }

    /// Replaces the radii.
    pub fn set_radii(&mut self, radius: impl Fn(usize) -> f64) {
        self.radius = four(radius);
    }

    /// A bit for each sphere that may overlap another one. The other radius may be below 0. Rounding adds bits, but
    /// removes none.
    #[inline]
    pub fn near(&self, centre: [f32x4; 3], radius: f32x4) -> u32 {
        let square = |v: f32x4| v * v;
        let [x, y, z] = from_fn(|axis| square(self.centre[axis] - centre[axis]));
        let reach = (self.radius + radius).fast_max(f32x4::ZERO);
        let slack = (square(radius) + f32x4::ONE) * f32x4::splat(COARSE);
        (x + y + z).simd_le(square(reach) + slack).to_bitmask()
    }
}
