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

/// A point brought onto the surface along the gradient, no farther than `most` in a step, and the unit normal there.
pub(super) fn onto(form: &dyn Form, p: DVec3, most: f64) -> (DVec3, DVec3) {
    let mut at = p;
    let mut normal = DVec3::Y;
    for _ in 0..STEPS {
        let jet = form.at(Spot::new(at));
        let square = jet.slope.length_squared();
        if square < 1e-12 {
            break;
        }
        normal = jet.slope / square.sqrt();
        let step = -jet.value / square.sqrt();
        at += normal * step.clamp(-most, most);
        if step.abs() < 1e-3 * most {
            break;
        }
    }
    (at, normal)
}
