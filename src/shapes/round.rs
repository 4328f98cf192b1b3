//! Sphere and egg.

use super::bone::Bone;
use super::form::Form;
use super::jet::{Jet, JetPoint, length};
use glam::DVec3;

/// An ellipsoid, or a rounded box.
pub(super) struct Ball {
    half: DVec3,
    square: f64,
}

impl Ball {
    /// The ball for the numbers `[height, depth, square]`.
    pub fn new(n: &[f64]) -> Self {
        let half = DVec3::new(1.0, n[0], n[1]);
        Self {
            half: half * (0.5 / half.max_element()),
            square: n[2],
        }
    }
}

impl Form for Ball {
    fn at(&self, p: JetPoint) -> Jet {
        let scaled = [
            p.x * (1.0 / self.half.x),
            (p.y - self.half.y) * (1.0 / self.half.y),
            p.z * (1.0 / self.half.z),
        ];
        let norm = if self.square == 2.0 {
            (scaled[0].squared() + scaled[1].squared() + scaled[2].squared()).root()
        } else {
            let e = self.square;
            let power = |v: Jet| {
                let v = v.abs();
                let one_less = libm::pow(v.value, e - 1.0);
                v.map(one_less * v.value, e * one_less)
            };
            let sum = power(scaled[0]) + power(scaled[1]) + power(scaled[2]);
            let norm = libm::pow(sum.value, 1.0 / e);
            let safe = sum.value.max(1e-9);
            sum.map(norm, norm / (e * safe))
        };
        (norm - 1.0) * self.half.min_element()
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let h = self.half;
        (DVec3::new(-h.x, 0.0, -h.z), DVec3::new(h.x, 2.0 * h.y, h.z))
    }

    fn coarsest(&self) -> f64 {
        self.half.min_element() * if self.square > 2.0 { 0.25 } else { 0.4 }
    }

    fn steepest(&self) -> f64 {
        1.8
    }

    fn bones(&self) -> Vec<Bone> {
        let up = 2.0 * self.half.y * DVec3::Y;
        vec![Bone::straight(
            DVec3::ZERO,
            up,
            self.half.x.min(self.half.z),
        )]
    }
}

/// An egg that stands on its blunt end.
pub(super) struct Egg {
    half: f64,
    radius: f64,
    point: f64,
    /// The height that is cut off at the bottom.
    base: f64,
}

impl Egg {
    /// The egg for the numbers `[height, point, base]`.
    pub fn new(n: &[f64]) -> Self {
        let scale = 1.0 / (n[0] * (1.0 - n[2])).max(1.0);
        Self {
            half: 0.5 * n[0] * scale,
            radius: 0.5 * scale,
            point: n[1],
            base: n[2] * n[0] * scale,
        }
    }
}

impl Form for Egg {
    fn at(&self, p: JetPoint) -> Jet {
        let y = p.y - (self.half - self.base);
        // Wider below the middle, narrower above.
        let narrower = (y * (self.point / self.half)).max(-0.9) + 1.0;
        let round = length(p.x, p.z) * narrower;
        let norm = length(round * (1.0 / self.radius), y * (1.0 / self.half));
        let egg = (norm - 1.0) * self.radius.min(self.half);
        if self.base > 0.0 {
            egg.cut(-p.y, 0.12)
        } else {
            egg
        }
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        // The widest place is a little below the middle.
        let r = self.radius * (1.0 + 0.55 * self.point * self.point);
        let top = 2.0 * self.half - self.base;
        (DVec3::new(-r, 0.0, -r), DVec3::new(r, top, r))
    }

    fn coarsest(&self) -> f64 {
        0.12 * self.half
    }

    fn steepest(&self) -> f64 {
        2.0
    }

    fn bones(&self) -> Vec<Bone> {
        let top = (2.0 * self.half - self.base) * DVec3::Y;
        vec![Bone::straight(DVec3::ZERO, top, self.radius)]
    }
}
