//! Mesh elements that a constraint line divides: each side of the line sees them as its own.
//!
//! Cells on the two sides of a line are packed each against the line and need not face each other.
//! Seen from its own side an element ends at the line, as if the cells were mirrored through it: its
//! middle is the foot of the middle of the cells there. At the free end of a line, where cells see
//! each other around it, all share the end.

use crate::domain::Domain;
use glam::DVec2;

/// Farther from the line than this (in sizes) cells do not end at it.
const FAR: f64 = 1.2;
/// The foot on a bent line may be this far (in sizes) from the line.
const OFF: f64 = 0.3;
/// The end of a line is shared by elements whose middle is this near to it (in sizes).
const END: f64 = 0.75;

/// Which cells of an element see each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Visibility {
    /// All do.
    Whole,
    /// Only those of the same number.
    Divided([u8; 4]),
    /// Some see others that do not see each other.
    Around,
}

/// What the constraint lines leave of an element with these corners.
pub(super) fn visibility(domain: &Domain, corners: &[DVec2]) -> Visibility {
    let middle = corners.iter().sum::<DVec2>() / corners.len() as f64;
    let farthest = corners.iter().map(|p| p.distance(middle));
    let farthest = farthest.fold(0.0, f64::max);
    if domain
        .nearest_line(middle)
        .is_none_or(|near| near.distance > farthest)
    {
        return Visibility::Whole;
    }
    let mut group = [0u8; 4];
    let mut groups = 0;
    let sees = |a: usize, b: usize| !domain.crosses_line(corners[a], corners[b]);
    for k in 0..corners.len() {
        group[k] = match (0..k).find(|&j| sees(j, k)) {
            Some(j) => group[j],
            None => {
                groups += 1;
                groups - 1
            }
        };
    }
    for k in 0..corners.len() {
        if (0..k).any(|j| sees(j, k) != (group[j] == group[k])) {
            return Visibility::Around;
        }
    }
    if groups == 1 {
        Visibility::Whole
    } else {
        Visibility::Divided(group)
    }
}

/// Where an element ends at the line between cells with the middle `own` and others beyond it: the
/// line's segment and the place.
pub(super) fn foot(
    domain: &Domain,
    own: DVec2,
    others: DVec2,
    size: f64,
) -> Option<(usize, DVec2)> {
    let [a, b] = domain.line_between(own, others)?;
    let along = (b - a).normalize();
    let foot = a + along * along.dot(own - a);
    let near = domain.nearest_line(foot)?;
    let fits = near.distance < OFF * size && near.point.distance(own) < FAR * size;
    fits.then_some((near.segment, near.point))
}

/// The end of a line that is near to the middle of an element: its segment and the place.
pub(super) fn end(domain: &Domain, middle: DVec2, size: f64) -> Option<(usize, DVec2)> {
    let mut best = None;
    let mut least = END * size;
    let mut segment = 0;
    for line in domain.lines() {
        for (number, end) in [
            (segment, line[0]),
            (segment + line.len() - 2, line[line.len() - 1]),
        ] {
            let by = domain.space().shortest(end - middle);
            if by.length() < least {
                least = by.length();
                best = Some((number, middle + by));
            }
        }
        segment += line.len() - 1;
    }
    best
}

/// The place where a line meets the outline that is near to the middle of an element: the outline's
/// segment and the place.
pub(super) fn junction(domain: &Domain, middle: DVec2, size: f64) -> Option<(usize, DVec2)> {
    let near = |&&(_, p): &&(usize, DVec2)| p.distance(middle) < END * size;
    let mut best: Option<(usize, DVec2)> = None;
    for &(segment, p) in domain.junctions().iter().filter(near) {
        if best.is_none_or(|(_, q)| p.distance(middle) < q.distance(middle)) {
            best = Some((segment, p));
        }
    }
    best
}
