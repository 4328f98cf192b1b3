//! Solid forms: a number at each point of space that is negative inside.

use super::bone::Bone;
use super::jet::{Jet, Spot};
use glam::DVec3;

/// A solid form whose surface is where a function is 0.
pub(super) trait Form {
    /// The function: negative inside, about the distance to the surface near it.
    fn at(&self, p: Spot) -> Jet;

    /// A box around it, as tight as is known.
    fn bounds(&self) -> (DVec3, DVec3);

    /// The length of the longest edges that still show all its parts.
    fn coarsest(&self) -> f64;

    /// No gradient is longer.
    fn steepest(&self) -> f64 {
        1.0
    }

    fn bones(&self) -> Vec<Bone>;
}

/// Newton's steps onto the surface at most.
const STEPS: usize = 4;
/// A point is on it where the next step would be this part of the longest one.
const NEAR: f64 = 1e-4;

/// A point brought onto the surface along the gradient, no farther than `most` in a step.
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

/// A point brought nearer to the surface, by one step: enough for one that has been on it and is moved a little.
pub(super) fn near(form: &dyn Form, p: DVec3, most: f64) -> DVec3 {
    p + step(form, p, most).unwrap_or(DVec3::ZERO)
}

fn step(form: &dyn Form, at: DVec3, most: f64) -> Option<DVec3> {
    let jet = form.at(Spot::new(at));
    let length = jet.slope.length();
    let normal = jet.slope / length;
    (length > 1e-6).then(|| normal * (-jet.value / length).clamp(-most, most))
}
