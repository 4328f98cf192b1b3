//! Depth of the outline: the distance to its medial axis, and its innermost point.

use super::Domain;
use crate::order;
use glam::DVec2;

/// Points along a side of the raster that is searched for the deepest point; a power of two.
const RASTER: u32 = 64;
/// A bound, with reserve, on the rounding error of a distance (picture units).
const ROUNDING: f64 = 1e-9;

impl Domain {
    /// The distance from a boundary point along its inward normal to the medial axis, where another boundary
    /// point becomes nearer; at most `most`.
    pub(crate) fn medial_depth(&self, place: DVec2, inward: DVec2, most: f64) -> f64 {
        let stays = |t: f64| self.nearest(place + inward * t).distance >= 0.99 * t;
        if stays(most) {
            return most;
        }
        let (mut low, mut high) = (0.0, most);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            if stays(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }

    /// The innermost point (pole of inaccessibility) of a coarse raster. A narrow island's only cell goes there. `None`
    /// if no raster point is inside.
    pub(crate) fn deepest(&self) -> Option<DVec2> {
        let (lo, hi) = self.bounds();
        let step = (hi - lo) / f64::from(RASTER);
        // A square of raster points: its first column and row, the points along a side, and the depth at its
        // centre.
        let square = |column: u32, row: u32, side: u32| {
            let at = |k: u32| f64::from(k) + f64::from(side) / 2.0;
            let middle = lo + step * DVec2::new(at(column), at(row));
            (column, row, side, middle, self.nearest(middle).distance)
        };
        let mut best = (0.0, 0, None);
        let mut open = vec![square(0, 0, RASTER)];
        while let Some((column, row, side, middle, depth)) = open.pop() {
            // Depth changes by at most the distance moved, so this bounds the depth in the square.
            let most = depth + step.length() * f64::from(side - 1) / 2.0;
            if most + ROUNDING < best.0 {
                continue;
            }
            if side > 1 {
                let half = side / 2;
                let corners = [(half, half), (0, half), (half, 0), (0, 0)];
                let mut four = corners.map(|(x, y)| square(column + x, row + y, half));
                order::sort(&mut four, |&(_, _, _, _, depth)| (order::rank(depth), 0));
                open.extend(four);
                continue;
            }
            let index = row * RASTER + column;
            // Among equal depths the first point, row by row, wins.
            if depth > best.0 || (depth == best.0 && index < best.1) {
                best = (depth, index, Some(middle));
            }
        }
        best.2
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    #[test]
    fn the_deepest_place_is_that_of_the_whole_raster() {
        for seed in 0..40 {
            let mut random = Random::new(seed, Purpose::Placement, 0);
            let corners = 3 + random.below(9);
            // Regular polygons occur too: many points are equally deep there.
            let spread = [0.0, 40.0][random.below(2)];
            let ring = (0..corners).map(|k| {
                let turn = std::f64::consts::TAU * k as f64 / corners as f64;
                let radius = 50.0 - spread * random.unit();
                DVec2::new(
                    60.0 + radius * libm::cos(turn),
                    60.0 + radius * libm::sin(turn),
                )
            });
            let domain = Domain::of_rings(vec![ring.collect()], None);
            let (lo, hi) = domain.bounds();
            let raster = f64::from(RASTER);
            let (mut most, mut place) = (0.0, None);
            for k in 0..RASTER * RASTER {
                let at = DVec2::new(f64::from(k % RASTER) + 0.5, f64::from(k / RASTER) + 0.5);
                let p = lo + (hi - lo) * (at / raster);
                let depth = domain.nearest(p).distance;
                if depth > most {
                    (most, place) = (depth, Some(p));
                }
            }
            assert_eq!(domain.deepest(), place, "{corners} corners of seed {seed}");
        }
    }
}
