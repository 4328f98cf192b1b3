//! The convex hull of a few points (Andrew 1979, Another efficient algorithm for convex hulls in two dimensions).

use crate::order;
use crate::planar::orientation;
use glam::DVec2;
use smallvec::SmallVec;

/// A list of points; up to eight, as a block has, need no allocation.
pub(super) type Points = SmallVec<[DVec2; 8]>;

/// The corners of the hull, counter-clockwise. The first corner has the least s, and the least t among equal s.
pub(super) fn hull(points: &[DVec2]) -> Points {
    ring(points).unwrap_or_else(|| {
        let sorted = sorted(points);
        let mut corners = chain(sorted.iter().copied());
        corners.pop();
        corners.extend(chain(sorted.iter().rev().copied()));
        corners.pop();
        corners
    })
}

/// The short way for three or four points that already turn left at each corner: the same ring, from the corner where
/// [`hull`] begins. None for all other points.
fn ring(points: &[DVec2]) -> Option<Points> {
    let count = points.len();
    let turns = |k: usize| {
        let [a, b, c] = [k, k + 1, k + 2].map(|k| points[k % count]);
        orientation(a, b, c) > 0.0
    };
    // Five points that turn left may go round twice.
    if !matches!(count, 3 | 4) || !(0..count).all(turns) {
        return None;
    }
    let key = |k: &usize| (order::rank(points[*k].x), order::rank(points[*k].y));
    let first = (0..count).min_by_key(key)?;
    let corners = (first..first + count).map(|k| points[k % count]);
    Some(corners.collect())
}

/// Points sorted by s, then by t. There are few, so this is an insertion sort.
fn sorted(points: &[DVec2]) -> Points {
    let key = |p: &DVec2| (order::rank(p.x), order::rank(p.y));
    let mut sorted = Points::new();
    for p in points {
        let at = sorted.partition_point(|known| key(known) <= key(p));
        sorted.insert(at, *p);
    }
    sorted
}

/// The points of a sorted list at which its hull turns left, its ends included.
fn chain(points: impl Iterator<Item = DVec2>) -> Points {
    let mut chain = Points::new();
    for p in points {
        while let [.., a, b] = chain[..]
            && orientation(a, b, p) <= 0.0
        {
            chain.pop();
        }
        chain.push(p);
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    #[test]
    fn rings_begin_where_their_hull_does() {
        let mut random = Random::new(1, Purpose::Scatter, 0);
        let mut rings = 0;
        for k in 0..2000 {
            // Places of a small grid: many lie on one line, or on each other.
            let points: Vec<DVec2> = (0..3 + k % 3)
                .map(|_| DVec2::new(random.below(4) as f64, random.below(4) as f64 - 1.0))
                .collect();
            let known = sorted(&points);
            let mut wanted = chain(known.iter().copied());
            wanted.pop();
            wanted.extend(chain(known.iter().rev().copied()));
            wanted.pop();
            rings += usize::from(ring(&points).is_some());
            assert_eq!(hull(&points), wanted, "{points:?}");
        }
        assert!(rings > 100, "{rings}");
    }
}
