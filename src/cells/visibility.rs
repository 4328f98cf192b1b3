//! Mesh elements that a constraint line divides: each side of the line has its own vertex.
//!
//! Cells on the two sides are packed against the line and need not face each other. Seen from one side, an
//! element ends at the line as if its cells were mirrored: its vertex is the closest point of the line to the
//! cells' centre. Around the free end of a line, where cells see each other, all share the end.

use crate::domain::Domain;
use glam::DVec2;

/// Cells farther from the line than this (in sizes) do not end at it.
const FAR: f64 = 1.2;
/// On a bent line, the vertex may be this far (in sizes) off the line.
const OFF: f64 = 0.3;
/// If the centre of an element is nearer to the end of a line than this (in sizes), the end is the element's vertex.
const END: f64 = 0.75;

/// Which cells of an element see each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Visibility {
    /// All cells of the element see each other.
    Whole,
    /// Cells with the same number see each other; a number for each corner of the element.
    Divided([u8; 4]),
    /// Visibility is not transitive here: some cells see two cells that do not see each other.
    Around,
}

/// The visibility between the corners of an element, past the constraint lines.
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

/// The vertex of an element at the line between the cells around `own` and the cells around `others`: the number of the
/// line's segment, and the place nearest to `own`. `None` if the line is too far away.
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

/// The end of a line near the centre of an element: the number of the line's segment there, and the place.
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

/// The junction of a line and the outline near the centre of an element: the outline's segment and the place.
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
