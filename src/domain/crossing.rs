//! Finds whether rings meet themselves or each other. The test is exact and uses a grid of the segments'
//! boxes.

use super::ring::bounds;
use crate::planar::orientation;
use glam::DVec2;

/// A forbidden contact of rings; numbers are positions among all rings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// A ring meets itself.
    Within(usize, DVec2),
    /// Two rings meet; the lower number comes first.
    Between(usize, usize, DVec2),
}

/// One side of a ring.
#[derive(Clone, Copy)]
struct RingSide {
    a: DVec2,
    b: DVec2,
    ring: usize,
    /// Numbers of the segments that share its ends.
    neighbours: [usize; 2],
}

impl RingSide {
    fn low(&self) -> DVec2 {
        self.a.min(self.b)
    }

    fn high(&self) -> DVec2 {
        self.a.max(self.b)
    }
}

/// A place where two segments that are not neighbours meet, if there is one. Neighbours must not fold back on
/// each other.
pub fn first_contact(rings: &[Vec<DVec2>]) -> Option<Contact> {
    let segments = segments(rings);
    let mut grid = SegmentBins::new(&segments);
    // Segments enter the grid one by one, so each is tested against the earlier ones only.
    for (index, segment) in segments.iter().enumerate() {
        let mut found = None;
        grid.each_square(segment, |square| {
            if found.is_none() {
                found = square
                    .iter()
                    .filter(|&&other| !segment.neighbours.contains(&(other as usize)))
                    .map(|&other| &segments[other as usize])
                    .find_map(|other| meet(segment, other).map(|p| (other.ring, p)));
                square.push(index as u32);
            }
        });
        if let Some((ring, p)) = found {
            return Some(if ring == segment.ring {
                Contact::Within(ring, p)
            } else {
                Contact::Between(ring, segment.ring, p)
            });
        }
    }
    None
}

fn segments(rings: &[Vec<DVec2>]) -> Vec<RingSide> {
    let mut segments = Vec::new();
    for (index, ring) in rings.iter().enumerate() {
        let (first, n) = (segments.len(), ring.len());
        segments.extend((0..n).map(|k| RingSide {
            a: ring[k],
            b: ring[(k + 1) % n],
            ring: index,
            neighbours: [first + (k + n - 1) % n, first + (k + 1) % n],
        }));
    }
    segments
}

/// Squares with the numbers of the segments that pass through them.
struct SegmentBins {
    origin: DVec2,
    step: f64,
    columns: usize,
    squares: Vec<Vec<u32>>,
}

impl SegmentBins {
    fn new(segments: &[RingSide]) -> Self {
        let ends: Vec<DVec2> = segments.iter().map(|s| s.a).collect();
        let (low, high) = bounds(&ends);
        // About one square for each segment: short segments then share a square with few others.
        let along = (segments.len() as f64).sqrt().ceil();
        let step = (high - low).max_element() / along;
        let columns = ((high.x - low.x) / step) as usize + 1;
        let rows = ((high.y - low.y) / step) as usize + 1;
        Self {
            origin: low,
            step,
            columns,
            squares: vec![Vec::new(); columns * rows],
        }
    }

    fn index(&self, x: f64) -> usize {
        (x / self.step) as usize
    }

    /// Visits the squares that the segment passes, row by row, and a few more where rounding leaves doubt.
    fn each_square(&mut self, segment: &RingSide, mut visit: impl FnMut(&mut Vec<u32>)) {
        let (low, high) = (segment.low() - self.origin, segment.high() - self.origin);
        let (a, along) = (segment.a - self.origin, segment.b - segment.a);
        let rows = self.squares.len() / self.columns;
        let doubt = 1e-6 * self.step;
        for row in self.index(low.y)..=self.index(high.y).min(rows - 1) {
            // The part of the segment between the row's upper and lower border.
            let (mut left, mut right) = (low.x, high.x);
            if along.y != 0.0 {
                let x = |y: f64| a.x + (y - a.y) / along.y * along.x;
                let (upper, lower) = (
                    x((row as f64 * self.step).max(low.y)),
                    x(((row + 1) as f64 * self.step).min(high.y)),
                );
                left = left.max(upper.min(lower) - doubt);
                right = right.min(upper.max(lower) + doubt);
            }
            let last = self.index(right).min(self.columns - 1);
            for column in self.index(left).min(last)..=last {
                visit(&mut self.squares[row * self.columns + column]);
            }
        }
    }
}

/// A common point of two segments, if any. Its existence is exact, its place rounded.
fn meet(s: &RingSide, t: &RingSide) -> Option<DVec2> {
    if s.low().cmpgt(t.high()).any() || t.low().cmpgt(s.high()).any() {
        return None;
    }
    let (sa, sb) = (orientation(t.a, t.b, s.a), orientation(t.a, t.b, s.b));
    let (ta, tb) = (orientation(s.a, s.b, t.a), orientation(s.a, s.b, t.b));
    let apart = |u: f64, v: f64| (u > 0.0 && v > 0.0) || (u < 0.0 && v < 0.0);
    if apart(sa, sb) || apart(ta, tb) {
        return None;
    }
    if sa == 0.0 && sb == 0.0 {
        // The segments are collinear and their boxes overlap, so an end of one lies on the other.
        let on_both = |p: &DVec2| {
            let within = |s: &RingSide| p.cmpge(s.low()).all() && p.cmple(s.high()).all();
            within(s) && within(t)
        };
        return [s.a, s.b, t.a, t.b].into_iter().find(on_both);
    }
    Some(s.a + (s.b - s.a) * (sa / (sa - sb)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// All pairs of segments, without the grid.
    fn any_pair_meets(rings: &[Vec<DVec2>]) -> bool {
        let segments = segments(rings);
        (0..segments.len()).any(|i| {
            (0..i).any(|j| {
                let neighbours = segments[i].neighbours.contains(&j);
                !neighbours && meet(&segments[i], &segments[j]).is_some()
            })
        })
    }

    #[test]
    fn the_place_lies_on_both_segments() {
        let p = |x: f64, y: f64| DVec2::new(x, y);
        let bow = vec![p(0., 0.), p(4., 4.), p(4., 0.), p(0., 4.)];
        assert_eq!(first_contact(&[bow]), Some(Contact::Within(0, p(2., 2.))));
        // Collinear on a falling line, one segment within the other.
        let outer = vec![p(0., 9.), p(9., 0.), p(20., 20.)];
        let other = vec![p(3., 6.), p(5., 4.), p(4., 0.)];
        let Some(Contact::Between(0, 1, place)) = first_contact(&[outer, other]) else {
            panic!("no contact");
        };
        assert_eq!(place.x + place.y, 9.0);
    }

    proptest! {
        #[test]
        fn the_grid_finds_what_all_pairs_find(
            coarse in prop::collection::vec((0..12u8, 0..12u8), 3..14),
            fine in prop::collection::vec((0.0..12.0f64, 0.0..12.0f64), 3..14),
        ) {
            let whole = |&(x, y): &(u8, u8)| DVec2::new(x.into(), y.into());
            let coarse: Vec<DVec2> = coarse.iter().map(whole).collect();
            let fine: Vec<DVec2> = fine.into_iter().map(DVec2::from).collect();
            // The points must not all coincide: the check has already dropped repeated points.
            prop_assume!(coarse.iter().any(|&p| p != coarse[0]));
            let cases: [Vec<Vec<DVec2>>; 3] =
                [vec![coarse.clone()], vec![fine.clone()], vec![coarse, fine]];
            for rings in cases {
                prop_assert_eq!(first_contact(&rings).is_some(), any_pair_meets(&rings));
            }
        }
    }
}
