//! The only source of random numbers: a stream for every (seed, purpose, item).
//!
//! A draw depends on nothing else, so a stone keeps its colour whatever was drawn before it, on every
//! machine. The generator is SplitMix64 (Steele, Lea, Flood 2014, Fast Splittable Pseudorandom Number
//! Generators).

use std::f64::consts::TAU;

/// The default seed.
pub const SEED: u64 = 1;

/// The purpose of a stream; each has its own numbers for the same seed and item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u64)]
pub enum Purpose {
    /// Initial places of cells, and their order.
    Placement = 1,
    /// The size of a cell.
    Size = 2,
    /// The displaced corners of a stone.
    Distortion = 3,
    /// The fractal noise.
    Noise = 4,
    /// Colour, optics and other attributes of a stone.
    Attribute = 5,
    /// The ground between the stones.
    Ground = 6,
    /// Points scattered over the outline.
    Scatter = 7,
    /// Which cells are marked.
    Pattern = 8,
    /// Points thrown on a surface.
    Dart = 9,
    /// How a body is turned, which variant it is, and its size.
    Turn = 10,
    /// The order in which bodies settle.
    Order = 11,
    /// The colour of a body.
    Paint = 12,
    /// The displacement of a cell at the start of a packing.
    Jolt = 13,
}

/// A stream of random numbers.
#[derive(Clone, Debug)]
pub struct Random {
    state: u64,
}

const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

impl Random {
    /// The stream of `item` (a cell's id, a grid node's index) for one purpose under a seed.
    pub fn new(seed: u64, purpose: Purpose, item: u64) -> Self {
        let stream = mix(seed.wrapping_add(GOLDEN)).wrapping_add(purpose as u64);
        Self {
            state: mix(mix(stream).wrapping_add(item)),
        }
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(GOLDEN);
        mix(self.state)
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// Uniform in [-1, 1).
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Normal with mean 0 and standard deviation 1 (Box and Muller 1958).
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * libm::log(1.0 - self.unit())).sqrt();
        radius * libm::cos(TAU * self.unit())
    }

    /// Uniform among 0..n; 0 where n is 0.
    pub fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n.saturating_sub(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_differ_by_seed_purpose_and_item() {
        let first = |s, p, i| Random::new(s, p, i).bits();
        let base = first(1, Purpose::Size, 1);
        assert_eq!(base, first(1, Purpose::Size, 1));
        assert_ne!(base, first(2, Purpose::Size, 1));
        assert_ne!(base, first(1, Purpose::Noise, 1));
        assert_ne!(base, first(1, Purpose::Size, 2));
    }

    #[test]
    fn moments_are_those_of_the_distributions() {
        let n = 20_000;
        let mut random = Random::new(7, Purpose::Noise, 0);
        let (mut unit, mut square) = (0.0, 0.0);
        for _ in 0..n {
            unit += random.unit() / n as f64;
            let z = random.normal();
            square += z * z / n as f64;
        }
        assert!((unit - 0.5).abs() < 0.01, "mean {unit}");
        assert!((square - 1.0).abs() < 0.04, "variance {square}");
    }
}
