//! Fractal noise by midpoint displacement on a periodic grid.
//!
//! Miyata, Itoh, Shimada (2000), section 5.3; Fournier, Fussell, Carpenter (1982), Computer Rendering of
//! Stochastic Models. Midpoints of the grid's squares and sides are set to the mean of their neighbours and
//! displaced at random. The amplitude is proportional to distance^H, so it falls by 2^-H a level, with H = 2
//! - Fd for profiles of fractal dimension Fd.
//!
//! Pictures with more pixels a unit have more levels below the unit. These are flatter and preserve the mean
//! over each unit, so the bigger picture, averaged, equals the one with one pixel a unit. The finest of these
//! levels would take most of the memory and is computed on request.

#[cfg(house)]
use crate::order::greater;
use crate::random::{Purpose, Random};
#[cfg(house)]
use glam::Vec3;

/// Below the unit of length the amplitude falls by this factor each half level, whatever the dimension: more
/// pixels must not make the picture rougher and darker.
const BELOW: f32 = 0.6;
/// Levels below the unit that are stored.
const STORED: u32 = 2;
/// The factor for the level after the stored ones, which is visible only at the highest resolution and would darken it.
const LAST: f32 = 0.4;

/// A periodic square of noise with mean 0, and standard deviation 1 at the distance of the coarse grid's
/// points.
#[derive(Clone, Debug)]
pub struct NoiseTile {
    side: usize,
    /// Values for each unit of length, along a side.
    dense: f32,
    values: Vec<f32>,
    /// The level between the values, if any.
    midpoints: Option<Midpoints>,
}

/// Points midway between the values.
#[derive(Clone, Debug)]
struct Midpoints {
    /// Displacement amplitudes of points amid four values, and of points between two.
    amplitudes: [f32; 2],
    salt: u32,
}

impl Midpoints {
    /// The displacement of a point amid this many values, always the same for the same point.
    fn displacement(&self, x: usize, y: usize, amid: usize) -> f32 {
        self.amplitudes[usize::from(amid == 2)] * white([x, y], self.salt)
    }
}

/// White noise at a place, uniform with standard deviation 1, always the same for the same place and salt.
pub(crate) fn white([x, y]: [usize; 2], salt: u32) -> f32 {
    // Two rounds of a hash of 32 bits (Wellons 2018, Prospecting for Hash Functions).
    let mut bits = (x as u32).wrapping_mul(0x9E37_79B1) ^ (y as u32).wrapping_mul(0x85EB_CA77);
    bits ^= salt;
    for factor in [0x7FEB_352D, 0x846C_A68B_u32] {
        bits = (bits ^ bits >> 16).wrapping_mul(factor) ^ bits >> 15;
    }
    bits as i32 as f32 * (3.0f32.sqrt() / 2_147_483_648.0)
}

/// The noise at a place in space, blended from three readings of a plane noise: one along each axis, weighted by the
/// normal.
#[cfg(house)]
#[inline]
pub(crate) fn from_three_sides(p: Vec3, normal: Vec3, read: impl Fn(f32, f32) -> f32) -> f32 {
    let n = normal * normal;
    let weights = n * n / greater((n * n).element_sum(), 1e-6);
    weights.x * read(p.z, p.y)
        + weights.y * read(p.x + 31.0, p.z)
        + weights.z * read(p.x, p.y + 17.0)
}

impl NoiseTile {
    /// A tile with `2^log_side` values a side, starting from grid points `2^levels` apart (at most the side),
    /// with fractal dimension `dimension`, 1 to 2. `item` selects the random stream.
    pub fn new(seed: u64, item: u64, log_side: u32, levels: u32, dimension: f64) -> Self {
        Self::finer(seed, item, [log_side, levels], dimension, 0)
    }

    /// Like [`NoiseTile::new`], with more levels below the finest one. The tile contains every value of the coarser
    /// tile, and `2^doublings` values, at most 8, make a unit of length.
    pub fn finer(
        seed: u64,
        item: u64,
        [log_side, levels]: [u32; 2],
        dimension: f64,
        doublings: u32,
    ) -> Self {
        let is_stored = doublings <= STORED;
        let doublings = doublings.min(STORED);
        let side = 1usize << (log_side + doublings);
        let levels = levels.min(log_side) + doublings;
        let mut tile = Self {
            side,
            dense: (1u32 << doublings) as f32,
            values: vec![0.0; side * side],
            midpoints: None,
        };
        let mut random = Random::new(seed, Purpose::Noise, item);
        // Uniform numbers with standard deviation 1.
        let mut draw = move || (random.signed() * 3.0f64.sqrt()) as f32;
        let coarse = 1usize << levels;
        for y in (0..side).step_by(coarse) {
            for x in (0..side).step_by(coarse) {
                tile.values[y * side + x] = draw();
            }
        }
        let hurst = (2.0 - dimension).clamp(0.0, 1.0);
        let fall = libm::exp2(-hurst / 2.0) as f32;
        // Displacement of a point whose neighbours are 1 coarse step apart (Fournier et al.): the variance
        // that averaging removes.
        let mut amplitude = (1.0 - libm::exp2(2.0 * hurst - 2.0)).max(0.0).sqrt() as f32;
        let mut step = coarse;
        let unit = 1usize << doublings;
        while step > 1 {
            let fall = if step > unit { fall } else { BELOW };
            if step == unit {
                tile.sharpen(unit);
            }
            amplitude *= fall;
            tile.displace_squares(step, amplitude, &mut draw);
            amplitude *= fall;
            tile.displace_sides(step, amplitude, &mut draw);
            step /= 2;
        }
        tile.centre(unit);
        if !is_stored {
            tile.midpoints = Some(Midpoints {
                amplitudes: [amplitude * LAST, amplitude * LAST * LAST],
                salt: Random::new(seed, Purpose::Noise, item).bits() as u32,
            });
        }
        tile
    }

    /// Values along a side, a power of two.
    pub fn side(&self) -> usize {
        self.side << u32::from(self.midpoints.is_some())
    }

    /// The value at a grid point; the tile repeats in all directions.
    pub fn at(&self, x: i32, y: i32) -> f32 {
        match &self.midpoints {
            None => self.stored(x, y),
            Some(midpoints) => self.midway(midpoints, x, y),
        }
    }

    fn stored(&self, x: i32, y: i32) -> f32 {
        let mask = self.side - 1;
        self.values[(y as usize & mask) * self.side + (x as usize & mask)]
    }

    /// The value at a place on the grid with half the stored spacing.
    fn midway(&self, midpoints: &Midpoints, x: i32, y: i32) -> f32 {
        let (left, up) = (x >> 1, y >> 1);
        let (right, down) = (left + (x & 1), up + (y & 1));
        let amid = 1 << ((x & 1) + (y & 1));
        let here = self.stored(left, up);
        if amid == 1 {
            return here;
        }
        let sum =
            here + self.stored(right, up) + self.stored(left, down) + self.stored(right, down);
        let mask = 2 * self.side - 1;
        sum / 4.0 + midpoints.displacement(x as usize & mask, y as usize & mask, amid)
    }

    /// The value between grid points, bilinear; x and y are in units of length.
    pub fn between(&self, x: f32, y: f32) -> f32 {
        let (x, y) = (x * self.dense, y * self.dense);
        let (ix, iy) = (floor(x), floor(y));
        let (tx, ty) = (x - ix as f32, y - iy as f32);
        let upper = self.stored(ix, iy) * (1.0 - tx) + self.stored(ix + 1, iy) * tx;
        let lower = self.stored(ix, iy + 1) * (1.0 - tx) + self.stored(ix + 1, iy + 1) * tx;
        upper * (1.0 - ty) + lower * ty
    }

    fn displace_squares(&mut self, step: usize, amplitude: f32, draw: &mut impl FnMut() -> f32) {
        let (side, half, mask) = (self.side, step / 2, self.side - 1);
        for y in (half..side).step_by(step) {
            let (up, down) = ((y - half) * side, ((y + half) & mask) * side);
            for x in (half..side).step_by(step) {
                let (left, right) = (x - half, (x + half) & mask);
                let v = &self.values;
                let sum = v[up + left] + v[up + right] + v[down + left] + v[down + right];
                self.values[y * side + x] = sum / 4.0 + amplitude * draw();
            }
        }
    }

    fn displace_sides(&mut self, step: usize, amplitude: f32, draw: &mut impl FnMut() -> f32) {
        let (side, half, mask) = (self.side, step / 2, self.side - 1);
        for y in (0..side).step_by(half) {
            let first = if (y / half) % 2 == 0 { half } else { 0 };
            let (up, down) = (
                ((y + side - half) & mask) * side,
                ((y + half) & mask) * side,
            );
            for x in (first..side).step_by(step) {
                let (left, right) = ((x + side - half) & mask, (x + half) & mask);
                let v = &self.values;
                let sum = v[up + x] + v[down + x] + v[y * side + left] + v[y * side + right];
                self.values[y * side + x] = sum / 4.0 + amplitude * draw();
            }
        }
    }

    /// Strengthens the values at whole units of length against their neighbours, so that means over units are
    /// unchanged by the added levels.
    fn sharpen(&mut self, unit: usize) {
        let n = self.side / unit;
        let units = |values: &[f32]| -> Vec<f32> {
            let rows = values.chunks_exact(n * unit).step_by(unit);
            rows.flat_map(|row| row.iter().step_by(unit).copied())
                .collect()
        };
        let wanted = units(&self.values);
        let mut sharp = wanted.clone();
        for _ in 0..2 {
            let along = mean_with_next(&sharp, n, 1);
            let means = mean_with_next(&along, n, n);
            for ((s, w), m) in sharp.iter_mut().zip(&wanted).zip(means) {
                *s += w - m;
            }
        }
        for (k, s) in sharp.into_iter().enumerate() {
            self.values[(k / n * n * unit + k % n) * unit] = s;
        }
    }

    /// Subtracts the mean of the values at whole units of length.
    fn centre(&mut self, unit: usize) {
        let rows = self.values.chunks_exact(self.side).step_by(unit);
        let values = rows.flat_map(|row| row.iter().step_by(unit));
        let sum: f64 = values.map(|&v| f64::from(v)).sum();
        let count = (self.side / unit) * (self.side / unit);
        let mean = (sum / count as f64) as f32;
        self.values.iter_mut().for_each(|v| *v -= mean);
    }
}

/// The mean over one unit of length around each of n x n periodic values, along a line of values; `step` is 1
/// along rows and n down columns.
fn mean_with_next(values: &[f32], n: usize, step: usize) -> Vec<f32> {
    let last = n * n - 1;
    let beside = |k: usize| {
        let (row, along) = (k & !(n - 1), k & (n - 1));
        if step == 1 {
            [row | (along + n - 1) & (n - 1), row | (along + 1) & (n - 1)]
        } else {
            [(k + n * n - n) & last, (k + n) & last]
        }
    };
    let mean = |k: usize| {
        let [before, after] = beside(k).map(|b| values[b]);
        0.75 * values[k] + 0.125 * (before + after)
    };
    (0..values.len()).map(mean).collect()
}

/// Rounds down. `f32::floor` is a call where the target has no rounding instruction.
pub(crate) fn floor(v: f32) -> i32 {
    let whole = v as i32;
    whole - i32::from((whole as f32) > v)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half the mean squared difference of values `lag` apart along rows and columns.
    fn variogram(tile: &NoiseTile, lag: i32) -> f64 {
        let side = tile.side() as i32;
        let mut sum = 0.0;
        for y in 0..side {
            for x in 0..side {
                let here = tile.at(x, y);
                for there in [tile.at(x + lag, y), tile.at(x, y + lag)] {
                    sum += f64::from((here - there) * (here - there));
                }
            }
        }
        sum / f64::from(4 * side * side)
    }

    /// From the slope 2 H of the variogram on logarithmic scales, by least squares over doubling lags.
    fn measured_dimension(tile: &NoiseTile) -> f64 {
        let points: Vec<(f64, f64)> = (0..6)
            .map(|k| (f64::from(k), libm::log2(variogram(tile, 1 << k))))
            .collect();
        let n = points.len() as f64;
        let (mx, my) = points
            .iter()
            .fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
        let covariance: f64 = points.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum();
        let variance: f64 = points.iter().map(|p| (p.0 - mx) * (p.0 - mx)).sum();
        2.0 - covariance / variance / 2.0
    }

    #[test]
    fn the_profile_has_the_dimension_asked_for() {
        for tenth in 11..=19 {
            let asked = f64::from(tenth) / 10.0;
            let mean = (0..4)
                .map(|seed| measured_dimension(&NoiseTile::new(seed, 0, 9, 8, asked)) / 4.0)
                .sum::<f64>();
            assert!((mean - asked).abs() < 0.1, "asked {asked}, got {mean}");
        }
    }

    #[test]
    fn more_levels_keep_the_means() {
        let tile = NoiseTile::new(5, 2, 6, 9, 1.6);
        let finer = NoiseTile::finer(5, 2, [6, 9], 1.6, 2);
        let mut off = 0.0;
        for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
            let around = (0..16).map(|k| (4 * x - 2 + k % 4, 4 * y - 2 + k / 4));
            let mean = around.map(|(x, y)| finer.at(x, y)).sum::<f32>() / 16.0;
            off += (mean - tile.at(x, y)).abs() / 4096.0;
            assert_eq!(finer.at(4 * x, 4 * y), finer.between(x as f32, y as f32));
        }
        assert!(off < 0.1, "{off}");
    }

    #[test]
    fn the_finest_level_lies_between_the_others() {
        let [stored, finest] = [2, 3].map(|levels| NoiseTile::finer(5, 2, [6, 9], 1.8, levels));
        assert_eq!((stored.side(), finest.side()), (256, 512));
        let (mut sum, mut squares) = (0.0, 0.0);
        for (x, y) in (0..512).flat_map(|y| (0..512).map(move |x| (x, y))) {
            assert_eq!(finest.at(x, y), finest.at(x - 512, y + 512));
            if (x | y) & 1 == 0 {
                assert_eq!(finest.at(x, y), stored.at(x / 2, y / 2));
            } else {
                let (x, y) = (0.5 * x as f32, 0.5 * y as f32);
                let off = finest.at((2.0 * x) as i32, (2.0 * y) as i32)
                    - stored.between(0.25 * x, 0.25 * y);
                (sum, squares) = (sum + off, squares + off * off);
            }
        }
        let count = (3 * 512 * 512 / 4) as f32;
        let deviation = (squares / count).sqrt();
        let rise = variogram(&stored, 1).sqrt() as f32;
        assert!((sum / count).abs() < 0.02 * deviation, "{sum}");
        assert!(
            (0.05..0.9).contains(&(deviation / rise)),
            "{deviation} {rise}"
        );
    }

    #[test]
    fn repeats_without_a_seam() {
        let tile = NoiseTile::new(3, 0, 6, 4, 1.3);
        assert_eq!(tile.at(-1, 5), tile.at(63, 69));
        let seam: f32 = (0..64)
            .map(|y| (tile.at(63, y) - tile.at(64, y)).abs())
            .sum();
        let inside: f32 = (0..64)
            .map(|y| (tile.at(31, y) - tile.at(32, y)).abs())
            .sum();
        assert!(seam < 2.0 * inside);
        assert_eq!(tile.between(7.0, 9.0), tile.at(7, 9));
    }
}
