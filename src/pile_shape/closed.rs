//! Rice ball and block: closed surfaces.

use super::cuboid::cuboid;
use super::edges::{self, StepSearch};
use super::piled::PiledShape;
use crate::trimesh::Soup;
use glam::DVec3;
use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// The block for the numbers `[height, depth, round]`.
pub(super) fn block(n: &[f64], edge: f64) -> PiledShape {
    let half = 0.5 * DVec3::new(1.0, n[0], n[1]);
    let most = half.min_element();
    let make = |step: f64| {
        // Short steps on narrow edges, and no flat part on narrow sides, so that no triangle is a sliver.
        let step = step.min(4.0 * n[2] * most);
        let is_narrow = 2.0 * (1.0 - n[2]) * most < 0.25 * step;
        cuboid(half, if is_narrow { most } else { n[2] * most }, step).0
    };
    let mut surface = edges::within(edge, FRAC_1_SQRT_2, make);
    surface.positions.iter_mut().for_each(|p| p.y += half.y);
    PiledShape::free(surface)
}

/// The form of a rice ball: a triangle with soft corners seen along z, one of them up. Its middle is the origin.
struct Onigiri {
    /// The power of the norm that joins the three sides: the higher, the sharper the corners.
    power: f64,
    /// The weight of a circle in this norm, which bends the sides.
    circle: f64,
    /// Half the thickness.
    half: f64,
}

/// The power of the profile from one face to the other: 2 gives an ellipse, higher ones are flatter.
const FLATNESS: f64 = 3.1;
/// Directions in which an outline is measured.
const DIRECTIONS: usize = 720;
/// How often vertices move to the middle of their neighbours.
const EASINGS: usize = 12;

impl Onigiri {
    /// The form for the numbers `[thick, round]`, and the least and greatest corner of its bounding box.
    fn new(n: &[f64]) -> (Self, DVec3, DVec3) {
        let mut form = Self {
            power: 7.0 - 4.0 * n[1],
            circle: 0.5 + 0.2 * n[1],
            half: 1.0,
        };
        let outline = (0..DIRECTIONS).map(|k| {
            let angle = TAU * k as f64 / DIRECTIONS as f64;
            let way = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
            way / form.norm(way)
        });
        let (lo, hi) = outline.fold((DVec3::ZERO, DVec3::ZERO), |(lo, hi), p| {
            (lo.min(p), hi.max(p))
        });
        form.half = n[0] * hi.x;
        let front = form.half * DVec3::Z;
        (form, lo - front, hi + front)
    }

    /// A function that is 1 on the surface, and proportional to the distance along each ray from the middle.
    fn norm(&self, p: DVec3) -> f64 {
        let slant = 0.75f64.sqrt() * p.x;
        let sides = [-p.y, 0.5 * p.y + slant, 0.5 * p.y - slant];
        let radius = (p.x * p.x + p.y * p.y).sqrt();
        let power = |x: f64| libm::pow(x.max(0.0), self.power);
        let sum: f64 = sides.into_iter().map(power).sum();
        let plan = libm::pow(sum + power(self.circle * radius), 1.0 / self.power);
        let profile = |x: f64| libm::pow(x, FLATNESS);
        libm::pow(
            profile(plan) + profile(p.z.abs() / self.half),
            1.0 / FLATNESS,
        )
    }

    /// A point, moved onto the form along its ray.
    fn onto(&self, p: DVec3) -> DVec3 {
        p / self.norm(p)
    }
}

/// The rice ball that most visitors see: its numbers, the length of its edges, and the step that the search finds for
/// them. Two of three tries are saved, each of which takes a second on a slow phone.
const USUAL: ([f64; 2], f64, f64) = ([0.45, 0.5], 0.02, 0.028173504994008714);

/// A rice ball in progress.
pub(super) struct RiceBallBuilding {
    form: Onigiri,
    bounds: [DVec3; 2],
    scale: f64,
    search: StepSearch,
    /// The triangles of the present step, and how often they have been eased.
    soup: Option<Soup>,
    eased: usize,
}

impl RiceBallBuilding {
    /// Starts the rice ball for the numbers `[thick, round]`.
    pub fn new(n: &[f64], edge: f64) -> Self {
        let mut new = Self::searching(n, edge);
        let (numbers, length, step) = USUAL;
        if n == numbers && edge == length {
            new.search.step = step;
        }
        new
    }

    /// Starts the search with no known step.
    fn searching(n: &[f64], edge: f64) -> Self {
        let (form, lo, hi) = Onigiri::new(n);
        let scale = 1.0 / (hi - lo).max_element();
        Self {
            form,
            bounds: [lo, hi],
            scale,
            search: StepSearch::new(edge / scale, FRAC_1_SQRT_2),
            soup: None,
            eased: 0,
        }
    }

    /// Eases the triangles once, or begins with those of the next step; returns the shape in the end.
    pub fn advance(&mut self) -> Option<PiledShape> {
        let Some(soup) = &mut self.soup else {
            (self.soup, self.eased) = (Some(self.draw()), 0);
            return None;
        };
        if self.eased < EASINGS {
            ease(soup, |p| self.form.onto(p));
            self.eased += 1;
            return None;
        }
        let mut soup = self.soup.take()?;
        if !self.search.takes(&soup) {
            return None;
        }
        let low = self.bounds[0].y * DVec3::Y;
        let places = soup.positions.iter_mut();
        places.for_each(|p| *p = (*p - low) * self.scale);
        Some(PiledShape::free(soup))
    }

    /// A box that is drawn onto the form, with squares of about the size of a step.
    fn draw(&self) -> Soup {
        let [lo, hi] = self.bounds;
        let (half, middle) = (0.5 * (hi - lo), 0.5 * (lo + hi));
        let (mut soup, _) = cuboid(half, 0.9 * half.min_element(), self.search.step);
        let places = soup.positions.iter_mut();
        places.for_each(|p| *p = self.form.onto(*p + middle));
        soup
    }
}

/// Moves each vertex to the middle of its neighbours, and onto the form again.
fn ease(soup: &mut Soup, onto: impl Fn(DVec3) -> DVec3) {
    let mut sums = vec![(DVec3::ZERO, 0.0); soup.positions.len()];
    for &[a, b, c] in &soup.triangles {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            let sum = &mut sums[p as usize];
            *sum = (sum.0 + soup.positions[q as usize], sum.1 + 1.0);
        }
    }
    for (p, (sum, count)) in soup.positions.iter_mut().zip(sums) {
        *p = onto(sum / count);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pile_shape::PileShape;

    #[test]
    fn the_step_of_the_usual_rice_ball_is_the_one_that_is_found() {
        let (numbers, edge, step) = USUAL;
        assert_eq!(PileShape::RiceBall.fitted(&[]), numbers);
        let mut building = RiceBallBuilding::searching(&numbers, edge);
        assert!(building.search.step > step);
        let found = loop {
            if let Some(made) = building.advance() {
                break made;
            }
        };
        assert_eq!(building.search.step, step);
        let made = PileShape::RiceBall.build(&numbers, edge);
        assert!(made.surface == found.surface);
    }
}
