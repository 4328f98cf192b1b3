//! Rounds lines that cross to pieces that meet only in their ends, on grid points.
//!
//! The method is snap rounding by hot pixels (Hobby 1999, Practical segment intersection with finite
//! precision output; Guibas, Marimont 1998). Every end and every crossing, rounded to the grain, makes the
//! grid square around it hot, and each line goes through the centres of all hot squares that it passes. The
//! passing test is exact. So no two new lines cross or overlap except in shared ends, none is farther from
//! its line than one step of the grain, and images a whole number of steps apart are rounded alike.
//!
//! All crossings are found before anything is triangulated. spade never has to split a constraint, because it
//! would round the new point in its own way.

use super::rtree::RTree;
use super::{GRAIN, orientation};
use crate::order;
use glam::DVec2;

/// Points and the pieces between them; the pieces of one line follow each other.
pub(super) struct Snapped {
    /// Distinct points: first the ends of the lines, in order, then the crossings.
    pub points: Vec<DVec2>,
    /// Each piece: the number of its line, and the numbers of its two points. A piece is listed once for each line that
    /// runs along it.
    pub pieces: Vec<(u32, [u32; 2])>,
}

/// Rounds lines whose ends are on the grain.
pub(super) fn snap(lines: &[[DVec2; 2]]) -> Snapped {
    let tree = RTree::new(lines);
    let mut places: Vec<DVec2> = lines.iter().flatten().copied().collect();
    places.extend(crossings(lines, &tree));
    let points = distinct(&places);
    // The line, the distance along it, and the point.
    let mut passed: Vec<(u32, f64, u32)> = Vec::new();
    let mut near = Vec::new();
    for (&p, number) in points.iter().zip(0..) {
        tree.near(p - HALF, p + HALF, &mut near);
        for &k in near.iter().filter(|&&k| passes(lines[k as usize], p)) {
            // The sum of both coordinate distances from the start orders the squares: neither distance falls along the
            // line, and at least one grows.
            let along = (p - lines[k as usize][0]).abs().element_sum();
            passed.push((k, along, number));
        }
    }
    order::sort(&mut passed, |p| (p.0.into(), order::rank(p.1)));
    let pairs = passed.windows(2).filter(|w| w[0].0 == w[1].0);
    let pieces = pairs.map(|w| (w[0].0, [w[0].2, w[1].2])).collect();
    Snapped { points, pieces }
}

const HALF: DVec2 = DVec2::splat(GRAIN / 2.0);

/// Whether a line between grid points passes the grid square around a point. The left and upper sides belong to the
/// square, except their ends at the lower left and the upper right corner.
fn passes([a, b]: [DVec2; 2], p: DVec2) -> bool {
    let (lo, hi) = (p - HALF, p + HALF);
    // The line's ends are grid points, and no side contains one. So the boxes share more than a side, or nothing.
    if a.max(b).cmplt(lo).any() || a.min(b).cmpgt(hi).any() {
        return false;
    }
    let corners = [lo, DVec2::new(hi.x, lo.y), hi, DVec2::new(lo.x, hi.y)];
    let sides = corners.map(|corner| orientation(a, b, corner));
    let (left, right) = (
        sides.iter().any(|&s| s > 0.0),
        sides.iter().any(|&s| s < 0.0),
    );
    // A line that only touches the square does so in a corner: a line along a side would end inside that
    // side.
    (left && right) || sides[0] == 0.0
}

/// The crossings of lines, rounded to the grain, without those in an end of one of the lines.
fn crossings(lines: &[[DVec2; 2]], tree: &RTree) -> Vec<DVec2> {
    let mut places = Vec::new();
    let mut near = Vec::new();
    for (k, &[a, b]) in lines.iter().enumerate() {
        tree.near(a.min(b), a.max(b), &mut near);
        let others = near.iter().map(|&j| j as usize).filter(|&j| j < k);
        places.extend(others.filter_map(|j| crossing([a, b], lines[j])));
    }
    order::sort(&mut places, |p| (order::rank(p.y), order::rank(p.x)));
    places
}

/// The grid point nearest to the crossing of two lines.
fn crossing([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<DVec2> {
    let apart = |a, b, c, d| orientation(a, b, c) * orientation(a, b, d) < 0.0;
    if !apart(a, b, c, d) || !apart(c, d, a, b) {
        return None;
    }
    let whole = |x: f64| (x / GRAIN) as i128;
    let [u, v, w] = [b - a, d - c, c - a].map(|p| (whole(p.x), whole(p.y)));
    let (mut part, mut all) = (w.0 * v.1 - w.1 * v.0, u.0 * v.1 - u.1 * v.0);
    if all < 0 {
        (part, all) = (-part, -all);
    }
    // The nearest whole number, halves up.
    let step = |u: i128| (2 * u * part + all).div_euclid(2 * all) as f64 * GRAIN;
    Some(a + DVec2::new(step(u.0), step(u.1)))
}

/// The points without duplicates, in order of first occurrence.
fn distinct(places: &[DVec2]) -> Vec<DVec2> {
    let mut sorted: Vec<u32> = (0..places.len() as u32).collect();
    let at = |k: u32| places[k as usize];
    order::sort(&mut sorted, |&k| {
        (order::rank(at(k).x), order::rank(at(k).y))
    });
    // Keeps the first of equal points.
    sorted.dedup_by(|next, first| at(*next) == at(*first));
    order::sort(&mut sorted, |&k| (k.into(), 0));
    sorted.into_iter().map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Space;
    use super::super::closest_on_segment;
    use super::*;
    use proptest::prelude::*;

    type Lines = Vec<[DVec2; 2]>;

    fn point(x: i64, y: i64) -> DVec2 {
        DVec2::new(x as f64, y as f64) * GRAIN
    }

    /// Lines of a few grid steps, where nearly everything meets; in bundles that are nearly one line; across
    /// pictures; and far out.
    fn lines() -> impl Strategy<Value = Lines> {
        let places = |x: i64, y: i64| (-x..=x, -y..=y).prop_map(|(x, y)| point(x, y)).boxed();
        let place = prop_oneof![
            4 => places(6, 6),
            3 => places(2000, 3),
            3 => places(1 << 25, 2),
            2 => places(1 << 12, 1 << 12),
            1 => places(1 << 25, 1 << 25),
            1 => places(1 << 39, 1 << 39),
        ];
        let line = (place.clone(), place).prop_map(|(a, b)| [a, b]);
        prop::collection::vec(line, 1..24)
    }

    /// Whether two pieces share more than an end of both.
    fn clash([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
        let within = |p: DVec2, a: DVec2, b: DVec2| {
            let boxed = p.cmpge(a.min(b)).all() && p.cmple(a.max(b)).all();
            p != a && p != b && boxed && orientation(a, b, p) == 0.0
        };
        let apart = |a, b, c, d| orientation(a, b, c) * orientation(a, b, d) < 0.0;
        (apart(a, b, c, d) && apart(c, d, a, b))
            || within(a, c, d)
            || within(b, c, d)
            || within(c, a, b)
            || within(d, a, b)
    }

    fn pieces(lines: &[[DVec2; 2]]) -> Lines {
        let Snapped { points, pieces } = snap(lines);
        let ends = |(_, piece): (u32, [u32; 2])| piece.map(|k| points[k as usize]);
        pieces.into_iter().map(ends).collect()
    }

    /// The pieces as a set: without directions and duplicates.
    fn as_set(pieces: &[[DVec2; 2]]) -> Vec<[(i64, i64); 2]> {
        let whole = |p: DVec2| ((p.x / GRAIN) as i64, (p.y / GRAIN) as i64);
        let mut set: Vec<[(i64, i64); 2]> = pieces.iter().map(|p| p.map(whole)).collect();
        set.iter_mut().for_each(|ends| ends.sort());
        set.sort();
        set.dedup();
        set
    }

    /// The runs of pieces of each line, in the order of the lines.
    fn runs(lines: &[[DVec2; 2]]) -> Vec<Lines> {
        let mut left = pieces(lines).into_iter();
        let mut runs = Vec::new();
        for &[a, b] in lines {
            let (mut at, mut run) = (a, Vec::new());
            while at != b {
                let piece = left.next().expect("the line ends early");
                assert_eq!(piece[0], at);
                at = piece[1];
                run.push(piece);
            }
            runs.push(run);
        }
        assert_eq!(left.next(), None);
        runs
    }

    #[test]
    fn lines_through_one_square_of_the_grain_meet_in_its_middle() {
        // The first two cross at (3.5, 0.5): halves go up. The first passes the other's start, too.
        let cross = [[point(0, 0), point(7, 1)], [point(3, 0), point(4, 1)]];
        let past = [point(4, -9), point(4, 9)];
        let all = as_set(&pieces(&[cross[0], cross[1], past]));
        let way = [(0, 0), (3, 0), (4, 1), (7, 1)];
        assert!(way.windows(2).all(|w| all.contains(&[w[0], w[1]])));
        assert!(all.contains(&[(4, -9), (4, 1)]) && all.contains(&[(4, 1), (4, 9)]));
        assert_eq!(all.len(), 5);
    }

    #[test]
    fn a_line_through_an_end_of_another_is_divided_there() {
        let all = pieces(&[[point(0, 0), point(9, 3)], [point(6, 2), point(0, 9)]]);
        assert_eq!(all.len(), 3);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if cfg!(target_arch = "wasm32") { 64 } else { 1024 }))]

        #[test]
        fn no_two_pieces_cross_or_overlap(lines in lines()) {
            let set = pieces(&lines);
            for (k, &piece) in set.iter().enumerate() {
                for &other in &set[..k] {
                    prop_assert!(!clash(piece, other), "{piece:?} {other:?} of {lines:?}");
                }
            }
        }

        #[test]
        fn each_line_goes_from_end_to_end_and_stays_within_a_step(lines in lines()) {
            for (&[a, b], run) in lines.iter().zip(runs(&lines)) {
                for [p, q] in run {
                    for r in [p, p.midpoint(q), q] {
                        let off = (r - closest_on_segment(r, a, b)).length() / GRAIN;
                        // The error of the measurement itself grows with the line.
                        prop_assert!(off < 0.708 + 1e-15 * a.distance(b) / GRAIN, "{off}");
                    }
                }
            }
        }

        #[test]
        fn order_and_direction_do_not_matter(lines in lines()) {
            let mut turned: Lines = lines.iter().map(|&[a, b]| [b, a]).collect();
            turned.reverse();
            prop_assert_eq!(as_set(&pieces(&lines)), as_set(&pieces(&turned)));
        }

        #[test]
        fn images_are_rounded_alike(lines in lines(), x in -3i64..3, y in -3i64..3) {
            let by = point(x << 20, y << 20);
            let moved: Lines = lines.iter().map(|l| l.map(|p| p + by)).collect();
            let back: Lines = pieces(&moved).iter().map(|l| l.map(|p| p - by)).collect();
            prop_assert_eq!(pieces(&lines), back);
        }

        #[test]
        fn on_a_torus_each_picture_is_like_the_next(
            ends in prop::collection::vec((0..64i64, 0..64i64, -32..32i64, -32..32i64), 1..6),
        ) {
            let side = 64.0 * GRAIN;
            let line = |(x, y, u, v)| [point(x, y), point(x + u, y + v)];
            let lines: Lines = ends.into_iter().map(line).collect();
            let torus = Space::torus(side);
            let images: Lines = torus.repeated(&lines, 2).collect();
            let runs = runs(&images);
            for (run, by) in runs.chunks(lines.len()).zip(torus.shifts(2)) {
                if by.abs().max_element() <= side {
                    for (home, image) in runs.iter().zip(run) {
                        let moved: Lines = home.iter().map(|l| l.map(|p| p + by)).collect();
                        prop_assert_eq!(&moved, image);
                    }
                }
            }
        }

        #[test]
        fn the_tree_finds_every_segment_that_comes_near(
            lines in lines(), x in -9i64..9, y in -9i64..9, width in 0i64..99, height in 0i64..99,
        ) {
            let (lo, hi) = (point(x, y), point(x + width, y + height));
            let mut found = Vec::new();
            RTree::new(&lines).near(lo, hi, &mut found);
            found.sort();
            let near = |&k: &u32| {
                let [a, b] = lines[k as usize];
                a.min(b).cmple(hi).all() && a.max(b).cmpge(lo).all()
            };
            let wanted: Vec<u32> = (0..lines.len() as u32).filter(near).collect();
            prop_assert_eq!(found, wanted);
        }
    }
}
