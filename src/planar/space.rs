//! The space of places: the plane, or a torus.
//!
//! Most stages loop over the images of a place (in the plane there is one) and need not know the space. They
//! ask only where they make something different: the grid and the lattice of the fields, rays and gradients
//! that must repeat (`field`), meshes that end at walls or close over seams (`mesh::meshing`,
//! `cells::dual_builder`), and the filling of a picture without an outline.

use glam::DVec2;

/// The plane, or the torus that a square picture becomes when opposite edges are glued.
///
/// On the torus a place is the same as all its images, which are whole sides away from it. Its representative
/// is the image inside the picture, 0 <= x, y < side. In the plane every place is its own representative and
/// its only image, so code that loops over images is right in both.
///
/// The side of a torus is a whole number of steps of the grain to which places are rounded, as pictures have
/// whole sides. So the images of places on the grain are exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    /// The side of the torus (picture units); `None` in the plane.
    period: Option<f64>,
}

impl Space {
    /// The plane.
    pub const PLANE: Self = Self { period: None };

    /// The torus with this side (picture units).
    pub fn torus(side: f64) -> Self {
        Self { period: Some(side) }
    }

    /// The side of the torus, for code that treats it differently; `None` in the plane.
    #[inline]
    pub fn period(self) -> Option<f64> {
        self.period
    }

    /// The shortest difference between the images of two places whose difference is `r`.
    #[inline]
    pub fn shortest(self, r: DVec2) -> DVec2 {
        match self.period {
            Some(side) => r - (r / side).round() * side,
            None => r,
        }
    }

    /// Whether this difference of two places is the shortest between their images.
    #[inline]
    pub(crate) fn is_shortest(self, r: DVec2) -> bool {
        let side = self.period.unwrap_or(f64::INFINITY);
        r.abs().max_element() <= 0.5 * side
    }

    /// The image of a place inside the picture.
    #[inline]
    pub fn wrap(self, p: DVec2) -> DVec2 {
        let Some(side) = self.period else { return p };
        let q = p - self.tile(p);
        // A number a little below 0 rounds up to the side itself.
        DVec2::select(q.cmpge(DVec2::splat(side)), DVec2::ZERO, q)
    }

    /// The shift from the picture to its copy that contains a place.
    #[inline]
    pub(crate) fn tile(self, p: DVec2) -> DVec2 {
        let shift = |side: f64| (p / side).floor() * side;
        self.period.map_or(DVec2::ZERO, shift)
    }

    /// How far outside the picture the nearest image of a place inside can lie, seen from another place
    /// inside; 0 in the plane.
    pub(crate) fn overhang(self) -> f64 {
        self.period.map_or(0.0, |side| side / 2.0)
    }

    /// The shifts to images up to `far` sides away along each axis: zero first, then row by row.
    pub(crate) fn shifts(self, far: i32) -> impl Iterator<Item = DVec2> + Clone {
        let (side, far) = self.period.map_or((0.0, 0), |side| (side, far));
        Shifts { side, far, next: 0 }
    }

    /// Those of the nine images in and around the picture that lie in it or at most `reach` outside. The place itself,
    /// which must be in the picture, comes first.
    #[inline]
    pub(crate) fn images(self, p: DVec2, reach: f64) -> impl Iterator<Item = DVec2> + Clone {
        const SHIFTS: [f64; 3] = [0.0, -1.0, 1.0];
        let (side, count) = self.period.map_or((0.0, 1), |side| (side, 9));
        (0..count)
            .map(move |k| p + side * DVec2::new(SHIFTS[k % 3], SHIFTS[k / 3]))
            .filter(move |&q| self.is_near_home([q, q], reach))
    }

    /// The shifts that make a box meet the picture; in the plane only zero.
    pub(crate) fn shifts_home(self, [lo, hi]: [DVec2; 2]) -> impl Iterator<Item = DVec2> {
        let shifts = self.shifts(2);
        shifts.filter(move |&by| self.is_near_home([lo + by, hi + by], 0.0))
    }

    /// Whether part of a box lies in the picture, or at most `reach` outside along each axis.
    #[inline]
    pub(crate) fn is_near_home(self, [lo, hi]: [DVec2; 2], reach: f64) -> bool {
        self.period.is_none_or(|side| {
            (hi.cmpge(DVec2::splat(-reach)) & lo.cmple(DVec2::splat(side + reach))).all()
        })
    }

    /// The images of segments up to `far` sides away, shift by shift; the unshifted segments come first.
    pub(crate) fn repeated(
        self,
        segments: &[[DVec2; 2]],
        far: i32,
    ) -> impl Iterator<Item = [DVec2; 2]> {
        let image = move |by| segments.iter().map(move |s| s.map(|p| p + by));
        self.shifts(far).flat_map(image)
    }

    /// The images of segments whose boxes meet a box around the picture; in the plane the segments
    /// themselves.
    pub(crate) fn repeated_over(
        self,
        segments: &[[DVec2; 2]],
        [lo, hi]: [DVec2; 2],
    ) -> impl Iterator<Item = [DVec2; 2]> {
        let far = |side: f64| (hi.max_element() / side).ceil() as i32 + 1;
        let images = self.repeated(segments, self.period.map_or(0, far));
        images.filter(move |[a, b]| {
            self.period.is_none() || (a.min(*b).cmple(hi) & a.max(*b).cmpge(lo)).all()
        })
    }

    /// The sides of the square around all nine copies of the picture; no sides in the plane.
    pub(crate) fn frame(self) -> impl Iterator<Item = [DVec2; 2]> {
        let rim = |side| {
            let at = |x: f64, y: f64| DVec2::new(x, y) * side;
            let corners = [at(-1., -1.), at(2., -1.), at(2., 2.), at(-1., 2.)];
            (0..4).map(move |k| [corners[k], corners[(k + 1) % 4]])
        };
        self.period.map(rim).into_iter().flatten()
    }
}

/// See [`Space::shifts`].
#[derive(Clone)]
struct Shifts {
    side: f64,
    far: i32,
    next: i32,
}

impl Iterator for Shifts {
    type Item = DVec2;

    fn next(&mut self) -> Option<DVec2> {
        let across = 2 * self.far + 1;
        let (count, middle) = (across * across, across * across / 2);
        let place = match self.next {
            0 => middle,
            next if next <= middle => next - 1,
            next => next,
        };
        self.next += 1;
        let sides = [place % across, place / across].map(|k| f64::from(k - self.far));
        (place < count).then(|| DVec2::from(sides) * self.side)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TORUS: Space = Space { period: Some(64.0) };

    fn at(x: f64, y: f64) -> DVec2 {
        DVec2::new(x, y)
    }

    #[test]
    fn in_the_plane_everything_is_its_only_image() {
        let plane = Space::PLANE;
        let p = at(-3e9, 5e9);
        assert_eq!((plane.shortest(p), plane.wrap(p)), (p, p));
        assert!(plane.is_shortest(p) && plane.is_near_home([p, p], 0.0));
        assert_eq!(plane.shifts(5).collect::<Vec<_>>(), [DVec2::ZERO]);
        assert_eq!(plane.images(p, 0.0).collect::<Vec<_>>(), [p]);
        assert_eq!(plane.shifts_home([p, p]).count(), 1);
        let segments = [[p, DVec2::ZERO]];
        let over = plane.repeated_over(&segments, [DVec2::ZERO; 2]);
        assert_eq!(over.collect::<Vec<_>>(), segments);
        assert_eq!(plane.frame().count(), 0);
    }

    #[test]
    fn the_image_at_home_is_never_on_the_far_edge() {
        for x in [
            0.0,
            -0.0,
            63.9,
            64.0,
            -64.0,
            -1e-20,
            1e9 + 0.25,
            -1e9 - 0.25,
        ] {
            let home = TORUS.wrap(at(x, 7.0 - x));
            assert!(home.cmpge(DVec2::ZERO).all() && home.cmplt(DVec2::splat(64.0)).all());
            assert!(TORUS.is_near_home([home, home], 0.0));
        }
        assert_eq!(TORUS.wrap(at(-1.0, 129.5)), at(63.0, 1.5));
        assert_eq!(TORUS.tile(at(-1.0, 129.5)), at(-64.0, 128.0));
    }

    #[test]
    fn the_shortest_difference_is_at_most_half_a_side_along_each_axis() {
        let r = TORUS.shortest(at(63.0, -40.0));
        assert_eq!(r, at(-1.0, 24.0));
        assert!(TORUS.is_shortest(r) && !TORUS.is_shortest(at(63.0, -40.0)));
    }

    #[test]
    fn shifts_begin_with_none_and_go_row_by_row() {
        let shifts: Vec<(f64, f64)> = TORUS.shifts(1).map(|by| (by / 64.0).into()).collect();
        let rows = [(-1., -1.), (0., -1.), (1., -1.), (-1., 0.), (1., 0.)];
        assert_eq!(shifts[0], (0., 0.));
        assert_eq!(shifts[1..6], rows);
        assert_eq!(shifts[6..], [(-1., 1.), (0., 1.), (1., 1.)]);
        assert_eq!(TORUS.shifts(3).count(), 49);
    }

    #[test]
    fn images_are_those_within_reach() {
        let p = at(1.0, 32.0);
        assert_eq!(TORUS.images(p, f64::INFINITY).count(), 9);
        let near: Vec<_> = TORUS.images(p, 3.0).collect();
        assert_eq!(near, [p, at(65.0, 32.0)]);
        let home: Vec<_> = TORUS.shifts_home([at(60.0, 5.0), at(70.0, 9.0)]).collect();
        assert_eq!(home, [DVec2::ZERO, at(-64.0, 0.0)]);
    }

    #[test]
    fn segments_are_repeated_as_far_as_the_box() {
        let segments = [[at(10.0, 10.0), at(20.0, 10.0)]];
        assert_eq!(TORUS.repeated(&segments, 1).count(), 9);
        let over = [at(-64.0, 0.0), at(128.0, 64.0)];
        let images: Vec<_> = TORUS.repeated_over(&segments, over).collect();
        assert_eq!(images.len(), 3);
        assert_eq!(images[0], segments[0]);
    }
}
