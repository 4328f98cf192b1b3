//! Finds the segment nearest to a point, with a grid of candidates.

use crate::order::{greater, lesser};
use crate::planar::closest_on_segment;
use glam::DVec2;

/// For each grid square, the segments that can be nearest to some point of it: those whose distance from the square's
/// centre exceeds the least such distance by at most the square's diagonal.
#[derive(Clone, Debug)]
pub(super) struct CandidateGrid {
    origin: DVec2,
    step: f64,
    columns: usize,
    rows: usize,
    /// For each square, the range of its segments in `list`.
    spans: Vec<(u32, u32)>,
    list: Vec<u32>,
    all: Vec<u32>,
    rulers: Vec<Ruler>,
}

/// Squares along the longer side of the outline's bounding box.
const SQUARES: f64 = 64.0;
/// Lists this short are not narrowed any further.
const FEW: usize = 4;
/// A generous bound on the rounding errors of distances, as a share of the coordinates.
const ROUNDING: f64 = 1e-9;

impl CandidateGrid {
    /// A grid for these segments; there must be at least one.
    pub fn new(segments: &[[DVec2; 2]]) -> Self {
        Self::like(segments, None)
    }

    /// A grid for these segments, with squares as large as those of another grid, if one is given.
    pub fn like(segments: &[[DVec2; 2]], other: Option<&Self>) -> Self {
        let all: Vec<u32> = (0..segments.len() as u32).collect();
        let (lo, hi) = segments
            .iter()
            .flatten()
            .fold((segments[0][0], segments[0][0]), |(lo, hi), &p| {
                (lo.min(p), hi.max(p))
            });
        let own = (hi - lo).max_element() / SQUARES;
        let step = other.map_or(own, |grid| grid.step);
        // A margin of a few squares: packing also asks about points a little outside.
        let origin = lo - DVec2::splat(4.0 * step);
        let columns = ((hi.x - lo.x) / step) as usize + 9;
        let rows = ((hi.y - lo.y) / step) as usize + 9;
        let mut grid = Self {
            origin,
            step,
            columns,
            rows,
            spans: Vec::new(),
            list: Vec::new(),
            all,
            rulers: segments.iter().map(Ruler::new).collect(),
        };
        grid.fill();
        grid
    }

    /// Fills the lists of all squares: narrows the candidates for the whole grid first, then for its quarters and so
    /// on, so that each square tries few segments.
    fn fill(&mut self) {
        self.spans = vec![(0, 0); self.columns * self.rows];
        let side = self.columns.max(self.rows).next_power_of_two();
        let (mut stack, mut squares) = (self.all.clone(), Vec::new());
        self.divide((0, 0), side, (&mut stack, 0), &mut squares);
    }

    /// Narrows the candidates for a block of squares, then for its quarters. The candidates stand in a stack, from
    /// `first` on; `squares` is scratch space.
    fn divide(
        &mut self,
        (left, top): (usize, usize),
        side: usize,
        (stack, first): (&mut Vec<u32>, usize),
        squares: &mut Vec<f64>,
    ) {
        if left >= self.columns || top >= self.rows {
            return;
        }
        let corner = DVec2::new(left as f64, top as f64);
        let middle = self.origin + self.step * (corner + DVec2::splat(side as f64 / 2.0));
        let end = stack.len();
        self.narrow(middle, side as f64 * self.step, (stack, first), squares);
        if side == 1 || stack.len() - end <= FEW {
            let first = self.list.len() as u32;
            self.list.extend_from_slice(&stack[end..]);
            let span = (first, self.list.len() as u32);
            let right = self.columns.min(left + side);
            for row in top..self.rows.min(top + side) {
                self.spans[row * self.columns + left..row * self.columns + right].fill(span);
            }
        } else {
            let half = side / 2;
            for (x, y) in [(0, 0), (half, 0), (0, half), (half, half)] {
                self.divide((left + x, top + y), half, (stack, end), squares);
            }
        }
        stack.truncate(end);
    }

    /// Pushes those of the candidates that can be nearest to a point of a square with this centre and side.
    fn narrow(
        &self,
        middle: DVec2,
        side: f64,
        (stack, first): (&mut Vec<u32>, usize),
        squares: &mut Vec<f64>,
    ) {
        let square_to = |&k: &u32| self.rulers[k as usize].square_to(middle);
        squares.clear();
        squares.extend(stack[first..].iter().map(square_to));
        let least = squares.iter().fold(f64::INFINITY, |m, &d| lesser(m, d));
        // From the middle to a corner and back is a diagonal.
        let reach = least.sqrt() + 1.415 * side;
        for (k, &square) in (first..).zip(&*squares) {
            if square <= reach * reach {
                stack.push(stack[k]);
            }
        }
    }

    /// The squared distance, the closest point and the number of the nearest segment.
    pub fn nearest(&self, segments: &[[DVec2; 2]], p: DVec2) -> (f64, DVec2, usize) {
        // Segments that are farther than the nearest so far by more than rounding errors are left out.
        let farthest = p.abs().max(self.origin.abs()).max_element() + SQUARES * self.step;
        let mut reach = f64::INFINITY;
        let mut best = (f64::INFINITY, p, 0);
        for &index in self.candidates(p) {
            if self.rulers[index as usize].square_to(p) > reach {
                continue;
            }
            let [a, b] = segments[index as usize];
            let point = closest_on_segment(p, a, b);
            let square = point.distance_squared(p);
            if square < best.0 {
                best = (square, point, index as usize);
                reach = square.sqrt() + ROUNDING * farthest;
                reach *= reach;
            }
        }
        best
    }

    fn candidates(&self, p: DVec2) -> &[u32] {
        let at = (p - self.origin) / self.step;
        if !(at.x >= 0.0 && at.y >= 0.0 && at.x < self.columns as f64 && at.y < self.rows as f64) {
            return &self.all;
        }
        let square = at.y as usize * self.columns + at.x as usize;
        let (from, to) = self.spans[square];
        &self.list[from as usize..to as usize]
    }
}

/// Measures the distance to a segment quickly, with rounding errors that the choice of candidates allows.
#[derive(Clone, Debug)]
struct Ruler {
    start: DVec2,
    along: DVec2,
    /// 1 over the segment's squared length; 0 if the segment is a point.
    per_square: f64,
}

impl Ruler {
    fn new(&[a, b]: &[DVec2; 2]) -> Self {
        let along = b - a;
        let square = along.length_squared();
        Self {
            start: a,
            along,
            per_square: if square > 0.0 { 1.0 / square } else { 0.0 },
        }
    }

    /// The squared distance from a place to the segment.
    #[inline]
    fn square_to(&self, p: DVec2) -> f64 {
        let way = p - self.start;
        let share = lesser(greater(way.dot(self.along) * self.per_square, 0.0), 1.0);
        way.distance_squared(self.along * share)
    }
}
