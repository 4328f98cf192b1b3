//! The outline of the ground below a building.

use crate::building::Building;
use glam::DVec3;

/// How far the ground reaches beyond the building's plan: a part of the plan's radius, and the least and the most
/// (metres).
const BEYOND: f64 = 0.18;
const LEAST_BEYOND: f64 = 0.2;
const MOST_BEYOND: f64 = 0.55;
/// The thickness of the ground (metres).
pub(super) const THICK: f64 = 0.16;

/// The outline of the ground in the building's own coordinates (metres).
pub(super) struct Disc {
    pub middle: DVec3,
    pub radius: f64,
}

impl Disc {
    /// The ground of a building.
    pub fn new(building: &Building) -> Self {
        let places = building.vertices().iter().map(|v| v.position);
        let start = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let [low, high] = places.fold(start, |[low, high], p| [low.min(p), high.max(p)]);
        let middle = low.midpoint(high).with_y(low.y);
        let plan = middle.distance(low);
        let beyond = (BEYOND * plan).clamp(LEAST_BEYOND, MOST_BEYOND);
        Self {
            middle,
            radius: plan + beyond,
        }
    }

    /// The height of the lower side (metres).
    pub fn foot(&self) -> f64 {
        self.middle.y - THICK
    }
}
