//! Clips cells against what is occupied, so that they stay convex and overlap nothing.
//!
//! Legakis, Dorsey, Gortler (2001), section 5.1, clip the footprint of a cell against the occupancy map. Here
//! obstacles are exact convex polygons. Each of them cuts the cell along one of its own sides.

use super::footprint::{Footprint, HalfPlane};
use crate::order;
use glam::DVec2;
use std::borrow::Borrow;

/// Overlaps up to this area do not count (square metres).
pub const TOUCH: f64 = 1e-8;
/// Pieces below this share of their cell are dropped.
pub const LEAST_SHARE: f64 = 0.06;
/// How far beyond a side of an obstacle another one is looked for (metres).
const BEYOND: f64 = 1e-3;
/// The usual depth to which [`clip_multi`] splits the halves that its cuts remove.
pub const MOST_DEPTH: u32 = 3;

/// The largest part of a cell that overlaps no obstacle, as cuts along single sides of the obstacles leave it. None if
/// it is below `least` of the cell (a share, usually [`LEAST_SHARE`]). New sides get the inset `inset` (metres).
///
/// Each obstacle cuts along the side that leaves most of the cell. Each obstacle is tried as the first to cut; the
/// others follow by falling overlap. Beside an arch the first cut is the only one, so the choice of the first obstacle
/// decides.
pub fn clip(
    cell: &Footprint,
    obstacles: &[impl Borrow<Footprint>],
    inset: f64,
    least: f64,
) -> Option<Footprint> {
    let near = by_overlap(cell, obstacles);
    clip_at(cell, &near, inset, (least, CutSides::All))
}

/// As [`clip`], but cuts go along sides of obstacles that border free space, if such a side leaves enough. So no brick
/// beside an arch is cut along a joint between two stones of that arch, which would spoil its bed.
pub fn clip_at_borders(
    cell: &Footprint,
    obstacles: &[impl Borrow<Footprint>],
    inset: f64,
    least: f64,
) -> Option<Footprint> {
    let near = by_overlap(cell, obstacles);
    clip_at(cell, &near, inset, (least, CutSides::Borders(&near)))
}

/// The sides of obstacles that may cut.
#[derive(Clone, Copy)]
enum CutSides<'a> {
    All,
    /// Those beyond which none of these obstacles lies.
    Borders(&'a [&'a Footprint]),
}

impl CutSides<'_> {
    /// Whether a side of an obstacle with this half-plane may cut a part.
    fn has(&self, part: &Footprint, ends: [DVec2; 2], half: &HalfPlane) -> bool {
        let Self::Borders(obstacles) = self else {
            return true;
        };
        let middle = middle_within(part, ends);
        middle.is_some_and(|middle| {
            let beyond = middle - half.normal * BEYOND;
            !obstacles.iter().any(|obstacle| obstacle.contains(beyond))
        })
    }
}

fn clip_at(
    cell: &Footprint,
    near: &[&Footprint],
    inset: f64,
    (least, sides): (f64, CutSides),
) -> Option<Footprint> {
    let least = least * cell.area();
    if near.is_empty() {
        return Some(cell.clone());
    }
    let mut best: Option<Footprint> = None;
    let mut most = least;
    for first in 0..near.len() {
        let rest = near.iter().enumerate().filter(|(k, _)| *k != first);
        let order = [near[first]]
            .into_iter()
            .chain(rest.map(|(_, &obstacle)| obstacle));
        if let Some((area, part)) = cut_by(cell, order, inset, (least, most), sides) {
            (most, best) = (area, Some(part));
        }
    }
    best
}

/// A cell cut by one obstacle after the other, and its area; none once no more than `most` of it is left. `least` is that
/// of [`best_side`] (square metres both).
fn cut_by<'a>(
    cell: &Footprint,
    obstacles: impl Iterator<Item = &'a Footprint>,
    inset: f64,
    (least, most): (f64, f64),
    sides: CutSides,
) -> Option<(f64, Footprint)> {
    let (mut area, mut part) = (cell.area(), cell.clone());
    for obstacle in obstacles {
        if part.shared_area(obstacle) > TOUCH {
            let half = best_side(&part, obstacle, (least, sides));
            part = part.clip(half, inset)?;
            area = part.area();
            // Later cuts only take more away.
            if area <= most {
                return None;
            }
        }
    }
    Some((area, part))
}

/// The parts of a cell that overlap no obstacle. Cuts are those of [`clip`], but the halves that they remove are split
/// as well, to a depth of `depth`. Parts below `least` of the cell (a share) are dropped.
pub fn clip_multi(
    cell: &Footprint,
    obstacles: &[impl Borrow<Footprint>],
    inset: f64,
    (least, depth): (f64, u32),
) -> Vec<Footprint> {
    let mut found = Vec::new();
    let near: Vec<&Footprint> = by_overlap(cell, obstacles);
    split(
        cell.clone(),
        &near,
        inset,
        (least * cell.area(), depth),
        &mut found,
    );
    found
}

fn split(
    mut part: Footprint,
    obstacles: &[&Footprint],
    inset: f64,
    (least, depth): (f64, u32),
    found: &mut Vec<Footprint>,
) {
    for (k, obstacle) in obstacles.iter().enumerate() {
        if part.shared_area(obstacle) <= TOUCH {
            continue;
        }
        let half = best_side(&part, obstacle, (least, CutSides::All));
        let is_large = |part: &Footprint| part.area() > least;
        if depth > 0
            && let Some(rest) = part.clip(half.opposite(), inset).filter(is_large)
        {
            split(rest, &obstacles[k..], inset, (least, depth - 1), found);
        }
        match part.clip(half, inset).filter(is_large) {
            Some(left) => part = left,
            None => return,
        }
    }
    found.push(part);
}

/// All of a polygon that no obstacle covers, as convex polygons without overlaps.
pub fn remainder(polygon: &Footprint, obstacles: &[impl Borrow<Footprint>]) -> Vec<Footprint> {
    let mut parts = vec![polygon.clone()];
    for obstacle in obstacles.iter().map(Borrow::borrow) {
        if !parts.iter().all(|part| part.is_apart(obstacle)) {
            parts = parts
                .iter()
                .flat_map(|part| without(part, obstacle))
                .collect();
        }
    }
    parts
}

/// A polygon without an obstacle: each side of the obstacle cuts off one part. The rest after the last cut is the area
/// that both share. If that is empty, the polygon stays whole.
fn without(polygon: &Footprint, obstacle: &Footprint) -> Vec<Footprint> {
    if polygon.is_apart(obstacle) {
        return vec![polygon.clone()];
    }
    let mut parts = Vec::new();
    let mut rest = Some(polygon.clone());
    for half in obstacle.half_planes() {
        let Some(inner) = rest else { break };
        parts.extend(inner.clip(half.opposite(), 0.0));
        rest = inner.clip(half, 0.0);
    }
    // Two rectangles that are not apart do overlap, even if their common part is too small to count.
    let are_rectangles = polygon.is_rectangle() && obstacle.is_rectangle();
    match rest {
        None if !are_rectangles => vec![polygon.clone()],
        _ => parts,
    }
}

/// The obstacles that overlap a cell, by falling overlap; the first of equal ones stays first.
fn by_overlap<'a>(cell: &Footprint, obstacles: &'a [impl Borrow<Footprint>]) -> Vec<&'a Footprint> {
    let shares = obstacles.iter().map(|obstacle| {
        let obstacle = obstacle.borrow();
        (cell.shared_area(obstacle), obstacle)
    });
    let mut found: Vec<(f64, &Footprint)> = shares.filter(|&(area, _)| area > TOUCH).collect();
    order::sort(&mut found, |&(area, _)| (!order::rank(area), 0));
    found.into_iter().map(|(_, obstacle)| obstacle).collect()
}

/// The middle of the part of a line that lies inside or on the border of a polygon; none if that is shorter than 1 mm.
fn middle_within(polygon: &Footprint, [a, b]: [DVec2; 2]) -> Option<DVec2> {
    let mut span = [0.0f64, 1.0];
    for half in polygon.half_planes() {
        let [from, to] = [a, b].map(|p| half.distance(p));
        if from.max(to) < 0.0 {
            return None;
        }
        let at = from / (from - to);
        if from < 0.0 {
            span[0] = span[0].max(at);
        } else if to < 0.0 {
            span[1] = span[1].min(at);
        }
    }
    let is_long = (span[1] - span[0]) * a.distance(b) > BEYOND;
    is_long.then(|| a.lerp(b, 0.5 * (span[0] + span[1])))
}

/// The half-plane beyond the side of an obstacle that leaves most of a part; the first of equal sides. If the sides that
/// may cut leave no more than `least` (square metres), any side may.
fn best_side(part: &Footprint, obstacle: &Footprint, (least, sides): (f64, CutSides)) -> HalfPlane {
    let best = |sides: CutSides| {
        let halves = (0..obstacle.corners().len()).filter_map(|k| {
            let ends = obstacle.side(k);
            let half = HalfPlane::left_of(ends[0], ends[1]);
            sides.has(part, ends, &half).then(|| half.opposite())
        });
        let sized = halves.map(|half| (part.area_in(half), half));
        sized.reduce(|best, next| if next.0 > best.0 { next } else { best })
    };
    let found = best(sides).filter(|&(area, _)| area > least);
    let found = found.or_else(|| best(CutSides::All));
    found.expect("a polygon has sides").1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    fn rectangle(low: (f64, f64), high: (f64, f64)) -> Footprint {
        Footprint::rectangle(low.into(), high.into()).unwrap()
    }

    fn triangle(random: &mut Random) -> Footprint {
        loop {
            let corners = [0; 3].map(|_| DVec2::new(random.unit(), random.unit()));
            if let Ok(found) = Footprint::new(&corners) {
                return found;
            }
        }
    }

    #[test]
    fn parts_overlap_neither_obstacles_nor_each_other() {
        let mut random = Random::new(1, Purpose::Scatter, 0);
        let cell = rectangle((0.0, 0.0), (1.0, 1.0));
        for _ in 0..200 {
            let obstacles = [0; 3].map(|_| triangle(&mut random));
            let one = clip(&cell, &obstacles, 0.0, LEAST_SHARE);
            let many = clip_multi(&cell, &obstacles, 0.0, (LEAST_SHARE, MOST_DEPTH));
            let all = remainder(&cell, &obstacles);
            for (k, part) in many.iter().chain(&one).enumerate() {
                assert!(part.area() >= LEAST_SHARE);
                let worst = obstacles
                    .iter()
                    .map(|o| o.shared_area(part))
                    .fold(0.0, f64::max);
                assert!(worst <= 2.0 * TOUCH, "{worst}");
                let others = many.iter().take(k.min(many.len()));
                assert!(k == many.len() || others.map(|o| o.shared_area(part)).sum::<f64>() < 1e-9);
            }
            let area = |parts: &[Footprint]| parts.iter().map(Footprint::area).sum::<f64>();
            let first = one.as_ref().map_or(0.0, Footprint::area);
            assert!(area(&many) >= first - 1e-9 && area(&all) >= area(&many) - 1e-6);
        }
    }

    #[test]
    fn what_is_left_and_what_is_covered_make_the_whole() {
        let mut random = Random::new(2, Purpose::Scatter, 0);
        let cell = rectangle((0.2, 0.1), (0.9, 0.8));
        for _ in 0..200 {
            let obstacle = triangle(&mut random);
            let left: f64 = remainder(&cell, std::slice::from_ref(&obstacle))
                .iter()
                .map(Footprint::area)
                .sum();
            assert!((left + cell.shared_area(&obstacle) - cell.area()).abs() < 1e-9);
        }
    }

    #[test]
    fn a_hole_in_the_middle_leaves_one_half_or_all_four_sides() {
        let cell = rectangle((0.0, 0.0), (1.0, 1.0));
        let hole = [rectangle((0.4, 0.4), (0.6, 0.6))];
        let one = clip(&cell, &hole, 0.01, LEAST_SHARE).unwrap();
        assert!((one.area() - 0.4).abs() < 1e-12);
        assert!(one.corners().iter().any(|corner| corner.inset == 0.01));
        let many = clip_multi(&cell, &hole, 0.0, (LEAST_SHARE, MOST_DEPTH));
        let sum: f64 = many.iter().map(Footprint::area).sum();
        assert_eq!(many.len(), 4);
        assert!((sum - 0.96).abs() < 1e-9, "{sum}");
        assert_eq!(
            clip(
                &cell,
                &[rectangle((-1.0, -1.0), (2.0, 0.97))],
                0.0,
                LEAST_SHARE
            ),
            None
        );
    }

    #[test]
    fn a_brick_is_not_cut_along_a_joint_between_two_obstacles() {
        let cell = rectangle((0.0, 0.0), (1.0, 0.3));
        let arch = [
            rectangle((0.3, -0.1), (1.2, 0.15)),
            rectangle((0.35, 0.15), (1.3, 0.4)),
        ];
        // The joint leaves most of the brick, but only the upper half of its bed.
        let any = clip(&cell, &arch, 0.0, LEAST_SHARE).unwrap();
        assert!((any.area() - 0.35 * 0.15).abs() < 1e-9);
        let border = clip_at_borders(&cell, &arch, 0.0, LEAST_SHARE).unwrap();
        assert!((border.area() - 0.3 * 0.3).abs() < 1e-9);
        // If no other side leaves enough, the joint does.
        let arch = [
            rectangle((-0.1, -0.1), (1.2, 0.15)),
            rectangle((0.35, 0.15), (1.3, 0.4)),
        ];
        let last = clip_at_borders(&cell, &arch, 0.0, LEAST_SHARE).unwrap();
        assert!((last.area() - 0.35 * 0.15).abs() < 1e-9);
    }
}
