//! The segment nearest to a point, by a grid of those that can be it.

use glam::DVec2;

/// The point of the segment a to b nearest to p.
pub(crate) fn closest_on_segment(p: DVec2, a: DVec2, b: DVec2) -> DVec2 {
    let ab = b - a;
    let square = ab.length_squared();
    if square == 0.0 {
        return a;
    }
    let t = (p - a).dot(ab) / square;
    if t <= 0.0 {
        a
    } else if t >= 1.0 {
        b
    } else {
        a + ab * t
    }
}

/// For each square of a grid, the segments that can be the nearest to some point of it: those not
/// farther from its middle than the nearest one by more than the square's diagonal.
#[derive(Clone, Debug)]
pub(super) struct CandidateGrid {
    origin: DVec2,
    step: f64,
    columns: usize,
    rows: usize,
    start: Vec<u32>,
    list: Vec<u32>,
    all: Vec<u32>,
}

/// Squares along the longer side of the box around the outline.
const SQUARES: f64 = 64.0;
/// Squares along the side of a block, for which segments are sorted out first.
const BLOCK: usize = 8;

impl CandidateGrid {
    /// For segments that stay the same; there must be one.
    pub fn new(segments: &[[DVec2; 2]]) -> Self {
        let all: Vec<u32> = (0..segments.len() as u32).collect();
        let (lo, hi) = segments
            .iter()
            .flatten()
            .fold((segments[0][0], segments[0][0]), |(lo, hi), &p| {
                (lo.min(p), hi.max(p))
            });
        let step = (hi - lo).max_element() / SQUARES;
        // A margin of a few squares: the packing asks about points a little outside, too.
        let origin = lo - DVec2::splat(4.0 * step);
        let columns = ((hi.x - lo.x) / step) as usize + 9;
        let rows = ((hi.y - lo.y) / step) as usize + 9;
        let mut grid = Self {
            origin,
            step,
            columns,
            rows,
            start: vec![0],
            list: Vec::new(),
            all,
        };
        grid.fill(segments);
        grid
    }

    /// Blocks of squares first, so that each square tries few segments.
    fn fill(&mut self, segments: &[[DVec2; 2]]) {
        let mut lists = vec![Vec::new(); self.columns * self.rows];
        for top in (0..self.rows).step_by(BLOCK) {
            for left in (0..self.columns).step_by(BLOCK) {
                let corner = DVec2::new(left as f64, top as f64);
                let middle = self.origin + self.step * (corner + DVec2::splat(BLOCK as f64 / 2.0));
                let block = nearest_to(segments, &self.all, middle, BLOCK as f64 * self.step);
                for row in top..(top + BLOCK).min(self.rows) {
                    for column in left..(left + BLOCK).min(self.columns) {
                        let at = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                        let middle = self.origin + self.step * at;
                        lists[row * self.columns + column] =
                            nearest_to(segments, &block, middle, self.step);
                    }
                }
            }
        }
        for list in lists {
            self.list.extend(list);
            self.start.push(self.list.len() as u32);
        }
    }

    /// The squared distance, the place and the number of the segment nearest to a point.
    pub fn nearest(&self, segments: &[[DVec2; 2]], p: DVec2) -> (f64, DVec2, usize) {
        let mut best = (f64::INFINITY, p, 0);
        for &index in self.candidates(p) {
            let [a, b] = segments[index as usize];
            let point = closest_on_segment(p, a, b);
            let square = point.distance_squared(p);
            if square < best.0 {
                best = (square, point, index as usize);
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
        &self.list[self.start[square] as usize..self.start[square + 1] as usize]
    }
}

/// Those of the segments in `among` that can be the nearest to a point of a square with this middle
/// and side.
fn nearest_to(segments: &[[DVec2; 2]], among: &[u32], middle: DVec2, side: f64) -> Vec<u32> {
    let distance: Vec<f64> = among
        .iter()
        .map(|&i| {
            let [a, b] = segments[i as usize];
            closest_on_segment(middle, a, b).distance(middle)
        })
        .collect();
    let least = distance.iter().fold(f64::INFINITY, |m, &d| m.min(d));
    // From the middle to a corner and back is a diagonal.
    let reach = least + 1.415 * side;
    let near = among.iter().zip(distance).filter(|&(_, d)| d <= reach);
    near.map(|(&i, _)| i).collect()
}
