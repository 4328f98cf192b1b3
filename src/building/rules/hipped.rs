//! Hipped roofs over convex plans: all slopes rise at one pitch from level eaves.

use super::plain::sides;
use glam::DVec2;

/// Ends of ridges and hips that are nearer than this are one (metres).
const SAME: f64 = 4e-4;

/// A corner of a slope in plan, and how far it is from its eave (metres).
pub(super) type SlopeCorner = (DVec2, f64);

/// The slopes over a convex plan that is counter-clockwise seen from above, one for each side. A slope covers the part
/// of the plan that is nearest to its side.
pub(super) fn slopes(plan: &[DVec2]) -> Vec<Vec<SlopeCorner>> {
    let eaves: Vec<[DVec2; 2]> = sides(plan).map(|[a, b]| [a, (b - a).normalize()]).collect();
    let off = |[from, way]: [DVec2; 2], p: DVec2| way.perp_dot(p - from);
    let mut kept: Vec<DVec2> = Vec::new();
    let slope = |own: &[DVec2; 2]| {
        let others = eaves.iter().filter(|other| *other != own);
        let ring = others.fold(plan.to_vec(), |ring, other| {
            below(&ring, |p| off(*own, p) - off(*other, p))
        });
        let mut ring: Vec<DVec2> = ring.iter().map(|&p| same(&mut kept, p)).collect();
        ring.dedup();
        if ring.first() == ring.last() {
            ring.pop();
        }
        ring.iter().map(|&p| (p, off(*own, p))).collect()
    };
    eaves.iter().map(slope).collect()
}

/// The part of a convex ring where a linear function is not above 0.
fn below(ring: &[DVec2], value: impl Fn(DVec2) -> f64) -> Vec<DVec2> {
    let mut part = Vec::new();
    for [a, b] in sides(ring) {
        let [from, to] = [a, b].map(&value);
        if from <= 0.0 {
            part.push(a);
        }
        if (from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0) {
            part.push(a.lerp(b, from / (from - to)));
        }
    }
    part
}

/// The first known place within [`SAME`] of this one; if there is none, this one, which is added.
fn same(kept: &mut Vec<DVec2>, p: DVec2) -> DVec2 {
    let known = kept.iter().find(|known| known.distance(p) < SAME).copied();
    known.unwrap_or_else(|| {
        kept.push(p);
        p
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::signed_area;

    /// The slopes cover the plan once, share their corners, and a slope's corners lie as high as those of its neighbours.
    #[test]
    fn slopes_cover_a_plan_once() {
        let shapes = [
            vec![(0.0, 0.0), (4.0, 0.0), (4.0, 2.5), (0.0, 2.5)],
            vec![(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)],
            vec![(0.0, 0.0), (5.0, 0.0), (6.0, 2.0), (4.0, 4.0), (1.0, 3.5)],
            vec![(0.0, 0.0), (5.0, 0.0), (1.0, 4.0)],
        ];
        for shape in shapes {
            let plan: Vec<DVec2> = shape.into_iter().map(DVec2::from).collect();
            let slopes = slopes(&plan);
            let rings = slopes
                .iter()
                .map(|slope| slope.iter().map(|corner| corner.0));
            let areas = rings.map(|ring| signed_area(&ring.collect::<Vec<DVec2>>()));
            assert!((areas.sum::<f64>() - signed_area(&plan)).abs() < 1e-9);
            let corners: Vec<&SlopeCorner> = slopes.iter().flatten().collect();
            for (p, off) in &corners {
                let here: Vec<_> = corners.iter().filter(|other| other.0 == *p).collect();
                let least = if *off < 1e-9 { 2 } else { 3 };
                assert!(here.len() >= least, "{p}");
                assert!(here.iter().all(|other| (other.1 - off).abs() < 1e-9));
            }
        }
    }
}
