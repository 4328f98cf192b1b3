//! Cuts polygons by half-planes, or by half-spaces (Sutherland, Hodgman 1974, Reentrant polygon clipping).

/// The part of a polygon where `distance` is not negative. A convex polygon stays one polygon. `keep` gets the
/// corners in order. Where a side enters or leaves the part, `crossing` makes a corner from the side's ends and their
/// distances.
#[inline(always)]
pub(crate) fn cut_polygon<P: Copy, D: Copy + Default + PartialOrd>(
    polygon: &[P],
    distance: impl Fn(P) -> D,
    crossing: impl Fn((P, D), (P, D)) -> P,
    mut keep: impl FnMut(P),
) {
    let Some(&last) = polygon.last() else {
        return;
    };
    let is_inside = |(_, distance): (P, D)| distance >= D::default();
    let mut from = (last, distance(last));
    for &p in polygon {
        let to = (p, distance(p));
        if is_inside(from) != is_inside(to) {
            keep(crossing(from, to));
        }
        if is_inside(to) {
            keep(p);
        }
        from = to;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn cut(polygon: &[DVec2], normal: DVec2, at: f64) -> Vec<DVec2> {
        let mut left = Vec::new();
        let between = |(p, s): (DVec2, f64), (q, t): (DVec2, f64)| p + (q - p) * (s / (s - t));
        cut_polygon(polygon, |p| normal.dot(p) - at, between, |p| left.push(p));
        left
    }

    #[test]
    fn a_square_is_cut_at_the_line() {
        let square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(DVec2::from);
        let half = [(1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (1.0, 2.0)].map(DVec2::from);
        assert_eq!(cut(&square, DVec2::X, 1.0), half);
        assert_eq!(cut(&square, DVec2::X, 3.0), []);
        assert_eq!(cut(&square, DVec2::X, 0.0), square);
        assert_eq!(cut(&[], DVec2::X, 0.0), []);
        let corner = cut(&square, DVec2::ONE, 3.0);
        assert_eq!(corner.len(), 3);
        assert_eq!(crate::domain::signed_area(&corner), 0.5);
    }
}
