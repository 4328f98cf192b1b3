//! Implicit solids: functions on space that are negative inside.

use super::bone::Bone;
use super::jet::{Jet, JetPoint};
use glam::DVec3;

/// A solid whose surface is the zero set of a function.
pub(super) trait Form {
    /// The function: negative inside, and about the distance to the surface near it.
    fn at(&self, p: JetPoint) -> Jet;

    /// A bounding box, as tight as is known.
    fn bounds(&self) -> (DVec3, DVec3);

    /// The length of the longest edges that still resolve all its parts.
    fn coarsest(&self) -> f64;

    /// The greatest length of the function's gradient.
    fn steepest(&self) -> f64 {
        1.0
    }

    fn bones(&self) -> Vec<Bone>;

    /// The plane faces where the body is cut off.
    fn cuts(&self) -> Vec<Cut> {
        Vec::new()
    }

    /// The claws on its toes, or the horny tip of its tail, each from root to point.
    fn claws(&self) -> Vec<Bone> {
        Vec::new()
    }
}

/// How a body ends where it is cut off, and at toes and tips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ends {
    /// Round, and like the rest of the surface.
    #[default]
    Round,
    /// Cut off straight, with claws on toes and a horny tip on a tail.
    Cut,
}

/// A plane face where a body is cut off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// A point of the plane.
    pub at: DVec3,
    /// The unit normal, away from the body.
    pub out: DVec3,
}

/// A face belongs to a cut if the cosine between their normals is at least this, ...
const ALIKE: f64 = 0.75;
/// ... and if it is nearer to the plane than this.
const CLOSE: f64 = 0.03;

impl Cut {
    /// Whether a triangle of the surface with this middle and normal is part of the cut.
    pub fn has(&self, middle: DVec3, normal: DVec3) -> bool {
        normal.dot(self.out) >= ALIKE && (middle - self.at).dot(self.out).abs() < CLOSE
    }
}

/// The most Newton steps onto the surface.
const STEPS: usize = 4;
/// A point is on the surface if its next step would be shorter than this part of the longest one.
const NEAR: f64 = 1e-4;

/// Moves a point onto the surface along the gradient, by at most `most` in a step.
pub(super) fn onto(form: &dyn Form, p: DVec3, most: f64) -> DVec3 {
    let mut at = p;
    for _ in 0..STEPS {
        let Some(step) = step(form, at, most) else {
            break;
        };
        at += step;
        if step.length_squared() < NEAR * NEAR * most * most {
            break;
        }
    }
    at
}

/// Moves a point towards the surface by one step: enough for a point that was on it and has been moved a little.
pub(super) fn near(form: &dyn Form, p: DVec3, most: f64) -> DVec3 {
    p + step(form, p, most).unwrap_or(DVec3::ZERO)
}

fn step(form: &dyn Form, at: DVec3, most: f64) -> Option<DVec3> {
    let jet = form.at(JetPoint::new(at));
    let length = jet.slope.length();
    let normal = jet.slope / length;
    (length > 1e-6).then(|| normal * (-jet.value / length).clamp(-most, most))
}
