//! The shell of a turtle: a dome with keels, a belly, and a rim that rises over neck and tail.

use super::bone::Bone;
use super::form::Form;
use super::jet::{Jet, JetPoint, length};
use glam::DVec3;

pub(super) struct Turtle {
    half: f64,
    width: f64,
    height: f64,
    belly: f64,
    rim: f64,
    keel: f64,
}

/// Half the length; the head is at -x.
const HALF: f64 = 0.44;
/// Distances inside are clamped to this depth, which is less than that of the belly.
const DEEP: f64 = 0.05;

impl Turtle {
    /// The turtle for the numbers `[width, height, rim, keel]`.
    pub fn new(n: &[f64]) -> Self {
        Self {
            half: HALF,
            width: HALF * n[0],
            height: 0.9 * n[1],
            belly: 0.06,
            rim: 0.026 + 0.03 * n[2],
            keel: n[3],
        }
    }
}

/// About the distance to an ellipse or ellipsoid. `over` is the length of the point divided by the radii, and
/// `over_square` is its length divided by the squared radii.
fn ellipsoid(over: Jet, over_square: Jet) -> Jet {
    over * (over - 1.0) * over_square.max(1e-6).inverse()
}

impl Form for Turtle {
    fn at(&self, p: JetPoint) -> Jet {
        let y = p.y - self.belly;
        // Narrower at the head.
        let along = p.x * (1.0 / self.half);
        let z = p.z * (along * 0.1 - along.squared() * 0.03 + 1.0).inverse();
        let (a, b) = (self.half, self.width);
        let (u, v) = (p.x * (1.0 / a), z * (1.0 / b));
        let plan = length(u, v);
        let plan_square = length(u * (1.0 / a), v * (1.0 / b));
        // The dome with three keels, and the belly below.
        let keels =
            (v * 7.0).bell() + ((v - 0.45) * 8.0).bell() * 0.6 + ((v + 0.45) * 8.0).bell() * 0.6;
        let ridge = keels * (0.14 * self.keel) + 1.0;
        let h = if y.value > 0.0 {
            self.height
        } else {
            self.belly
        };
        let level = match y.value > 0.0 {
            true => y * ridge.inverse() * (1.0 / h),
            false => y * (1.0 / h),
        };
        let dome = ellipsoid(length(plan, level), length(plan_square, level * (1.0 / h)));
        // The rim: an ellipse all around, raised over the neck and a little over the tail.
        let raised = ((along + 1.0) * 2.2).bell() * 0.05 + ((along - 1.0) * 2.6).bell() * 0.02;
        let out = ellipsoid(plan, plan_square);
        let up = y - raised - 0.004;
        let rim = length(out - 0.3 * self.rim, (up - out * 0.25) * 1.45) - self.rim;
        // The distance deep inside is useless, and steep.
        dome.max(-DEEP).join(rim, 0.08)
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let r = 1.3 * self.rim;
        let (x, z) = (self.half + r, 1.06 * self.width + r);
        let top = self.belly + self.height * (1.0 + 0.14 * self.keel);
        (DVec3::new(-x, 0.0, -z), DVec3::new(x, top, z))
    }

    fn coarsest(&self) -> f64 {
        (1.0 * self.rim).min(0.035)
    }

    fn steepest(&self) -> f64 {
        2.2
    }

    fn bones(&self) -> Vec<Bone> {
        let y = self.belly + 0.3 * self.height;
        let x = self.half;
        vec![Bone::straight(
            DVec3::new(-x, y, 0.0),
            DVec3::new(x, y, 0.0),
            self.width,
        )]
    }
}
