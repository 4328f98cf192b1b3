//! Numbers and vectors of four pixels, for light that is computed for four pixels at once. Only additions,
//! multiplications, divisions, roots and bits are used, so all machines have the same bits.

use super::tile::Vectors;
use std::array::from_fn;
use std::f32::consts::LN_2;
use std::ops::{Add, Mul, Neg, Sub};
use wide::bytemuck::cast;
use wide::{f32x4, i32x4};

/// The bits of sqrt(1/2): mantissas are taken in the range sqrt(1/2)..sqrt(2).
const LEAST: i32 = 0x3F35_04F3;
/// Adding this rounds to an integer, which is then in the lowest bits.
const WHOLE: f32 = 12_582_912.0;
/// The number of bits of a mantissa.
const MANTISSA: i32 = 23;

/// The number in all lanes.
#[inline(always)]
pub(super) fn all(v: f32) -> f32x4 {
    f32x4::splat(v)
}

/// The numbers of four pixels of a tile.
#[inline(always)]
pub(super) fn four(list: &[f32], k: usize) -> f32x4 {
    f32x4::new(from_fn(|j| list[k + j]))
}

/// Each number, at most 1 and at least 0.
#[inline(always)]
pub(super) fn share(v: f32x4) -> f32x4 {
    v.fast_max(f32x4::ZERO).fast_min(f32x4::ONE)
}

/// Vectors of four pixels, by components.
#[derive(Clone, Copy)]
pub(super) struct FourVectors {
    pub x: f32x4,
    pub y: f32x4,
    pub z: f32x4,
}

impl FourVectors {
    /// The same vector four times.
    #[inline(always)]
    pub fn all([x, y, z]: [f32; 3]) -> Self {
        let [x, y, z] = [all(x), all(y), all(z)];
        Self { x, y, z }
    }

    /// The vectors of four pixels of a tile.
    #[inline(always)]
    pub fn of(list: &Vectors, k: usize) -> Self {
        let [x, y, z] = [four(&list[0], k), four(&list[1], k), four(&list[2], k)];
        Self { x, y, z }
    }

    /// Writes the vectors to a tile's list, from index `k` on.
    #[inline(always)]
    pub fn put(self, list: &mut Vectors, k: usize) {
        for (row, four) in list.iter_mut().zip([self.x, self.y, self.z]) {
            row[k..k + 4].copy_from_slice(&four.to_array());
        }
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> f32x4 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The componentwise product.
    #[inline(always)]
    pub fn times(self, other: Self) -> Self {
        Self {
            x: self.x * other.x,
            y: self.y * other.y,
            z: self.z * other.z,
        }
    }
}

impl Add for FourVectors {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl Sub for FourVectors {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl Neg for FourVectors {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self * all(-1.0)
    }
}

impl Mul<f32x4> for FourVectors {
    type Output = Self;
    #[inline(always)]
    fn mul(self, by: f32x4) -> Self {
        Self {
            x: self.x * by,
            y: self.y * by,
            z: self.z * by,
        }
    }
}

/// Each base to the power of its exponent, to about 1e-4 of 1. Bases are 0..1, exponents at least 0.1; a base of 0
/// counts as a very small number.
#[inline(always)]
pub(super) fn power(base: f32x4, exponent: f32x4) -> f32x4 {
    two_to(exponent * log2(base))
}

#[inline(always)]
fn log2(v: f32x4) -> f32x4 {
    let bits: i32x4 = cast(v);
    let doublings = (bits - i32x4::splat(LEAST)) >> MANTISSA;
    let part: f32x4 = cast(bits - (doublings << MANTISSA));
    let t = (part - f32x4::ONE) / (part + f32x4::ONE);
    let square = t * t;
    // 2 / ln 2 times the series of the inverse hyperbolic tangent.
    let series = all(2.885_39) + square * (all(0.961_796_7) + square * all(0.577_078));
    doublings.round_float() + t * series
}

/// Two to the power of numbers that are at most 0.
#[inline(always)]
fn two_to(v: f32x4) -> f32x4 {
    let v = v.fast_max(all(-120.0));
    let whole = v + all(WHOLE);
    let part = v - (whole - all(WHOLE));
    let mantissa = all(0.055_504_1) + part * all(0.009_618_1);
    let mantissa = all(LN_2) + part * (all(0.240_226_5) + part * mantissa);
    let mantissa: i32x4 = cast(f32x4::ONE + part * mantissa);
    let doublings: i32x4 = cast(whole);
    cast(mantissa + (doublings << MANTISSA))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_near_the_exact_ones() {
        for base in (0..=1000).map(|k| k as f32 / 1000.0) {
            for exponent in [0.1, 1.0, 6.5, 40.0, 200.0, 900.0] {
                let exact = libm::pow(base.into(), f64::from(exponent)) as f32;
                let [found, ..] = power(all(base), all(exponent)).to_array();
                let off = (found - exact).abs();
                assert!(off < 3e-4, "{base} {exponent}: {found} of {exact}");
            }
        }
        assert_eq!(power(all(1.0), all(77.0)).to_array(), [1.0; 4]);
    }
}
