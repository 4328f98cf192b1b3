//! Bonds of panels: herringbone and basket weave in a rectangle.

use crate::masonry::footprint::Footprint;
use crate::masonry::plan::pieces;
use glam::DVec2;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// Pieces below this share of a brick are slivers.
const SLIVER: f64 = 0.1;
/// The number of heights at which herringbone is tried, within a period of the pattern.
const HEIGHTS: u32 = 8;

/// The bricks of a panel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weave {
    /// The length of a brick (metres).
    length: f64,
    /// How many bricks side by side are as wide as one is long.
    count: usize,
}

/// A piece of a panel, and its share of a brick.
pub(super) type WovenPiece = (Footprint, f64);

impl Weave {
    /// Bricks of this size, with joints (metres). Their width becomes a whole part of their length.
    pub fn new(length: f64, width: f64) -> Self {
        Self {
            length,
            count: pieces(length, width),
        }
    }

    /// How many bricks side by side are as wide as one is long.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Herringbone, turned by 45 degrees and clipped to a rectangle. A line between two of its strips runs through the
    /// middle of the rectangle. Both sorts of such lines are tried at several heights, and the first try with the
    /// fewest slivers is kept.
    pub fn herringbone(&self, rectangle: &Footprint) -> Vec<WovenPiece> {
        let width = self.length / self.count as f64;
        let tries = (0..2 * HEIGHTS).map(|k| {
            let across = FRAC_1_SQRT_2 * (0.5 * width + f64::from(k / HEIGHTS) * self.length);
            let up = SQRT_2 * width * f64::from(k % HEIGHTS) / f64::from(HEIGHTS);
            self.herringbone_at(rectangle, DVec2::new(across, up))
        });
        let slivers = |found: &Vec<WovenPiece>| {
            let small = found.iter().filter(|(_, share)| *share < SLIVER);
            small.count()
        };
        tries.min_by_key(slivers).unwrap_or_default()
    }

    /// Herringbone with the origin of its lattice at a distance from the middle of a rectangle.
    ///
    /// A square (u, v) of the lattice lies in a brick along u if u - v, modulo 2n, is below n; else it lies in a brick
    /// along v. n squares make a brick.
    fn herringbone_at(&self, rectangle: &Footprint, shift: DVec2) -> Vec<WovenPiece> {
        let n = self.count as i64;
        let width = self.length / self.count as f64;
        let [low, high] = rectangle.bounds();
        let origin = low.midpoint(high) + shift;
        let place = |u: i64, v: i64| {
            origin + DVec2::new((u - v) as f64, (u + v) as f64) * (width * FRAC_1_SQRT_2)
        };
        let most = ((0.5 * low.distance(high) + 3.0 * self.length) / width).ceil() as i64;
        let turns = most / n + 1;
        let bricks = (-most..=most).flat_map(|row| {
            let starts = (-turns..=turns).map(move |turn| row + 2 * n * turn);
            starts.flat_map(move |start| {
                let along_u = [start, row, start + n, row + 1];
                let along_v = [row, start + 1, row + 1, start + 1 + n];
                [along_u, along_v]
            })
        });
        let pieces = bricks.filter_map(|[u, v, to_u, to_v]| {
            let corners = [
                place(u, v),
                place(to_u, v),
                place(to_u, to_v),
                place(u, to_v),
            ];
            let is_near = corners.iter().any(|p| p.cmpgt(low - self.length).all())
                && corners.iter().any(|p| p.cmplt(high + self.length).all());
            let brick = is_near.then(|| Footprint::new(&corners).ok()).flatten()?;
            let piece = brick.intersection(rectangle)?;
            let share = piece.area() / brick.area();
            Some((piece, share))
        });
        pieces.collect()
    }

    /// Basket weave: squares of bricks that lie along s and along t in turn. Bricks are stretched so that they fill the
    /// rectangle.
    pub fn basket(&self, rectangle: &Footprint) -> Vec<WovenPiece> {
        let [low, high] = rectangle.bounds();
        let size = high - low;
        let [across, up] = [size.x, size.y].map(|side| pieces(side, self.length));
        let n = self.count;
        let place = |x: usize, y: usize| {
            low + size * DVec2::new(x as f64 / (across * n) as f64, y as f64 / (up * n) as f64)
        };
        let squares = (0..up).flat_map(|b| (0..across).map(move |a| [a, b]));
        let bricks = squares.flat_map(|[a, b]| {
            (0..n).map(move |k| match (a + b) % 2 {
                0 => [[a * n, b * n + k], [(a + 1) * n, b * n + k + 1]],
                _ => [[a * n + k, b * n], [a * n + k + 1, (b + 1) * n]],
            })
        });
        let pieces = bricks.filter_map(|[from, to]| {
            let brick = Footprint::rectangle(place(from[0], from[1]), place(to[0], to[1]))?;
            Some((brick, 1.0))
        });
        pieces.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces of both bonds in rectangles of several sizes.
    fn woven() -> Vec<(Footprint, [Vec<WovenPiece>; 2])> {
        let weave = Weave::new(0.25, 0.25 / 3.0);
        let sizes = [(0.25, 0.75), (0.74, 1.0), (1.25, 0.5), (0.37, 0.83)];
        let rectangles = sizes.map(|(width, height)| {
            let low = DVec2::new(0.3, -0.2);
            Footprint::rectangle(low, low + DVec2::new(width, height)).unwrap()
        });
        let both = |rectangle: &Footprint| [weave.herringbone(rectangle), weave.basket(rectangle)];
        rectangles
            .map(|rectangle| (rectangle.clone(), both(&rectangle)))
            .to_vec()
    }

    #[test]
    fn pieces_fill_the_rectangle_without_overlap() {
        for (rectangle, both) in woven() {
            for pieces in both {
                let sum: f64 = pieces.iter().map(|(piece, _)| piece.area()).sum();
                assert!((sum - rectangle.area()).abs() < 1e-6, "{sum}");
                for (k, (a, _)) in pieces.iter().enumerate() {
                    assert!(pieces[..k].iter().all(|(b, _)| a.shared_area(b) < 1e-9));
                }
            }
        }
    }

    #[test]
    fn herringbone_is_oblique_and_three_bricks_wide() {
        let weave = Weave::new(0.25, 0.25 / 3.0);
        let large = Footprint::rectangle(DVec2::ZERO, DVec2::splat(1.5)).unwrap();
        let pieces = weave.herringbone(&large);
        let whole: Vec<&Footprint> = pieces
            .iter()
            .filter(|(_, share)| *share > 0.999)
            .map(|(piece, _)| piece)
            .collect();
        assert!(whole.len() > 50, "{}", whole.len());
        let mut rising = 0;
        for brick in &whole {
            let sides: Vec<DVec2> = (0..4).map(|k| brick.side(k)).map(|[a, b]| b - a).collect();
            let long = if sides[0].length() > sides[1].length() {
                sides[0]
            } else {
                sides[1]
            };
            assert!((long.length() - 0.25).abs() < 1e-9);
            assert!((long.x.abs() - long.y.abs()).abs() < 1e-9);
            rising += usize::from(long.x * long.y > 0.0);
        }
        // Half of the bricks rise to either side.
        assert!(rising.abs_diff(whole.len() - rising) * 10 < whole.len());
        let slivers = pieces.iter().filter(|(_, share)| *share < SLIVER).count();
        assert!(slivers * 10 < pieces.len(), "{slivers} of {}", pieces.len());
    }

    #[test]
    fn basket_weave_alternates_between_squares() {
        let weave = Weave::new(0.25, 0.25 / 3.0);
        let rectangle = Footprint::rectangle(DVec2::ZERO, DVec2::new(0.5, 0.75)).unwrap();
        let pieces = weave.basket(&rectangle);
        assert_eq!(pieces.len(), 2 * 3 * 3);
        let is_flat = |(piece, _): &&WovenPiece| {
            let [low, high] = piece.bounds();
            high.x - low.x > high.y - low.y
        };
        assert_eq!(pieces.iter().filter(is_flat).count(), 9);
    }
}
