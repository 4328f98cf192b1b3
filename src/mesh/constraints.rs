//! Triangles and sides at constraint lines.

use crate::domain::Domain;
use crate::packing::Particle;
use glam::DVec2;

/// Share of a side that is ignored at each end, because the end may stand on a constraint line.
const SHRINK: f64 = 0.02;
/// A point nearer to a constraint line than this (in sizes) lies on it.
const ON_LINE: f64 = 0.05;

/// Whether a constraint line crosses a side of the triangle.
pub(super) fn is_cut(domain: &Domain, [a, b, c]: [DVec2; 3]) -> bool {
    [[a, b], [b, c], [c, a]]
        .iter()
        .any(|&[p, q]| domain.crosses_line(p.lerp(q, SHRINK), q.lerp(p, SHRINK)))
}

/// Whether both cells stand on a constraint line, and the segment between them does, too.
pub(super) fn lies_on_line(domain: &Domain, [a, b]: [&Particle; 2]) -> bool {
    let on = |p: DVec2| {
        let near = domain.nearest_line(p);
        near.is_some_and(|near| near.distance < ON_LINE * a.size)
    };
    on(a.centre.midpoint(b.centre)) && on(a.centre) && on(b.centre)
}
